# CYCLE119: Lage im Raum.

cycle119-title = Lage im Raum aus drei Punkten
cycle119-help = Berechnet die Lage eines Werkstücks im Raum aus Soll- und Messpositionen dreier Punkte. Auf Wunsch korrigiert der Zyklus ein Frame um Verschiebung und Drehung.
cycle119-words = Lage im Raum Frame drei 3 Punkte Dreieck Referenzdreieck Ausrichten ausrichten Ebene Drehung Verschiebung Nullpunktverschiebung NPV NV Einpassen Best-Fit Rechenzyklus
cycle119-position = Frame aus drei Sollpunkten und drei Messpunkten

check-119-set-line = Die drei Sollpunkte liegen auf einer Geraden oder aufeinander: Die Drehung des Werkstücks ist nicht berechenbar.
check-119-measured-line = Die drei Messpunkte liegen auf einer Geraden oder aufeinander: Die Drehung des Werkstücks ist nicht berechenbar.
check-119-line-hint = Drei Punkte wählen, die ein weites Dreieck bilden; Soll- und Messpunkte in gleicher Reihenfolge eingeben.

param-119-set-x = Sollpunkt, 1. Geometrieachse
param-119-set-x-help = Sollposition des Punkts, X in Werkstückkoordinaten. Der erste Index ist der Punkt (0 bis 2), der zweite die Achse (0: X, 1: Y, 2: Z).
param-119-set-y = Sollpunkt, 2. Geometrieachse
param-119-set-y-help = Sollposition des Punkts, Y in Werkstückkoordinaten.
param-119-set-z = Sollpunkt, 3. Geometrieachse
param-119-set-z-help = Sollposition des Punkts, Z in Werkstückkoordinaten.
param-119-measured-x = Messpunkt, 1. Geometrieachse
param-119-measured-x-help = Gemessene Position desselben Punkts, X in Werkstückkoordinaten; meist ein Ergebnis wie { "_OVR[5]" } der vorhergehenden Messung.
param-119-measured-y = Messpunkt, 2. Geometrieachse
param-119-measured-y-help = Gemessene Position desselben Punkts, Y in Werkstückkoordinaten.
param-119-measured-z = Messpunkt, 3. Geometrieachse
param-119-measured-z-help = Gemessene Position desselben Punkts, Z in Werkstückkoordinaten.
param-119-limit = Grenzwert der Verzerrung
param-119-limit-help = Die Dreiecke sind nie ganz gleich. Der Zyklus korrigiert das Frame nur, wenn die Summe der Abweichungen der drei Punkte kleiner als dieser Wert ist; sonst wird { "_ALARM" } 61414.
need-119-corrected = Die Korrektur eines Frames braucht einen Grenzwert.

result-119-alarm = 0 oder die Alarmnummer
result-119-distortion = Summe der Abweichungen der drei Punkte; unter 0: kein Frame
result-119-frame-x = Ergebnisframe; mit dem aktiven verkettet, bringt es das gemessene Dreieck in die Solllage: Verschiebung X
result-119-frame-y = Ergebnisframe: Verschiebung Y
result-119-frame-z = Ergebnisframe: Verschiebung Z
result-119-turn-x = Ergebnisframe: Drehung um X
result-119-turn-y = Ergebnisframe: Drehung um Y
result-119-turn-z = Ergebnisframe: Drehung um Z
