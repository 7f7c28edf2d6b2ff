# CYCLE994：标题、搜索词、测量方式，及其自有参数、检查和结果。

cycle994-title = 车削件：2 点测量
cycle994-help = 在工件零点两侧、正负设定值处的相对两点测量车削件的外径或内径，并补偿刀具。
cycle994-words = 测量 工件 车削 车床 直径 镗孔 轴 外 内 两点 相对 安全区 保护区 X Y 刀具补偿 磨损 外圆 内孔 刀补 磨耗 内径 外径 探头

cycle994-inside-zone = 测内径，绕过保护区
cycle994-inside-zone-words = 车削 车床 镗孔 直径 两点 安全 障碍 销 刀具补偿 磨损
cycle994-outside-inside = 绕过保护区测外径，或无保护区测内径
cycle994-outside-inside-words = 车削 车床 直径 轴 镗孔 两点 安全 刀具补偿 磨损

param-setval-two-diameter = 设定直径
param-setval-two-diameter-help = 取自图纸。DIAMON 时为直径，DIAMOF 时为半径；两点对称于工件零点。
param-setval-two-radius = 到零点的设定距离
param-setval-two-radius-help = 两点到工件零点的距离，一点在正方向，一点在负方向。
param-sza-turned = 横坐标方向保护区
param-sza-turned-help = 保护区在平面第 1 轴（G18：Z）的边界，从工件零点算起；测头沿边界绕行。按测球中心计：须加上测球半径；X 轴且 DIAMON 时为直径，须加上测球直径。
param-szo-turned = 纵坐标方向保护区
param-szo-turned-help = 保护区在平面第 2 轴（G18：X）的边界，从工件零点算起；测头沿边界绕行。按测球中心计：为半径，须加上测球半径；X 轴且 DIAMON 时为直径，须加上测球直径。
param-szo-turned-applicate = 垂直坐标方向保护区
param-szo-turned-applicate-help = 保护区在第 3 轴（G18：Y）的边界，从工件零点算起；测头沿边界绕行。按测球中心计：为半径，须加上测球半径；_CHBIT[19]=1 时与 X 相同。

need-zone-inside = 此测量方式绕过保护区。
need-zone-outside = 测外径时需要；此测量方式测内径时没有保护区：请留空。

check-two-setpoint = 设定值 { $set } mm 必须大于 0：两点位于正负设定值处，其间须有距离。
check-two-setpoint-hint = 请输入大于 0 的直径或半径。
check-two-ball = 不校准时（{ "_CHBIT[7]" }=1）循环使用测球直径 { $name }，而其值不大于 0。
check-two-ball-hint = 请把测球直径输入 { $name }，或校准测头并设 { "_CHBIT[7]" }=0。
check-two-zone-inside = 保护区为 { $zone } mm 时，内尺寸 { $size } mm 中放不下测球。
check-two-zone-inside-hint = 请在测量轴上把保护区减小到不超过 { $limit } mm。
check-two-no-zone = 没有保护区时此测量方式测内径；测外径时会沿用以前调用的保护区。
check-two-no-zone-hint = 请在测外径时输入 { "_SZA" } 和 { "_SZO" }。
check-two-half-zone = 保护区不完整：{ $name } 沿用以前调用的值。
check-two-half-zone-hint = 请在测外径时输入 _SZA 和 _SZO，测内径时两者都不输入。
check-two-zone-outside = 测外径时，测球在 { $zone } mm 处经过会碰到 { $size } mm 的工件；测内径时忽略此保护区。
check-two-zone-outside-hint = 请在测外径时把保护区加大到不小于 { $limit } mm，测内径时留空。

result-set-two = 设定直径或半径
result-set-two-abscissa = 设定直径或半径，横坐标
result-set-two-ordinate = 设定直径或半径，纵坐标
result-set-two-applicate = 设定直径或半径，垂直坐标
result-actual-two = 实际直径或半径
result-actual-two-abscissa = 实际直径或半径，横坐标
result-actual-two-ordinate = 实际直径或半径，纵坐标
result-actual-two-applicate = 实际直径或半径，垂直坐标
result-difference-two = 直径或半径偏差
result-difference-two-abscissa = 直径或半径偏差，横坐标
result-difference-two-ordinate = 直径或半径偏差，纵坐标
result-difference-two-applicate = 直径或半径偏差，垂直坐标
