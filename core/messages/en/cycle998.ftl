# CYCLE998: titles, search words, variants, words of its own parameters and checks.

cycle998-title = Angle of a surface
cycle998-help = Measures the rotation of a clamped part: one angle from two points on a straight edge or surface, or two angles of an oblique plane from three points.
cycle998-words = measure workpiece angle align alignment skew rotate rotation orientation edge surface face plane oblique inclined tilt clamped crooked rotary table C axis zero offset ZO frame G54 two points three points probe probing clock datum work
cycle998-each-words = two angle

cycle998-one = One angle, travel along the setpoint angle
cycle998-one-differential = One angle, differential measurement
cycle998-one-paraxial = One angle, travel along the axis
cycle998-two = Two angles, travel along the setpoint angles
cycle998-two-paraxial = Two angles, travel along the axes

mvar-angles = Angles
angles-one = One, from two points
angles-one-words = edge align rotation rotary table two points safe area set position
angles-two = Two, from three points
angles-two-words = oblique plane in space tilt inclination three points swivel CYCLE800
mvar-positioning = Travel between the points
positioning-angle = Along the setpoint angle, off the surface
positioning-paraxial = Along the axis
positioning-paraxial-words = axis paraxial parallel direction without setpoint

param-setval-point = Setpoint position of P1
param-setval-point-help = Expected position of the surface at P1, in the measuring axis. The start side determines the measuring direction. A surface that deviates by more than _FA is not found.
param-setval-point-applicate = Setpoint height of P1
param-setval-point-applicate-help = Expected position of the surface at P1, in the applicate (G17: Z).
param-ma-offset = Measuring axis and offset axis
param-ma-offset-help = Axis in which the surface is touched, and axis in which P2 is offset from P1. The measured angle is a rotation about the remaining axis.
ma-102 = Ordinate, points along the abscissa
ma-103 = Applicate, points along the abscissa
ma-201 = Abscissa, points along the ordinate
ma-203 = Applicate, points along the ordinate
ma-301 = Abscissa, points along the applicate
ma-302 = Ordinate, points along the applicate
param-id-points = Distance from P1 to P2
param-id-points-help = In plus direction of the offset axis, so P1 has the smaller coordinate. The larger the distance, the more accurate the angle.
param-id-points-abscissa = Distance from P1 to P2
param-id-points-abscissa-help = In plus direction of the abscissa (G17: X). The larger the distance, the more accurate the angle.
param-setv0-points = Distance from P1 to P3
param-setv0-points-help = In plus direction of the ordinate (G17: Y).
param-sta1-edge = Setpoint angle
param-sta1-edge-help = Angle of the surface from the drawing, to the plus direction of the offset axis, counter-clockwise positive. With travel along the angle it must be close to the actual angle.
param-sta1-about-abscissa = Setpoint angle about abscissa
param-sta1-about-abscissa-help = Inclination from P1 to P3, positive if the surface rises. With travel along the angles, the probe also follows it.
param-inca-about-ordinate = Setpoint angle about ordinate
param-inca-about-ordinate-help = Inclination from P1 to P2, positive if the surface falls. With travel along the angles, the probe also follows it.
param-ra = Rotary axis
param-ra-help = 0 rotates the coordinate system about the axis not in _MA. Otherwise channel axis number of a rotary axis: its zero offset receives the difference; rotating it aligns the part.
param-fa-paraxial = Measuring path
param-fa-paraxial-help = The surface must be within twice this distance from the position before each point. Always in mm.
param-tsa-angle = Safe area: angle
param-tsa-angle-help = In degrees. A larger difference of the angle stops the program with alarm 61303. With travel along the angle, the probe also moves away from the surface by this angle.

need-set-position = The setpoint position determines the measuring direction and the first touch.
need-axes-angle = The angle is in the plane of two axes.
need-direction-paraxial = Without a setpoint position, the measuring direction must be specified.
need-third-point = A plane needs a third point.
need-second-angle = A plane has two angles.
need-rotary = Enter the axis that receives the angle: 0 for the coordinate system.

check-angle-steep = Angle { $param } plus safe area is { $sum }°: at 90° or more the probe cannot travel along it.
check-angle-steep-hint = Reduce _TSA below { $limit }°. It is an angle here, not a length.
check-angle-reach = With _TSA the next point starts { $away } mm from the setpoint surface; the whole measuring path is { $path } mm.
check-angle-reach-hint = Increase _FA to at least { $needed } mm, or reduce _TSA.
check-angle-reach-worst = If the angle deviates by the safe area, { $area }°, the probe misses the next point: alarm 61301, not 61303.
check-angle-paraxial = Between the points the setpoint surface is offset by { $rise } mm, more than the whole measuring path of { $path } mm.
check-angle-paraxial-hint = Increase _FA above { $needed } mm, or choose a variant that travels along the angle.
check-rotary-axis = Channel axis { $axis } has no name or is not a rotary axis.
check-rotary-across = This rotary axis does not rotate about the axis of the measured angle, so it cannot correct the angle.
check-rotary-across-hint = Enter the rotary axis that rotates in the plane of the two axes in _MA, or 0 to rotate the coordinate system.
check-rotary-axis-hint = Enter the channel axis number of a rotary axis (MD 20080, MD 30300), or 0 to rotate the coordinate system.
