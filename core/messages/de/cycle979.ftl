# CYCLE979: Titel, Suchwörter, Varianten, Texte der eigenen Parameter, Prüfungen und Ergebnisse.

cycle979-title = Bohrung, Welle, Nut, Steg unter Winkel
cycle979-help = Misst Maß und Mitte unter einem Winkel zu den Achsen: Bohrung, Welle oder Kreissegment an drei oder vier Punkten eines Kreises; Nut oder Steg entlang einer schrägen Linie.
cycle979-words = messen vermessen antasten Werkstück Bohrung Loch Bohrungsmitte Welle Zapfen Kreiszapfen Nut Steg Rippe Segment Kreissegment Bogen Winkel schräg Durchmesser Breite Mitte Mittelpunkt drei vier Punkte innen außen Werkzeugkorrektur Verschleiß Nullpunkt setzen Nullpunktverschiebung NV NPV Taster Messtaster zentrieren Teilkreis Bezugspunkt
cycle979-each-words = Winkel schräg Segment Bogen

cycle979-hole-tool = Bohrung unter Winkel, Werkzeug korrigieren
cycle979-shaft-tool = Welle unter Winkel, Werkzeug korrigieren
cycle979-groove-tool = Nut unter Winkel, Werkzeug korrigieren
cycle979-web-tool = Steg unter Winkel, Werkzeug korrigieren
cycle979-hole-zero = Bohrung unter Winkel, NV korrigieren
cycle979-shaft-zero = Welle unter Winkel, NV korrigieren
cycle979-groove-zero = Nut unter Winkel, NV korrigieren
cycle979-web-zero = Steg unter Winkel, NV korrigieren

prnum-points = Punkte auf dem Kreis
prnum-three = drei Punkte
prnum-four = vier Punkte
param-setval-width-angle = Sollbreite
param-setval-width-angle-help = Breite aus der Zeichnung, quer zur Nut oder zum Steg, unter dem Winkel _STA1.
param-sta1-width = Richtung der Breite
param-sta1-width-help = Winkel zur Abszisse, unter dem die Breite gemessen wird; der erste Punkt liegt von der Mitte aus in dieser Richtung.
param-id-lift = Abhebeweg über den Steg
param-id-lift-help = Weg in der Werkzeugachse von der Messhöhe zur Höhe beim Überfahren, mit Vorzeichen. Bezieht sich die Messtasterlänge auf die Kugelmitte (_CBIT[14]=0), muss der Kugelradius darin enthalten sein.
param-prnum-with-points = Messtaster und Anzahl der Punkte
param-prnum-with-points-help = Drei oder vier Punkte auf dem Kreis, Messtastertyp, Nummer der Messtasterdaten in _WP.

need-lift = Der Messtaster muss den Steg überfahren.

check-points-unused = Die Anzahl der Punkte gilt nur für Bohrung und Welle.
check-points-unused-hint = Drei Punkte wählen: 0 in der 4. Stelle von _PRNUM.
check-path-centre = Der Messweg beginnt hinter dem Mittelpunkt: Von Punkt zu Punkt würde der Messtaster auf der Gegenseite fahren.
check-path-centre-hint = _FA kleiner als { $free } mm wählen.
check-lift = Der Messtaster hebt vor dem Überfahren des Stegs nicht ab.
check-lift-hint = Positiven Abhebeweg eingeben; liegt das Messtastergehäuse auf der Minus-Seite der Applikate, einen negativen.
check-lift-ball = Der Abhebeweg ist nicht größer als der Kugelradius, { $ball } mm, den er enthalten muss.
check-lift-ball-hint = Kugelradius addieren oder _CBIT[14]=1 setzen, wenn sich die Messtasterlänge auf den Kugelumfang bezieht.
