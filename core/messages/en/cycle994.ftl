# CYCLE994: titles, search words, variants, words of its own parameters, checks and results.

cycle994-title = Turned part: 2-point measurement
cycle994-help = Measures a diameter of a turned part, outside or inside, at two opposite points at plus and minus the setpoint from the workpiece zero, and corrects a tool.
cycle994-words = measure workpiece turning lathe turned part diameter bore shaft outside inside two points opposite safety zone protection zone X Y facing axis tool offset wear probe probing

cycle994-inside-zone = Inside, around a protection zone
cycle994-inside-zone-words = turning lathe bore diameter two points safety obstacle stud tool offset wear
cycle994-outside-inside = Outside around a zone, or inside without
cycle994-outside-inside-words = turning lathe diameter shaft bore two points protection safety tool offset wear

param-setval-two-diameter = Setpoint diameter
param-setval-two-diameter-help = From the drawing. With DIAMON it is the diameter, with DIAMOF the radius; both points are symmetrical about the workpiece zero.
param-setval-two-radius = Setpoint distance from zero
param-setval-two-radius-help = Distance of each point from the workpiece zero, one in plus and one in minus direction.
param-sza-turned = Protection zone in the abscissa
param-sza-turned-help = Border of the zone in the 1st axis of the plane (G18: Z), from the workpiece zero. The ball centre moves along it: add the ball radius; to a diameter (X, DIAMON) the ball diameter.
param-szo-turned = Protection zone in the ordinate
param-szo-turned-help = Border of the zone in the 2nd axis (G18: X), along which the centre of the ball moves: a radius plus the ball radius, or in X with DIAMON a diameter plus the ball diameter.
param-szo-turned-applicate = Protection zone in the applicate
param-szo-turned-applicate-help = Border of the zone in the 3rd axis (G18: Y), along which the centre of the ball moves: a radius plus the ball radius, or as X with _CHBIT[19]=1.

need-zone-inside = This variant moves around a protection zone.
need-zone-outside = Needed for a measurement outside; inside, this variant has no zone: leave the field empty.

check-two-setpoint = The two points are at plus and minus the setpoint: { $set } mm leaves no room between them.
check-two-setpoint-hint = Enter the diameter or radius as a value above 0.
check-two-ball = Without calibration ({ "_CHBIT[7]" }=1) the cycle uses the ball diameter { $name }, but it is 0 or less.
check-two-ball-hint = Enter the ball diameter in { $name }, or calibrate the probe and set { "_CHBIT[7]" }=0.
check-two-zone-inside = The protection zone, { $zone } mm, leaves no room for the ball inside { $size } mm.
check-two-zone-inside-hint = Reduce the protection zone to at most { $limit } mm, in the measuring axis.
check-two-no-zone = Without a protection zone this variant measures inside; outside, the zone of an earlier call would apply.
check-two-no-zone-hint = Enter { "_SZA" } and { "_SZO" } for a measurement outside.
check-two-half-zone = The protection zone is incomplete: for { $name } the value of an earlier call applies.
check-two-half-zone-hint = Outside, enter both _SZA and _SZO; inside, neither of them.
check-two-zone-outside = Outside, the ball would touch the part, { $size } mm, when it passes at { $zone } mm; inside, this zone is ignored.
check-two-zone-outside-hint = Outside, increase the zone to at least { $limit } mm; inside, leave it empty.

result-set-two = Setpoint diameter or radius
result-set-two-abscissa = Setpoint size, abscissa
result-set-two-ordinate = Setpoint size, ordinate
result-set-two-applicate = Setpoint size, applicate
result-actual-two = Actual diameter or radius
result-actual-two-abscissa = Actual size, abscissa
result-actual-two-ordinate = Actual size, ordinate
result-actual-two-applicate = Actual size, applicate
result-difference-two = Difference, diameter or radius
result-difference-two-abscissa = Size difference, abscissa
result-difference-two-ordinate = Size difference, ordinate
result-difference-two-applicate = Size difference, applicate
