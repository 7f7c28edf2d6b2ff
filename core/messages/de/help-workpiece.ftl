# Hilfeseiten der Zyklen, die ein Werkstück auf Fräsmaschinen messen.

help-cycle961-measures-inside = Innenecke: Schnittpunkt der beiden Kanten und Drehung der Bezugskante (P1, P2).
help-cycle961-measures-outside = Außenecke: Schnittpunkt der beiden Kanten und Drehung der Bezugskante (P1, P2).
help-cycle961-measures-square = Ecke eines Rechtecks: Drei Punkte genügen, für die zweite Kante nimmt der Zyklus einen rechten Winkel an.
help-cycle961-measures-free = Der Winkel zwischen den Kanten ist unbekannt: Je Kante sind zwei Punkte nötig.
help-cycle961-measures-given = Vier Punkte, jeder durch seine Koordinaten vorgegeben.
help-cycle961-before-opposite = Der Messtaster steht auf Messtiefe gegenüber der Ecke, in der Tasche oder außerhalb des Werkstücks. Von dort sind alle Punkte erreichbar; _STA1 und _INCA sind auf 10° genau bekannt.
help-cycle961-before-above = Der Messtaster steht so hoch, dass alle Punkte auf geraden Wegen erreichbar sind. _ID ist die Zustellung von dort auf Messtiefe, mit Minusvorzeichen.
help-cycle961-before-multi = Der Messtaster schaltet in allen Richtungen der Ebene (Multitaster).
help-cycle961-order-three = P2 bei _SETV[0] auf der Bezugskante, P1 bei der Hälfte davon, dann P3 bei der Hälfte von _SETV[1] auf der zweiten Kante.
help-cycle961-order-four = P2 bei _SETV[0] auf der Bezugskante, P1 bei der Hälfte davon, dann auf der zweiten Kante P3 bei der Hälfte von _SETV[1] und P4 bei _SETV[1].
help-cycle961-order-in-plane = Alle Wege liegen auf Messtiefe, in der Tasche.
help-cycle961-order-passes = Von P1 nach P3 hebt der Messtaster um _ID ab, fährt über die Ecke und stellt wieder zu; mit _ID=0 fährt er über die Startposition um die Ecke herum.
help-cycle961-order-infeed = P2, P1, P3, P4: Über jedem Punkt stellt der Messtaster um _ID zu, tastet an, fährt zurück und hebt ab.
help-cycle961-order-toward-pocket = Jede Antastung ist vom anderen Punktepaar weg gerichtet.
help-cycle961-order-toward-part = Jede Antastung ist zu der Seite gerichtet, auf der das andere Punktepaar liegt.
help-cycle961-order-along-axis = Jede Antastung liegt parallel zu einer Achse des aktiven Koordinatensystems, höchstens zweimal _FA lang; für ein kleineres _FA gilt der Mindestwert des Zyklus, 20 mm oder mehr.
help-cycle961-order-end-p4 = Endposition: über P4, auf Starthöhe.
help-cycle961-corrects-absolute = Mit _KNUM größer 0 diese NV, Grobverschiebung, absolut: Die Ecke wird zum Nullpunkt der Ebene, die Abszisse liegt auf der Bezugskante. Feinverschiebung gelöscht, Applikate unverändert.
help-cycle961-corrects-choice = Mit _SETV[4]=2 liegt der Nullpunkt um _SETV[2] neben der Ecke, mit 4 um _SETV[3], mit 3 um beide Werte.
help-cycle961-wrong-angle = Die Kanten weichen um mehr als 10° von _STA1 und _INCA ab: Ein Punkt verfehlt seine Kante, Alarm 61301.
help-cycle961-wrong-not-opposite = Die Startposition liegt nicht gegenüber der Ecke: Der Zyklus sucht P3 neben der Kante.
help-cycle961-wrong-swapped = P1 und P2 sind vertauscht: Das Koordinatensystem ist danach um 180° gedreht.
help-cycle961-wrong-same-points = Zwei Punkte einer Kante sind identisch (Alarm 61367) oder die Kanten sind parallel (Alarm 61368).

