# Help pages of the probing macros of the NCT controls.

help-stylus = The stylus is in the spindle, its length offset is active, and it touches nothing.
help-oriented = The spindle is oriented (M19), and where the machine switches the stylus by M functions, it is on (M59, which also orients). Switch it off with M55 before the spindle starts.
help-levels-none = It calls no other macro, and subprograms on 2 levels. Add the level of the calling program: the limit is in the description of the control.
help-levels-one = It calls macros on 1 level and subprograms on 2 levels. Add the level of the calling program: the limit is in the description of the control.
help-levels-two = It calls macros on 2 levels and subprograms on 2 levels. Add the level of the calling program: the limit is in the description of the control.
help-guarded = The stylus was moved there with G101, so a collision on the path would have stopped it.
help-steps = One touch has three steps: fast up to the signal, back at medium feed, forward again very slowly; the last step gives the result.
help-position-lost = The last G101 did not reach its target: OUT OF POSITION.
help-result = S corrects a work offset by measured minus nominal, T the tool register so that the next part is correct; M only stores the deviation, plus: material left. Without S and T, no correction.
help-limits = A deviation above H raises OUT OF TOLERANCE; a deviation above U raises UPPER TOL EXEEDED, and nothing is corrected.
help-both-targets = S and T are both programmed: FORMAT ERROR. A deviation corrects only one of them.
help-middle-tolerance = The nominal size is not the middle of the tolerance: H applies on both sides of the nominal size (enter 20 +0.1/−0.3 as 19.9 with H0.2).
help-one-system = Part of the calibration was done in inch, part in metric: calibrate everything in one system.

help-g101-measures-nothing = Nothing: it moves the stylus to X, Y, Z and monitors every signal on the path.
help-g101-before-free = The length offset of the stylus is active, and it touches nothing.
help-g101-order-straight = A straight path at F, by default 1500 mm/min; a signal stops it immediately.
help-g101-corrects-nothing = Nothing. After a stop it stores that the target was missed, and every measuring macro is refused until the next G101 succeeds.
help-g101-wrong-obstructed = There is an obstacle in the path: PATH OBSTRUCTED. Move the stylus away manually and choose another path.
help-g101-wrong-incremental = With G91 active, the addresses are incremental, not positions.

help-g102-measures-offset = The offset of the ball from the spindle axis, in both axes of the plane.
help-g102-before-ring = The oriented spindle is on the axis of a bore above 20 mm that it has bored; or #510 contains the M function that rotates it by 180°, and the ball is within 10 mm of a ring gauge's middle.
help-g102-order-walls = Four walls in both axes; with an M function in #510, once more with the spindle rotated by 180°.
help-g102-corrects-offset = #504 and #505, the radial offset in the 1st and 2nd axis of the plane.
help-g102-wrong-moved = The spindle is no longer on the axis of the bore, and #510 is 0 (no rotation by 180°): the position error is stored as offset.

help-g103-measures-radius = The effective ball radius in both directions of both axes of the plane.
help-g103-before-ring = G102 is done; the ball is at depth, within 10 mm of the middle of a ring gauge.
help-g103-order-centre = The probe touches four walls to find the centre of the ring; from the centre, it touches each wall once more.
help-g103-corrects-radius = #500 and #501 for plus and minus of the 1st axis, #502 and #503 for the 2nd axis.
help-g103-wrong-size = D is only approximate: half of its error carries over to every radius. Enter the exact size of the ring.

help-g104-measures-length = The length of the stylus, on a surface whose coordinate in the tool axis is known.
help-g104-before-above = The ball is above the surface; the length register contains the length to within 5 mm.
help-g104-order-down = The stylus touches downwards, at most 10 mm below the specified coordinate.
help-g104-corrects-register = The length register T: afterwards the control shows the specified coordinate where the ball touches.
help-g104-wrong-coordinate = The coordinate refers to a work offset other than the active one.

help-g105-measures-surface = The position of a surface perpendicular to one axis of the plane.
help-g105-before-side = The ball is on the free side of the surface: at depth, or, with the address of the tool axis, above it.
help-g105-order-touch = With the address of the tool axis, the stylus moves to R in front of the surface and down; then it touches towards the nominal coordinate, at most Q past it.
help-g105-corrects-radius = T is a radius register and is corrected by the whole deviation.
help-g105-wrong-far = The surface is more than Q past its nominal coordinate: PROBE FAIL.

