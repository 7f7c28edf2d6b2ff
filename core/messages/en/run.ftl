# Running a program or a call: why it stopped, what was not understood.

run-crash = The probe hit the part in a motion that nobody watches.
run-not-finite = The target of a motion is not a number.
run-trace-limit = More than { $limit } steps were recorded; the run was given up.
