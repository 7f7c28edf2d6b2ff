# What the cycles at a tool probe have in common: parameters, choices, results, findings.

mvar-task = Task
task-calibrate = Calibrate the probe
task-calibrate-words = calibrate calibration tool probe trigger point side top
task-still = Measure a tool, spindle stationary
task-still-words = length radius motionless stationary standing drill end mill edge
task-rotating = Measure a tool, spindle rotating
task-rotating-words = length radius rotating turning largest edge cutter face mill speed feed
mvar-reference = Probe data
reference-machine = Machine-related (_TP)
reference-machine-words = machine _TP
reference-setting = Workpiece-related (_CBIT[5]=1, _TP)
reference-workpiece = Workpiece-related (_TPW)
reference-workpiece-words = workpiece WCS frame _TPW
ma-lathe-l2 = L2, touched in the abscissa (G18: Z)
ma-lathe-l1 = L1, touched in the ordinate (G18: X)
mvar-approach = Approach to the probe
approach-normal = Positioned by the cycle
approach-incremental = Incremental: measuring motion only
approach-incremental-words = incremental signed path unknown position first time geometry JOG
approach-automatic = Automatic: all sides
approach-automatic-words = automatic all axes directions centre

param-prnum-tool = Tool probe
param-prnum-tool-help = Number of the tool probe: its data are _TP[n-1,…] or, with a _TPW variant, _TPW[n-1,…].
param-evnum-tool = Empirical value memory
param-evnum-tool-help = Number n of the memory _EV[n-1] that corrects the measured value; 0: none. Above 9999 only the last four digits apply, because no mean value is formed.
param-tzl-tool = Zero compensation area
param-tzl-tool-help = Differences up to this limit are not corrected and raise no alarm.
param-tdif-tool = Dimensional difference check
param-tdif-tool-help = A difference of this size or more is not corrected: the cycle outputs message 62306. The program continues, with _CBIT[2]=1 only after NC START.
param-tsa-tool-probe = Safe area: trigger point
param-tsa-tool-probe-help = If a trigger point differs by more than this from the stored one, the program stops with alarm 61303 and nothing is stored.
param-tsa-tool = Safe area: tool
param-tsa-tool-help = A length or radius that differs by this value or more is not corrected: the program stops with alarm 61303.
param-fa-tool = Measuring path
param-fa-tool-help = Distance from the start of the measuring block to the expected trigger point, and the same distance past it. Also the clearance around the probe. Always in mm, in X as a radius.
param-ma-lathe-length = Measured length
param-ma-lathe-length-help = Length to be measured, which also determines the axis of the touch. The start position is opposite the side of the probe that the cutting edge touches.
param-ma-calibrate = Calibrated axis
param-ma-calibrate-help = Axis in which the probe is touched. Unless the approach is incremental, the start position determines the direction; in the applicate it is then always minus.

result-trigger-minus-1 = Trigger point −, 1st axis
result-trigger-minus-1-difference = Trigger point −, difference, 1st axis
result-trigger-plus-1 = Trigger point +, 1st axis
result-trigger-plus-1-difference = Trigger point +, difference, 1st axis
result-trigger-minus-2 = Trigger point −, 2nd axis
result-trigger-minus-2-difference = Trigger point −, difference, 2nd axis
result-trigger-plus-2 = Trigger point +, 2nd axis
result-trigger-plus-2-difference = Trigger point +, difference, 2nd axis
result-trigger-minus-3 = Trigger point −, 3rd axis
result-trigger-minus-3-difference = Trigger point −, difference, 3rd axis
result-trigger-plus-3 = Trigger point +, 3rd axis
result-trigger-plus-3-difference = Trigger point +, difference, 3rd axis
result-actual-l1 = Actual length L1
result-difference-l1 = Difference of length L1
result-actual-l2 = Actual length L2
result-difference-l2 = Difference of length L2

check-tool-probe-number-hint = Enter a number from 1 to { $fields }, or create more probe data and increase { $array }.
check-tool-limits = { $small }, { $low } mm, is not smaller than { $large }, { $high } mm: no difference lies between them.
check-tool-limits-hint = Keep this order, smallest first: _TZL, _TDIF, _TSA.
check-tool-speed = { $name } is 0 or less: the cycle cannot position the tool.
check-tool-speed-hint = Set _SPEED[0] in % of rapid traverse; with collision monitoring (_CHBIT[2]=1) _SPEED[1] and _SPEED[2] above 0.
check-tool-probe-empty = The position of the tool probe is not set: { $names } are 0.
check-tool-probe-empty-hint = Enter the approximate positions of its sides in GUD6; the cycle calculates its paths from them.
check-tool-probe-sides = { $minus } is not larger than { $plus }: the side touched in minus direction must be on the plus side of the probe.
check-tool-probe-sides-hint = Swap the two values, or enter the missing value.
check-tool-probe-in-use = The active tool is a workpiece probe.
check-tool-probe-in-use-hint = Change to the tool to be measured, or the calibration tool, before the call.
check-tool-type = Tool type { $type } is not permitted here.
check-tool-type-hint = Change to the tool to be measured, or the calibration tool; check $TC_DP1.
check-turning-type-hint = Use a turning tool (type 5xy) and call the cycle with its D number active; check $TC_DP1.
check-tip = Cutting edge position { $tip } is not permitted here.
check-tip-calibration-hint = Calibrate the probe with a tool of cutting edge position 3; check $TC_DP2.
check-tip-hint = Use a tool with cutting edge position 1 to 8; check $TC_DP2.
check-tip-axis = A tool with cutting edge position { $tip } has no cutting edge in this axis.
check-tip-axis-hint = Measure positions 5 and 7 in the abscissa only, 6 and 8 in the ordinate only.
check-tool-radius-negative = Radius plus wear of the active tool is { $radius } mm. No tool has such a radius: it is simulated with radius 0.
check-tool-radius-negative-hint = Correct the radius or its wear in the tool data.