help-g106-measures-surface = The height of a surface perpendicular to the tool axis.
help-g106-before-above = The ball is above the touch point.
help-g106-order-down = The stylus touches downwards, at most Q below the nominal coordinate.
help-g106-corrects-length = T is a length register and is corrected by the whole deviation.
help-g106-wrong-low = The ball is already at least Q below the nominal coordinate: NO MOVEMENT.

help-g107-measures-corner = The intersection of the two walls of an internal corner.
help-g107-before-inside = The ball is inside the corner at depth, away from both walls, which are parallel to the axes.
help-g107-order-walls = The wall perpendicular to the 1st axis, back, then the wall perpendicular to the 2nd axis, each at most Q past its nominal coordinate.
help-g107-corrects-offset = The work offset S, without S the active one, in both axes: the corner gets its nominal coordinates.
help-g107-wrong-turned = The part is clamped at an angle: the corner is corrected, its direction is not.

help-g108-measures-corner = The intersection of the two walls of an external corner.
help-g108-before-before = The ball is in front of the corner at depth, outside both walls. It touches as far past the corner as it is in front of the corner at the start.
help-g108-order-walls = The stylus passes the corner, touches the wall perpendicular to the 1st axis and returns; then the same for the 2nd axis, each at most Q past its nominal coordinate.
help-g108-corrects-offset = The work offset S, without S the active one, in both axes, by the deviation of the corner.
help-g108-wrong-close = The start position is too near the corner: only its rounding or chamfer is touched.

help-g109-measures-pocket = The width of a pocket and its middle, in one axis of the plane.
help-g109-measures-web = The width of a web and its middle, in one axis of the plane.
help-g109-before-inside = The ball is at the nominal middle of the pocket, at depth.
help-g109-before-above = The ball is above the nominal middle of the web.
help-g109-order-outwards = One wall outwards, then the opposite wall, each at most Q past its nominal position.
help-g109-order-inwards = On each side the stylus moves to R beside the wall, down, and touches inwards, at most Q past its nominal position.
help-g109-corrects-half = S is corrected by the shift of the middle; T, a radius, by half of the width deviation.
help-g109-wrong-width = No width, or 0: FORMAT ERROR.
help-g109-wrong-room = The corrected tool would no longer fit into the pocket: TOOL DIA OFFS TOO LARGE.

help-g110-measures-bore = The diameter and the centre of a bore.
help-g110-measures-boss = The diameter and the centre of a boss.
help-g110-before-inside = The ball is at the nominal centre of the bore, at depth.
help-g110-before-above = The ball is above the nominal centre of the boss.
help-g110-order-outwards = Both walls in the 1st axis, then both in the 2nd axis, outwards, each at most Q past its nominal position.
help-g110-order-inwards = Both walls in the 1st axis, then both in the 2nd axis: each time to R beside the wall, down, inwards, at most Q past its nominal position.
help-g110-corrects-half = S is corrected by the shift of the centre in both axes; T, a radius, by half of the diameter deviation.
help-g110-wrong-room = The corrected tool would no longer fit into the bore: TOOL DIA OFFS TOO LARGE.

help-p9920-measures-probe = Position and diameter of the tool probe disc.
help-p9920-measures-length = The length of a tool.
help-p9920-measures-both = Length and diameter of a tool.
help-p9920-before-reference = The machine is referenced, and the axis of the probe is parallel to Z.
help-p9920-before-centre = The reference tool, of exactly known diameter, is above the centre of the disc.
help-p9920-before-above = The tool is above the probe in Z, and the probe is calibrated.
help-p9920-order-rim = In +X, −X, +Y and −Y: from the centre out by half the sum of the two diameters plus E, down by Z, in to the rim, up again.
help-p9920-order-face = Then, above the centre, down to the disc, and up to the start position.
help-p9920-order-length = In +X to half of D from the centre, then down by at most Z until it touches.
help-p9920-order-diameter = Up by K from the touch, in +X to half the sum of the two diameters plus E from the centre, down to K below the touch, in to the rim.
help-p9920-corrects-probe = #506, #507 and #508 receive the position of the disc, #509 its diameter, #513 the length of the reference tool.
help-p9920-corrects-length = The length in register T, as G43 applies it.
help-p9920-corrects-radius = The radius in register T.
help-p9920-wrong-length = After the macro G49 is active, and feed and speed may have changed: activate a length again before moving in Z.
help-p9920-wrong-turning = A tool that rotates while it moves down (M3, M4) may tear off the disc.
help-p9920-wrong-lift = With a lift below 2 mm the tool may miss the rim of the disc.
help-p9920-wrong-disk = The disc diameter differs by more than 2 mm from the 40 mm in #509: until the probe is calibrated, the macro calculates with a wrong diameter.
