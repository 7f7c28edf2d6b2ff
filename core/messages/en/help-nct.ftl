# Help pages of the probing macros of the NCT controls.

help-stylus = The stylus is in the spindle, its length offset is applied, and it touches nothing.
help-guarded = It was moved there with G101, so that a collision on the way would have stopped it.
help-steps = One touch has three steps: fast up to the signal, back at medium feed, forward again very slowly; the last one counts.
help-position-lost = The last G101 did not reach its target: OUT OF POSITION.
help-result = With S a work offset takes measured minus nominal; with T the tool register takes it, so that the next part comes out right; with M it is only stored, positive where material is left. Without them nothing is corrected.
help-limits = A deviation greater than H is OUT OF TOLERANCE; one greater than U is UPPER TOL EXEEDED and corrects nothing.
help-both-targets = S and T are both given: a deviation belongs to one of them.
help-middle-tolerance = The nominal size is not the middle of the tolerance: H counts to both sides of it (20 +0.1/−0.3 is 19.9 with H0.2).
help-one-system = Part of the calibration was made in inch, part in metric: do all of it in one system.

help-g101-measures-nothing = Nothing: it moves the stylus to X, Y, Z and watches every signal on the way.
help-g101-before-free = The length offset of the stylus is applied, and it touches nothing.
help-g101-order-straight = A straight way at F, 1500 mm/min unless given; a signal stops it at once.
help-g101-corrects-nothing = Nothing. After a stop it remembers that the target was missed, and every gauging macro refuses until the next G101 succeeds.
help-g101-wrong-obstructed = Something stands in the way: PATH OBSTRUCTED. Move the stylus away by hand and choose another way.
help-g101-wrong-incremental = With G91 active the addresses are ways, not positions.

help-g102-measures-offset = How far the ball stands beside the spindle axis, in both axes of the plane.
help-g102-before-ring = The ball is in the middle of a bore of diameter D, within 10 mm. Either this spindle has just bored it, or it is a ring and #510 holds the M function that turns the spindle by 180°.
help-g102-order-walls = Four walls in both axes; with #510 set once more with the spindle turned by 180°.
help-g102-corrects-offset = #504 and #505, the radial offset in the first and second axis of the plane.
help-g102-wrong-moved = The bore was not made with the spindle where it stands, and the spindle is not turned over: its place counts as offset.

help-g103-measures-radius = The effective ball radius in both directions of both axes of the plane.
help-g103-before-ring = G102 is done; the ball is in the middle of a ring gauge, within 10 mm, at depth.
help-g103-order-centre = Four walls give the centre of the ring; from there each wall is touched once more.
help-g103-corrects-radius = #500 and #501 for plus and minus of the first axis, #502 and #503 for the second.
help-g103-wrong-size = D is only approximate: half its error goes into every radius. Give the exact size of the ring.

help-g104-measures-length = The length of the stylus, against a surface whose coordinate along the tool axis is given.
help-g104-before-above = The ball is above the surface; the length register holds the length to about 5 mm.
help-g104-order-down = It touches downwards, at most 10 mm below the given coordinate.
help-g104-corrects-register = The length register T: afterwards the control shows the given coordinate where the ball touches.
help-g104-wrong-coordinate = The coordinate belongs to another work offset than the active one.

help-g105-measures-surface = The position of a surface that stands across one axis of the plane.
help-g105-before-side = The ball stands on the free side of the surface: at depth, or, with the address of the tool axis, above it.
help-g105-order-touch = With the address of the tool axis it goes to R before the surface and down; then it touches towards the nominal coordinate, at most Q past it.
help-g105-corrects-radius = T is the register of a radius and takes the whole deviation.
help-g105-wrong-far = The surface lies further than Q behind its nominal coordinate: PROBE FAIL.

help-g106-measures-surface = The height of a surface that lies across the tool axis.
help-g106-before-above = The ball stands above the place to be touched.
help-g106-order-down = It touches downwards, at most Q below the nominal coordinate.
help-g106-corrects-length = T is the register of a length and takes the whole deviation.
help-g106-wrong-low = The ball already stands below the nominal coordinate: NO MOVEMENT.

