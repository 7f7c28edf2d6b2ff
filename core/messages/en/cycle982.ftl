# CYCLE982: titles, search words, variants, words of its own parameters, checks.

cycle982-title = Turning: tool probe, turning and milling tools
cycle982-help = Measures L1, L2 of turning tools, milling tools, drills, and R of milling tools at a tool probe parallel to the axes, or calibrates a side with a tool of cutting edge position 3.
cycle982-words = measure tool setter tool setting preset lathe turning mill-turn driven tool live tool tool probe cube calibrate calibration length L1 L2 radius diameter insert nose tip cutting edge position drill end mill groove mill T-slot reversal incremental automatic wear geometry trigger point
cycle982-each-words = lathe measure tool

cycle982-calibrate = Calibrate the tool probe
cycle982-calibrate-workpiece = Calibrate the tool probe (WCS)
cycle982-incremental-calibrate = Calibrate the tool probe incrementally
cycle982-incremental-calibrate-workpiece = Calibrate the tool probe incrementally (WCS)
cycle982-measure = Measure: length L1 or L2 of a turning tool, milling tool or drill in axial position
cycle982-measure-reversal = Measure: length L1 or L2 of a milling tool or drill in axial position, with reversal
cycle982-measure-radius = Measure: radius of a milling tool in axial position
cycle982-measure-radius-reversal = Measure: radius of a milling tool in axial position, with reversal
cycle982-measure-both = Measure: length and radius of a milling tool in axial position
cycle982-measure-both-reversal = Measure: length and radius of a milling tool in axial position, with reversal
cycle982-measure-radial = Measure: length L1 or L2 of a milling tool or drill in radial position
cycle982-measure-radial-reversal = Measure: length L1 or L2 of a milling tool or drill in radial position, with reversal
cycle982-measure-radius-radial = Measure: radius of a milling tool in radial position
cycle982-measure-radius-radial-reversal = Measure: radius of a milling tool in radial position, with reversal
cycle982-measure-both-radial = Measure: length and radius of a milling tool in radial position
cycle982-measure-both-radial-reversal = Measure: length and radius of a milling tool in radial position, with reversal
cycle982-measure-workpiece = Measure: length L1 or L2 of a turning tool, milling tool or drill in axial position (WCS)
cycle982-measure-reversal-workpiece = Measure: length L1 or L2 of a milling tool or drill in axial position, with reversal (WCS)
cycle982-measure-radius-workpiece = Measure: radius of a milling tool in axial position (WCS)
cycle982-measure-radius-reversal-workpiece = Measure: radius of a milling tool in axial position, with reversal (WCS)
cycle982-measure-both-workpiece = Measure: length and radius of a milling tool in axial position (WCS)
cycle982-measure-both-reversal-workpiece = Measure: length and radius of a milling tool in axial position, with reversal (WCS)
cycle982-measure-radial-workpiece = Measure: length L1 or L2 of a milling tool or drill in radial position (WCS)
cycle982-measure-radial-reversal-workpiece = Measure: length L1 or L2 of a milling tool or drill in radial position, with reversal (WCS)
cycle982-measure-radius-radial-workpiece = Measure: radius of a milling tool in radial position (WCS)
cycle982-measure-radius-radial-reversal-workpiece = Measure: radius of a milling tool in radial position, with reversal (WCS)
cycle982-measure-both-radial-workpiece = Measure: length and radius of a milling tool in radial position (WCS)
cycle982-measure-both-radial-reversal-workpiece = Measure: length and radius of a milling tool in radial position, with reversal (WCS)
cycle982-automatic = Measure automatically: both lengths, radius; turning tool, milling tool or drill in axial position
cycle982-automatic-reversal = Measure automatically: both lengths, radius; milling tool or drill in axial position, with reversal
cycle982-automatic-upper = Measure automatically: upper cutting edge; milling tool in axial position
cycle982-automatic-upper-reversal = Measure automatically: upper cutting edge; milling tool in axial position, with reversal
cycle982-automatic-opposite = Measure automatically: upper cutting edge, length against the approach; milling tool in axial position
cycle982-automatic-opposite-reversal = Measure automatically: upper cutting edge, length against the approach; milling tool in axial position, with reversal
cycle982-automatic-radial = Measure automatically: both lengths, radius; milling tool or drill in radial position
cycle982-automatic-radial-reversal = Measure automatically: both lengths, radius; milling tool or drill in radial position, with reversal
cycle982-automatic-upper-radial = Measure automatically: upper cutting edge; milling tool in radial position
cycle982-automatic-upper-radial-reversal = Measure automatically: upper cutting edge; milling tool in radial position, with reversal
cycle982-automatic-opposite-radial = Measure automatically: upper cutting edge, length against the approach; milling tool in radial position
cycle982-automatic-opposite-radial-reversal = Measure automatically: upper cutting edge, length against the approach; milling tool in radial position, with reversal
cycle982-automatic-workpiece = Measure automatically: both lengths, radius; turning tool, milling tool or drill in axial position (WCS)
cycle982-automatic-reversal-workpiece = Measure automatically: both lengths, radius; milling tool or drill in axial position, with reversal (WCS)
cycle982-automatic-upper-workpiece = Measure automatically: upper cutting edge; milling tool in axial position (WCS)
cycle982-automatic-upper-reversal-workpiece = Measure automatically: upper cutting edge; milling tool in axial position, with reversal (WCS)
cycle982-automatic-opposite-workpiece = Measure automatically: upper cutting edge, length against the approach; milling tool in axial position (WCS)
cycle982-automatic-opposite-reversal-workpiece = Measure automatically: upper cutting edge, length against the approach; milling tool in axial position, with reversal (WCS)
cycle982-automatic-radial-workpiece = Measure automatically: both lengths, radius; milling tool or drill in radial position (WCS)
cycle982-automatic-radial-reversal-workpiece = Measure automatically: both lengths, radius; milling tool or drill in radial position, with reversal (WCS)
cycle982-automatic-upper-radial-workpiece = Measure automatically: upper cutting edge; milling tool in radial position (WCS)
cycle982-automatic-upper-radial-reversal-workpiece = Measure automatically: upper cutting edge; milling tool in radial position, with reversal (WCS)
cycle982-automatic-opposite-radial-workpiece = Measure automatically: upper cutting edge, length against the approach; milling tool in radial position (WCS)
cycle982-automatic-opposite-radial-reversal-workpiece = Measure automatically: upper cutting edge, length against the approach; milling tool in radial position, with reversal (WCS)
cycle982-incremental-measure = Measure incrementally: length L1 or L2 of a turning tool, milling tool or drill in axial position
cycle982-incremental-measure-reversal = Measure incrementally: length L1 or L2 of a milling tool or drill in axial position, with reversal
cycle982-incremental-measure-radius = Measure incrementally: radius of a milling tool in axial position
cycle982-incremental-measure-radius-reversal = Measure incrementally: radius of a milling tool in axial position, with reversal
cycle982-incremental-measure-radial = Measure incrementally: length L1 or L2 of a milling tool or drill in radial position
cycle982-incremental-measure-radial-reversal = Measure incrementally: length L1 or L2 of a milling tool or drill in radial position, with reversal
cycle982-incremental-measure-radius-radial = Measure incrementally: radius of a milling tool in radial position
cycle982-incremental-measure-radius-radial-reversal = Measure incrementally: radius of a milling tool in radial position, with reversal
cycle982-incremental-measure-workpiece = Measure incrementally: length L1 or L2 of a turning tool, milling tool or drill in axial position (WCS)
cycle982-incremental-measure-reversal-workpiece = Measure incrementally: length L1 or L2 of a milling tool or drill in axial position, with reversal (WCS)
cycle982-incremental-measure-radius-workpiece = Measure incrementally: radius of a milling tool in axial position (WCS)
cycle982-incremental-measure-radius-reversal-workpiece = Measure incrementally: radius of a milling tool in axial position, with reversal (WCS)
cycle982-incremental-measure-radial-workpiece = Measure incrementally: length L1 or L2 of a milling tool or drill in radial position (WCS)
cycle982-incremental-measure-radial-reversal-workpiece = Measure incrementally: length L1 or L2 of a milling tool or drill in radial position, with reversal (WCS)
cycle982-incremental-measure-radius-radial-workpiece = Measure incrementally: radius of a milling tool in radial position (WCS)
cycle982-incremental-measure-radius-radial-reversal-workpiece = Measure incrementally: radius of a milling tool in radial position, with reversal (WCS)

