# CYCLE974: titles, search words, variants, words of its own parameters, checks and results.

cycle974-title = Turned part: 1-point measurement
cycle974-help = Measures one point of a turned part, outside or inside, on a diameter, an end face or in the 3rd axis, against the setpoint from the drawing.
cycle974-words = measure workpiece turning lathe turned part diameter outside inside shoulder end face length one point single X Z Y facing axis reversal runout spindle tool offset wear zero offset ZO probe probing datum work
cycle974-each-words = turning lathe diameter face length L1 L2

cycle974-tool = 1-point measurement: correct a tool
cycle974-zero = 1-point measurement: correct a zero offset
cycle974-reversal = 1-point with reversal: correct a tool

mvar-reversal = Reversal
reversal-without = Without
reversal-with = With: 2nd touch, part rotated by 180°
reversal-with-words = reversal spindle 180 degree runout eccentricity opposite

param-setval-turned-diameter = Setpoint diameter
param-setval-turned-diameter-help = From the drawing. With DIAMON it is the diameter, with DIAMOF the radius.
param-setval-turned-position = Setpoint position
param-setval-turned-position-help = Position of the surface from the drawing, in the workpiece coordinate system, in the measuring axis.
param-sta1-spindle = Spindle position
param-sta1-spindle-help = Angle to which the spindle rotates the part for the first touch; the second touch is 180° further.

need-angle-reversal = For reversal, the cycle positions the spindle.

check-reversal-part = For reversal, the cycle rotates the part by 180°, but the spindle cannot be positioned.
check-reversal-part-hint = Measure without reversal, or on a machine whose master spindle can be positioned.

result-compensation-radius = Compensation value, as a radius
