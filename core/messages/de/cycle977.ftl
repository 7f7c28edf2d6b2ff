# CYCLE977: Titel, Suchwörter, Varianten.

cycle977-title = Bohrung, Welle, Nut, Steg, Rechteck
cycle977-help = Ermittelt Maß und Mitte achsparallel, von der Sollmitte aus: zwei Antastungen bei Nut und Steg, sonst vier. Das Ergebnis korrigiert ein Werkzeug, eine Nullpunktverschiebung oder nichts.
cycle977-words = messen vermessen antasten Werkstück Bohrung Loch Bohrungsmitte Welle Zapfen Kreiszapfen Nut Steg Rippe Tasche Kreistasche Rechtecktasche Insel Rechteck Rechteckzapfen Durchmesser Breite Mitte Mittelpunkt innen außen Werkzeugkorrektur Verschleiß Nullpunkt setzen Nullpunktverschiebung NV NPV achsparallel Schutzzone Sicherheitszone Taster Messtaster Kantentaster zentrieren Passung Passfedernut Langloch Innendurchmesser Außendurchmesser Bezugspunkt

cycle977-hole-tool = Bohrung, Werkzeug korrigieren
cycle977-shaft-tool = Welle, Werkzeug korrigieren
cycle977-groove-tool = Nut, Werkzeug korrigieren
cycle977-web-tool = Steg, Werkzeug korrigieren
cycle977-pocket-tool = Rechteck innen, Werkzeug korrigieren
cycle977-island-tool = Rechteck außen, Werkzeug korrigieren
cycle977-hole-zero = Bohrung, NV korrigieren
cycle977-shaft-zero = Welle, NV korrigieren
cycle977-groove-zero = Nut, NV korrigieren
cycle977-web-zero = Steg, NV korrigieren
cycle977-pocket-zero = Rechteck innen, NV korrigieren
cycle977-island-zero = Rechteck außen, NV korrigieren
cycle977-hole-zone-tool = Bohrung mit Schutzzone, Werkzeug korrigieren
cycle977-shaft-zone-tool = Welle mit Schutzzone, Werkzeug korrigieren
cycle977-groove-zone-tool = Nut mit Schutzzone, Werkzeug korrigieren
cycle977-web-zone-tool = Steg mit Schutzzone, Werkzeug korrigieren
cycle977-pocket-zone-tool = Rechteck innen mit Schutzzone, Werkzeug korrigieren
cycle977-island-zone-tool = Rechteck außen mit Schutzzone, Werkzeug korrigieren
cycle977-hole-zone-zero = Bohrung mit Schutzzone, NV korrigieren
cycle977-shaft-zone-zero = Welle mit Schutzzone, NV korrigieren
cycle977-groove-zone-zero = Nut mit Schutzzone, NV korrigieren
cycle977-web-zone-zero = Steg mit Schutzzone, NV korrigieren
cycle977-pocket-zone-zero = Rechteck innen mit Schutzzone, NV korrigieren
cycle977-island-zone-zero = Rechteck außen mit Schutzzone, NV korrigieren
