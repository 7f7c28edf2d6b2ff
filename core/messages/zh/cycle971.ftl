# CYCLE971：标题、搜索词、测量方式，及其自有参数、检查和结果。

cycle971-title = 铣床刀具测头：校准，测量刀具
cycle971-help = 在刀具测头上测量主轴中铣刀或钻头的长度 L1 或铣刀的半径，或用尺寸已知的刀具校准该测头。
cycle971-words = 测量 刀具 对刀仪 对刀 设定 预调 测量头 测头 触碰 激光 方块 圆盘 校准 长度 L1 半径 直径 铣刀 端面 钻头 磨损 主轴 旋转 静止 刀刃 触发点 断刀 刀补 磨耗 刀长 刀长测量 对刀块 刀具检测 断刀检测 破损 标定 磨损补偿
cycle971-each-words = 测量 刀具

cycle971-calibrate = 校准刀具测头
cycle971-calibrate-workpiece = 校准刀具测头（工件坐标系）
cycle971-still = 测量刀具，主轴静止
cycle971-rotating = 测量刀具，主轴旋转
cycle971-still-workpiece = 测量刀具，主轴静止（工件坐标系）
cycle971-rotating-workpiece = 测量刀具，主轴旋转（工件坐标系）
cycle971-incremental = 增量校准刀具测头
cycle971-incremental-workpiece = 增量校准刀具测头（工件坐标系）
cycle971-automatic = 自动校准刀具测头
cycle971-automatic-workpiece = 自动校准刀具测头（工件坐标系）

ma-abscissa-centred = 横坐标（G17：X），先在纵坐标求中心
ma-ordinate-centred = 纵坐标（G17：Y），先在横坐标求中心
ma-applicate-abscissa = 垂直坐标（G17：Z），宽刀具沿横坐标偏移
ma-applicate-ordinate = 垂直坐标（G17：Z），宽刀具沿纵坐标偏移
ma-radius-abscissa = 半径，在横坐标触碰（G17：X）
ma-radius-ordinate = 半径，在纵坐标触碰（G17：Y）
ma-length = 长度，在测头中心
ma-length-abscissa = 长度，宽刀具沿横坐标偏移（G17：X）
ma-length-ordinate = 长度，宽刀具沿纵坐标偏移（G17：Y）
param-ma-measure-tool = 长度或半径
param-ma-measure-tool-help = 测量的尺寸和方向。测长度时，比测头宽的铣刀偏移“刀具半径减 _ID”，使刀刃位于测头中心上方。
param-id-calibrate = 宽校准刀具偏移量
param-id-calibrate-help = 刀具比测头宽时，偏离测头中心的量为刀具半径减此值。通常为 0。
param-id-length = 从半径到刀刃最低点
param-id-length-help = 从半径向内到刀刃最低点的距离；铣刀比测头宽时，偏移量为半径减此值。最低点就在半径处时为 0。
param-id-radius = 刀具端部到最大直径处
param-id-radius-help = 刀具端部到最大直径处的距离；刀具再下降此值。端部直径最大时为 0。
param-fa-incremental = 测量行程（带方向）
param-fa-incremental-help = 从当前位置到触碰面的距离；正值朝正方向测量，负值朝负方向。最大行程为其两倍。始终以 mm 为单位。

need-axis-tool-probe = 循环需要测量轴。
need-offset-edge = 循环据此定位铣刀；省略时沿用以前调用的值。普通刀刃或钻头请输入 0。
need-offset-wide = 只在刀具比测头宽时有效。
need-signed-path = 符号决定测量方向。

result-actual-radius = 实际半径
result-difference-radius = 半径偏差

