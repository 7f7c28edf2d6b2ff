# CYCLE971: titles, search words, variants, words of its own parameters, checks and results.

cycle971-title = Tool probe in milling: calibrate, measure tools
cycle971-help = Measures length L1 or radius of the milling tool or drill in the spindle at a tool probe, or calibrates this probe with a tool of known size.
cycle971-words = measure tool setter tool setting preset tool probe touch probe laser cube disc disk calibrate calibration length L1 radius diameter cutter end mill face mill drill wear geometry breakage spindle rotating standing edge trigger point
cycle971-each-words = measure tool probe

cycle971-calibrate = Calibrate the tool probe
cycle971-calibrate-workpiece = Calibrate the tool probe in the workpiece system
cycle971-still = Measure a tool, spindle standing
cycle971-rotating = Measure a tool, spindle turning
cycle971-still-workpiece = Measure a tool in the workpiece system, spindle standing
cycle971-rotating-workpiece = Measure a tool in the workpiece system, spindle turning
cycle971-incremental = Calibrate the tool probe incrementally
cycle971-incremental-workpiece = Calibrate the tool probe incrementally in the workpiece system
cycle971-automatic = Calibrate all sides of the tool probe
cycle971-automatic-workpiece = Calibrate all sides of the tool probe in the workpiece system

ma-abscissa-centred = Abscissa (G17: X), centred in the ordinate
ma-ordinate-centred = Ordinate (G17: Y), centred in the abscissa
ma-applicate-abscissa = Applicate (G17: Z), wide tool moved in the abscissa
ma-applicate-ordinate = Applicate (G17: Z), wide tool moved in the ordinate
ma-radius-abscissa = Radius, touched in the abscissa (G17: X)
ma-radius-ordinate = Radius, touched in the ordinate (G17: Y)
ma-length = Length, at the centre of the probe
ma-length-abscissa = Length, wide tool moved in the abscissa (G17: X)
ma-length-ordinate = Length, wide tool moved in the ordinate (G17: Y)
param-ma-measure-tool = Length or radius
param-ma-measure-tool-help = What is measured, and in which direction. A tool wider than the probe is offset by its radius less _ID, so that its edge comes over the centre of the probe.
param-id-calibrate = Offset of a wide calibration tool
param-id-calibrate-help = A tool wider than the probe is offset from its centre by the tool radius less this value. Usually 0.
param-id-length = From the radius to the deepest point of the edge
param-id-length-help = How far inside of the radius the deepest point of the edge lies; the tool is offset by its radius less this value. 0 where the edge is deepest at its radius.
param-id-radius = From the tool's end to its widest point
param-id-radius-help = How far above its end the tool is widest; it is lowered by this much more. 0 where it is widest at its end.
param-fa-incremental = Measuring path with direction
param-fa-incremental-help = Distance from the present position to the side that is touched; plus measures in plus direction, minus in minus direction. The same distance again is travelled beyond it. Always in mm.

need-axis-tool-probe = The cycle has to know the axis.
need-offset-edge = The cycle places the tool by it and keeps the value of an earlier call otherwise; enter 0 for a plain edge.
need-offset-wide = Counts for a tool that is wider than the probe.
need-signed-path = Its sign is the direction of the measurement.

result-actual-radius = Actual radius
result-difference-radius = Difference of the radius

