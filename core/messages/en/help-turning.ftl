# Help pages of the cycles that measure a workpiece on turning machines.

help-turning-probe = The probe (type 5xy) is in the working position, its D number and G40 are active; the coordinate system is neither turned nor scaled.
help-turning-diameter = Diameters and radii are mixed up: with DIAMON setpoint and tolerances in X are diameters, _FA and the correction are not.

help-cycle974-measures-point = The position of one point of a turned part: a diameter seen from one side, an end face, or a point in the third axis.
help-cycle974-before-opposite = The ball stands opposite the point, further away than _FA; it measures from there towards _SETVAL.
help-cycle974-before-chuck = The master spindle, which holds the part, can be positioned.
help-cycle974-order-axis = Only the measuring axis moves; it ends _FA before the surface.
help-cycle974-order-reversal = The spindle goes to _STA1 and the point is touched; the spindle turns by 180° and it is touched again. The mean counts, so that run-out cancels.
help-cycle974-corrects-half = A length takes the deviation along its axis: half of a deviation in diameter.
help-cycle974-corrects-one-axis = Only the measuring axis is corrected.
help-cycle974-wrong-side = The start lies on the wrong side or within _FA of the surface.
help-cycle974-wrong-run-out = The part runs out: one point is not its diameter. Measure with reversal.

help-cycle994-measures-diameter = A diameter of a turned part about the workpiece zero, from two opposite points.
help-cycle994-before-plus-side = The ball stands opposite the point on the plus side, further away than _FA.
help-cycle994-before-inside = The ball stands inside the bore; _SZA and _SZO describe what has to be gone round there, ball radius included.
help-cycle994-before-either = Where the ball stands decides: further out than the setpoint measures outside, with the zone _SZA and _SZO to be gone round, ball radius included; nearer measures inside.
help-cycle994-order-plus-first = The point on the plus side is touched first, then the one on the minus side; it ends _FA before that one.
help-cycle994-order-round-inside = Inside the bore it goes along the zone: out to _SZO, along to _SZA, across and back.
help-cycle994-order-round-outside = Outside it goes out to _SZO, along to _SZA, across and back; inside it goes straight through the bore.
help-cycle994-corrects-half = A length takes half the deviation of the diameter.
help-cycle994-wrong-zone = The zone is an old one or leaves no room for the ball: it runs into the part (61302), or no way is left (61334).
help-cycle994-wrong-ball = With _CHBIT[7]=1 the stored ball diameter counts instead of both trigger values: it has to be right.
