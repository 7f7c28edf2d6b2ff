# Das gedruckte Blatt des Protokolls.

record-sheet-title = Messprotokoll
record-sheet-part = Teil
record-sheet-order = Auftrag
record-sheet-program = Programm
record-sheet-machine = Maschine
record-sheet-control = Steuerung
record-sheet-probe = Messtaster
record-sheet-ball = Kugel { $diameter } mm
record-sheet-clock = Datum der Steuerung
record-sheet-printed = Gedruckt
record-sheet-inspector = Prüfer
record-sheet-signature = Unterschrift
record-fill = Schriftfeld des gedruckten Protokolls
record-sheet-picture = Messelemente
record-sheet-quantity = Messelement
record-sheet-tolerance = Toleranz
record-sheet-used = Ausnutzung
