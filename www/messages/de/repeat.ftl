# Die Testprogramme eines Messtasters.

repeat-intro = Zwei Programme, die mit MEAS messen, ohne Zyklus: ob der Messtaster schaltet, und wie weit Antastungen einer Stelle streuen. Das zweite läuft hier auf der gewählten Maschine, an einer Fläche in der Mitte zwischen Start und Ende.
repeat-axis = Achse
repeat-from = Startposition
repeat-to = Ende ohne Signal
repeat-feed = Vorschub
repeat-count = Anzahl der Antastungen
repeat-parameters = Werte in R-Parametern ab (leer: ein Feld)
repeat-input = Messeingang
repeat-input-machine = Wie in den Maschinendaten
repeat-machine = Werte im Maschinenkoordinatensystem
repeat-changes = Werkzeugwechsel mit M6
repeat-real = Werte der realen Maschine (leer: simuliert)
repeat-histogram = Häufigkeit der Werte von { $from } bis { $to } { $unit }
repeat-values-shown = Die { $count } Werte
repeat-program = Programm: Wiederholgenauigkeit
repeat-function = Programm: Funktionstest
repeat-save-program = Programm Wiederholgenauigkeit speichern
repeat-save-function = Funktionstest speichern
