# CYCLE971: titles, search words, variants, words of its own parameters, checks and results.

cycle971-title = Milling: calibrate tool probe, measure tools
cycle971-help = Measures length L1 of the milling tool or drill in the spindle, or the radius of a milling tool, at a tool probe; or calibrates this probe with a tool of known size.
cycle971-words = measure tool setter tool setting preset tool probe touch probe laser cube disc disk calibrate calibration length L1 radius diameter cutter end mill face mill drill wear geometry breakage spindle rotating stationary standing edge trigger point
cycle971-each-words = measure tool probe

cycle971-calibrate = Calibrate the tool probe
cycle971-calibrate-workpiece = Calibrate the tool probe (WCS)
cycle971-still = Measure a tool, spindle stationary
cycle971-rotating = Measure a tool, spindle rotating
cycle971-still-workpiece = Measure a tool, spindle stationary (WCS)
cycle971-rotating-workpiece = Measure a tool, spindle rotating (WCS)
cycle971-incremental = Calibrate the tool probe incrementally
cycle971-incremental-workpiece = Calibrate the tool probe incrementally (WCS)
cycle971-automatic = Calibrate the tool probe automatically
cycle971-automatic-workpiece = Calibrate the tool probe automatically (WCS)

ma-abscissa-centred = Abscissa (G17: X), centred in the ordinate
ma-ordinate-centred = Ordinate (G17: Y), centred in the abscissa
ma-applicate-abscissa = Applicate (G17: Z), wide tool offset in the abscissa
ma-applicate-ordinate = Applicate (G17: Z), wide tool offset in the ordinate
ma-radius-abscissa = Radius, touched in the abscissa (G17: X)
ma-radius-ordinate = Radius, touched in the ordinate (G17: Y)
ma-length = Length, at the centre of the probe
ma-length-abscissa = Length, wide tool offset in the abscissa (G17: X)
ma-length-ordinate = Length, wide tool offset in the ordinate (G17: Y)
param-ma-measure-tool = Length or radius
param-ma-measure-tool-help = Measured size and direction. For the length, a milling tool wider than the probe is offset by its radius minus _ID: its cutting edge is above the centre of the probe.
param-id-calibrate = Offset of wide calibration tool
param-id-calibrate-help = A tool wider than the probe is offset from the centre of the probe by the tool radius minus this value. Usually 0.
param-id-length = Radius to deepest cutting point
param-id-length-help = Distance from the tool radius inwards to the edge's deepest point; a milling tool wider than the probe is offset by radius minus this value. 0 if the outermost point is deepest.
param-id-radius = Tool end to largest diameter
param-id-radius-help = Distance from the tool end up to its largest diameter; the tool moves down further by this value. 0 if the tool is widest at its end.
param-fa-incremental = Measuring path with direction
param-fa-incremental-help = Distance from the current position to the side to be touched; plus measures in plus direction, minus in minus direction. The tool travels at most twice this path. Always in mm.

need-axis-tool-probe = The cycle requires the measuring axis.
need-offset-edge = Determines the position of a milling tool; if omitted, the value of an earlier call applies. Plain edge or drill: enter 0.
need-offset-wide = Applies to a tool wider than the probe.
need-signed-path = The sign determines the measuring direction.

result-actual-radius = Actual radius
result-difference-radius = Radius difference

