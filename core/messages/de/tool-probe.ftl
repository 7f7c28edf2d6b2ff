# Gemeinsames der Zyklen am Werkzeugmesstaster: Parameter, Auswahlen, Ergebnisse, Prüfungen.

mvar-task = Aufgabe
task-calibrate = Messtaster kalibrieren
task-calibrate-words = kalibrieren abgleichen eichen Kalibrierung Werkzeugmesstaster Messtaster Taster Triggerpunkt Seite Oberseite
task-still = Werkzeug messen, Spindel steht
task-still-words = Länge Radius stehend Stillstand Bohrer Schaftfräser Schneide
task-rotating = Werkzeug messen, Spindel dreht
task-rotating-words = Länge Radius drehend rotierend größte Schneide Fräser Planfräser Messerkopf Drehzahl Vorschub
mvar-reference = Messtasterdaten
reference-machine = maschinenbezogen (_TP)
reference-machine-words = Maschine MKS _TP
reference-setting = werkstückbezogen (_CBIT[5]=1, _TP)
reference-workpiece = werkstückbezogen (_TPW)
reference-workpiece-words = Werkstück WKS Frame _TPW
ma-lathe-l2 = L2, in der Abszisse angetastet (G18: Z)
ma-lathe-l1 = L1, in der Ordinate angetastet (G18: X)
mvar-approach = Anfahren des Messtasters
approach-normal = Positionieren durch den Zyklus
approach-incremental = inkrementell: nur die Messbewegung
approach-incremental-words = inkrementell Messweg Vorzeichen unbekannte Position Lage erstes Mal Geometrie JOG
approach-automatic = automatisch: alle Seiten
approach-automatic-words = automatisch alle Achsen Richtungen Mitte

param-prnum-tool = Werkzeugmesstaster
param-prnum-tool-help = Nummer des Werkzeugmesstasters: Seine Daten sind _TP[n-1,…] oder, bei einer _TPW-Messvariante, _TPW[n-1,…].
param-evnum-tool = Erfahrungswertspeicher
param-evnum-tool-help = Nummer n des Speichers _EV[n-1], der den Messwert korrigiert; 0: keiner. Über 9999 gelten nur die letzten vier Stellen, da der Zyklus keinen Mittelwert bildet.
param-tzl-tool = Nullkorrektur
param-tzl-tool-help = Differenzen bis zu dieser Grenze korrigiert der Zyklus nicht; es erscheint kein Alarm.
param-tdif-tool = Maßdifferenzkontrolle
param-tdif-tool-help = Differenzen ab dieser Grenze korrigiert der Zyklus nicht; er zeigt Meldung 62306 an. Das Programm läuft weiter, mit _CBIT[2]=1 erst nach NC START.
param-tsa-tool-probe = Vertrauensbereich des Triggerpunkts
param-tsa-tool-probe-help = Weicht ein Triggerpunkt um mehr als diesen Wert vom gespeicherten ab, hält Alarm 61303 das Programm an, und nichts wird gespeichert.
param-tsa-tool = Vertrauensbereich des Werkzeugs
param-tsa-tool-help = Weicht Länge oder Radius um diesen Wert oder mehr ab, korrigiert der Zyklus den Wert nicht: Alarm 61303 hält das Programm an.
param-fa-tool = Messweg
param-fa-tool-help = Abstand vom Start des Messsatzes zum erwarteten Triggerpunkt; gemessen wird ebenso weit darüber hinaus. Auch Abstand beim Umfahren des Messtasters. Immer in mm, in X als Radius.
param-ma-lathe-length = Zu messende Länge
param-ma-lathe-length-help = Zu messende Länge; sie bestimmt auch die Achse der Antastung. Die Startposition liegt vor der Messtasterseite, die die Schneide antastet.
param-ma-calibrate = Kalibrierte Achse
param-ma-calibrate-help = Achse, in der der Messtaster angetastet wird. Außer bei inkrementellem Anfahren bestimmt die Startposition die Richtung; in der Applikate ist sie dann immer minus.

