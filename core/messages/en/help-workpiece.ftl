# Help pages of the cycles that measure a workpiece on milling machines.

help-cycle961-measures-inside = An inside corner: intersection of its two edges, and rotation of the reference edge (P1, P2).
help-cycle961-measures-outside = An outside corner: intersection of its two edges, and rotation of the reference edge (P1, P2).
help-cycle961-measures-square = The corner of a rectangle: three points are sufficient, the second edge is assumed at a right angle.
help-cycle961-measures-free = The angle between the edges is not known: two points are required on each edge.
help-cycle961-measures-given = Four points, each specified by its coordinates.
help-cycle961-before-opposite = The probe is at measuring depth opposite the corner: inside the pocket, or outside the part. All points can be reached from there; _STA1 and _INCA are known to within 10°.
help-cycle961-before-above = The probe is at a height from which all points can be reached on straight paths; _ID is the infeed from there to the measuring depth, with minus sign.
help-cycle961-before-multi = The probe switches in all directions of the plane (multi probe).
help-cycle961-order-three = P2 at _SETV[0] along the reference edge, P1 at half of that distance, then P3 at half of _SETV[1] along the second edge.
help-cycle961-order-four = P2 at _SETV[0] along the reference edge, P1 at half of that distance, then P3 at half of _SETV[1] and P4 at _SETV[1] along the second edge.
help-cycle961-order-in-plane = All paths are at measuring depth, inside the pocket.
help-cycle961-order-passes = From P1 to P3 the probe lifts by _ID, passes over the corner and infeeds again; with _ID=0 it moves around the corner through the start position.
help-cycle961-order-infeed = P2, P1, P3, P4: above each point the probe infeeds by _ID, touches, moves back and up.
help-cycle961-order-toward-pocket = Each touch is directed away from the other pair of points.
help-cycle961-order-toward-part = Each touch is directed to the side of the other pair of points.
help-cycle961-order-along-axis = Every touch is parallel to an axis of the active coordinate system, at most twice _FA long; a smaller _FA is increased to the minimum of the cycle, 20 mm or more.
help-cycle961-order-end-p4 = End position: above P4, at start height.
help-cycle961-corrects-absolute = With _KNUM above 0, this zero offset, coarse and absolute: the corner becomes zero in the plane, the abscissa is along the reference edge. Fine offset deleted, applicate unchanged.
help-cycle961-corrects-choice = With _SETV[4]=2 the zero point is offset from the corner by _SETV[2], with 4 by _SETV[3], with 3 by both.
help-cycle961-wrong-angle = The edges differ by more than 10° from _STA1 and _INCA: a point misses its edge, alarm 61301.
help-cycle961-wrong-not-opposite = The start position is not opposite the corner: the cycle searches for P3 beside its edge.
help-cycle961-wrong-swapped = P1 and P2 are swapped: the coordinate system is then rotated by 180°.
help-cycle961-wrong-same-points = Two points of an edge are identical (alarm 61367), or the edges are parallel (61368).

help-cycle977-measures-hole = Diameter and centre of a hole.
help-cycle977-measures-shaft = Diameter and centre of a shaft.
help-cycle977-measures-groove = Width of a groove and its middle, in the axis _MA.
help-cycle977-measures-web = Width of a web and its middle, in the axis _MA.
help-cycle977-measures-pocket = Both lengths and the centre of a paraxial inside rectangle.
help-cycle977-measures-island = Both lengths and the centre of a paraxial outside rectangle.
help-cycle977-before-centre = The probe is at or above the setpoint centre: the cycle compares the measured centre with this position in the plane.
help-cycle977-before-middle = The probe is at or above the setpoint middle: the cycle compares the measured middle with this position in _MA.
help-cycle977-before-depth = The ball is at measuring height.
help-cycle977-before-above = The ball is above the element, high enough to pass freely; _ID is the infeed from there to the measuring height, downwards with minus sign.
help-cycle977-before-zone-inside = _SZA is the size of the obstacle in the middle that the probe must not touch.
help-cycle977-before-zone-outside = _SZA is the size of the free space around the element, element included.
help-cycle977-before-zone-lengths = _SZA applies in the abscissa, _SZO in the ordinate.
help-cycle977-order-two-axes = Abscissa: plus side, then minus side. Then to the middle between them, and ordinate: plus side, minus side.
help-cycle977-order-one-axis = The plus side in _MA, then the minus side.
help-cycle977-order-straight = All paths are straight, at measuring height.
help-cycle977-order-outwards = The probe touches outwards, from the middle to the wall.
help-cycle977-order-inwards = At each point the probe moves beside the element, infeeds by _ID, touches towards the middle, moves back and up, and crosses over the element.
help-cycle977-order-over-zone = From point to point the probe lifts by _ID and crosses the obstacle in the middle.
help-cycle977-order-less-room = If the zone leaves less room, the cycle shortens _FA so that the ball still fits.
help-cycle977-order-diameter = The diameter is calculated from the touches in the ordinate, through the centre measured in the abscissa.
help-cycle977-order-lengths = Each length and each coordinate of the centre is calculated from the two touches of its axis.
help-cycle977-order-end = End position: at or above the measured centre, at start height.
help-cycle977-corrects-half = A radius is corrected by half of the size deviation.
help-cycle977-corrects-mean = The larger of the two length deviations decides whether a correction is made; the correction is the mean of the two.
help-cycle977-corrects-both-axes = Both axes of the plane are corrected.
help-cycle977-corrects-one-axis = Only _MA is corrected.
help-cycle977-wrong-depth = The ball is too high: it touches a chamfer or nothing.
help-cycle977-wrong-infeed = _ID has the wrong sign or is too short: the ball passes over the element. Too long: it hits the bottom, alarm 61302.
help-cycle977-wrong-zone = The protection zone leaves no room for the ball: alarm 61334.
help-cycle977-wrong-start = The start position is not the setpoint centre: its error carries over to the zero offset.

