# Was neben der Zeichnung steht.
frame-now = { $name }
frame-machine = MKS
frame-before = { $name } vorher
frame-after = { $name } nachher
collision-ball = Messtasterkugel
collision-stylus = Tastschaft
collision-body = Messtastergehäuse
collision-tool = Werkzeug
collision-crash = Kollision: { $what }
collision-alarm = { $code }: { $what }
collision-first = Berührt zuerst: { $what }
diameter-real = Ø{ $diameter }
diameter-exact = = Ø{ $diameter }
diameter-off = Ø{ $diameter } { $off }
touch-value = { $axis } { $value }
