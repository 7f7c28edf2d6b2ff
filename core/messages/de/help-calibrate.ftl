# Hilfeseiten der Zyklen, die einen Werkstückmesstaster kalibrieren.

help-cycle976-measures-hole = Die Triggerpunkte des Messtasters in der Ebene, an der Wand eines Kalibrierrings oder einer Bohrung mit bekanntem Durchmesser _SETVAL.
help-cycle976-measures-one = Eine Richtung einer Achse: _MA und _MD.
help-cycle976-measures-two = Beide Richtungen der Achse _MA.
help-cycle976-measures-four = Beide Richtungen beider Achsen.
help-cycle976-measures-centre = Der Zyklus ermittelt auch den Mittelpunkt des Rings.
help-cycle976-measures-surface = Der Triggerpunkt des Messtasters in einer Richtung einer Achse, an einer Fläche bei _SETVAL.
help-cycle976-measures-length = Die Länge L1 des Messtasters und sein Triggerpunkt in der Werkzeugachse, an einer Fläche bei _SETVAL.
help-cycle976-before-at-centre = Die Spindelachse steht genau im Mittelpunkt der Bohrung, die Kugel auf Kalibriertiefe.
help-cycle976-before-near-centre = Die Kugel steht auf Kalibriertiefe nahe dem Mittelpunkt; der Abstand dazu ist nicht größer als _FA.
help-cycle976-before-spindle = Die Spindel lässt sich positionieren, und der Messtaster darf mit ihr auf jeden Winkel von 0 bis 360° drehen.
help-cycle976-before-opposite = Die Kugel steht der Fläche gegenüber, weiter entfernt als _FA.
help-cycle976-before-within = Die Fläche liegt innerhalb von zweimal _FA vor der Kugel; L1 des Messtasters darf unbekannt sein.
help-cycle976-before-radius = Der Kugelradius ist in den Werkzeugdaten des Messtasters eingetragen; keine Spiegelung ist aktiv.
help-cycle976-order-one = Der Zyklus tastet die Wand einmal an, von der Startposition aus.
help-cycle976-order-two = Plus-Richtung von _MA, zurück durch den Mittelpunkt, dann Minus-Richtung.
help-cycle976-order-four = Abszisse plus und minus, dann Ordinate plus und minus, jedes Mal zurück durch den Mittelpunkt.
help-cycle976-order-angle = Alle Richtungen sind um _STA1 gedreht; beide Achsen fahren gleichzeitig.
help-cycle976-order-twice = Alles zweimal, beim Multitaster zuerst mit um 180° gedrehter Spindel: Die halbe Differenz der beiden Mittelpunkte ist dann die Lageabweichung, ihr Mittelwert der Mittelpunkt.
help-cycle976-order-no-approach = Der Zyklus tastet von der Startposition aus in Richtung _MD an, über höchstens zweimal _FA, und fährt zurück.
help-cycle976-order-end-centre = Endposition: die Startposition im Mittelpunkt.
help-cycle976-order-end-found = Endposition: der ermittelte Mittelpunkt.
help-cycle976-order-end-surface = Endposition: die Startposition, bei _MA=3 im Abstand _FA vor der Fläche.
help-cycle976-corrects-ball = Auch der wirksame Kugeldurchmesser _WP[k,0], den CYCLE979 und, bei Messung unter Winkel, CYCLE997 brauchen; mit _CBIT[15]=1 auch der Radius des Messtasters.
help-cycle976-corrects-skew = Auch die Lageabweichung des Taststifts, _WP[k,7] und _WP[k,8].
help-cycle976-corrects-length = Der Zyklus korrigiert L1 in der Geometrie des Messtasters um die Differenz; _TSA überwacht sie nicht.
help-cycle976-wrong-off-centre = Die Spindel steht nicht im Mittelpunkt: Dieser Fehler geht in alle Triggerpunkte ein und in jede später gemessene Position.
help-cycle976-wrong-diameter = _SETVAL ist nicht der wahre Durchmesser des Rings: Der halbe Fehler geht in jeden Triggerpunkt ein.
help-cycle976-wrong-position = _SETVAL ist nicht die tatsächliche Position der Fläche im aktiven Koordinatensystem.

help-cycle973-measures-surface = Der Triggerpunkt des Messtasters in einer Richtung einer Achse, an einer Werkstückfläche bei _SETVAL.
help-cycle973-measures-groove-one = Der Triggerpunkt des Messtasters in einer Richtung, an einer Wand oder am Boden einer Kalibriernut.
help-cycle973-measures-groove-two = Die Triggerpunkte des Messtasters in beiden Richtungen einer Achse, an beiden Wänden einer Kalibriernut.
help-cycle973-before-surface = Der Messtaster hat Schneidenlage 5 bis 8 und steht der Fläche gegenüber, weiter entfernt als _FA.
help-cycle973-before-groove = Der Messtaster hat Schneidenlage 7 oder 8; von der Startposition aus ist die Kalibriernut _CALNUM achsparallel auf freiem Weg erreichbar.
help-cycle973-before-centre = L1 und L2 des Messtasters beziehen sich auf die Kugelmitte, der Kugelradius ist in den Werkzeugdaten eingetragen.
help-cycle973-order-surface = Nur die Messachse _MA verfährt, in Richtung _MD; Endposition: _FA vor der Fläche.
help-cycle973-order-into-groove = Es gelten Maschinenkoordinaten. Der Messtaster fährt achsparallel über die Mitte der Nut und in sie hinein.
help-cycle973-order-one = Der Zyklus tastet in Achse _MA und Richtung _MD an; am Nutboden ist nur die Minus-Richtung möglich.
help-cycle973-order-two = Der Zyklus tastet die Wand in Plus-Richtung an, fährt durch die Nut und tastet die Wand in Minus-Richtung an.
help-cycle973-order-end-groove = Endposition: in der Nut, _FA vor der zuletzt angetasteten Fläche.
help-cycle973-corrects-ball = Auch der wirksame Kugeldurchmesser _WP[k,0].
help-cycle973-corrects-skew = Auch die Lageabweichung in der Messachse, _WP[k,7] oder _WP[k,8].
help-cycle973-wrong-groove-data = Die Nutdaten in _KB sind in X als Durchmesser eingetragen: Nötig sind Radien.
help-cycle973-wrong-position = Die Schneidenlage des Messtasters ist nicht 7 oder 8: Alarm 61315.
help-cycle973-wrong-shank = In dieser Richtung würde der Tastschaft statt der Kugel antasten.