help-cycle978-measures-point = The position of one point on a surface perpendicular to axis _MA.
help-cycle978-before-opposite = The ball is opposite the point, further from the surface than _FA; the side on which it is positioned determines the direction.
help-cycle978-order-axis = Only _MA moves; end position: _FA from the surface.
help-cycle978-corrects-full = A length or radius is corrected by the whole deviation.
help-cycle978-corrects-one-axis = Only _MA is corrected; the empirical value of _EVNUM is first subtracted from the actual value (_CHBIT[5]=1: added).
help-cycle978-wrong-side = The ball is on the wrong side: it moves away from the surface.
help-cycle978-wrong-oblique = The surface is not perpendicular to _MA: the ball does not touch at its outermost point, and the result is wrong.

help-cycle979-measures-hole = Diameter and centre of a hole or a segment of a hole, from points on its circle.
help-cycle979-measures-shaft = Diameter and centre of a shaft or a segment of a shaft, from points on its circle.
help-cycle979-measures-groove = Width of an oblique groove, and its middle on the line at _STA1.
help-cycle979-measures-web = Width of an oblique web, and its middle on the line at _STA1.
help-cycle979-before-near = The ball is at measuring height near P1, further from the contour than _FA, with a clear straight path to P1. P1 is at the angle _STA1 seen from the setpoint centre _CPA, _CPO.
help-cycle979-before-ball = The active ball diameter of the probe is calibrated (CYCLE976 with ball diameter).
help-cycle979-order-circle = Three points (four if the 4th digit of _PRNUM is 1), each _INCA further; between them the probe moves on an arc at _RF.
help-cycle979-order-outwards = Each touch is directed away from the setpoint centre.
help-cycle979-order-inwards = Each touch is directed towards the setpoint centre.
help-cycle979-order-across = P1, straight along the line to the other wall, P2, all at measuring height.
help-cycle979-order-over = P1, up by _ID, across the web on the line, down again, P2.
help-cycle979-order-fit = The circle through all points gives diameter and centre.
help-cycle979-order-end = End position: _FA from the last point, at measuring height.
help-cycle979-corrects-half = A radius is corrected by half of the deviation of diameter or width.
help-cycle979-corrects-both = Both axes of the plane are corrected; for a groove or web, by the shift of its middle along the line.
help-cycle979-wrong-arc = The arc beside a segment collides with the part: alarm 61302.
help-cycle979-wrong-close = The points are close together: a small error in one point shifts the centre by a multiple. Set _INCA as large as the segment permits.
help-cycle979-wrong-speed = _RF is 0: alarm 61365.
help-cycle979-wrong-skewed = The line at _STA1 is not perpendicular to the walls: the measured width is too large.
help-cycle979-wrong-lift = _ID is too short; if lengths refer to the centre of the ball (_CBIT[14]=0), it must include the ball radius.

