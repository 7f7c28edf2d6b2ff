# Running a program or a call: why it stopped, what was not understood.

run-unknown-word = “{ $word }” is not known here.
run-unknown-variable = There is no variable “{ $word }”.
run-no-simulation = “{ $word }” is known with its form, checks and text, but what it does is not simulated. The simulation ends here.
run-not-simulated = “{ $word }” is understood, but not simulated.
run-index = The index of “{ $word }” lies outside of the array.
run-division = Division by zero.
run-not-a-number = “{ $word }” is no number here.
run-function = “{ $word }” cannot be worked out with these values.
run-read-only = “{ $word }” cannot be written.
run-label = The jump target “{ $word }” was not found.
run-unmatched = “{ $word }” has no counterpart.
run-subprogram = The subprogram “{ $word }” is not in this text; the call was left out.
run-depth = Calls are nested deeper than { $limit } levels.
run-steps = The program did not end within { $limit } blocks; it was stopped.
run-trace-limit = More than { $limit } steps were recorded; the run was given up.
run-no-tool = There is no tool “{ $word }” in the tool memory.
run-no-feed = A motion with feed, but no feed F was programmed.
run-arc = The centre or the radius of this arc does not fit its ends.
run-crash = The probe hit the part in a motion that nobody watches.
run-not-finite = The target of a motion is not a number.
run-alarm = The measuring cycle stopped with an alarm.
run-m-function = M function “{ $word }” belongs to the machine; nothing was simulated for it.
run-radius-compensation = Motion with tool radius compensation: the path is simulated without it.
run-call = The call “{ $word }” was refused; see the problems at its parameters.
run-shear = A rotation inside of a scale that differs by axis would shear the coordinates; such frames do not exist.
run-limit = The target lies beyond a software limit switch.
