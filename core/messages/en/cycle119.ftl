# CYCLE119: position in space.

cycle119-title = Position in space from three points
cycle119-help = Computes how a part lies in space: three points that should be somewhere, the reference triangle, and the same three points as they were measured one by one, for example with CYCLE977 or CYCLE997. Nothing moves. Declare the variables at the begin of the program: DEF REAL { "_SETPOINT[3,3], _MEASPOINT[3,3], _RES" }, DEF INT { "_ALARM" } and DEF FRAME { "_REFRAME" }; { "_ALARM" } has to be 0 at the call. With { "_COR" }=0 only the frame between the triangles is computed; otherwise that frame is corrected by shift and rotation, provided that the triangles fit each other to { "_RESLIM" }. It must not mirror or scale. The program does not stop: look at { "_ALARM" } behind the call, 0 says that it worked. The corrected frame counts only when its G function (G54 …) is programmed again.
cycle119-words = position in space frame three points triangle align alignment plane rotation shift zero offset rigid best fit helper
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
