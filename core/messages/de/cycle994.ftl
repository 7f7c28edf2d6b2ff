# CYCLE994: Titel, Suchwörter, Messvarianten, Texte eigener Parameter, Prüfungen und Ergebnisse.

cycle994-title = Drehteil: 2-Punkt-Messung
cycle994-help = Misst den Durchmesser eines Drehteils außen oder innen an zwei gegenüberliegenden Punkten, plus und minus Sollwert um den Werkstücknullpunkt, und korrigiert ein Werkzeug.
cycle994-words = messen Werkstück Antasten Vermessen Taster Drehen Drehmaschine Drehbank Drehteil Durchmesser Bohrung Welle Zapfen außen innen zwei 2 Punkte 2-Punkt gegenüber Schutzzone Sicherheitszone X Y Planachse Werkzeugkorrektur Verschleiß Außendurchmesser Innendurchmesser Messschraube

cycle994-inside-zone = Innenmessung mit Schutzzone
cycle994-inside-zone-words = Drehen Drehmaschine Bohrung Durchmesser zwei Punkte Schutzzone Hindernis Zapfen Werkzeugkorrektur Verschleiß
cycle994-outside-inside = Außenmessung mit Schutzzone oder Innenmessung ohne
cycle994-outside-inside-words = Drehen Drehmaschine Durchmesser Welle Bohrung zwei Punkte Schutzzone Werkzeugkorrektur Verschleiß

param-setval-two-diameter = Solldurchmesser
param-setval-two-diameter-help = Aus der Zeichnung. Mit DIAMON der Durchmesser, mit DIAMOF der Radius; beide Punkte liegen symmetrisch zum Werkstücknullpunkt.
param-setval-two-radius = Sollabstand vom Nullpunkt
param-setval-two-radius-help = Abstand beider Punkte vom Werkstücknullpunkt, einer in Plus- und einer in Minus-Richtung.
param-sza-turned = Schutzzone in der Abszisse
param-sza-turned-help = Grenze der Schutzzone in der 1. Achse der Ebene (G18: Z), ab Werkstücknullpunkt; auf ihr fährt die Kugelmitte: Kugelradius addieren, zum Durchmesser (X, DIAMON) Kugeldurchmesser.
param-szo-turned = Schutzzone in der Ordinate
param-szo-turned-help = Grenze der Schutzzone in der 2. Achse (G18: X); auf ihr fährt die Kugelmitte um die Zone: Radius plus Kugelradius, in X mit DIAMON Durchmesser plus Kugeldurchmesser.
param-szo-turned-applicate = Schutzzone in der Applikate
param-szo-turned-applicate-help = Grenze der Schutzzone in der 3. Achse (G18: Y); auf ihr fährt die Kugelmitte um die Zone: Radius plus Kugelradius, mit _CHBIT[19]=1 wie X.

need-zone-inside = Diese Messvariante umfährt eine Schutzzone.
need-zone-outside = Außen nötig; innen hat diese Messvariante keine Schutzzone: Feld dann leer lassen.

check-two-setpoint = Die beiden Punkte liegen bei plus und minus Sollwert: Bei { $set } mm ist kein Platz dazwischen.
check-two-setpoint-hint = Durchmesser oder Radius als Zahl größer als 0 eingeben.
check-two-ball = Ohne Kalibrierung ({ "_CHBIT[7]" }=1) gilt der Kugeldurchmesser { $name }, aber er ist nicht größer als 0.
check-two-ball-hint = Kugeldurchmesser eintragen ({ $name }) oder Messtaster kalibrieren und { "_CHBIT[7]" }=0 setzen.
check-two-zone-inside = Die Schutzzone, { $zone } mm, lässt der Kugel im Innenmaß, { $size } mm, keinen Platz.
check-two-zone-inside-hint = In der Messachse eine Schutzzone von höchstens { $limit } mm wählen.
check-two-no-zone = Ohne Schutzzone misst diese Messvariante innen; außen würde die Schutzzone eines früheren Aufrufs gelten.
check-two-no-zone-hint = Für eine Außenmessung { "_SZA" } und { "_SZO" } eingeben.
check-two-half-zone = Die Schutzzone ist unvollständig, { $name } fehlt: Es gilt der Wert eines früheren Aufrufs.
check-two-half-zone-hint = Außen sowohl _SZA als auch _SZO eingeben, innen keinen von beiden.
check-two-zone-outside = Außen würde die Kugel beim Vorbeifahren auf { $zone } mm das Werkstück, { $size } mm, berühren; innen gilt diese Schutzzone nicht.
check-two-zone-outside-hint = Außen eine Schutzzone von mindestens { $limit } mm wählen; innen leer lassen.

result-set-two = Sollwert Durchmesser/Radius
result-set-two-abscissa = Sollwert Durchmesser/Radius, Abszisse
result-set-two-ordinate = Sollwert Durchmesser/Radius, Ordinate
result-set-two-applicate = Sollwert Durchmesser/Radius, Applikate
result-actual-two = Istwert Durchmesser/Radius
result-actual-two-abscissa = Istwert Durchmesser/Radius, Abszisse
result-actual-two-ordinate = Istwert Durchmesser/Radius, Ordinate
result-actual-two-applicate = Istwert Durchmesser/Radius, Applikate
result-difference-two = Differenz Durchmesser/Radius
result-difference-two-abscissa = Differenz Durchmesser/Radius, Abszisse
result-difference-two-ordinate = Differenz Durchmesser/Radius, Ordinate
result-difference-two-applicate = Differenz Durchmesser/Radius, Applikate