help-cycle977-measures-hole = Durchmesser und Mittelpunkt einer Bohrung.
help-cycle977-measures-shaft = Durchmesser und Mittelpunkt einer Welle.
help-cycle977-measures-groove = Breite und Mitte einer Nut in der Achse _MA.
help-cycle977-measures-web = Breite und Mitte eines Stegs in der Achse _MA.
help-cycle977-measures-pocket = Beide Längen und der Mittelpunkt eines achsparallelen Rechtecks innen.
help-cycle977-measures-island = Beide Längen und der Mittelpunkt eines achsparallelen Rechtecks außen.
help-cycle977-before-centre = Der Messtaster steht im Sollmittelpunkt oder darüber: Mit dieser Position in der Ebene vergleicht der Zyklus den ermittelten Mittelpunkt.
help-cycle977-before-middle = Der Messtaster steht in der Sollmitte oder darüber: Mit dieser Position in _MA vergleicht der Zyklus die ermittelte Mitte.
help-cycle977-before-depth = Die Messtasterkugel ist auf Messhöhe.
help-cycle977-before-above = Die Messtasterkugel ist so hoch über dem Messelement, dass sie frei darüberfährt. _ID ist die Zustellung von dort auf Messhöhe, abwärts mit Minusvorzeichen.
help-cycle977-before-zone-inside = _SZA ist das Maß des Hindernisses in der Mitte, das der Messtaster nicht berühren darf.
help-cycle977-before-zone-outside = _SZA ist das Maß des freien Raums samt Messelement.
help-cycle977-before-zone-lengths = _SZA gilt in der Abszisse, _SZO ebenso in der Ordinate.
help-cycle977-order-two-axes = Abszisse: Plus-Seite, dann Minus-Seite. Danach zur Mitte zwischen beiden, dann Ordinate: Plus-Seite, Minus-Seite.
help-cycle977-order-one-axis = Die Plus-Seite in _MA, dann die Minus-Seite.
help-cycle977-order-straight = Alle Wege sind gerade und liegen auf Messhöhe.
help-cycle977-order-outwards = Der Messtaster tastet nach außen an, von der Mitte zur Wand.
help-cycle977-order-inwards = An jedem Punkt fährt der Messtaster neben das Messelement, stellt um _ID zu, tastet zur Mitte hin an, fährt zurück, hebt ab und fährt über das Messelement hinweg.
help-cycle977-order-over-zone = Von Punkt zu Punkt hebt der Messtaster um _ID ab und fährt über das Hindernis in der Mitte.
help-cycle977-order-less-room = Lässt die Schutzzone weniger Platz, verkürzt der Zyklus _FA so weit, dass die Messtasterkugel noch passt.
help-cycle977-order-diameter = Der Durchmesser ergibt sich aus den Antastungen in der Ordinate; sie gehen durch den in der Abszisse ermittelten Mittelpunkt.
help-cycle977-order-lengths = Jede Länge und jede Koordinate des Mittelpunkts ergibt sich aus den beiden Antastungen ihrer Achse.
help-cycle977-order-end = Endposition: in der ermittelten Mitte oder darüber, auf Starthöhe.
help-cycle977-corrects-half = Einen Radius korrigiert der Zyklus um die halbe Abweichung des Maßes.
help-cycle977-corrects-mean = Die größere der beiden Längenabweichungen bestimmt, ob korrigiert wird; der Mittelwert beider bestimmt, um wie viel.
help-cycle977-corrects-both-axes = Der Zyklus korrigiert beide Achsen der Ebene.
help-cycle977-corrects-one-axis = Der Zyklus korrigiert nur _MA.
help-cycle977-wrong-depth = Die Messtasterkugel ist zu hoch: Sie trifft eine Fase oder nichts.
help-cycle977-wrong-infeed = _ID hat das falsche Vorzeichen oder ist zu kurz: Die Messtasterkugel fährt über das Messelement hinweg. Zu lang: Sie trifft auf den Grund, Alarm 61302.
help-cycle977-wrong-zone = Die Schutzzone lässt der Messtasterkugel keinen Platz: Alarm 61334.
help-cycle977-wrong-start = Die Startposition ist nicht die Sollmitte: Der Fehler geht in die NV ein.

help-cycle978-measures-point = Position eines Punkts auf einer Fläche senkrecht zur Achse _MA.
help-cycle978-before-opposite = Die Messtasterkugel steht gegenüber dem Punkt, weiter als _FA von der Fläche entfernt. Die Seite, auf der sie steht, bestimmt die Messrichtung.
help-cycle978-order-axis = Nur _MA verfährt; Endposition: _FA vor der Fläche.
help-cycle978-corrects-full = Länge oder Radius korrigiert der Zyklus um die ganze Abweichung.
help-cycle978-corrects-one-axis = Der Zyklus korrigiert nur _MA; vorher subtrahiert er den Erfahrungswert aus _EVNUM vom Istwert (mit _CHBIT[5]=1 addiert er ihn).
help-cycle978-wrong-side = Die Messtasterkugel steht auf der falschen Seite: Sie fährt von der Fläche weg.
help-cycle978-wrong-oblique = Die Fläche steht nicht senkrecht zu _MA: Die Kugel tastet nicht mit ihrem Scheitel an; das Ergebnis ist dadurch falsch.

