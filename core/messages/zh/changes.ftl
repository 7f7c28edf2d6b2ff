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
change-register-length = 寄存器 { $register }，长度
change-register-length-wear = 寄存器 { $register }，长度磨损
change-register-radius = 寄存器 { $register }，半径
change-register-radius-wear = 寄存器 { $register }，半径磨损
change-other = { $name }
