# CYCLE994: titles, search words, variants, words of its own parameters, checks and results.

cycle994-title = Turned part: two points
cycle994-help = Measures a diameter of a turned part by two opposite points that lie at plus and minus the setpoint about the workpiece zero, outside or inside, and corrects a tool.
cycle994-words = measure workpiece turning lathe turned part diameter bore shaft outside inside two points opposite safety zone protection zone X Y facing axis tool offset wear probe probing

cycle994-inside-zone = Inside, around a protection zone
cycle994-inside-zone-words = turning lathe bore diameter two points safety obstacle stud tool offset wear
cycle994-outside-inside = Outside around a zone, or inside without one
cycle994-outside-inside-words = turning lathe diameter shaft bore two points protection safety tool offset wear

param-setval-two-diameter = Set diameter
param-setval-two-diameter-help = From the drawing. With DIAMON it is the diameter, with DIAMOF the radius; both points lie about the workpiece zero.
param-setval-two-radius = Set distance from the zero
param-setval-two-radius-help = Both points lie this far from the workpiece zero, one in plus and one in minus.
param-sza-turned = Protection zone in the abscissa
param-sza-turned-help = Position in the 1st axis of the plane (G18: Z) at which the probe passes the part, seen from the workpiece zero. The centre of the ball passes there: add its radius.
param-szo-turned = Protection zone in the ordinate
param-szo-turned-help = Size in the 2nd axis of the plane (G18: X) to which the probe moves before it passes the part; a diameter with DIAMON, else a radius. The centre of the ball passes there: add its radius.
param-szo-turned-applicate = Protection zone in the applicate
param-szo-turned-applicate-help = Size in the 3rd axis (G18: Y) to which the probe moves before it passes the part; a radius, or like X with _CHBIT[19]=1. The centre of the ball passes there: add its radius.

need-zone-inside = This variant goes around a protection zone.
need-zone-outside = Needed outside; inside this variant has no zone, and leaving it out is right.

check-two-setpoint = The two points lie at plus and minus the setpoint; { $set } mm leaves no room between them.
check-two-setpoint-hint = Enter the diameter or radius as a number above 0.
check-two-ball = Without calibration ({ "_CHBIT[7]" }=1) the ball diameter { $name } counts, and it is 0.
check-two-ball-hint = Enter the ball diameter into { $name }, or calibrate the probe and set { "_CHBIT[7]" }=0.
check-two-zone-inside = The protection zone { $zone } mm leaves no room for the ball inside of { $size } mm.
check-two-zone-inside-hint = Choose a zone of up to { $limit } mm, in the measuring axis.
check-two-no-zone = Without a protection zone this variant measures inside; outside, the zone of an earlier call would count.
check-two-no-zone-hint = Enter { "_SZA" } and { "_SZO" } for a measurement outside.
check-two-half-zone = Only a part of the protection zone is given: for { $name } the value of an earlier call counts.
check-two-half-zone-hint = Give both _SZA and _SZO outside, none of them inside.
check-two-zone-outside = Outside, the ball would touch the part of { $size } mm when it passes at { $zone } mm; inside, this zone does not count.
check-two-zone-outside-hint = Outside, choose a zone of at least { $limit } mm; inside, leave it out.

result-set-two = Set diameter or radius
result-set-two-abscissa = Set diameter or radius, abscissa
result-set-two-ordinate = Set diameter or radius, ordinate
result-set-two-applicate = Set diameter or radius, applicate
result-actual-two = Actual diameter or radius
result-actual-two-abscissa = Actual diameter or radius, abscissa
result-actual-two-ordinate = Actual diameter or radius, ordinate
result-actual-two-applicate = Actual diameter or radius, applicate
result-difference-two = Difference of diameter or radius
result-difference-two-abscissa = Difference of diameter or radius, abscissa
result-difference-two-ordinate = Difference of diameter or radius, ordinate
result-difference-two-applicate = Difference of diameter or radius, applicate
