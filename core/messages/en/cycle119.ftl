# CYCLE119: position in space.

cycle119-title = Position in space from three points
cycle119-help = Computes how a part lies in space from three points that should be somewhere, the reference triangle, and the same points as measured; corrects a frame by shift and rotation, if it is told to.
cycle119-words = position in space frame three points triangle align alignment plane rotation shift zero offset rigid best fit helper datum work probe probing
cycle119-position = Frame from three set and three measured points

check-119-set-line = The three set points lie on one line or upon each other: they do not tell how the part is turned.
check-119-measured-line = The three measured points lie on one line or upon each other: they do not tell how the part is turned.
check-119-line-hint = Choose three points that form a wide triangle, and enter them in the same order both times.

param-119-set-x = Set point, 1st geometry axis
param-119-set-x-help = Where the point should be, X in workpiece coordinates. The first index is the point (0 to 2), the second the axis (0: X, 1: Y, 2: Z).
param-119-set-y = Set point, 2nd geometry axis
param-119-set-y-help = Where the point should be, Y in workpiece coordinates.
param-119-set-z = Set point, 3rd geometry axis
param-119-set-z-help = Where the point should be, Z in workpiece coordinates.
param-119-measured-x = Measured point, 1st geometry axis
param-119-measured-x-help = Where the same point was measured, X in workpiece coordinates; usually a result such as { "_OVR[5]" } of the measurement before.
param-119-measured-y = Measured point, 2nd geometry axis
param-119-measured-y-help = Where the same point was measured, Y in workpiece coordinates.
param-119-measured-z = Measured point, 3rd geometry axis
param-119-measured-z-help = Where the same point was measured, Z in workpiece coordinates.
param-119-limit = Limit of the distortion
param-119-limit-help = The two triangles never have quite the same shape. The frame is corrected only if the deviations of the three points add up to less than this; otherwise { "_ALARM" } becomes 61414.
need-119-corrected = A frame is corrected, so that a limit is needed.

result-119-alarm = 0, or the number of the alarm that says why there is no frame
result-119-distortion = Sum of the deviations of the three points; below 0: no frame was computed
result-119-frame-x = Frame that brings the measured triangle into the set position, chained to the active one: translation X
result-119-frame-y = The same frame: translation Y
result-119-frame-z = The same frame: translation Z
result-119-turn-x = The same frame: rotation about X
result-119-turn-y = The same frame: rotation about Y
result-119-turn-z = The same frame: rotation about Z
