# CYCLE974: Titel, Suchwörter, Varianten, Texte der eigenen Parameter, Prüfungen und Ergebnisse.

cycle974-title = Drehteil: 1-Punkt-Messung
cycle974-help = Misst einen Punkt am Drehteil, außen oder innen, an Durchmesser, Stirnfläche oder in der 3. Achse, gegen den Sollwert aus der Zeichnung.
cycle974-words = messen vermessen antasten Werkstück drehen Drehmaschine Drehteil Durchmesser außen innen Absatz Schulter Stirnfläche Planfläche Länge ein Punkt Einzelpunkt X Z Y Planachse Umschlag Umschlagmessung Rundlauf Schlag Spindel Werkzeugkorrektur Verschleiß Nullpunkt setzen Nullpunktverschiebung NV NPV Taster Messtaster Außendurchmesser Innendurchmesser plan
cycle974-each-words = drehen Drehmaschine Durchmesser Stirnfläche Länge L1 L2

cycle974-tool = 1-Punkt-Messung, Werkzeug korrigieren
cycle974-zero = 1-Punkt-Messung, NV korrigieren
cycle974-reversal = 1-Punkt-Messung mit Umschlag, Werkzeug korrigieren

mvar-reversal = Umschlag
reversal-without = ohne
reversal-with = mit: 2. Antastung, Werkstück um 180° gedreht
reversal-with-words = Umschlag Spindel 180 Grad Rundlauf Schlag Exzentrizität gegenüber

param-setval-turned-diameter = Solldurchmesser
param-setval-turned-diameter-help = Aus der Zeichnung. Bei DIAMON der Durchmesser, bei DIAMOF der Radius.
param-setval-turned-position = Sollposition
param-setval-turned-position-help = Position der Fläche aus der Zeichnung, im WKS, in der Messachse.
param-sta1-spindle = Spindelstellung
param-sta1-spindle-help = Winkel, auf den die Spindel das Werkstück für die erste Antastung dreht; die zweite liegt 180° weiter.

need-angle-reversal = Beim Umschlag positioniert der Zyklus die Spindel.

check-reversal-part = Beim Umschlag dreht der Zyklus das Werkstück um 180°, aber die Spindel lässt sich nicht positionieren.
check-reversal-part-hint = Ohne Umschlag messen oder auf einer Maschine, deren Hauptspindel sich positionieren lässt.

result-compensation-radius = Korrekturwert als Radius
