# CYCLE998: titles, search words, variants, words of its own parameters and checks.

cycle998-title = Angle of a surface
cycle998-help = Measures how a clamped part is turned: one angle from two points on a straight edge or surface, or two angles of an oblique plane from three points.
cycle998-words = measure workpiece angle align alignment skew rotate rotation orientation edge surface face plane oblique inclined tilt clamped crooked rotary table C axis zero offset ZO frame G54 two points three points probe probing clock datum work
cycle998-each-words = two angle

cycle998-one = One angle, travel along the set angle
cycle998-one-differential = One angle, differential measurement
cycle998-one-paraxial = One angle, travel along the axis
cycle998-two = Two angles, travel along the set angles
cycle998-two-paraxial = Two angles, travel along the axes

mvar-angles = Angles
angles-one = One, from two points
angles-one-words = edge align rotation rotary table two points safe area set position
angles-two = Two, from three points
angles-two-words = oblique plane in space tilt inclination three points swivel CYCLE800
mvar-positioning = Travel between the points
positioning-angle = Along the set angle, away from the surface
positioning-paraxial = Along the axis
positioning-paraxial-words = axis paraxial parallel direction without setpoint

param-setval-point = Set position of P1
param-setval-point-help = Where the surface is expected at the first point, in the measuring axis. The side on which the probe stands decides the measuring direction. A position differing by more than the measuring path is not found.
param-setval-point-applicate = Set height of P1
param-setval-point-applicate-help = Where the surface is expected under the first point, in the applicate (G17: Z).
param-ma-offset = Measuring axis and offset axis
param-ma-offset-help = In which axis the surface is touched, and in which axis the second point lies. The axis that is neither of them is the one about which the part is turned.
ma-102 = Ordinate, points along the abscissa
ma-103 = Applicate, points along the abscissa
ma-201 = Abscissa, points along the ordinate
ma-203 = Applicate, points along the ordinate
ma-301 = Abscissa, points along the applicate
ma-302 = Ordinate, points along the applicate
param-id-points = Distance from P1 to P2
param-id-points-help = In plus direction of the offset axis; the first point therefore has the smaller coordinate. The larger the distance, the better the angle.
param-id-points-abscissa = Distance from P1 to P2
param-id-points-abscissa-help = In plus direction of the abscissa (G17: X). The larger the distance, the better the angle.
param-setv0-points = Distance from P1 to P3
param-setv0-points-help = In plus direction of the ordinate (G17: Y).
param-sta1-edge = Set angle
param-sta1-edge-help = Angle that the surface should have to the plus direction of the offset axis, plus counter-clockwise. With travel along the angle it also leads the probe, so that it should differ little from the real angle.
param-sta1-about-abscissa = Set angle about the abscissa
param-sta1-about-abscissa-help = Inclination from P1 to P3. With travel along the angles it also leads the probe.
param-inca-about-ordinate = Set angle about the ordinate
param-inca-about-ordinate-help = Inclination from P1 to P2. With travel along the angles it also leads the probe.
param-ra = Rotary axis
param-ra-help = 0 turns the coordinate system about the axis that is not named in _MA. Otherwise the number of a rotary axis in the channel: the angle is added to its zero offset, and the table turns the part when the axis is moved.
param-tsa-angle = Safe area of the angle
param-tsa-angle-help = In degrees. A larger difference of the angle stops the program with alarm 61303. With travel along the angle the probe is led away from the surface by it as well.

need-set-position = The measuring direction and the first touch follow from it.
need-axes-angle = The angle lies in the plane of two axes.
need-direction-paraxial = Without a set position the direction of the touch has to be told.
need-third-point = A plane needs a third point.
need-second-angle = A plane has two angles.
need-rotary = Tell what takes the angle: 0 for the coordinate system.

check-angle-steep = Angle { $param } and safe area make { $sum }° together; along 90° or more the probe cannot travel.
check-angle-steep-hint = Choose _TSA below { $limit }°. It is an angle here, not a length.
check-angle-reach = On the way to the next point the safe area leads the probe so far away that the set surface lies { $away } mm ahead, beyond the whole measuring path of { $path } mm.
check-angle-reach-hint = Choose _FA of { $needed } mm or more, or a smaller _TSA.
check-angle-reach-worst = An angle that differs by the whole safe area, { $area }°, would be missed at the next point: alarm 61301 comes before 61303.
check-angle-paraxial = From point to point the set surface rises by { $rise } mm, more than the whole measuring path of { $path } mm.
check-angle-paraxial-hint = Choose _FA above { $needed } mm, or a variant that travels along the angle.
check-rotary-axis = The channel axis { $axis } has no name or is no rotary axis.
check-rotary-across = This rotary axis does not turn about the direction about which the angle is measured, so that it cannot take the angle back.
check-rotary-across-hint = Name the rotary axis that turns in the plane of both axes of _MA, or 0 to turn the coordinate system.
check-rotary-axis-hint = Enter the number of the rotary axis in the channel, or 0 to turn the coordinate system. Which axes there are stands in MD 20080 and MD 30300.
