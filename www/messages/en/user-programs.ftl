# CYCLE198 and CYCLE199.

user-program-intro = CYCLE198 runs before each measurement, CYCLE199 after it, from the label of the measuring cycle to its M17. Write lines there that switch the probe on and off, orient the spindle, or open a cover. A program of this page that contains them shows at each call which lines run around it.
user-program-cycles = Measuring cycles
user-program-lines-before = Lines before the measurement, such as M27
user-program-lines-behind = Lines after the measurement, such as M28
user-program-case = Variable of the CASE in the original file (empty: lines to insert)
user-program-save = Save { $name }
