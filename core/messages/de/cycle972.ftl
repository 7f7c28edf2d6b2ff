# CYCLE972: Titel, Suchwörter, Messvarianten.

cycle972-title = Drehen: Werkzeugmesstaster kalibrieren, Drehwerkzeuge messen
cycle972-help = Misst L1 oder L2 eines Drehwerkzeugs (Schneidenlage 1 bis 8) an einem achsparallelen Werkzeugmesstaster oder kalibriert eine Seite mit bekanntem Werkzeug der Schneidenlage 3. Besser: CYCLE982.
cycle972-words = Werkzeug messen vermessen Werkzeugvermessung Werkzeugmessung Werkzeugvoreinstellung Voreinstellgerät Drehmaschine Drehen Werkzeugmesstaster Werkzeugtaster Messtaster Taster Messdose Würfel antasten kalibrieren abgleichen eichen einmessen Länge L1 L2 Wendeschneidplatte Platte Schneide Schneidenradius Spitze Schneidenlage Drehmeißel Drehstahl Stahl Verschleiß Geometrie Triggerpunkt Werkzeugkorrektur Werkzeuglänge Einstellgerät Messarm

cycle972-calibrate = Werkzeugmesstaster kalibrieren
cycle972-calibrate-words = Drehmaschine Drehen Triggerpunkt Maschine _TP kalibrieren abgleichen eichen Kalibrierung Seite
cycle972-measure = Drehwerkzeug messen
cycle972-measure-words = Drehmaschine vermessen Länge L1 L2 Wendeschneidplatte Drehmeißel Verschleiß Geometrie Maschine
