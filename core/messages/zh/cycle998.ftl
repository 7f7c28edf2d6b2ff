# CYCLE998：标题、搜索词、测量方式，及其自有参数和检查。

cycle998-title = 表面的角度
cycle998-help = 测量装夹后的工件转过的角度：由直边或表面上两点求一个角度，或由斜面上三点求两个角度。
cycle998-words = 测量 工件 角度 找正 偏斜 边 表面 端面 平面 倾斜 装夹 回转工作台 C 轴 零点 补偿 零偏 坐标框架 G54 两点 三点 打表 拉表 校表 校正 拉直 平行 夹斜 虎钳 探头 转台
cycle998-each-words = 两 角度

cycle998-one = 一个角度，沿设定角度移动
cycle998-one-differential = 一个角度，差值测量
cycle998-one-paraxial = 一个角度，沿轴移动
cycle998-two = 两个角度，沿设定角度移动
cycle998-two-paraxial = 两个角度，沿轴移动

mvar-angles = 角度
angles-one = 一个，由两点
angles-one-words = 找正 边 回转工作台 设定 位置
angles-two = 两个，由三点
angles-two-words = 平面 倾斜 三点 CYCLE800
mvar-positioning = 测量点间移动方式
positioning-angle = 沿设定角度移动，并让开表面
positioning-paraxial = 沿轴
positioning-paraxial-words = 平行于轴 方向

param-setval-point = P1 设定位置
param-setval-point-help = P1 处表面在测量轴上的预期位置。起点所在的一侧决定测量方向。表面偏离此位置超过 _FA 时找不到表面。
param-setval-point-applicate = P1 设定高度
param-setval-point-applicate-help = P1 处表面的预期位置，在垂直坐标（G17：Z）上。
param-ma-offset = 测量轴和偏移轴
param-ma-offset-help = 触碰表面所沿的轴，以及 P2 相对 P1 偏移所沿的轴。测得的角度是绕余下的轴的转角。
ma-102 = 沿纵坐标测量，测量点沿横坐标分布
ma-103 = 沿垂直坐标测量，测量点沿横坐标分布
ma-201 = 沿横坐标测量，测量点沿纵坐标分布
ma-203 = 沿垂直坐标测量，测量点沿纵坐标分布
ma-301 = 沿横坐标测量，测量点沿垂直坐标分布
ma-302 = 沿纵坐标测量，测量点沿垂直坐标分布
param-id-points = P1 到 P2 距离
param-id-points-help = 沿偏移轴的正方向，因此 P1 的坐标较小。距离越大，角度越准。
param-id-points-abscissa = P1 到 P2 距离
param-id-points-abscissa-help = 沿横坐标（G17：X）的正方向。距离越大，角度越准。
param-setv0-points = P1 到 P3 距离
param-setv0-points-help = 沿纵坐标（G17：Y）的正方向。
param-sta1-edge = 设定角度
param-sta1-edge-help = 表面与偏移轴正方向的设定夹角，逆时针为正。沿角度移动时必须接近实际角度。
param-sta1-about-abscissa = 设定角度，绕横坐标
param-sta1-about-abscissa-help = 从 P1 到 P3 的倾斜，表面升高为正。沿角度移动时测头也按此角度移动。
param-inca-about-ordinate = 设定角度，绕纵坐标
param-inca-about-ordinate-help = 从 P1 到 P2 的倾斜，表面下降为正。沿角度移动时测头也按此角度移动。
param-ra = 回转轴
param-ra-help = 0：坐标系绕 _MA 未指定的轴旋转。否则为回转轴的通道轴号：角度偏差加到其零点偏移中，移动该轴即找正工件。
param-fa-paraxial = 测量行程
param-fa-paraxial-help = 每个点处，表面离测头位置不得超过此距离的两倍。始终以 mm 为单位。
param-tsa-angle = 角度安全区
param-tsa-angle-help = 单位为度。角度的偏差超过此值，程序以报警 61303 停止。沿角度移动时，测头也按此角度离开表面。

need-set-position = 测量方向和第一次触碰由设定位置决定。
need-axes-angle = 角度位于两个轴的平面内。
need-direction-paraxial = 没有设定位置，因此必须给出测量方向。
need-third-point = 平面需要第三点。
need-second-angle = 平面有两个角度。
need-rotary = 请指定由哪个轴补偿角度；输入 0 则旋转坐标系。

check-angle-steep = 角度 { $param } 加安全区为 { $sum }°：不小于 90° 时测头无法沿其移动。
check-angle-steep-hint = 请把 _TSA 减小到小于 { $limit }°。这里 _TSA 是角度，不是长度。
check-angle-reach = 按 _TSA，下一测量程序段的起点离设定表面 { $away } mm：大于整个测量行程 { $path } mm。
check-angle-reach-hint = 请把 _FA 加大到不小于 { $needed } mm，或减小 _TSA。
check-angle-reach-worst = 角度偏差达到整个安全区 { $area }° 时，下一点超出测量行程：报警 61301 而不是 61303。
check-angle-paraxial = 在各点之间设定表面的位置相差 { $rise } mm，大于整个测量行程 { $path } mm。
check-angle-paraxial-hint = 请把 _FA 加大到大于 { $needed } mm，或选沿角度移动的测量方式。
check-rotary-axis = 通道轴 { $axis } 没有名称，或不是回转轴。
check-rotary-across = 此回转轴不在所测角度的平面内旋转，因此不能补偿该角度。
check-rotary-across-hint = 请输入在 _MA 两轴所在平面内旋转的回转轴，或输入 0 以旋转坐标系。
check-rotary-axis-hint = 请输入回转轴的通道轴号（MD 20080、MD 30300），或输入 0 以旋转坐标系。
