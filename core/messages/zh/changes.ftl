# 调用在控制系统中改变了什么。

change-radius-wear = T{ $tool } D{ $edge }，半径磨损
change-radius = T{ $tool } D{ $edge }，半径
change-length-wear = T{ $tool } D{ $edge }，长度 { $length } 磨损
change-length = T{ $tool } D{ $edge }，长度 { $length }
change-length-offset = T{ $tool } D{ $edge }，长度 { $length }，DL{ $offset }
change-radius-offset = T{ $tool } D{ $edge }，半径，DL{ $offset }
change-coarse = { $frame }，{ $axis } 粗偏移
change-fine = { $frame }，{ $axis } 精偏移
change-rotation = { $frame }，绕 { $axis } 旋转
change-offset = { $frame }，{ $axis }
change-mean = 平均值存储器 { $memory }
change-empirical = 经验值 { $memory }
change-probe-ball = 测头 { $probe }，测球直径
change-trigger-abscissa-minus = 测头 { $probe }，触发点，横坐标负向
change-trigger-abscissa-plus = 测头 { $probe }，触发点，横坐标正向
change-trigger-ordinate-minus = 测头 { $probe }，触发点，纵坐标负向
change-trigger-ordinate-plus = 测头 { $probe }，触发点，纵坐标正向
change-trigger-applicate-minus = 测头 { $probe }，触发点，垂直坐标负向
change-trigger-applicate-plus = 测头 { $probe }，触发点，垂直坐标正向
change-skew-abscissa = 测头 { $probe }，位置偏差，横坐标
change-skew-ordinate = 测头 { $probe }，位置偏差，纵坐标
change-register-length = 寄存器 { $register }，长度
change-register-length-wear = 寄存器 { $register }，长度磨损
change-register-radius = 寄存器 { $register }，半径
change-register-radius-wear = 寄存器 { $register }，半径磨损
change-other = { $name }