help-cycle979-measures-hole = Durchmesser und Mittelpunkt einer Bohrung oder eines Kreissegments davon, aus Punkten auf dem Kreis.
help-cycle979-measures-shaft = Durchmesser und Mittelpunkt einer Welle oder eines Kreissegments davon, aus Punkten auf dem Kreis.
help-cycle979-measures-groove = Breite einer schräg liegenden Nut und ihre Mitte auf der Linie unter _STA1.
help-cycle979-measures-web = Breite eines schräg liegenden Stegs und seine Mitte auf der Linie unter _STA1.
help-cycle979-before-near = Die Messtasterkugel steht auf Messhöhe nahe P1, weiter als _FA von der Kontur entfernt; der gerade Weg zu P1 ist frei. P1 liegt vom Sollmittelpunkt _CPA, _CPO aus unter dem Winkel _STA1.
help-cycle979-before-ball = Der wirksame Kugeldurchmesser des Messtasters ist kalibriert (CYCLE976 mit Kugeldurchmesser).
help-cycle979-order-circle = Drei Punkte (vier, wenn die 4. Stelle von _PRNUM 1 ist), jeder um _INCA weiter; dazwischen fährt der Messtaster mit _RF auf einem Kreisbogen.
help-cycle979-order-outwards = Jede Antastung ist vom Sollmittelpunkt weg gerichtet.
help-cycle979-order-inwards = Jede Antastung ist zum Sollmittelpunkt hin gerichtet.
help-cycle979-order-across = P1, gerade auf der Linie zur anderen Wand, P2, alles auf Messhöhe.
help-cycle979-order-over = P1, um _ID abheben, auf der Linie über den Steg, wieder zustellen, P2.
help-cycle979-order-fit = Der Kreis durch alle Punkte ergibt Durchmesser und Mittelpunkt.
help-cycle979-order-end = Endposition: _FA vor dem letzten Punkt, auf Messhöhe.
help-cycle979-corrects-half = Einen Radius korrigiert der Zyklus um die halbe Abweichung von Durchmesser oder Breite.
help-cycle979-corrects-both = Der Zyklus korrigiert beide Achsen der Ebene; bei Nut und Steg so weit, wie sich die Mitte auf der Linie verschoben hat.
help-cycle979-wrong-arc = Der Kreisbogen neben einem Kreissegment trifft das Werkstück: Alarm 61302.
help-cycle979-wrong-close = Die Punkte liegen dicht beieinander: Ein kleiner Fehler an einem Punkt verschiebt den Mittelpunkt um ein Vielfaches. _INCA so groß wählen, wie es das Kreissegment zulässt.
help-cycle979-wrong-speed = _RF ist 0: Alarm 61365.
help-cycle979-wrong-skewed = Die Linie unter _STA1 steht nicht senkrecht zu den Wänden: Die gemessene Breite ist zu groß.
help-cycle979-wrong-lift = _ID ist zu kurz; bezieht sich die Messtasterlänge auf die Kugelmitte (_CBIT[14]=0), muss _ID den Kugelradius enthalten.

help-cycle997-measures-one = Mittelpunkt einer Kugel.
help-cycle997-measures-three = Mittelpunkte von drei Kugeln, daraus Verschiebung und Drehung des Werkstücks.
help-cycle997-measures-diameter = Durchmesser jeder Kugel.
help-cycle997-before-above = Die Messtasterkugel steht auf Sicherheitshöhe über dem Sollmittelpunkt von Kugel 1; auf dieser Höhe ist jede Kugel ohne Berührung erreichbar.
help-cycle997-before-ball = CYCLE976 hat vorher den wirksamen Kugeldurchmesser des Messtasters ermittelt.
help-cycle997-before-frame = Die aktive NV ist so genau, dass jede Kugel höchstens um _FA von ihrer Sollposition abweicht; kein Maßstabsfaktor ist aktiv, bei drei Kugeln auch keine Spiegelung.
help-cycle997-order-paraxial = Auf Höhe des Sollmittelpunkts: Abszisse Plus- und Minus-Seite, dann durch die ermittelte Mitte Ordinate Plus- und Minus-Seite; zwischen den Punkten fährt der Messtaster _FA über der Kugel.
help-cycle997-order-three-points = Auf Höhe des Sollmittelpunkts: drei Punkte, der erste unter _STA1, jeder folgende um _INCA weiter, dazwischen Kreisbögen mit _RF.
help-cycle997-order-four-points = Auf Höhe des Sollmittelpunkts: vier Punkte, der erste unter _STA1, jeder folgende um _INCA weiter, dazwischen Kreisbögen mit _RF.
help-cycle997-order-top = Danach der oberste Punkt, über dem eben ermittelten Mittelpunkt.
help-cycle997-order-diameter = Ein weiterer Punkt auf Höhe des ermittelten Mittelpunkts, in Plus-Richtung der Abszisse, ergibt den Durchmesser.
help-cycle997-order-repeat = Der Zyklus misst die ganze Kugel noch einmal, vom ermittelten Mittelpunkt aus.
help-cycle997-order-next = Kugel 2 und Kugel 3 folgen ebenso; der Weg zur nächsten Kugel liegt auf Sicherheitshöhe.
help-cycle997-order-end = Endposition: auf Sicherheitshöhe über der letzten Kugel.
help-cycle997-corrects-shift = Die NV aus _KNUM, in allen drei Achsen: Die Kugel erhält ihre Sollkoordinaten; die Drehung der NV bleibt. _KNUM=0 korrigiert nichts.
help-cycle997-corrects-turn = Mit _KNUM größer 0 diese NV, Grobverschiebung und Drehung: Danach liegen die drei Kugeln auf ihren Sollpositionen. Verzerrung über _TNVL: Alarm 61414, keine Korrektur.
help-cycle997-corrects-area = Jede Differenz über _TSA hält das Programm mit Alarm 61303 an.
help-cycle997-wrong-holder = Der Halter der Kugel steht dort, wo ein Messpunkt liegt oder der Messtaster zustellt.
help-cycle997-wrong-no-ball = Der Messtaster wurde ohne Kugeldurchmesser kalibriert: Fehlt der Wert, folgt Alarm 61341; ein falscher Wert verschiebt jede Anfahrposition an der Kugel.
help-cycle997-wrong-line = Die Sollmittelpunkte liegen auf einer Geraden: Alarm 61411.

