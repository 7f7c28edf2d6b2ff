# CYCLE978: Titel, Suchwörter, Varianten.

cycle978-title = Fläche
cycle978-help = Misst einen Punkt einer Fläche senkrecht zu einer Achse. Der Messtaster startet gegenüber der Fläche, weiter entfernt als der Messweg; die Seite, auf der er steht, bestimmt die Messrichtung.
cycle978-words = messen vermessen antasten ankratzen Werkstück Fläche Kante Planfläche Ebene Wand Punkt Position Einzelpunkt Werkzeugkorrektur Verschleiß Nullpunkt setzen Nullpunktverschiebung NV NPV achsparallel Differenzmessung Taster Messtaster Kantentaster Höhe Oberfläche Z Bezugspunkt anfahren
cycle978-each-words = ein Punkt Kante Planfläche Höhe Oberfläche Kantentaster

cycle978-tool = Fläche, Werkzeug korrigieren
cycle978-zero = Fläche, NV korrigieren
cycle978-differential-tool = Fläche mit Differenzmessung, Werkzeug korrigieren
cycle978-differential-zero = Fläche mit Differenzmessung, NV korrigieren
cycle978-measured = Fläche, nur messen