help-g107-measures-corner = Where the two walls of an internal corner meet.
help-g107-before-inside = The ball stands inside the corner at depth, away from both walls, which lie along the axes.
help-g107-order-walls = The wall across the first axis, back, then the wall across the second one, each at most Q past its nominal coordinate.
help-g107-corrects-offset = The work offset S, without S the active one, in both axes: the corner gets its nominal coordinates.
help-g107-wrong-turned = The part is clamped at an angle: a corner is corrected, its direction is not.

help-g108-measures-corner = Where the two walls of an external corner meet.
help-g108-before-before = The ball stands before the corner at depth, outside of both walls. It stands as far before the corner as it is to touch behind it.
help-g108-order-walls = It passes the corner, touches the wall across the first axis and returns; then the same for the second axis, each at most Q past its nominal coordinate.
help-g108-corrects-offset = The work offset S, without S the active one, in both axes, by the difference of the corner.
help-g108-wrong-close = The start lies too near to the corner: only its rounding or chamfer is touched.

help-g109-measures-pocket = The width of a pocket and its middle, in one axis of the plane.
help-g109-measures-web = The width of a web and its middle, in one axis of the plane.
help-g109-before-inside = The ball stands in the nominal middle of the pocket, at depth.
help-g109-before-above = The ball stands above the nominal middle of the web.
help-g109-order-outwards = One wall outwards, then the opposite one, each at most Q past its nominal place.
help-g109-order-inwards = On each side it goes to R beside the wall, down, and touches inwards, at most Q past its nominal place.
help-g109-corrects-half = S takes the shift of the middle; T, a radius, takes half the deviation of the width.
help-g109-wrong-width = No width, or 0: FORMAT ERROR.

help-g110-measures-bore = The diameter and the centre of a bore.
help-g110-measures-boss = The diameter and the centre of a boss.
help-g110-before-inside = The ball stands in the nominal centre of the bore, at depth.
help-g110-before-above = The ball stands above the nominal centre of the boss.
help-g110-order-outwards = Both walls in the first axis, then both in the second, outwards, each at most Q past its nominal place.
help-g110-order-inwards = Both walls in the first axis, then both in the second: each time to R beside the wall, down, inwards, at most Q past its nominal place.
help-g110-corrects-half = S takes the shift of the centre in both axes; T, a radius, takes half the deviation of the diameter.
help-g110-wrong-room = The corrected tool would no longer fit into the bore: TOOL DIA OFFS TOO LARGE.

help-p9920-measures-probe = Where the disk of the tool probe stands, and its diameter.
help-p9920-measures-length = The length of a tool.
help-p9920-measures-both = Length and diameter of a tool.
help-p9920-before-reference = The reference point has been assumed, and the axis of the probe is parallel to Z.
help-p9920-before-centre = The reference tool, whose diameter is exactly known, stands above the centre of the disk.
help-p9920-before-above = The tool stands above the probe in Z, and the probe has been calibrated.
help-p9920-order-rim = From +X, −X, +Y and −Y: out beside the disk by half of both diameters and E, down by Z, to the rim, up again.
help-p9920-order-face = Then over the centre down to the disk, and up to where it began.
help-p9920-order-length = Beside the centre by half of D, down by at most Z until it touches.
help-p9920-order-diameter = Up by K from there, out in +X by half of both diameters and E, down to K below where it touched, to the rim.
help-p9920-corrects-probe = #506, #507 and #508 get the place of the disk, #509 its diameter, #513 the length of the reference tool.
help-p9920-corrects-length = The length of the register T, as G43 applies it.
help-p9920-corrects-radius = The radius of the register T.
help-p9920-wrong-length = The macro leaves G49, and feed and speed may be others: apply a length again before moving in Z.
help-p9920-wrong-turning = A tool that turns while it comes down (M3, M4) may tear off the disk.
help-p9920-wrong-lift = With a lift below about 2 mm the tool does not meet the rim of the disk.
help-p9920-wrong-disk = A disk whose diameter differs from the 40 mm of #509 by more than 2 mm is no longer reckoned rightly before it is calibrated.
