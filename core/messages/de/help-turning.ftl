# Hilfeseiten der Zyklen, die an Drehmaschinen ein Werkstück messen.

help-turning-probe = Der Messtaster (Typ 5xy) ist in Arbeitsstellung, seine D-Nummer und G40 sind aktiv; weder Drehung noch Maßstabsfaktor ist aktiv.
help-turning-diameter = Durchmesser und Radien sind verwechselt: Mit DIAMON sind Sollwert und, beim Messen, Toleranzen in X Durchmesser; _FA, Triggerpunkte und Korrektur nicht.

help-cycle974-measures-point = Die Position eines Punkts am Drehteil: ein von einer Seite gemessener Durchmesser, eine Stirnfläche oder ein Punkt in der 3. Achse.
help-cycle974-before-opposite = Die Kugel steht dem Punkt gegenüber, weiter entfernt als _FA; von dort misst der Zyklus in Richtung _SETVAL.
help-cycle974-before-chuck = Die Hauptspindel, in der das Werkstück gespannt ist, lässt sich positionieren.
help-cycle974-order-axis = Der Messtaster fährt nur in der Messachse; Endposition: _FA vor der Fläche.
help-cycle974-order-reversal = Die Spindel fährt auf _STA1, der Zyklus tastet an; die Spindel dreht um 180°, der Zyklus tastet erneut an. Der Mittelwert gilt: Die Rundlaufabweichung hebt sich auf.
help-cycle974-corrects-half = Eine Länge wird um die Abweichung in ihrer Achse korrigiert, bei einem Durchmesser also um dessen halbe Abweichung.
help-cycle974-corrects-one-axis = Nur die Messachse wird korrigiert; mit _CHBIT[19]=1 in G18 X statt Y.
help-cycle974-wrong-side = Die Startposition liegt auf der falschen Seite oder näher als _FA an der Fläche.
help-cycle974-wrong-run-out = Das Werkstück läuft nicht rund: Das Ergebnis hängt von der Spindelstellung ab. Für eine Werkzeugkorrektur mit Umschlag messen.

help-cycle994-measures-diameter = Ein Durchmesser eines Drehteils um den Werkstücknullpunkt, aus zwei gegenüberliegenden Punkten.
help-cycle994-before-plus-side = Die Kugel steht dem Punkt auf der Plus-Seite gegenüber, weiter entfernt als _FA.
help-cycle994-before-inside = Die Kugel steht in der Bohrung; _SZA und _SZO beschreiben das Hindernis dort, Kugelradius eingerechnet.
help-cycle994-before-either = Die Startposition entscheidet: Liegt sie weiter außen als der Sollwert, misst der Zyklus außen und umfährt die Schutzzone _SZA und _SZO (Kugelradius eingerechnet), sonst misst er innen.
help-cycle994-before-calibrated = Der Messtaster ist in dieser Ebene und in den Messrichtungen mit demselben Vorschub kalibriert; mit _CHBIT[7]=1 genügt der gespeicherte Kugeldurchmesser.
help-cycle994-order-plus-first = Der Zyklus tastet zuerst den Punkt auf der Plus-Seite an, dann den auf der Minus-Seite; Endposition: _FA vor diesem.
help-cycle994-order-round-inside = In der Bohrung fährt der Messtaster an der Schutzzone entlang: auf _SZO, weiter auf _SZA, hinüber und zurück (bei _MA=1 zuerst auf _SZA).
help-cycle994-order-round-outside = Außen fährt der Messtaster auf _SZO heraus, weiter auf _SZA, hinüber und zurück (bei _MA=1 zuerst auf _SZA); innen fährt er gerade durch die Bohrung.
help-cycle994-corrects-half = Eine Länge wird um die halbe Abweichung des Durchmessers korrigiert.
help-cycle994-wrong-zone = Die Schutzzone stammt von einem früheren Aufruf oder lässt der Kugel keinen Platz: Der Messtaster kollidiert mit dem Werkstück (Alarm 61302), oder es bleibt kein Weg (Alarm 61334).
help-cycle994-wrong-ball = Mit _CHBIT[7]=1 gilt der gespeicherte Kugeldurchmesser statt der beiden Triggerpunkte: Er muss stimmen.
