# Measuring in JOG as a program, and a call as its mask: what differs, why there is none.

jog-differs-expected = The cycle expects the part within { $reach } mm of the set position; further away it raises 61301 or 61303. JOG searches from where the probe stands.
jog-differs-stand = The cycle takes where the probe stands at the call as set position, and measures on lines through it. JOG measures through where the probe was jogged to; the set position is a field.
jog-differs-points = The cycle travels between its points by itself and touches at places of its own.
jog-differs-up = Between the points the probe rises by { $path } mm (_ID). JOG does not know the height of the part: check that this is enough.
jog-differs-fourth = The cycle needs a fourth point: between P3 and the corner.
jog-differs-around = The cycle goes around the spigot at measuring height. In JOG the probe goes over it.
jog-differs-angle = The cycle measures angles up to 45°; beyond that it raises 61331.
jog-differs-skew = JOG puts the ball, not the spindle axis, opposite the point. On an edge at an angle the cycle touches off by the skew of the probe.
jog-differs-spindle = In JOG the spindle follows a rotated WCS as E_MESS_SETT[0] says, in the cycle as _CHBIT[13] says. They are set differently.
jog-differs-corner-zero = The cycle makes the corner zero of both axes. The set positions of the mask have no place in it.
jog-differs-fine = JOG writes coarse and clears fine. The cycle corrects fine; with _CHBIT[21] = 1 it does as JOG.
jog-differs-active = What the cycle writes takes effect when the program calls the zero offset again. JOG activates it at once or on the activation screen.
jog-differs-tool-data = The cycle takes tool probe and speeds from its own data (_TP, _CM), JOG from E_MESS_MT_… and E_MESS_….
jog-differs-tool-memory = JOG writes geometry or wear as _JM_B[0] says, the cycle as _CHBIT[3] says. They are set differently.
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
