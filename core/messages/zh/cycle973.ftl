# CYCLE973：标题、搜索词、测量方式，及其自有参数和检查。

cycle973-title = 校准车床工件测头
cycle973-help = 求出车床测头的触发位置，并把触发点存入测头数据 _WP；以后的测量都使用它们。
cycle973-words = 校准 工件 测量头 测头 车削 基准 槽 方块 表面 端面 触发点 测球 直径 偏斜 位置偏差 探头 标定 探针
cycle973-each-words = 车削 触发点 标定

cycle973-surface = 表面：一个方向
cycle973-groove-short = 基准槽：1 个方向，短写法
cycle973-groove-one = 基准槽：1 个方向
cycle973-groove-two = 基准槽：一个轴的 2 个方向
cycle973-groove-two-ball = 基准槽：一个轴的 2 个方向，测球直径
cycle973-groove-two-skew = 基准槽：一个轴的 2 个方向，位置偏差
cycle973-groove-two-skew-ball = 基准槽：一个轴的 2 个方向，位置偏差，测球直径

calibrate-groove = 基准槽
calibrate-groove-words = 方块
calibrate-one-short = 未指定：一个方向，同 1
calibrate-one-short-words = 一 13
calibrate-position = 位置偏差

param-setval-surface-diameter = 表面处直径
param-setval-surface-diameter-help = 表面在工件坐标系中的精确位置：DIAMON 时为直径，DIAMOF 时为半径。
param-calnum = 基准槽
param-calnum-help = 校准体（槽对）的编号；其边和槽底在 _KB[n-1,…] 中，按机床坐标，X 按半径。

need-surface-position = 循环由表面的位置计算触发点。
need-groove = 槽决定触碰的位置。

check-groove-number = 没有基准槽号 { $number }。
check-groove-number-hint = 请输入 1 到 { $pairs } 的编号，或建立更多校准体数据并加大 { "_CVAL[2]" }。
check-groove-tip-hint = 请在槽中使用刀沿位置 7 或 8 的测头；其他测头在表面上校准。
check-groove-base = 在此轴上槽只有槽底：只能用负方向。
check-groove-base-hint = 请用一个方向和 { "_MD" }=1 校准槽底；两个方向只能在另一轴的槽壁上。
check-groove-empty = 基准槽数据未设定：{ $names } 为 0。
check-groove-empty-hint = 请在 GUD6 的 _KB[] 中输入槽边和槽底，按机床坐标和半径。
check-groove-edges = 正方向的边 { $plus } 不大于负方向的边 { $minus }。
check-groove-edges-hint = 请交换两个值，或输入缺少的一个。
check-shank = 刀沿位置 { $tip } 的测针指向相反方向：会以测针杆触碰。
check-shank-hint = 请把 { "_MD" } 改为相反方向，或检查刀沿位置和测量轴。
