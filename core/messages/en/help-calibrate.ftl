# Help pages of the cycles that calibrate a workpiece probe.

help-cycle976-measures-hole = Where the probe switches in the plane, against the wall of a ring gauge or a hole of known diameter _SETVAL.
help-cycle976-measures-one = One direction of one axis: _MA and _MD.
help-cycle976-measures-two = Both directions of the axis _MA.
help-cycle976-measures-four = Both directions of both axes.
help-cycle976-measures-centre = The centre of the ring is found on the way.
help-cycle976-measures-surface = Where the probe switches in one direction of one axis, against a surface at _SETVAL.
help-cycle976-measures-length = The length L1 of the probe and its trigger value in the tool axis, against a surface at _SETVAL.
help-cycle976-before-at-centre = The spindle axis stands exactly in the centre of the hole, the ball at calibration depth.
help-cycle976-before-near-centre = The ball stands at calibration depth near the centre, no further off than _FA bridges.
help-cycle976-before-spindle = The probe switches all round, and the spindle can be positioned.
help-cycle976-before-opposite = The ball stands opposite the surface, further away than _FA.
help-cycle976-before-within = The surface lies within twice _FA of where the ball stands; L1 of the probe may be unknown.
help-cycle976-before-radius = The radius of the ball stands in the tool data of the probe; no mirroring is active.
help-cycle976-order-one = The wall is touched once, from the start.
help-cycle976-order-two = Plus direction of _MA, back through the centre, then minus direction.
help-cycle976-order-four = Abscissa plus and minus, then ordinate plus and minus, each time back through the centre.
help-cycle976-order-angle = All directions are turned by _STA1; both axes move together.
help-cycle976-order-twice = All of this twice: first with the spindle turned by 180°, then as it stood. Half the difference of both middles is the skew, their mean the centre.
help-cycle976-order-no-approach = It touches from where it stands, over at most twice _FA in direction _MD, and goes back.
help-cycle976-order-end-centre = It ends where it started, in the centre.
help-cycle976-order-end-found = It ends in the centre that was found.
help-cycle976-order-end-surface = It ends at the start; in the applicate _FA before the surface.
help-cycle976-corrects-ball = The active ball diameter _WP[k,0], which CYCLE979 and CYCLE997 at an angle need, too; with _CBIT[15]=1 also the radius of the probe.
help-cycle976-corrects-skew = The skew of the stylus, _WP[k,7] and _WP[k,8], too.
help-cycle976-corrects-length = L1 in the geometry of the probe takes the difference; _TSA does not watch it.
help-cycle976-wrong-off-centre = The spindle does not stand in the centre: that error goes into every trigger value, with opposite signs.
help-cycle976-wrong-diameter = _SETVAL is not the true diameter of the ring: half the error goes into each trigger value.
help-cycle976-wrong-position = _SETVAL is not where the surface really lies in the active coordinate system.

help-cycle973-measures-surface = Where the probe switches in one direction of one axis, against a surface of the part at _SETVAL.
help-cycle973-measures-groove-one = Where the probe switches in one direction, against a wall or the base of a reference groove.
help-cycle973-measures-groove-two = Where the probe switches in both directions of an axis, against both walls of a reference groove.
help-cycle973-before-surface = The probe has cutting edge position 5 to 8 and stands opposite the surface, further away than _FA.
help-cycle973-before-groove = The probe has cutting edge position 7 or 8; from the start straight ways along the axes lead into the groove _CALNUM.
help-cycle973-before-centre = L1 and L2 of the probe end at the centre of the ball, its radius stands in the tool data.
help-cycle973-order-surface = Only the measuring axis _MA moves, in direction _MD; it ends _FA before the surface.
help-cycle973-order-into-groove = Machine coordinates count. It travels along the axes over the middle of the groove and into it.
help-cycle973-order-one = It touches in direction _MD of the axis _MA; the base of the groove knows the minus direction only.
help-cycle973-order-two = It touches the wall in plus direction, crosses the groove and touches the one in minus direction.
help-cycle973-order-end-groove = It ends in the groove, _FA before the face touched last.
help-cycle973-corrects-ball = The active ball diameter _WP[k,0], too.
help-cycle973-corrects-skew = The position deviation in the axis touched, _WP[k,7] or _WP[k,8], too.
help-cycle973-wrong-groove-data = The data of the groove in _KB are diameters in X: they have to be radii.
help-cycle973-wrong-position = The cutting edge position of the probe is not 7 or 8: alarm 61315.
help-cycle973-wrong-shank = The direction is one in which the shank instead of the ball would touch.
