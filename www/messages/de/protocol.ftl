# Protokolle einer wirklichen Maschine.

protocol-title = Protokoll der Maschine
protocol-of = Auf der Maschine gemessen: { $name }
protocol-busy = Wird gelesen …
protocol-close = Zurück zur Simulation
protocol-unfit = Zeilen, die nicht passen: { $count }
protocol-doubtful = Zu prüfende Zeilen: { $count }
protocol-unfit-save = Alle sichern
protocol-columns = Spalten
protocol-columns-ask = Keine Zeile passt von selbst: auswählen, was in welcher Spalte steht, mindestens den Istwert.
protocol-column-number = Nummer des Aufrufs
protocol-column-line = Zeile im Programm
protocol-column-result = Ergebnis
protocol-column-nominal = Sollwert
protocol-column-actual = Istwert
protocol-column-deviation = Abweichung
protocol-too-large = Die Datei ist größer als { $most } MB: das Protokoll eines einzelnen Teils wählen.