check-path-sign = The measuring path has to be greater than 0.
check-path-sign-hint = Enter _FA without a sign; the start position decides the direction. Only incremental calibration takes a signed path.
check-path-direction-hint = Enter the distance to the probe, with minus for the minus direction.
check-tool-probe-type = { $name } is not a type of tool probe.
check-tool-probe-plane = The disc in { $name } cannot be touched in this plane.
check-tool-probe-type-hint = 0 is a cube; 101 a disc in XY for G17, 201 in ZX for G18, 301 in YZ for G19.
check-tool-probe-depth = { $name } is 0: beside the probe the tool would not reach below its upper side.
check-tool-probe-depth-hint = Enter the distance from the probe's upper side to the tool's end.
check-directions-code = { $name } = { $code } names no directions.
check-directions-applicate = { $name } = { $code } does not allow the tool axis to be touched in minus direction.
check-directions-hint = Hundreds Z, tens Y, ones X: 0 not, 1 minus, 2 plus, 3 both. The tool axis needs 1 or 3; as delivered the value is 133.
check-tool-type-drill = A drill (type { $type }) has no radius to be measured.
check-tool-length-zero = Length L1 of the tool in use is 0.
check-tool-radius-zero = The radius of the tool in use is 0.
check-tool-zero-hint = Enter the approximate size in the tool data; of a calibration tool the exact one.
check-offset-missing = The tool, { $tool } mm wide, is wider than the probe, { $edge } mm; _ID decides where it is placed.
check-offset-missing-hint = Enter 0, if its outermost point should come over the centre of the probe.
check-offset-large = _ID is larger than the radius of the tool, { $radius } mm: it would be offset to the other side.
check-offset-large-hint = Enter the distance from the radius inwards.
check-offset-abscissa = The tool, { $tool } mm wide, is wider than the probe, { $edge } mm; it is offset in the abscissa.
check-offset-abscissa-hint = Choose 103 or 203 to name the axis of the offset.
check-mfs-missing = { $name } is not set: speed or feed of a probing is missing.
check-mfs-missing-hint = Set speeds in _MFS[0], [2], [4] and feeds in _MFS[1], [3], [5] in the machine's data, or let the cycle work them out with _CBIT[12]=0.
check-mfs-third = { $name } is 0: the third probing of _MFS[4] and [5] never happens.
check-mfs-third-hint = Set speed and feed of the second probing too, or set _MFS[4] to 0.
check-cm-direction = { $name } names no direction of rotation for a standing spindle.
check-cm-direction-hint = Set 3 for M3 or 4 for M4 in the machine's data.
check-cm-zero = { $name } is 0: speed or feed of the measurement would be 0.
check-cm-zero-hint = Set the limits in the machine's data: _CM[0] peripheral speed, [1] spindle speed, [3] accuracy, [4] largest feed.
check-cm-factor = { $name } is neither 0 nor at least 1.
check-cm-factor-hint = 0 leaves this probing out; otherwise the feed is multiplied by the factor.
check-cm-order = { $name } should be smaller than _CM[6]: each probing is slower than the one before.
check-cm-order-hint = Set a smaller feed factor 2, or 0 for two probings.
check-compensation-make = No compensation takes place: _MT_COMP=1 needs the make of the probe in { $name }.
check-compensation-make-hint = Set _TP_CF to 1 (TT130) or 2 (TS27R), or use a table of your own with _MT_COMP=2.
check-compensation-inside = The control takes the table of this make of probe off the measured value. It is inside of the control and in no manual: the prediction takes nothing off.
check-compensation-inside-hint = With _MT_COMP=2 a table of your own in { $name } counts, on the control and here.
check-compensation-table = Radii or peripheral speeds in { $name } do not ascend; the wrong compensation may be taken.
check-compensation-table-hint = Enter the radii in [0,1] to [0,4] and the speeds in [1,0] to [5,0] in ascending order, or set _MT_COMP=0.

param-mfs-speed-1 = Speed, first touch
param-mfs-speed-1-help = In revolutions a minute.
param-mfs-feed-1 = Feed, first touch
param-mfs-feed-1-help = Feed towards the tool probe at the first touch.
param-mfs-speed-2 = Speed, second touch
param-mfs-speed-2-help = In revolutions a minute. 0 ends the measurement behind the first touch.
param-mfs-feed-2 = Feed, second touch
param-mfs-feed-2-help = Feed towards the tool probe at the second touch.
param-mfs-speed-3 = Speed, third touch
param-mfs-speed-3-help = In revolutions a minute. 0 ends it behind the second.
param-mfs-feed-3 = Feed, third touch
param-mfs-feed-3-help = Feed towards the tool probe at the third touch.
