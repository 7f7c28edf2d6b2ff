# CYCLE998：标题、搜索词、测量方式，及其自有参数和检查。

cycle998-title = 表面的角度
cycle998-help = 测量装夹后的工件转过的角度：由直边或表面上两点求一个角度，或由斜面上三点求两个角度。
cycle998-words = 测量 工件 角度 找正 偏斜 边 表面 端面 平面 倾斜 装夹 回转 工作台 C 轴 零点 补偿 零偏 坐标框架 G54 两 点 三
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
mvar-positioning = 点与点之间的移动
positioning-angle = 沿设定角度移动，并让开表面
positioning-paraxial = 沿轴
positioning-paraxial-words = 平行于轴 方向

param-setval-point = P1 的设定位置
param-setval-point-help = 测量轴上第一点处表面的预期位置。测头所在的一侧决定测量方向。相差超过测量行程的位置找不到。
param-setval-point-applicate = P1 的设定高度
param-setval-point-applicate-help = 第一点下方表面的预期位置，在垂直坐标（G17：Z）上。
param-ma-offset = 测量轴和偏移轴
param-ma-offset-help = 在哪个轴触碰表面，第二点在哪个轴上。两者之外的轴就是工件转动所绕的轴。
ma-102 = 在纵坐标测量，点沿横坐标
ma-103 = 在垂直坐标测量，点沿横坐标
ma-201 = 在横坐标测量，点沿纵坐标
ma-203 = 在垂直坐标测量，点沿纵坐标
ma-301 = 在横坐标测量，点沿垂直坐标
ma-302 = 在纵坐标测量，点沿垂直坐标
param-id-points = P1 到 P2 的距离
param-id-points-help = 在偏移轴的正方向；因此第一点的坐标较小。距离越大，角度越准。
param-id-points-abscissa = P1 到 P2 的距离
param-id-points-abscissa-help = 在横坐标（G17：X）的正方向。距离越大，角度越准。
param-setv0-points = P1 到 P3 的距离
param-setv0-points-help = 在纵坐标（G17：Y）的正方向。
param-sta1-edge = 设定角度
param-sta1-edge-help = 表面应与偏移轴正方向所成的角度，逆时针为正。沿角度移动时也引导测头，因此应与实际角度相差不大。
param-sta1-about-abscissa = 绕横坐标的设定角度
param-sta1-about-abscissa-help = 从 P1 到 P3 的倾斜。沿角度移动时也引导测头。
param-inca-about-ordinate = 绕纵坐标的设定角度
param-inca-about-ordinate-help = 从 P1 到 P2 的倾斜。沿角度移动时也引导测头。
param-ra = 回转轴
param-ra-help = 0 使坐标系绕 _MA 中没有给出的轴旋转。否则为通道中回转轴的号：角度加到其零点偏移上，该轴移动时工作台转动工件。
param-tsa-angle = 角度的安全区
param-tsa-angle-help = 单位为度。角度相差更大时，程序以报警 61303 停止。沿角度移动时，测头也按此值从表面让开。

need-set-position = 测量方向和第一次触碰由它决定。
need-axes-angle = 角度位于两个轴的平面内。
need-direction-paraxial = 没有设定位置时必须给出触碰的方向。
need-third-point = 平面需要第三点。
need-second-angle = 平面有两个角度。
need-rotary = 请给出角度补偿写入哪里：0 为坐标系。

check-angle-steep = 角度 { $param } 与安全区合计 { $sum }°；不小于 90° 时测头无法移动。
check-angle-steep-hint = 请选小于 { $limit }° 的 _TSA。它在这里是角度，不是长度。
check-angle-reach = 到下一点时，安全区把测头让开太远，设定表面在前方 { $away } mm，超出整个测量行程 { $path } mm。
check-angle-reach-hint = 请选不小于 { $needed } mm 的 _FA，或减小 _TSA。
check-angle-reach-worst = 相差整个安全区 { $area }° 的角度在下一点会找不到：报警 61301 先于 61303。
check-angle-paraxial = 点与点之间设定表面升高 { $rise } mm，大于整个测量行程 { $path } mm。
check-angle-paraxial-hint = 请把 _FA 选得大于 { $needed } mm，或选沿角度移动的测量方式。
check-rotary-axis = 通道轴 { $axis } 没有名称，或不是回转轴。
check-rotary-across = 此回转轴的旋转方向与所测角度不一致，因此无法补偿该角度。
check-rotary-across-hint = 请给出在 _MA 两轴所在平面内旋转的回转轴，或输入 0 旋转坐标系。
check-rotary-axis-hint = 请输入回转轴在通道中的号，或输入 0 旋转坐标系。有哪些轴由 MD 20080 和 MD 30300 给出。