help-cycle998-measures-one = Ein Winkel: Drehung einer geraden Kante oder Fläche gegen eine Achse, aus zwei Punkten.
help-cycle998-measures-two = Zwei Winkel: Neigung einer Ebene um Abszisse und Ordinate, aus drei Punkten.
help-cycle998-before-opposite = Die Messtasterkugel steht gegenüber P1, weiter als _FA von _SETVAL entfernt; P2 folgt im Abstand _ID in Plus-Richtung der Versatzachse.
help-cycle998-before-both-near = Die Messtasterkugel steht gegenüber P1; beide Punkte liegen in der Messachse höchstens zweimal _FA von dieser Position entfernt.
help-cycle998-before-over = Die Messtasterkugel steht über P1, so hoch, dass P2 (_ID weiter in der Abszisse) und P3 (_SETV[0] weiter in der Ordinate) erreichbar sind.
help-cycle998-order-one-angle = P1, Weg zu P2 unter dem Sollwinkel _STA1, um den Winkel _TSA von der Fläche weggeneigt, dann P2.
help-cycle998-order-one-paraxial = P1 in Richtung _MD, zurück zur Startposition, um _ID in der Versatzachse, dann P2; _SETVAL wird nicht verwendet.
help-cycle998-order-two-angle = P1, Weg unter dem Sollwinkel zu P2, auf demselben Weg zurück, Weg unter dem anderen Sollwinkel zu P3; jeder Weg ist um den Winkel _TSA von der Fläche weggeneigt.
help-cycle998-order-two-paraxial = P1, P2 und P3, immer von der Starthöhe aus: in der Abszisse weiter, zurück, in der Ordinate weiter.
help-cycle998-order-end = Endposition: _FA vor dem letzten Punkt.
help-cycle998-order-end-height = Endposition: über P3, auf Starthöhe.
help-cycle998-corrects-rotation = Die Drehung der NV aus _KNUM (ein Winkel: mit _RA=0), um Istwinkel minus Sollwinkel. Die Verschiebung bleibt: Position danach messen. _KNUM=0 korrigiert nichts.
help-cycle998-corrects-axis = Mit _RA größer 0 stattdessen die NV dieser Rundachse; danach die Rundachse verfahren.
help-cycle998-corrects-area = Weicht ein Winkel um mehr als _TSA (in °) vom Sollwinkel ab: Alarm 61303.
help-cycle998-wrong-degrees = _TSA enthält noch einen Wert in mm aus einem anderen Zyklus; hier ist die Einheit °.
help-cycle998-wrong-near = Die Punkte liegen dicht beieinander: 0.01 mm Grat auf 10 mm sind 0.06°.
help-cycle998-wrong-limit = Das Werkstück ist um mehr als 45° gedreht: Das kann der Zyklus nicht messen; ein _STA1 über 45° löst Alarm 61331 aus.
help-cycle998-wrong-path = Ein Punkt liegt in der Messachse mehr als zweimal _FA von der Startposition entfernt: Der Messtaster schaltet dort nicht, Alarm 61301.
