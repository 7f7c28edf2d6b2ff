# What the cycles with the workpiece probe of a turning machine have in common.

ma-lathe-abscissa = Abscissa (G18: Z)
ma-lathe-ordinate = Ordinate (G18: X)
ma-lathe-applicate = Applicate (G18: Y), if available

param-fa-lathe = Measuring path
param-fa-lathe-help = Distance from the start of the measuring block to the setpoint position, and the same past it; the end position is as far from the surface. Always in mm, in X as a radius.

check-lathe-probe = A tool of type { $type } is active, but this cycle needs the probe of a turning machine.
check-lathe-probe-hint = Program the probe with its D number before the call; it needs type 5xy and cutting edge position 5 to 8.
check-lathe-tip = Cutting edge position { $tip } of the probe is not permitted here.
check-lathe-tip-hint = A probe has position 5, 6, 7 or 8: the side to which the stylus points. Correct $TC_DP2.
