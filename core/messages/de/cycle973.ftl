# CYCLE973: Titel, Suchwörter, Messvarianten, Texte eigener Parameter und Prüfungen.

cycle973-title = Werkstückmesstaster kalibrieren (Drehen)
cycle973-help = Ermittelt, wo der Messtaster einer Drehmaschine schaltet, und speichert die Triggerpunkte in den Messtasterdaten _WP; alle späteren Messungen verwenden sie.
cycle973-words = kalibrieren Kalibrierung abgleichen eichen einmessen Werkstückmesstaster Messtaster Taster Drehen Drehmaschine Drehbank Kalibriernut Referenznut Kalibrierkörper Fläche Planfläche Triggerpunkt Triggerwert Schaltpunkt Kugeldurchmesser Lageabweichung Schieflage 3D-Taster Tastkugel
cycle973-each-words = Drehen Drehmaschine Triggerpunkt Schaltpunkt

cycle973-surface = Fläche: 1 Richtung
cycle973-groove-short = Kalibriernut: 1 Richtung, kurze Nummer
cycle973-groove-one = Kalibriernut: 1 Richtung
cycle973-groove-two = Kalibriernut: 2 Richtungen einer Achse
cycle973-groove-two-ball = Kalibriernut: 2 Richtungen einer Achse, Kugeldurchmesser
cycle973-groove-two-skew = Kalibriernut: 2 Richtungen einer Achse, Lageabweichung
cycle973-groove-two-skew-ball = Kalibriernut: 2 Richtungen einer Achse, Lageabweichung, Kugeldurchmesser

calibrate-groove = Kalibriernut
calibrate-groove-words = Kalibrierkörper Referenznut
calibrate-one-short = ohne Angabe: 1 Richtung, wie 1
calibrate-one-short-words = eine 13
calibrate-position = Lageabweichung

param-setval-surface-diameter = Durchmesser an der Fläche
param-setval-surface-diameter-help = Genaue Position der Fläche im WKS: mit DIAMON der Durchmesser, mit DIAMOF der Radius.
param-calnum = Kalibriernut
param-calnum-help = Nummer des Kalibrierkörpers (Nutpaar); seine Kanten und Nutböden stehen in _KB[n-1,…], in Maschinenkoordinaten, in X als Radien.

need-surface-position = Der Zyklus berechnet den Triggerpunkt aus der Position der Fläche.
need-groove = Die Kalibriernut bestimmt die Positionen der Antastungen.

check-groove-number = Eine Kalibriernut mit der Nummer { $number } gibt es nicht.
check-groove-number-hint = Nummer von 1 bis { $pairs } wählen oder weitere Datenfelder für Kalibrierkörper anlegen und { "_CVAL[2]" } erhöhen.
check-groove-tip-hint = In der Kalibriernut ist Schneidenlage 7 oder 8 nötig; andere Messtaster an einer Fläche kalibrieren.
check-groove-base = In dieser Achse hat die Kalibriernut nur den Nutboden: Nur die Minus-Richtung ist möglich.
check-groove-base-hint = Am Nutboden mit einer Richtung und { "_MD" }=1 kalibrieren; beide Richtungen gibt es nur an den Wänden, in der anderen Achse.
check-groove-empty = Die Kalibriernut ist nicht eingetragen (Wert 0): { $names }.
check-groove-empty-hint = Kanten und Nutboden in _KB[] im Datenbaustein GUD6 eintragen, in Maschinenkoordinaten und als Radien.
check-groove-edges = Die Kante in Plus-Richtung, { $plus }, ist nicht größer als die Kante in Minus-Richtung, { $minus }.
check-groove-edges-hint = Werte beider Kanten tauschen oder den fehlenden eintragen.
check-shank = Ein Taststift mit Schneidenlage { $tip } zeigt in die Gegenrichtung: Er würde mit dem Tastschaft antasten.
check-shank-hint = Richtung { "_MD" } umkehren oder Schneidenlage und Messachse prüfen.
