# Protocols of a real machine.

protocol-title = Protocol of the machine
protocol-of = Measured on the machine: { $name }
protocol-busy = Reading …
protocol-close = Back to the simulation
protocol-unfit = Lines that do not fit: { $count }
protocol-doubtful = Lines to check: { $count }
protocol-unfit-save = Save all of them
protocol-columns = Columns
protocol-columns-ask = No line fits by itself: choose what stands in which column, at least the actual value.
protocol-column-number = Number of the call
protocol-column-line = Line in the program
protocol-column-result = Result
protocol-column-nominal = Setpoint
protocol-column-actual = Actual
protocol-column-deviation = Deviation
protocol-too-large = The file is larger than { $most } MB: choose the protocol of a single part.
