# Measuring in JOG as a program, and a call as its mask: what differs, why there is none.

jog-differs-expected = The cycle expects the part within { $reach } mm of the set position; further away it raises 61301 or 61303. JOG searches from where the probe stands.
jog-differs-stand = The cycle takes where the probe stands at the call as set position, and measures on lines through it. JOG measures through where the probe was jogged to; the set position is a field.
jog-differs-points = The cycle travels between its points by itself and touches at places of its own.
jog-differs-up = Between the points the probe rises by { $path } mm (_ID). JOG does not know the height of the part: check that this is enough.
jog-differs-fourth = The cycle needs a fourth point: between P3 and the corner.
jog-differs-around = The cycle goes around the spigot at measuring height. In JOG the probe goes over it.
jog-differs-angle = The cycle measures angles up to 45°; beyond that it raises 61331.
jog-differs-skew = JOG puts the ball, not the spindle axis, opposite the point. On an edge at an angle the cycle touches off by the skew of the probe.
jog-differs-corner-zero = The cycle makes the corner zero of both axes. The set positions of the mask have no place in it.
jog-differs-fine = JOG writes coarse and clears fine. The cycle corrects fine; with _CHBIT[21] = 1 it does as JOG.
jog-differs-active = What the cycle writes takes effect when the program calls the zero offset again. JOG activates it at once or on the activation screen.
jog-differs-tool-data = The cycle takes tool probe and speeds from its own data (_TP, _CM), JOG from E_MESS_MT_… and E_MESS_….
jog-differs-spindle = With a rotated WCS the cycle lets the spindle follow as { $cycle } = { $there } says (1: it follows), JOG as { $jog } = { $here } (0: it follows).
jog-differs-tilted = In a tilted WCS the spindle stays in the cycle, although _CHBIT[13] = 1. In JOG it follows.
jog-differs-tool-memory = The cycle writes as { $cycle } = { $there } says, JOG as { $jog } = { $here }: 0 geometry, 1 wear.
jog-differs-input = The cycle reads the probe at another input ({ $cycle } = { $there }) than JOG ({ $jog } = { $here }): 0 input 1, 1 input 2.
jog-differs-watched = With { $cycle } = { $there } the cycle does not watch the way between the points (61302) and travels it rapidly. JOG always watches it.
jog-differs-attempts = Without a signal the cycle tries as { $cycle } = { $there } says, JOG as { $jog } = { $here }: 0 five times, 1 once.
jog-differs-attempts-tool = Without a signal the cycle tries five times ({ $cycle } = { $there }). JOG touches a tool probe once.
jog-differs-return = The cycle returns from the point as { $cycle } = { $there } says, JOG as { $jog } = { $here }: 0 with positioning feed, 1 rapidly.
jog-differs-return-tool = The cycle returns from the point rapidly ({ $cycle } = { $there }), JOG with positioning feed.
jog-differs-touches = The cycle touches as { $cycle } = { $there } says, JOG as { $jog } = { $here }: 0 once, 1 first fast with _SPEED[3].
jog-differs-touches-tool = The cycle touches fast with _SPEED[3] first ({ $cycle } = { $there }). JOG has feeds of its own for tools.
jog-differs-screen = With { $cycle } = { $there } the cycle shows its result screen, and waits for NC START if _CHBIT[11] = 1. JOG shows results in the mask.
jog-differs-repeats = With { $cycle } = { $there } the cycle measures up to four times again outside its limits, with _CBIT[1] = 1 after M0. JOG has no limits.
jog-differs-offset-angle = With { $cycle } = { $there } the cycle turns the mono probe by _CORA in addition. JOG does not.
jog-differs-speeds = With { $cycle } = { $there } the cycle takes speeds and feeds of a rotating tool from _MFS[]. JOG calculates them from E_MESS_MAX_V and others.
jog-differs-erases = With { $cycle } = { $there } the cycle first deletes _WP[], _TP[] and other data of the probes. JOG keeps them.
jog-differs-watches-calibration = With { $cycle } = { $there } the cycle also measures with a probe that was calibrated otherwise. JOG refuses it (61341).
jog-differs-feeds = Between the points the cycle travels at _SPEED[1] = { $plane } mm/min and _SPEED[2] = { $depth } mm/min, JOG at E_MESS_F = { $feed } and E_MESS_FZ = { $infeed }.
jog-program-points = Measure all points first: the call needs their places.
jog-program-centres = No cycle measures several holes or spigots and corrects a zero offset by their centres. CYCLE977 with _KNUM = 0 measures each centre; CYCLE116 calculates a circle through three or four.
jog-program-none = No cycle does the same.
jog-program-step = No cycle measures two edges that face the same way or lie the other way round.
jog-program-heights = No cycle measures a groove or web along the infeed axis.
jog-program-corner = The points do not lie on the edges of this corner. Check the position, then measure them again.
jog-back-tool = The call corrects a tool. JOG measures only, or corrects a zero offset.
jog-back-without = The mask has no field for { $names }.
jog-back-direction = The call measures from where the probe stands towards the set position. Choose the direction in the mask.
jog-back-position = The set position of the call is where the probe stands in the program. Enter it in the mask.