result-trigger-minus-1 = Triggerpunkt in Minus-Richtung, 1. Geometrieachse, Istwert
result-trigger-minus-1-difference = Triggerpunkt in Minus-Richtung, 1. Geometrieachse, Differenz
result-trigger-plus-1 = Triggerpunkt in Plus-Richtung, 1. Geometrieachse, Istwert
result-trigger-plus-1-difference = Triggerpunkt in Plus-Richtung, 1. Geometrieachse, Differenz
result-trigger-minus-2 = Triggerpunkt in Minus-Richtung, 2. Geometrieachse, Istwert
result-trigger-minus-2-difference = Triggerpunkt in Minus-Richtung, 2. Geometrieachse, Differenz
result-trigger-plus-2 = Triggerpunkt in Plus-Richtung, 2. Geometrieachse, Istwert
result-trigger-plus-2-difference = Triggerpunkt in Plus-Richtung, 2. Geometrieachse, Differenz
result-trigger-minus-3 = Triggerpunkt in Minus-Richtung, 3. Geometrieachse, Istwert
result-trigger-minus-3-difference = Triggerpunkt in Minus-Richtung, 3. Geometrieachse, Differenz
result-trigger-plus-3 = Triggerpunkt in Plus-Richtung, 3. Geometrieachse, Istwert
result-trigger-plus-3-difference = Triggerpunkt in Plus-Richtung, 3. Geometrieachse, Differenz
result-actual-l1 = Istwert Länge L1
result-difference-l1 = Differenz Länge L1
result-actual-l2 = Istwert Länge L2
result-difference-l2 = Differenz Länge L2

check-tool-probe-number-hint = Nummer von 1 bis { $fields } wählen oder weitere Messtasterdaten anlegen und { $array } erhöhen.
check-tool-limits = { $small }, { $low } mm, ist nicht kleiner als { $large }, { $high } mm: Dazwischen liegt keine Differenz.
check-tool-limits-hint = Reihenfolge vom kleinsten zum größten Wert einhalten: _TZL, _TDIF, _TSA.
check-tool-speed = { $name } ist 0 oder negativ: Der Zyklus kann das Werkzeug nicht positionieren.
check-tool-speed-hint = _SPEED[0] in % des Eilgangs eintragen, mit Kollisionsüberwachung (_CHBIT[2]=1) _SPEED[1] und _SPEED[2] als Vorschub über 0.
check-tool-probe-empty = Die Position des Werkzeugmesstasters ist nicht eingetragen (Wert 0): { $names }.
check-tool-probe-empty-hint = Ungefähre Positionen der Messtasterseiten im Datenbaustein GUD6 eintragen; der Zyklus berechnet daraus seine Wege.
check-tool-probe-sides = { $minus } ist nicht größer als { $plus }: Die in Minus-Richtung angetastete Seite muss auf der Plus-Seite des Messtasters liegen.
check-tool-probe-sides-hint = Werte beider Seiten tauschen oder den fehlenden eintragen.
check-tool-probe-in-use = Als Werkzeug ist ein Werkstückmesstaster aktiv.
check-tool-probe-in-use-hint = Vor dem Aufruf das zu messende Werkzeug oder das Kalibrierwerkzeug einwechseln.
check-tool-type = Werkzeugtyp { $type } ist hier unzulässig.
check-tool-type-hint = Zu messendes Werkzeug oder Kalibrierwerkzeug einwechseln; $TC_DP1 prüfen.
check-turning-type-hint = Drehwerkzeug (Typ 5xy) einwechseln und seine D-Nummer vor dem Aufruf aktivieren; $TC_DP1 prüfen.
check-tip = Schneidenlage { $tip } ist hier unzulässig.
check-tip-calibration-hint = Zum Kalibrieren ein Werkzeug mit Schneidenlage 3 verwenden; $TC_DP2 prüfen.
check-tip-hint = Werkzeug mit Schneidenlage 1 bis 8 verwenden; $TC_DP2 prüfen.
check-tip-axis = Ein Werkzeug mit Schneidenlage { $tip } hat in dieser Achse keine Schneide.
check-tip-axis-hint = Werkzeuge mit Schneidenlage 5 oder 7 nur in der Abszisse messen, mit 6 oder 8 nur in der Ordinate.
check-tool-radius-negative = Radius und Verschleiß des aktiven Werkzeugs ergeben { $radius } mm. Das ist nicht möglich: Die Simulation rechnet mit Radius 0.
check-tool-radius-negative-hint = Radius oder dessen Verschleiß in den Werkzeugdaten korrigieren.