help-cycle997-measures-one = The centre of a sphere.
help-cycle997-measures-three = The centres of three spheres, and from them the translation and rotation of the part.
help-cycle997-measures-diameter = The diameter of each sphere.
help-cycle997-before-above = The ball is at safety height above the setpoint centre of sphere 1; every sphere can be reached from that height without collision.
help-cycle997-before-ball = CYCLE976 has already determined the active ball diameter.
help-cycle997-before-frame = The active zero offset is accurate enough for each sphere to be within _FA of its setpoint position; no scale factor is active and, with three spheres, no mirroring.
help-cycle997-order-paraxial = At the height of the setpoint centre: abscissa plus and minus side, then ordinate plus and minus side through the measured middle; between the points the probe rises to _FA above the sphere.
help-cycle997-order-three-points = At the height of the setpoint centre: three points, the first at _STA1, each following _INCA further, with arcs at _RF between them.
help-cycle997-order-four-points = At the height of the setpoint centre: four points, the first at _STA1, each following _INCA further, with arcs at _RF between them.
help-cycle997-order-top = Then the top, above the centre that was measured.
help-cycle997-order-diameter = One more point at the height of the measured centre, in plus direction of the abscissa, gives the diameter.
help-cycle997-order-repeat = The whole sphere is measured once more, starting from the measured centre.
help-cycle997-order-next = Sphere 2 and sphere 3 follow in the same way; the path to the next sphere is at safety height.
help-cycle997-order-end = End position: at safety height above the last sphere.
help-cycle997-corrects-shift = The zero offset in _KNUM, in all three axes: the sphere gets its setpoint coordinates; the rotation is unchanged. _KNUM=0 corrects nothing.
help-cycle997-corrects-turn = With _KNUM above 0, this zero offset, coarse offset and rotation: the three spheres are then at their setpoint positions. Distortion above _TNVL: alarm 61414, no correction.
help-cycle997-corrects-area = Any difference above _TSA stops the program with alarm 61303.
help-cycle997-wrong-holder = The holder of the sphere is at a measuring point or in the infeed path.
help-cycle997-wrong-no-ball = The probe was calibrated without ball diameter: if none is stored, alarm 61341 occurs; a wrong value shifts every approach to the sphere.
help-cycle997-wrong-line = The setpoint centres are collinear: alarm 61411.

help-cycle998-measures-one = One angle: rotation of a straight edge or surface relative to an axis, from two points.
help-cycle998-measures-two = Two angles: inclination of a plane about the abscissa and the ordinate, from three points.
help-cycle998-before-opposite = The ball is opposite P1, further from _SETVAL than _FA; P2 follows at _ID in plus direction of the offset axis.
help-cycle998-before-both-near = The ball is opposite P1; both points are within twice _FA of this position in the measuring axis.
help-cycle998-before-over = The ball is above P1, at a height from which P2 (_ID further in the abscissa) and P3 (_SETV[0] further in the ordinate) can be reached.
help-cycle998-order-one-angle = P1, then to P2 along the setpoint angle _STA1, inclined away from the surface by the angle _TSA, then P2.
help-cycle998-order-one-paraxial = P1 in direction _MD, back to the start position, by _ID in the offset axis, then P2; _SETVAL is not used.
help-cycle998-order-two-angle = P1, along the setpoint angle to P2, back on the same path, along the other setpoint angle to P3; each path is inclined away from the surface by the angle _TSA.
help-cycle998-order-two-paraxial = P1, P2 and P3, always from start height: in the abscissa, back, in the ordinate.
help-cycle998-order-end = End position: _FA from the last point.
help-cycle998-order-end-height = End position: above P3, at start height.
help-cycle998-corrects-rotation = The rotation of the zero offset in _KNUM (one angle: with _RA=0), by actual angle minus setpoint angle. Position unchanged: measure it afterwards. _KNUM=0 corrects nothing.
help-cycle998-corrects-axis = With _RA above 0, the zero offset of that rotary axis instead; move the rotary axis afterwards.
help-cycle998-corrects-area = An angle that differs by more than _TSA (in degrees) from the setpoint angle raises alarm 61303.
help-cycle998-wrong-degrees = _TSA still contains a value in mm from another cycle; here the unit is degrees.
help-cycle998-wrong-near = The points are close together: 0.01 mm of burr over 10 mm is 0.06°.
help-cycle998-wrong-limit = The part is rotated by more than 45°, which the cycle cannot measure; an _STA1 of more than 45° raises alarm 61331.
help-cycle998-wrong-path = In the measuring axis a point is more than twice _FA from the start position: the probe does not switch there, alarm 61301.
