# The printed page of the record.

record-sheet-title = Measurement record
record-sheet-part = Part
record-sheet-order = Order
record-sheet-program = Program
record-sheet-machine = Machine
record-sheet-control = Control
record-sheet-probe = Probe
record-sheet-ball = ball { $diameter } mm
record-sheet-clock = Date on the control
record-sheet-printed = Printed
record-sheet-inspector = Inspector
record-sheet-signature = Signature
record-fill = Title block of the printed record
record-sheet-picture = Features
record-sheet-quantity = Feature
record-sheet-tolerance = Tolerance
record-sheet-used = Used
