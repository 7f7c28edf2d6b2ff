# Definitionsdateien und Wertebelegungsprogramm.

definitions-intro = Was diese Maschine in den Definitionsdateien der Messzyklen ändert, bei neueren Steuerungen in Setting- und Maschinendaten: Feldgrößen und Werte, die vom Lieferzustand abweichen, das Programm, das die übrigen Werte belegt, und der nötige Speicher.
definitions-channels-label = Kanäle, die messen
definitions-read-files = Dateien zurücklesen
definitions-save-file = { $name } speichern
definitions-array = Feld
definitions-scope = Speicher
definitions-bytes = Byte
definitions-delivered = Im Lieferzustand
definitions-of-channel = je Kanal
definitions-of-control = Steuerung
