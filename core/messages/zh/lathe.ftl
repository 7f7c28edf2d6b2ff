# 使用车床工件测头的循环的共同内容。

ma-lathe-abscissa = 横坐标（G18：Z）
ma-lathe-ordinate = 纵坐标（G18：X）
ma-lathe-applicate = 垂直坐标（G18：Y），若有此轴

param-fa-lathe = 测量行程
param-fa-lathe-help = 从测量程序段起点到设定位置的距离，过了该位置再走同样的距离；最后停在表面前同样距离处。始终以 mm 为单位，X 轴按半径计。

check-lathe-probe = 当前刀具的类型为 { $type }，而此循环需要车床测头。
check-lathe-probe-hint = 请在调用前编程测头及其 D 号；类型须为 5xy，刀沿位置 5 到 8。
check-lathe-tip = 这里不允许测头的刀沿位置 { $tip }。
check-lathe-tip-hint = 请改正 $TC_DP2：测头的刀沿位置为 5、6、7 或 8，即测针所指的一侧。
