# CYCLE974：标题、搜索词、测量方式，及其自有参数、检查和结果。

cycle974-title = 车削件：1 点测量
cycle974-help = 按图纸的设定值测量车削件上的一点：外侧或内侧，直径、端面或第 3 轴方向。
cycle974-words = 测量 工件 车削 车床 直径 外 内 端 端面 长度 一个 点 单点 X Z Y 轴 反转 跳动 主轴 刀具补偿 磨损 零点 零偏 外圆 内孔 刀补 磨耗 探头 测头 换向 设零 长度方向 打表
cycle974-each-words = 车削 车床 直径 端面 长度 L1 L2

cycle974-tool = 1 点测量：补偿刀具
cycle974-zero = 1 点测量：补偿零点偏移
cycle974-reversal = 1 点测量，带 180° 换向：补偿刀具

mvar-reversal = 180° 换向
reversal-without = 无
reversal-with = 有：工件转过 180° 后再测一次
reversal-with-words = 反转 主轴 180 度 跳动 偏心 相对 换向

param-setval-turned-diameter = 设定直径
param-setval-turned-diameter-help = 取自图纸。DIAMON 时为直径，DIAMOF 时为半径。
param-setval-turned-position = 设定位置
param-setval-turned-position-help = 图纸上的表面位置，工件坐标系，沿测量轴。
param-sta1-spindle = 主轴位置
param-sta1-spindle-help = 第一次触碰时主轴把工件转到的角度；第二次再转 180°。

need-angle-reversal = 带 180° 换向时循环要定位主轴。

check-reversal-part = 带 180° 换向时循环要把工件转 180°，但主轴不能定位。
check-reversal-part-hint = 请选不带 180° 换向的测量方式，或在主主轴可定位的机床上测量。

result-compensation-radius = 补偿值，按半径
