# The test programs of a probe.

repeat-intro = Two programs that measure with MEAS, without a cycle: does the probe switch, and how far do touches of one place spread. The second runs here on the machine in use, on a face halfway between start and end.
repeat-axis = Axis
repeat-from = Start
repeat-to = End without a signal
repeat-feed = Feed
repeat-count = Number of touches
repeat-parameters = Values in R parameters from (empty: an array)
repeat-input = Measuring input
repeat-input-machine = As the machine data say
repeat-machine = Values in the machine system
repeat-changes = Tool change with M6
repeat-real = Values of the real machine (empty: simulated)
repeat-histogram = Frequency of the values from { $from } to { $to } { $unit }
repeat-values-shown = The { $count } values
repeat-program = Program: repeat accuracy
repeat-function = Program: function test
repeat-save-program = Save repeat program
repeat-save-function = Save function test
