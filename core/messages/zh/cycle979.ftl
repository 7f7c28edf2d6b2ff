# CYCLE979：标题、搜索词、测量方式，及其自有参数和检查。

cycle979-title = 成角度测量孔、轴、槽、凸台
cycle979-help = 与轴成角度测量尺寸和中心：孔、轴（外圆）或其一段圆弧在圆周上测三点或四点；槽或凸台沿斜线测量。
cycle979-words = 测量 工件 孔 镗孔 轴 圆凸台 槽 键槽 凸台 筋 圆弧段 圆弧 角度 倾斜 直径 宽度 中心 三点 四点 内 外 刀具补偿 磨损 零点 零偏 分中 外圆 内孔 刀补 磨耗 找中心 圆心 取中 内径 外径 探头 扇形
cycle979-each-words = 角度 倾斜 圆弧段

cycle979-hole-tool = 孔，成角度测量：补偿刀具
cycle979-shaft-tool = 轴（外圆），成角度测量：补偿刀具
cycle979-groove-tool = 槽，成角度测量：补偿刀具
cycle979-web-tool = 凸台，成角度测量：补偿刀具
cycle979-hole-zero = 孔，成角度测量：补偿零点偏移
cycle979-shaft-zero = 轴（外圆），成角度测量：补偿零点偏移
cycle979-groove-zero = 槽，成角度测量：补偿零点偏移
cycle979-web-zero = 凸台，成角度测量：补偿零点偏移

prnum-points = 圆周的点数
prnum-three = 三点
prnum-four = 四点
param-setval-width-angle = 设定宽度
param-setval-width-angle-help = 图纸上槽或凸台的宽度，沿起始角 _STA1 方向。
param-sta1-width = 宽度方向
param-sta1-width-help = 测量宽度的方向与横坐标的夹角；从中心看，第一点就在此方向上。
param-id-lift = 越过凸台抬高量
param-id-lift-help = 沿刀具轴从测量高度到越过高度的行程，带符号。测头长度算到测球中心（_CBIT[14]=0）时，此值必须包含测球半径。
param-prnum-with-points = 测头和点数
param-prnum-with-points-help = 圆周三点或四点、测头类型及其数据在 _WP 中的编号。

need-lift = 测头必须越过凸台。

check-points-unused = 点数只对孔或轴（外圆）有效。
check-points-unused-hint = 请选三点：_PRNUM 的第 4 位为 0。
check-path-centre = 测量行程从中心的另一侧开始：在各点之间测头会从那一侧经过。
check-path-centre-hint = 请把 _FA 减小到小于 { $free } mm。
check-lift = 测头越过凸台之前没有抬起。
check-lift-hint = 请输入正值；若测头本体位于垂直坐标的负侧，请输入负值。
check-lift-ball = 抬高量不大于测球半径 { $ball } mm，而抬高量必须包含该半径。
check-lift-ball-hint = 请加上测球半径；若测头长度算到测球圆周，则设 _CBIT[14]=1。
