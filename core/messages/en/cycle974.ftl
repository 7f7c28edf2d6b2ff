# CYCLE974: titles, search words, variants, words of its own parameters, checks and results.

cycle974-title = Turned part: one point
cycle974-help = Measures one point of a turned part, outside or inside, on a diameter, an end face or in the third axis, against the setpoint from the drawing.
cycle974-words = measure workpiece turning lathe turned part diameter outside inside shoulder end face length one point single X Z Y facing axis reversal runout spindle tool offset wear zero offset ZO probe probing datum work
cycle974-each-words = turning lathe diameter face length L1 L2

cycle974-tool = One point: correct a tool
cycle974-zero = One point: correct a zero offset
cycle974-reversal = One point with reversal: correct a tool

mvar-reversal = Reversal
reversal-without = Without
reversal-with = With: measured again after the part has turned by 180°
reversal-with-words = reversal spindle 180 degree runout eccentricity opposite

param-setval-turned-diameter = Set diameter
param-setval-turned-diameter-help = From the drawing. With DIAMON it is the diameter, with DIAMOF the radius.
param-setval-turned-position = Set position
param-setval-turned-position-help = Where the surface should be in the workpiece coordinate system, in the measuring axis.
param-sta1-spindle = Spindle position
param-sta1-spindle-help = Angle to which the spindle turns the part for the first touch; the second one is 180° further.

need-angle-reversal = With reversal the cycle positions the spindle.

check-reversal-part = With reversal the cycle turns the part by 180°, but the spindle cannot be positioned.
check-reversal-part-hint = Measure without reversal, or on a machine whose master spindle can be positioned.

result-compensation-radius = Compensation value, as a radius
