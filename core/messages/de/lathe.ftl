# Was die Zyklen mit dem Werkstückmesstaster einer Drehmaschine gemeinsam haben.

ma-lathe-abscissa = Abszisse (G18: Z)
ma-lathe-ordinate = Ordinate (G18: X)
ma-lathe-applicate = Applikate (G18: Y), falls vorhanden

param-fa-lathe = Messweg
param-fa-lathe-help = Abstand vom Start des Messsatzes zur Sollposition; ebenso weit fährt der Messtaster darüber hinaus. Die Endposition liegt gleich weit vor der Fläche. Immer in mm, in X als Radius.

check-lathe-probe = Ein Werkzeug vom Typ { $type } ist aktiv, aber dieser Zyklus braucht den Messtaster einer Drehmaschine.
check-lathe-probe-hint = Vor dem Aufruf den Messtaster mit seiner D-Nummer programmieren: Typ 5xy, Schneidenlage 5 bis 8.
check-lathe-tip = Schneidenlage { $tip } des Messtasters ist hier unzulässig.
check-lathe-tip-hint = Ein Messtaster hat Schneidenlage 5, 6, 7 oder 8: die Seite, zu der der Taststift zeigt. $TC_DP2 korrigieren.
