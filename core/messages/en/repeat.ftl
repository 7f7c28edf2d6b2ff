# Repeated touches of one place: the test programs of a probe, and what the values come to.

repeat-control = The test programs are for SINUMERIK controls.
repeat-value = { $name ->
    [axis] The axis must be X, Y or Z.
    [from] The start must be a number from -{ $most } to { $most }.
    [to] The end without a signal must be a number from -{ $most } to { $most } other than the start.
    [feed] The feed must be above 0 and at most { $most }.
    [input] The measuring input must be 1 or 2.
    [count] The number of touches must be a whole number from { $least } to { $most }.
   *[parameters] The first R parameter must be a whole number from { $least } to { $most }.
    }
repeat-few = At least two values are needed.
repeat-many = At most { $most } values are evaluated.
repeat-not-a-number = { $value } is not a number.
repeat-no-signal = The probe did not switch on the way, so there are no values.
repeat-no-tool = This machine has no tool T{ $tool } D{ $edge }, so there is no probe to touch with: enter it among the tools, or put the probe into the spindle.
repeat-no-probe = T{ $tool } D{ $edge } is of type { $kind }, so no probe touches here: enter it as type 710, in a turret as 580, or put the probe into the spindle.
repeat-behind = In this direction the ball is behind the stylus, so nothing can be touched. Choose an end on the other side of the start, such as { $axis }{ $to }.
repeat-no-scatter = The probe of this machine has no repeatability error: each touch gives the same value. Set its repeatability, or paste values from the real machine.
repeat-diameters = These values of X are diameters: the repeatability of the probe is half of this deviation.
repeat-drift = The values drift from touch to touch: this is not random. Repeat the test when the machine is warm.
repeat-narrow = Three standard deviations are { $three }, more than the proposed _TZL: more touches would find larger deviations.
repeat-switched = Function test: the probe switches at { $axis } = { $value }{ $unit }; the program stops at M0, with this value in R1
repeat-not-switched = Function test: the probe does not switch; the program stops at the M0 behind its message
repeat-mean = { $count } touches, mean { $mean }{ $unit }
repeat-deviation = Standard deviation s = { $one }{ $unit }; 2 s = { $two }, 3 s = { $three }
repeat-range = Smallest { $smallest }, largest { $largest }, range { $range }{ $unit }
repeat-furthest = Largest deviation from the mean { $furthest }{ $unit }
repeat-slope = Drift { $slope }{ $unit } from touch to touch (t = { $t })
repeat-zone = Proposed _TZL = { $zone }{ $unit }: the largest random deviation, rounded up; { $two }{ $unit } for a diameter or a width, which two touches make
probe-test-function = Function test: one touch of the probe by hand or at a part
probe-test-repeat = Repeat accuracy: touches of one place
probe-test-switched = Probe switched, R1 = WCS, R2 = MCS
probe-test-failed = Probe did not switch
probe-test-done = All touches done, read the values
