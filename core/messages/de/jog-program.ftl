# Messen in JOG als Programm und ein Aufruf als Maske: was anders ist, warum es keinen gibt.

jog-differs-expected = Der Zyklus erwartet das Werkstück bis { $reach } mm neben der Sollposition; weiter weg kommt 61301 oder 61303. JOG sucht von dort aus, wo der Messtaster steht.
jog-differs-stand = Der Zyklus nimmt den Ort des Messtasters beim Aufruf als Sollposition und misst auf Linien durch ihn. JOG misst dort, wohin der Messtaster verfahren wurde; die Sollposition ist ein Feld.
jog-differs-points = Der Zyklus fährt selbst von Punkt zu Punkt und tastet an eigenen Stellen an.
jog-differs-up = Zwischen den Punkten hebt der Messtaster um { $path } mm ab (_ID). JOG kennt die Höhe des Werkstücks nicht: prüfen, ob das reicht.
jog-differs-fourth = Der Zyklus braucht einen vierten Punkt: zwischen P3 und der Ecke.
jog-differs-around = Der Zyklus fährt auf Messhöhe um den Zapfen. In JOG fährt der Messtaster darüber.
jog-differs-angle = Der Zyklus misst Winkel bis 45°; darüber kommt 61331.
jog-differs-skew = JOG stellt die Kugel, nicht die Spindelachse, vor den Punkt. An einer schrägen Kante tastet der Zyklus um die Lageabweichung des Messtasters daneben an.
jog-differs-corner-zero = Der Zyklus macht die Ecke zum Nullpunkt beider Achsen. Die Sollpositionen der Maske haben darin keinen Platz.
jog-differs-fine = JOG schreibt grob und löscht fein. Der Zyklus korrigiert fein; mit _CHBIT[21] = 1 macht er es wie JOG.
jog-differs-active = Was der Zyklus schreibt, wirkt, sobald das Programm die Nullpunktverschiebung wieder aufruft. JOG aktiviert sofort oder im Aktivierungsbild.
jog-differs-tool-data = Der Zyklus nimmt Werkzeugmesstaster und Drehzahlen aus eigenen Daten (_TP, _CM), JOG aus E_MESS_MT_… und E_MESS_….
jog-differs-spindle = Bei gedrehtem WKS folgt die Spindel im Zyklus, wie { $cycle } = { $there } angibt (1: sie folgt), in JOG, wie { $jog } = { $here } angibt (0: sie folgt).
jog-differs-tilted = Im geneigten WKS bleibt die Spindel im Zyklus stehen, obwohl _CHBIT[13] = 1 ist. In JOG folgt sie.
jog-differs-tool-memory = Der Zyklus schreibt, wie { $cycle } = { $there } angibt, JOG, wie { $jog } = { $here } angibt: 0 Geometrie, 1 Verschleiß.
jog-differs-input = Der Zyklus liest den Messtaster an einem anderen Eingang ({ $cycle } = { $there }) als JOG ({ $jog } = { $here }): 0 Eingang 1, 1 Eingang 2.
jog-differs-watched = Mit { $cycle } = { $there } überwacht der Zyklus den Weg zwischen den Punkten nicht (61302) und fährt ihn im Eilgang. JOG überwacht ihn immer.
jog-differs-attempts = Ohne Schaltsignal versucht es der Zyklus, wie { $cycle } = { $there } angibt, JOG, wie { $jog } = { $here } angibt: 0 fünfmal, 1 einmal.
jog-differs-attempts-tool = Ohne Schaltsignal versucht es der Zyklus fünfmal ({ $cycle } = { $there }). JOG tastet einen Werkzeugmesstaster einmal an.
jog-differs-return = Der Zyklus fährt vom Punkt zurück, wie { $cycle } = { $there } angibt, JOG, wie { $jog } = { $here } angibt: 0 mit Positioniervorschub, 1 im Eilgang.
jog-differs-return-tool = Der Zyklus fährt vom Punkt im Eilgang zurück ({ $cycle } = { $there }), JOG mit Positioniervorschub.
jog-differs-touches = Der Zyklus tastet an, wie { $cycle } = { $there } angibt, JOG, wie { $jog } = { $here } angibt: 0 einmal, 1 zuerst schnell mit _SPEED[3].
jog-differs-touches-tool = Der Zyklus tastet zuerst schnell mit _SPEED[3] an ({ $cycle } = { $there }). JOG hat für Werkzeuge eigene Vorschübe.
jog-differs-screen = Mit { $cycle } = { $there } zeigt der Zyklus sein Messergebnisbild und wartet bei _CHBIT[11] = 1 auf NC-Start. JOG zeigt die Ergebnisse in der Maske.
jog-differs-repeats = Mit { $cycle } = { $there } misst der Zyklus außerhalb seiner Grenzen bis zu viermal erneut, bei _CBIT[1] = 1 nach M0. JOG hat keine Grenzen.
jog-differs-offset-angle = Mit { $cycle } = { $there } dreht der Zyklus den Monotaster zusätzlich um _CORA. JOG tut das nicht.
jog-differs-speeds = Mit { $cycle } = { $there } nimmt der Zyklus bei drehendem Werkzeug Drehzahlen und Vorschübe aus _MFS[]. JOG berechnet sie aus E_MESS_MAX_V und anderen.
jog-differs-erases = Mit { $cycle } = { $there } löscht der Zyklus zuerst _WP[], _TP[] und weitere Daten der Messtaster. JOG behält sie.
jog-differs-watches-calibration = Mit { $cycle } = { $there } misst der Zyklus auch mit einem anders kalibrierten Messtaster. JOG lehnt ihn ab (61341).
jog-differs-feeds = Zwischen den Punkten fährt der Zyklus mit _SPEED[1] = { $plane } mm/min und _SPEED[2] = { $depth } mm/min, JOG mit E_MESS_F = { $feed } und E_MESS_FZ = { $infeed }.
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
