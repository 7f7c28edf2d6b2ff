# CYCLE119: position in space.

cycle119-title = Position in space from three points
cycle119-help = Calculates the position of a part in space from the setpoints and the measured positions of three points. If requested, it corrects a frame by translation and rotation.
cycle119-words = position in space frame three points triangle align alignment plane rotation shift zero offset rigid best fit helper datum work probe probing set
cycle119-position = Frame from three setpoints and measured points

check-119-set-line = The three setpoints are collinear or coincident: the rotation of the part cannot be calculated.
check-119-measured-line = The three measured points are collinear or coincident: the rotation of the part cannot be calculated.
check-119-line-hint = Choose three points that form a wide triangle, and enter both sets in the same order.

param-119-set-x = Setpoint, 1st geometry axis
param-119-set-x-help = Setpoint of the point, X in workpiece coordinates. The first index is the point (0 to 2), the second the axis (0: X, 1: Y, 2: Z).
param-119-set-y = Setpoint, 2nd geometry axis
param-119-set-y-help = Setpoint of the point, Y in workpiece coordinates.
param-119-set-z = Setpoint, 3rd geometry axis
param-119-set-z-help = Setpoint of the point, Z in workpiece coordinates.
param-119-measured-x = Measured, 1st geometry axis
param-119-measured-x-help = Measured position of the same point, X in workpiece coordinates; usually a result of the previous measurement, such as { "_OVR[5]" }.
param-119-measured-y = Measured, 2nd geometry axis
param-119-measured-y-help = Measured position of the same point, Y in workpiece coordinates.
param-119-measured-z = Measured, 3rd geometry axis
param-119-measured-z-help = Measured position of the same point, Z in workpiece coordinates.
param-119-limit = Distortion limit
param-119-limit-help = The two triangles never match exactly. The cycle corrects the frame only if the sum of the deviations of the three points is less than this limit; otherwise { "_ALARM" } is 61414.
need-119-corrected = Correcting a frame requires a limit.

result-119-alarm = 0, or the alarm number
result-119-distortion = Sum of the three deviations; below 0: no frame
result-119-frame-x = Frame (chained to the active one) that moves the measured triangle to the setpoints: translation X
result-119-frame-y = Result frame: translation Y
result-119-frame-z = Result frame: translation Z
result-119-turn-x = Result frame: rotation about X
result-119-turn-y = Result frame: rotation about Y
result-119-turn-z = Result frame: rotation about Z
