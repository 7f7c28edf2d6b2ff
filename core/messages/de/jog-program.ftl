# Messen in JOG als Programm und ein Aufruf als Maske: was anders ist, warum es keinen gibt.

jog-differs-expected = Der Zyklus erwartet das Werkstück bis { $reach } mm neben der Sollposition; weiter weg kommt 61301 oder 61303. JOG sucht von dort aus, wo der Messtaster steht.
jog-differs-stand = Der Zyklus nimmt den Ort des Messtasters beim Aufruf als Sollposition und misst auf Linien durch ihn. JOG misst dort, wohin der Messtaster verfahren wurde; die Sollposition ist ein Feld.
jog-differs-points = Der Zyklus fährt selbst von Punkt zu Punkt und tastet an eigenen Stellen an.
jog-differs-up = Zwischen den Punkten hebt der Messtaster um { $path } mm ab (_ID). JOG kennt die Höhe des Werkstücks nicht: prüfen, ob das reicht.
jog-differs-fourth = Der Zyklus braucht einen vierten Punkt: zwischen P3 und der Ecke.
jog-differs-around = Der Zyklus fährt auf Messhöhe um den Zapfen. In JOG fährt der Messtaster darüber.
jog-differs-angle = Der Zyklus misst Winkel bis 45°; darüber kommt 61331.
jog-differs-skew = JOG stellt die Kugel, nicht die Spindelachse, vor den Punkt. An einer schrägen Kante tastet der Zyklus um die Lageabweichung des Messtasters daneben an.
jog-differs-spindle = In JOG folgt die Spindel einem gedrehten WKS nach E_MESS_SETT[0], im Zyklus nach _CHBIT[13]. Beide sind verschieden eingestellt.
jog-differs-corner-zero = Der Zyklus macht die Ecke zum Nullpunkt beider Achsen. Die Sollpositionen der Maske haben darin keinen Platz.
jog-differs-fine = JOG schreibt grob und löscht fein. Der Zyklus korrigiert fein; mit _CHBIT[21] = 1 macht er es wie JOG.
jog-differs-active = Was der Zyklus schreibt, wirkt, sobald das Programm die Nullpunktverschiebung wieder aufruft. JOG aktiviert sofort oder im Aktivierungsbild.
jog-differs-tool-data = Der Zyklus nimmt Werkzeugmesstaster und Drehzahlen aus eigenen Daten (_TP, _CM), JOG aus E_MESS_MT_… und E_MESS_….
jog-differs-tool-memory = JOG schreibt Geometrie oder Verschleiß nach _JM_B[0], der Zyklus nach _CHBIT[3]. Beide sind verschieden eingestellt.
jog-program-points = Zuerst alle Punkte messen: Der Aufruf braucht ihre Orte.
jog-program-centres = Kein Zyklus misst mehrere Bohrungen oder Zapfen und korrigiert nach ihren Mittelpunkten eine Nullpunktverschiebung. CYCLE977 mit _KNUM = 0 misst jeden Mittelpunkt; CYCLE116 berechnet einen Kreis durch drei oder vier.
jog-program-none = Kein Zyklus macht dasselbe.
jog-program-step = Kein Zyklus misst zwei Kanten, die in dieselbe Richtung zeigen oder vertauscht liegen.
jog-program-heights = Kein Zyklus misst eine Nut oder einen Steg in der Zustellachse.
jog-program-corner = Die Punkte liegen nicht auf den Kanten dieser Ecke. Die Lage prüfen, dann neu messen.
jog-back-tool = Der Aufruf korrigiert ein Werkzeug. JOG misst nur oder korrigiert eine Nullpunktverschiebung.
jog-back-without = Die Maske hat kein Feld für { $names }.
jog-back-direction = Der Aufruf misst vom Messtaster zur Sollposition. Die Richtung in der Maske wählen.
jog-back-position = Die Sollposition des Aufrufs ist der Ort des Messtasters im Programm. In der Maske eintragen.
