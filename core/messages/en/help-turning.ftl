# Help pages of the cycles that measure a workpiece on turning machines.

help-turning-probe = The probe (type 5xy) is in the working position, its D number and G40 are active; no rotation and no scale factor is active.
help-turning-diameter = Diameters and radii are mixed up: with DIAMON, setpoint and, when measuring, tolerances in X are diameters; _FA, trigger points and the correction are not.

help-cycle974-measures-point = The position of one point of a turned part: a diameter measured from one side, an end face, or a point in the 3rd axis.
help-cycle974-before-opposite = The ball is opposite the point, further away than _FA; it measures from there towards _SETVAL.
help-cycle974-before-chuck = The master spindle, which holds the part, can be positioned.
help-cycle974-order-axis = The probe moves only in the measuring axis; end position: _FA from the surface.
help-cycle974-order-reversal = The spindle moves to _STA1 and the point is touched; the spindle rotates by 180° and the point is touched again. The mean value is used, so run-out cancels.
help-cycle974-corrects-half = A length is corrected by the deviation along its axis: half of a diameter deviation.
help-cycle974-corrects-one-axis = Only the measuring axis is corrected; with _CHBIT[19]=1, in G18, X instead of Y.
help-cycle974-wrong-side = The start position is on the wrong side or within _FA of the surface.
help-cycle974-wrong-run-out = The part has run-out: the result depends on the spindle position. For a tool offset, measure with reversal.

help-cycle994-measures-diameter = A diameter of a turned part about the workpiece zero, from two opposite points.
help-cycle994-before-plus-side = The ball is opposite the point on the plus side, further away than _FA.
help-cycle994-before-inside = The ball is inside the bore; _SZA and _SZO describe the obstacle there, ball radius included.
help-cycle994-before-either = The start position decides: further out than the setpoint measures outside, around the zone _SZA and _SZO, ball radius included; nearer measures inside.
help-cycle994-before-calibrated = The probe is calibrated in this plane and in the measuring directions, at the same feed; with _CHBIT[7]=1 the stored ball diameter suffices.
help-cycle994-order-plus-first = The cycle touches the point on the plus side first, then the point on the minus side; end position: _FA from the latter.
help-cycle994-order-round-inside = Inside the bore, the probe moves along the zone: to _SZO, along to _SZA, across and back (with _MA=1 to _SZA first).
help-cycle994-order-round-outside = Outside, the probe moves out to _SZO, along to _SZA, across and back (with _MA=1 to _SZA first); inside, it moves straight through the bore.
help-cycle994-corrects-half = A length is corrected by half of the diameter deviation.
help-cycle994-wrong-zone = The zone is that of an earlier call or leaves no room for the ball: the probe hits the part (alarm 61302), or there is no path (61334).
help-cycle994-wrong-ball = With _CHBIT[7]=1 the stored ball diameter is used instead of the two trigger points: it must be correct.