task-measure-axis = Measure in one axis
task-measure-axis-words = measure insert driven tool end mill
task-measure-all = Measure automatically: all values
task-measure-all-words = automatic all values insert driven tool end mill
mvar-edges = Reversal (milling tool, drill)
second-edge-without = Without
second-edge-with = With: 2nd touch, spindle +180°
second-edge-with-words = two edges mean value 180°
mvar-extent = Size of the milling tool
extent-plain = One length; automatic: lengths and radius
extent-plain-words = length L1 L2
extent-radius = Radius only; not automatic
extent-radius-words = diameter
extent-length-radius = Length and radius, two sides; not incremental
extent-length-radius-words = diameter two points
extent-upper = Upper cutting edge, far side; automatic only
extent-upper-words = groove mill T-slot cutter disc length radius
extent-upper-opposite = Upper cutting edge, against approach; automatic only
extent-upper-opposite-words = groove mill T-slot cutter disc length radius opposite direction
mvar-tool-axis = Position of milling tool or drill
tool-axis-axial = Axial: radius in the ordinate (G18: X)
tool-axis-radial = Radial: radius in the abscissa (G18: Z)
ma-lathe-radius = Radius, touched in the abscissa (G18: Z)
ma-lathe-radius-ordinate = Radius, touched in the ordinate (G18: X)
ma-lathe-l2-radius = L2 and radius, touched in the abscissa (G18: Z)
ma-lathe-l1-radius = L1 and radius, touched in the ordinate (G18: X)

