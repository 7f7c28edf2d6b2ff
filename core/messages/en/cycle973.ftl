# CYCLE973: titles, search words, variants, words of its own parameters and checks.

cycle973-title = Calibrate workpiece probe (turning)
cycle973-help = Determines where the probe of a turning machine triggers, and stores the trigger points in the probe data _WP; all later measurements use them.
cycle973-words = calibrate calibration workpiece probe turning lathe reference groove gauging block surface face trigger point values ball diameter skew position deviation touch probing 3D taster positional
cycle973-each-words = turning lathe trigger point

cycle973-surface = Surface: one direction
cycle973-groove-short = Reference groove: 1 direction, short number
cycle973-groove-one = Reference groove: 1 direction
cycle973-groove-two = Reference groove: 2 directions of one axis
cycle973-groove-two-ball = Reference groove: 2 directions of one axis, ball diameter
cycle973-groove-two-skew = Reference groove: 2 directions of one axis, skew
cycle973-groove-two-skew-ball = Reference groove: 2 directions of one axis, skew, ball diameter

calibrate-groove = Reference groove
calibrate-groove-words = gauging block
calibrate-one-short = Not specified: one direction, same as 1
calibrate-one-short-words = one 13
calibrate-position = Skew (positional deviation)

param-setval-surface-diameter = Diameter at the surface
param-setval-surface-diameter-help = Exact position of the surface in the workpiece coordinate system: with DIAMON the diameter, with DIAMOF the radius.
param-calnum = Reference groove
param-calnum-help = Number of the gauging block (pair of grooves); its edges and groove bases are in _KB[n-1,…], in machine coordinates, in X as radii.

need-surface-position = The cycle calculates the trigger point from the position of the surface.
need-groove = The groove determines the positions to be touched.

check-groove-number = Reference groove number { $number } does not exist.
check-groove-number-hint = Enter a number from 1 to { $pairs }, or create more gauging block data and increase { "_CVAL[2]" }.
check-groove-tip-hint = In a groove, the probe needs cutting edge position 7 or 8; calibrate other probes on a surface.
check-groove-base = In this axis, the groove has only its base: only the minus direction is possible.
check-groove-base-hint = Calibrate on the base with one direction and { "_MD" }=1; both directions only on the walls, in the other axis.
check-groove-empty = The groove data are not set: { $names } are 0.
check-groove-empty-hint = Enter edges and base in _KB[] in GUD6, in machine coordinates and as radii.
check-groove-edges = The edge in plus direction, { $plus }, is not greater than the edge in minus direction, { $minus }.
check-groove-edges-hint = Swap the two values, or enter the missing value.
check-shank = A stylus with cutting edge position { $tip } points in the opposite direction: it would touch with its shank.
check-shank-hint = Reverse { "_MD" }, or check cutting edge position and measuring axis.