check-path-zero = The measuring path is 0: the tool would not move towards the probe.
check-path-zero-hint = Enter _FA above 0, without a sign.
check-path-sign = The measuring path is negative, which this variant does not permit.
check-path-sign-hint = Enter _FA without a sign; only incremental calibration uses a sign, for the direction.
check-path-direction-hint = Enter in _FA the distance to the probe, with minus for the minus direction.
check-tool-probe-type = { $name } does not contain a permitted type of tool probe.
check-tool-probe-plane = The disc in { $name } cannot be touched in this plane.
check-tool-probe-type-hint = Enter 0 for a cube, 101 for a disc in XY (G17), 201 in ZX (G18) or 301 in YZ (G19).
check-tool-probe-depth = { $name } is 0: the tool would touch no lower than the upper edge of the probe.
check-tool-probe-depth-hint = Enter the distance from the upper edge of the probe to the lower edge of the tool.
check-directions-code = { $name } = { $code } is not a permitted direction code.
check-directions-applicate = { $name } = { $code } does not permit touching in minus direction of the tool axis.
check-directions-hint = Enter the digits for Z, Y, X: 0 none, 1 minus, 2 plus, 3 both; tool axis 1 or 3. The default is 133.
check-tool-type-drill = A drill (type { $type }) has no radius that can be measured.
check-tool-length-zero = Length L1 of the active tool is 0.
check-tool-radius-zero = The radius of the active tool is 0.
check-tool-zero-hint = Enter the approximate size in the tool data, for a calibration tool the exact size.
check-offset-missing = The tool, { $tool } mm wide, is wider than the probe, { $edge } mm: _ID determines its position.
check-offset-missing-hint = Enter 0 in _ID if the outermost point is to be above the centre of the probe.
check-offset-large = _ID exceeds the tool radius, { $radius } mm: the tool would be offset to the other side.
check-offset-large-hint = Enter in _ID the distance from the radius inwards; it must not exceed the radius.
check-offset-abscissa = The tool, { $tool } mm wide, is wider than the probe, { $edge } mm: the cycle offsets it in the abscissa.
check-offset-abscissa-hint = Set _MA to 103 or 203 to specify the axis of the offset.
check-mfs-missing = { $name } is 0 or less: speed or feed of a touch is missing.
check-mfs-missing-hint = Set speeds in _MFS[0], [2], [4] and feeds in _MFS[1], [3], [5], or let the cycle calculate them: _CBIT[12]=0.
check-mfs-third = { $name } is 0 or less: the third touch with _MFS[4] and [5] is omitted.
check-mfs-third-hint = Set speed and feed of the second touch too, or set _MFS[4] to 0.
check-cm-direction = { $name } specifies no direction of rotation, which is needed if the spindle is stationary at the call.
check-cm-direction-hint = Set _CM[5] in GUD6 to 3 for M3 or to 4 for M4.
check-cm-zero = { $name } is 0 or less: the cycle cannot calculate speed and feed of the measurement.
check-cm-zero-hint = Set the limits: _CM[0] peripheral speed, [1] spindle speed, [3] accuracy, [4] maximum feed.
check-cm-factor = { $name } is neither 0 nor at least 1.
check-cm-factor-hint = Enter 0 to omit this touch, or at least 1: the feed is multiplied by this factor.
check-cm-order = { $name } is not smaller than _CM[6], but each touch should be slower than the previous one.
check-cm-order-hint = Reduce feed factor 2, or set it to 0 to touch only twice.
check-compensation-make = No compensation is applied: _MT_COMP=1 needs the probe make in { $name }.
check-compensation-make-hint = Set _TP_CF to 1 (TT130) or 2 (TS27R), or use your own table with _MT_COMP=2.
check-compensation-inside = The control applies an internal, undocumented table for this probe make; the simulation subtracts nothing.
check-compensation-inside-hint = With _MT_COMP=2 your own table applies, in the simulation too: _MT_EC_R for a radius, _MT_EC_L for a length.
check-compensation-table = Radii or peripheral speeds in { $name } are not in ascending order: the compensation may be wrong.
check-compensation-table-hint = Enter the radii in [0,1] to [0,4] and the speeds in [1,0] to [5,0] in ascending order, or set _MT_COMP=0.

param-mfs-speed-1 = Speed, first touch
param-mfs-speed-1-help = In rpm.
param-mfs-feed-1 = Feed, first touch
param-mfs-feed-1-help = Feed towards the tool probe for the first touch.
param-mfs-speed-2 = Speed, second touch
param-mfs-speed-2-help = In rpm. 0 ends the measurement after the first touch.
param-mfs-feed-2 = Feed, second touch
param-mfs-feed-2-help = Feed towards the tool probe for the second touch.
param-mfs-speed-3 = Speed, third touch
param-mfs-speed-3-help = In rpm. 0 ends the measurement after the second touch.
param-mfs-feed-3 = Feed, third touch
param-mfs-feed-3-help = Feed towards the tool probe for the third touch.