check-path-zero = 测量行程为 0：刀具不会向测头移动。
check-path-zero-hint = 请输入大于 0 的 _FA，不带符号。
check-path-sign = 测量行程为负，此测量方式不允许。
check-path-sign-hint = 请输入不带符号的 _FA；只有增量校准使用符号来表示方向。
check-path-direction-hint = 请在 _FA 中输入到测头的距离，负方向加负号。
check-tool-probe-type = { $name } 中的值不是允许的刀具测头类型。
check-tool-probe-plane = { $name } 中的圆盘在此平面无法触碰。
check-tool-probe-type-hint = 0 为方块；101 为 XY 平面的圆盘（G17），201 为 ZX（G18），301 为 YZ（G19）。
check-tool-probe-depth = { $name } 为 0：刀具的触碰点不会低于测头上沿。
check-tool-probe-depth-hint = 请输入测头上沿到刀具下沿的距离。
check-directions-code = { $name } = { $code } 不是允许的方向代码。
check-directions-applicate = { $name } = { $code } 不允许在刀具轴负方向触碰。
check-directions-hint = 百位 Z，十位 Y，个位 X：0 不触碰，1 负，2 正，3 两者。刀具轴须为 1 或 3；默认值为 133。
check-tool-type-drill = 钻头（类型 { $type }）没有可测的半径。
check-tool-length-zero = 当前刀具的长度 L1 为 0。
check-tool-radius-zero = 当前刀具的半径为 0。
check-tool-zero-hint = 请在刀具数据中输入近似尺寸，校准刀具则输入精确尺寸。
check-offset-missing = 刀具直径 { $tool } mm 大于测头宽度 { $edge } mm：_ID 决定其位置。
check-offset-missing-hint = 若刀具的最外点应位于测头中心上方，请把 _ID 设为 0。
check-offset-large = _ID 大于刀具半径 { $radius } mm：刀具会偏移到另一侧。
check-offset-large-hint = 请在 _ID 中输入从半径向内的距离，不得大于半径。
check-offset-abscissa = 刀具直径 { $tool } mm 大于测头宽度 { $edge } mm：循环使刀具沿横坐标偏移。
check-offset-abscissa-hint = 请把 _MA 设为 103 或 203，以指明偏移的轴。
check-mfs-missing = { $name } 不大于 0：缺少某次触碰的转速或进给。
check-mfs-missing-hint = 请设置 _MFS[0]、[2]、[4] 的转速和 _MFS[1]、[3]、[5] 的进给，或设 _CBIT[12]=0，由循环计算。
check-mfs-third = { $name } 不大于 0：省去第三次触碰（_MFS[4] 和 [5]）。
check-mfs-third-hint = 请也设置第二次触碰的转速和进给，或把 _MFS[4] 设为 0。
check-cm-direction = { $name } 没有指定旋转方向；若调用时主轴静止，则必须指定。
check-cm-direction-hint = 请把 GUD6 中的 _CM[5] 设为 3（M3）或 4（M4）。
check-cm-zero = { $name } 不大于 0：循环无法计算测量的转速和进给。
check-cm-zero-hint = 请设置极限：_CM[0] 圆周速度，[1] 主轴转速，[3] 精度，[4] 最大进给。
check-cm-factor = { $name } 必须为 0 或不小于 1。
check-cm-factor-hint = 请输入不小于 1 的值（进给乘以该系数），或输入 0 省去这次触碰。
check-cm-order = { $name } 不小于 _CM[6]，而每次触碰应比前一次慢。
check-cm-order-hint = 请减小进给系数 2，或设为 0，只触碰两次。
check-compensation-make = 不作补偿：_MT_COMP=1 时需要在 { $name } 中设置测头型号。
check-compensation-make-hint = 请把 _TP_CF 设为 1（TT130）或 2（TS27R），或采用用户自定义表并设 _MT_COMP=2。
check-compensation-inside = 控制系统按该型号测头的内部补偿表作扣除，而手册中没有此表：模拟不作扣除。
check-compensation-inside-hint = 请设 _MT_COMP=2：控制系统和模拟都使用用户自定义表，半径为 _MT_EC_R，长度为 _MT_EC_L。
check-compensation-table = { $name } 中的半径或圆周速度不是递增的：补偿可能错误。
check-compensation-table-hint = 请在 [0,1] 到 [0,4] 输入递增的半径，在 [1,0] 到 [5,0] 输入递增的速度，或设 _MT_COMP=0。

param-mfs-speed-1 = 转速，第一次触碰
param-mfs-speed-1-help = 单位 r/min。
param-mfs-feed-1 = 进给，第一次触碰
param-mfs-feed-1-help = 第一次触碰时朝向刀具测头的进给。
param-mfs-speed-2 = 转速，第二次触碰
param-mfs-speed-2-help = 单位 r/min。0：第一次触碰后结束测量。
param-mfs-feed-2 = 进给，第二次触碰
param-mfs-feed-2-help = 第二次触碰时朝向刀具测头的进给。
param-mfs-speed-3 = 转速，第三次触碰
param-mfs-speed-3-help = 单位 r/min。0：第二次触碰后结束测量。
param-mfs-feed-3 = 进给，第三次触碰
param-mfs-feed-3-help = 第三次触碰时朝向刀具测头的进给。
