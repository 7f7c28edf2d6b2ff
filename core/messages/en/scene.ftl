# What is written beside what is drawn.
frame-now = { $name }
frame-machine = MCS
frame-before = { $name } before
frame-after = { $name } after
collision-ball = ball
collision-stylus = stylus
collision-body = probe body
collision-tool = tool
collision-crash = Crash: { $what }
collision-alarm = { $code }: { $what }
collision-first = Touches first: { $what }
diameter-real = Ø{ $diameter }
diameter-exact = = Ø{ $diameter }
diameter-off = Ø{ $diameter } { $off }
touch-value = { $axis } { $value }
