# CYCLE979: titles, search words, variants, words of its own parameters and checks.

cycle979-title = Hole, shaft, groove, web at an angle
cycle979-help = Measures size and centre at an angle to the axes: a hole, a shaft or a segment at three or four points on a circle; a groove or web along an oblique line.
cycle979-words = measure workpiece hole bore shaft boss groove slot web rib segment arc angle oblique inclined diameter width centre center three four points inside outside tool offset wear zero offset ZO probe probing datum work set
cycle979-each-words = angle oblique segment arc

cycle979-hole-tool = Hole at an angle: correct a tool
cycle979-shaft-tool = Shaft at an angle: correct a tool
cycle979-groove-tool = Groove at an angle: correct a tool
cycle979-web-tool = Web at an angle: correct a tool
cycle979-hole-zero = Hole at an angle: correct a zero offset
cycle979-shaft-zero = Shaft at an angle: correct a zero offset
cycle979-groove-zero = Groove at an angle: correct a zero offset
cycle979-web-zero = Web at an angle: correct a zero offset

prnum-points = Points on the circle
prnum-three = Three points
prnum-four = Four points
param-setval-width-angle = Setpoint width
param-setval-width-angle-help = Width from the drawing, across the groove or web, in the direction of the starting angle _STA1.
param-sta1-width = Direction of the width
param-sta1-width-help = Angle to the abscissa at which the width is measured; the first point lies in this direction from the centre.
param-id-lift = Lift over the web
param-id-lift-help = Travel in the tool axis from measuring height to crossing height, with sign. If the length refers to the ball centre (_CBIT[14]=0), it must include the ball radius.
param-prnum-with-points = Probe and number of points
param-prnum-with-points-help = Three or four points on the circle, type of the probe, number of its data in _WP.

need-lift = The probe must cross the web.

check-points-unused = The number of points applies to a hole or shaft only.
check-points-unused-hint = Choose three points: 0 in the 4th digit of _PRNUM.
check-path-centre = The measuring path starts past the centre: between the points, the probe would move on the far side.
check-path-centre-hint = Reduce _FA below { $free } mm.
check-lift = The probe does not lift before it crosses the web.
check-lift-hint = Enter a positive value; if the probe body is on the minus side of the applicate, a negative one.
check-lift-ball = The lift is not larger than the ball radius, { $ball } mm, which it must include.
check-lift-ball-hint = Add the ball radius, or set _CBIT[14]=1 if the probe length refers to the circumference of the ball.
