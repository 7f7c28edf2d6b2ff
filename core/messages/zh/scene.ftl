# 图形旁边的文字。
frame-now = { $name }
frame-machine = MCS
frame-before = { $name } 补偿前
frame-after = { $name } 补偿后
collision-ball = 测球
collision-stylus = 测针
collision-body = 测头本体
collision-tool = 刀具
collision-crash = 碰撞：{ $what }
collision-alarm = { $code }：{ $what }
collision-first = 先触碰：{ $what }
diameter-real = Ø{ $diameter }
diameter-exact = = Ø{ $diameter }
diameter-off = Ø{ $diameter } { $off }
touch-value = { $axis } { $value }