param-ma-lathe-measured = Measured size
param-ma-lathe-measured-help = Size to be measured; also determines the axis of the touch. The radius is in the ordinate of an axial tool, in the abscissa of a radial tool. Start opposite the side to be touched.
param-md-incremental = Measuring direction
param-md-incremental-help = Direction in which the tool moves from its current position to the probe.
param-sta1-milling-spindle = Milling spindle starting angle
param-sta1-milling-spindle-help = Angle of the stationary milling spindle before the first touch, so that a cutting edge points at the probe. No effect while the spindle rotates, or with _CHBIT[20]=1.
param-cora-second-edge = Offset angle of second edge
param-cora-second-edge-help = Added to the 180° of the spindle for the second touch, if the second cutting edge is not exactly opposite.
param-fa-present-position = Measuring path
param-fa-present-position-help = The tool is in front of the probe; it must touch within twice this distance. Always in mm, in X as a radius.

need-axis-ignored = Ignored: the length of this drill applies along the applicate (SD 42950 = 0).
need-direction-incremental = In incremental variants, the start position does not determine the measuring direction.
need-start-angle-spindle = The stationary milling spindle is positioned to it; if omitted, the value of an earlier call applies.
need-start-angle-milling = Applies to milling tools.
need-second-edge = Applies to the second touch of a measurement with reversal.

check-tool-reference = _CBIT[5]=1: the values of _TP refer to the active WCS, although digit 2 of _MVAR says machine-related.
check-tool-reference-hint = Set _CBIT[5] to 0 or choose the workpiece-related variant (_TPW); then calibrate the tool probe again.
check-lathe-tool-type-hint = Use a turning tool (type 5xy), a milling tool (1xy, 711 to 799) or a drill (2xy); check $TC_DP1.
check-turning-digits = Digits 3 to 5 of { $value } apply to milling tools and drills, but a turning tool is active.
check-turning-digits-hint = Choose { $plain } for the turning tool, or change to the milling tool before the call.
check-tip-direction = A tool with cutting edge position { $tip } points in the other direction: its back would hit the probe.
check-tip-direction-hint = Start on the other side of the probe and change _MD, or check $TC_DP2.
check-drill-radius = The cycle does not measure the radius of a drill.
check-drill-radius-hint = Choose a variant with digit 4 = 0, or change to a milling tool; check $TC_DP1.
check-drill-plane = With SD 42950 = 0 the length of a drill applies along Y in G18, which the cycle does not measure.
check-drill-applicate = With SD 42950 = 0 the cycle measures only the length of a drill: in one axis, without reversal.
check-drill-applicate-hint = Choose 1, 11, 100001 or 100011 with G17 (along Z) or G19 (along X), or set SD 42950 to 2 and use G18.
check-length-assignment = SD 42950 is { $value }: L1 and L2 of milling tools and drills are not assigned as for turning tools.
check-length-assignment-hint = Set SD 42950 ($SC_TOOL_LENGTH_TYPE) to 2 before the call; for a drill in G17 or G19, 0 also works.
check-spindle-stays = This variant rotates the spindle or measures twice, but _CHBIT[20]=1 suppresses spindle positioning.
check-spindle-stays-hint = Set _CHBIT[20] to 0, or choose a variant xxx0x1 whose digits x are 0 or 1: one point, without reversal.
check-spindle-turns = The milling spindle must be positioned to _STA1, but it cannot be positioned.
check-spindle-turns-hint = Turn the cutting edge to the probe, set _CHBIT[20] to 1 and choose variant xxx0x1: one point, no reversal.
check-side-radius = The tool touches with its side, but its radius is 0: the length cannot be calculated.
check-side-radius-hint = Enter the radius in the tool data, or measure in the axis along the tool.
check-radius-length = { $length } of the tool is 0, but the radius is calculated from it.
check-radius-length-hint = Measure or enter this length first, or choose length and radius together (digit 4 = 2; not incremental).
