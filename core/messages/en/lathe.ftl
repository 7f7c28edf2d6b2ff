# What the cycles with the workpiece probe of a turning machine have in common.

ma-lathe-abscissa = Abscissa (G18: Z)
ma-lathe-ordinate = Ordinate (G18: X)
ma-lathe-applicate = Applicate (G18: Y), where there is one

param-fa-lathe = Measuring path
param-fa-lathe-help = Distance from the start of the measuring block to the set position; the same distance again is travelled beyond it, and the probe ends this far before the surface. Always in mm, in X as a radius.

check-lathe-probe = A tool of type { $type } is in use: these cycles work with the probe of a turning machine.
check-lathe-probe-hint = Call the probe with its D number before; its type is 5xy, its cutting edge position 5 to 8.
check-lathe-tip = The cutting edge position { $tip } of the probe is not permitted here.
check-lathe-tip-hint = A probe has position 5, 6, 7 or 8: the side to which the stylus points. Correct $TC_DP2.
