# Help pages of the cycles that calibrate a workpiece probe.

help-cycle976-measures-hole = The trigger points of the probe in the plane, on the wall of a ring gauge or a hole of known diameter _SETVAL.
help-cycle976-measures-one = One direction of one axis: _MA and _MD.
help-cycle976-measures-two = Both directions of the axis _MA.
help-cycle976-measures-four = Both directions of both axes.
help-cycle976-measures-centre = The cycle also determines the centre of the ring.
help-cycle976-measures-surface = The trigger point of the probe in one direction of one axis, on a surface at _SETVAL.
help-cycle976-measures-length = The length L1 of the probe and its trigger point in the tool axis, on a surface at _SETVAL.
help-cycle976-before-at-centre = The spindle axis is exactly at the centre of the hole, the ball at calibration depth.
help-cycle976-before-near-centre = The ball is at calibration depth near the centre, at most _FA away from it.
help-cycle976-before-spindle = The spindle can be positioned, and the probe may be rotated with it to any angle from 0 to 360°.
help-cycle976-before-opposite = The ball is opposite the surface, further away than _FA.
help-cycle976-before-within = The surface is within twice _FA of the ball; L1 of the probe may be unknown.
help-cycle976-before-radius = The ball radius is entered in the tool data of the probe; no mirroring is active.
help-cycle976-order-one = The cycle touches the wall once, from the start position.
help-cycle976-order-two = Plus direction of _MA, back through the centre, then minus direction.
help-cycle976-order-four = Abscissa plus and minus, then ordinate plus and minus, each time back through the centre.
help-cycle976-order-angle = All directions are rotated by _STA1; both axes move together.
help-cycle976-order-twice = The whole sequence twice, with a multi probe first with the spindle rotated by 180°: half the difference between the two centres is then the skew, their mean value is the centre.
help-cycle976-order-no-approach = The cycle touches from the start position in direction _MD, over at most twice _FA, and moves back.
help-cycle976-order-end-centre = End position: the start position at the centre.
help-cycle976-order-end-found = End position: the centre that was measured.
help-cycle976-order-end-surface = End position: the start position; with _MA=3, _FA from the surface.
help-cycle976-corrects-ball = Also the active ball diameter _WP[k,0], which CYCLE979, and CYCLE997 at an angle, require; with _CBIT[15]=1 also the radius of the probe.
help-cycle976-corrects-skew = Also the skew of the stylus, _WP[k,7] and _WP[k,8].
help-cycle976-corrects-length = L1 in the geometry of the probe is corrected by the difference; _TSA does not monitor it.
help-cycle976-wrong-off-centre = The spindle is not at the centre: this error carries over to every trigger point and to every position measured later.
help-cycle976-wrong-diameter = _SETVAL is not the true diameter of the ring: half of the error carries over to each trigger point.
help-cycle976-wrong-position = _SETVAL is not the actual position of the surface in the active coordinate system.

help-cycle973-measures-surface = The trigger point of the probe in one direction of one axis, on a surface of the part at _SETVAL.
help-cycle973-measures-groove-one = The trigger point of the probe in one direction, on a wall or the base of a reference groove.
help-cycle973-measures-groove-two = The trigger points of the probe in both directions of an axis, on both walls of a reference groove.
help-cycle973-before-surface = The probe has cutting edge position 5 to 8 and is opposite the surface, further away than _FA.
help-cycle973-before-groove = The probe has cutting edge position 7 or 8; the groove _CALNUM can be reached from the start position on a clear paraxial path.
help-cycle973-before-centre = L1 and L2 of the probe refer to the centre of the ball, and the ball radius is entered in the tool data.
help-cycle973-order-surface = Only the measuring axis _MA moves, in direction _MD; end position: _FA from the surface.
help-cycle973-order-into-groove = Machine coordinates apply. The probe moves paraxially above the middle of the groove and into it.
help-cycle973-order-one = The cycle touches in direction _MD of axis _MA; on the groove base only the minus direction is possible.
help-cycle973-order-two = The cycle touches the wall in plus direction, crosses the groove and touches the wall in minus direction.
help-cycle973-order-end-groove = End position: in the groove, _FA from the face touched last.
help-cycle973-corrects-ball = Also the active ball diameter _WP[k,0].
help-cycle973-corrects-skew = Also the skew in the measuring axis, _WP[k,7] or _WP[k,8].
help-cycle973-wrong-groove-data = The groove data in _KB are diameters in X: they must be radii.
help-cycle973-wrong-position = The cutting edge position of the probe is not 7 or 8: alarm 61315.
help-cycle973-wrong-shank = In this direction the shank would touch instead of the ball.
