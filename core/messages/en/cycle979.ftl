# CYCLE979: titles, search words, variants, words of its own parameters and checks.

cycle979-title = Hole, shaft, groove, web at an angle
cycle979-help = Measures a size and its centre where the axes cannot be followed: a hole or shaft, also a segment of one, at three or four points on a circle; a groove or web across an oblique line.
cycle979-words = measure workpiece hole bore shaft boss groove slot web rib segment arc angle oblique inclined diameter width centre center three four points inside outside tool offset wear zero offset ZO probe probing datum work
cycle979-each-words = angle oblique segment arc

cycle979-hole-tool = Hole at an angle: correct a tool
cycle979-shaft-tool = Shaft at an angle: correct a tool
cycle979-groove-tool = Groove at an angle: correct a tool
cycle979-web-tool = Web at an angle: correct a tool
cycle979-hole-zero = Hole at an angle: correct a zero offset
cycle979-shaft-zero = Shaft at an angle: correct a zero offset
cycle979-groove-zero = Groove at an angle: correct a zero offset
cycle979-web-zero = Web at an angle: correct a zero offset

prnum-points = Points of a circle
prnum-three = Three points
prnum-four = Four points
param-setval-width-angle = Set width
param-setval-width-angle-help = Width from the drawing, across the groove or web, in the direction of the starting angle.
param-sta1-width = Direction of the width
param-sta1-width-help = Angle to the abscissa in which the width is measured; the first point lies on this side of the centre.
param-id-lift = Lift over the web
param-id-lift-help = Way in the tool axis from the measuring height up to where the probe crosses, with its sign. While the length ends at the ball's centre (_CBIT[14]=0) it has to include the ball radius.
param-prnum-with-points = Probe and number of points
param-prnum-with-points-help = Three or four points of a circle, type of the probe, number of its data in _WP.

need-lift = The probe has to cross the web.

check-points-unused = The number of points counts for a hole or shaft only.
check-points-unused-hint = Choose 3, that is the digit 0.
check-path-centre = The measuring path begins beyond the centre: on the way from point to point the probe would pass on the other side.
check-path-centre-hint = Choose _FA below { $free } mm.
check-lift = The probe does not rise before it crosses the web.
check-lift-hint = Enter a positive value if the tool axis points up.
check-lift-ball = The lift is not larger than the ball radius, { $ball } mm, which it has to include.
check-lift-ball-hint = Add the ball radius, or set _CBIT[14]=1 where the probe's length ends at the circumference.
