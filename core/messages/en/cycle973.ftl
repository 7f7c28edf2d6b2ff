# CYCLE973: titles, search words, variants, words of its own parameters and checks.

cycle973-title = Calibrate workpiece probe in turning
cycle973-help = Finds where the probe of a turning machine switches, and stores it in the probe's data _WP, from where every later measurement takes it.
cycle973-words = calibrate calibration workpiece probe turning lathe reference groove gauging block surface face trigger point values ball diameter skew position deviation touch probing 3D taster
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
calibrate-one-short = Not told: one direction, as 1
calibrate-one-short-words = one 13
calibrate-position = Position deviation (skew)

param-setval-surface-diameter = Diameter at the surface
param-setval-surface-diameter-help = Exact position of the surface in the workpiece coordinate system: with DIAMON the diameter, with DIAMOF the radius.
param-calnum = Reference groove
param-calnum-help = Number of the pair of grooves; their edges and bases stand in _KB[n-1,…], in machine coordinates, in X as radii.

need-surface-position = The trigger value is worked out from the position of the surface.
need-groove = The groove gives the positions that are touched.

check-groove-number = There is no pair of reference grooves with number { $number }.
check-groove-number-hint = Choose a number from 1 to { $pairs }, or create more data for grooves and raise { "_CVAL[2]" }.
check-groove-tip-hint = In a groove the probe has position 7 or 8; calibrate other probes on a surface.
check-groove-base = In this axis the groove has its base only: the minus direction.
check-groove-base-hint = Calibrate the base with one direction and { "_MD" }=1; both directions exist at the walls, in the other axis.
check-groove-empty = The groove is not known: { $names } are 0.
check-groove-empty-hint = Enter its edges and its base in the machine's data, in machine coordinates and as radii.
check-groove-edges = The edge in plus direction { $plus } is not larger than the edge in minus direction { $minus }.
check-groove-edges-hint = Exchange both values, or enter the missing one.
check-shank = A stylus with cutting edge position { $tip } points the other way: it would touch with its shank.
check-shank-hint = Turn { "_MD" } round, or check cutting edge position and measuring axis.
