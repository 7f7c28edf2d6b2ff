# Help pages of the cycles that measure a workpiece on milling machines.

help-cycle961-measures-inside = 内拐角：两条边的交点，以及基准边（P1、P2）转过的角度。
help-cycle961-measures-outside = 外拐角：两条边的交点，以及基准边（P1、P2）转过的角度。
help-cycle961-measures-square = 矩形的拐角：三点即可，第二条边按直角计算。
help-cycle961-measures-free = 两边之间的角度未知：每条边取两点。
help-cycle961-measures-given = 四点，每点由坐标给出。
help-cycle961-before-opposite = 测头在测量深度对着拐角：型腔内，或工件外。从该处能到达所有点；_STA1 和 _INCA 的误差不超过 10°。
help-cycle961-before-above = 测头停在某一高度，从该处沿直线能到达所有点；_ID 为从该处到测量深度的进刀深度，为负值。
help-cycle961-before-multi = 测头在平面各方向都能触发（多向测头）。
help-cycle961-order-three = 先在基准边上 _SETV[0] 处测 P2，再在该距离的一半处测 P1，然后在另一边 _SETV[1] 的一半处测 P3。
help-cycle961-order-four = 先在基准边上 _SETV[0] 处测 P2，再在该距离的一半处测 P1，然后在另一边 _SETV[1] 的一半处测 P3、_SETV[1] 处测 P4。
help-cycle961-order-in-plane = 所有路径都在测量深度，位于型腔内。
help-cycle961-order-passes = 从 P1 到 P3 抬高 _ID，越过拐角再下降；_ID=0 时经起点绕过拐角。
help-cycle961-order-infeed = 依次测 P2、P1、P3、P4：在每点上方下降 _ID，触碰，退回并抬起。
help-cycle961-order-toward-pocket = 每次触碰都背离另一对点。
help-cycle961-order-toward-part = 每次触碰都朝另一对点所在的一侧。
help-cycle961-order-along-axis = 每次触碰沿有效坐标系的一个轴，最多走两倍 _FA；_FA 小于循环的最小值（20 mm 或更大）时采用该最小值。
help-cycle961-order-end-p4 = 最后停在 P4 上方的起始高度。
help-cycle961-corrects-absolute = _KNUM 大于 0 时写入该零点偏移的粗偏移，为绝对值：拐角成为平面内的零点，横坐标沿基准边。精偏移清零，垂直坐标不变。
help-cycle961-corrects-choice = _SETV[4] 为 2 时零点从拐角移开 _SETV[2]，为 4 时移开 _SETV[3]，为 3 时移开两者。
help-cycle961-wrong-angle = 边的方向与 _STA1、_INCA 相差超过 10°：某点碰不到边，报警 61301。
help-cycle961-wrong-not-opposite = 起点没有对着拐角：循环在边以外寻找 P3。
help-cycle961-wrong-swapped = P1 和 P2 颠倒：坐标系转 180°。
help-cycle961-wrong-same-points = 一条边上的两点重合（报警 61367），或两条边平行（61368）。

help-cycle977-measures-hole = 孔的直径和中心。
help-cycle977-measures-shaft = 轴（外圆）的直径和中心。
help-cycle977-measures-groove = 槽在轴 _MA 上的宽度和中线。
help-cycle977-measures-web = 凸台在轴 _MA 上的宽度和中线。
help-cycle977-measures-pocket = 平行于轴的内矩形的两个长度和中心。
help-cycle977-measures-island = 平行于轴的外矩形的两个长度和中心。
help-cycle977-before-centre = 测头在设定中心处或其上方：循环把求出的中心与测头在平面内的这个位置比较。
help-cycle977-before-middle = 测头在设定中线处或其上方：循环把求出的中线与测头在 _MA 上的这个位置比较。
help-cycle977-before-depth = 测球在测量高度。
help-cycle977-before-above = 测球在被测要素上方，高度足以自由越过；_ID 是从该处到测量高度的进刀深度，向下为负。
help-cycle977-before-zone-inside = _SZA 是中间不得触碰的障碍物的尺寸。
help-cycle977-before-zone-outside = _SZA 是被测要素周围可用空间的尺寸，包括被测要素。
help-cycle977-before-zone-lengths = _SZA 用于横坐标，_SZO 用于纵坐标。
help-cycle977-order-two-axes = 横坐标：先正侧，后负侧。然后移到两点的中间，纵坐标：先正侧，后负侧。
help-cycle977-order-one-axis = 先触碰 _MA 的正侧，再触碰负侧。
help-cycle977-order-straight = 所有路径都是直线，位于测量高度。
help-cycle977-order-outwards = 从中间向外触碰壁。
help-cycle977-order-inwards = 在每点移到被测要素旁，下降 _ID，朝中间触碰，退回并抬起，再从被测要素上方越过。
help-cycle977-order-over-zone = 点与点之间抬高 _ID，越过中间的障碍物。
help-cycle977-order-less-room = 保护区使空间不足时，循环缩短 _FA，使测球仍放得下。
help-cycle977-order-diameter = 直径由纵坐标方向的两次触碰算出，触碰路径经过横坐标方向求出的中心。
help-cycle977-order-lengths = 每个长度和中心的每个坐标由该轴的两次触碰算出。
help-cycle977-order-end = 最后在起始高度，停在求出的中心处或其上方。
help-cycle977-corrects-half = 半径按尺寸偏差的一半补偿。
help-cycle977-corrects-mean = 由偏差较大的长度决定是否补偿，补偿量为两个偏差的平均值。
help-cycle977-corrects-both-axes = 补偿平面的两个轴。
help-cycle977-corrects-one-axis = 只补偿 _MA。
help-cycle977-wrong-depth = 测球太高：碰到倒角或什么也碰不到。
help-cycle977-wrong-infeed = _ID 符号错误或太短：测球从被测要素上方越过。太长：撞到底面，报警 61302。
help-cycle977-wrong-zone = 保护区使测球放不下：报警 61334。
help-cycle977-wrong-start = 起点不是设定中心：起点的误差会计入零点偏移。

help-cycle978-measures-point = 垂直于轴 _MA 的表面上一点的位置。
help-cycle978-before-opposite = 测球对着该点，离表面的距离大于 _FA；所在的一侧决定测量方向。
help-cycle978-order-axis = 只有 _MA 移动；最后停在表面前 _FA 处。
help-cycle978-corrects-full = 长度或半径按全部偏差补偿。
help-cycle978-corrects-one-axis = 只补偿 _MA；先从实际值中减去 _EVNUM 的经验值（_CHBIT[5]=1 时加上）。
help-cycle978-wrong-side = 测球在错误的一侧：背离表面移动。
help-cycle978-wrong-oblique = 表面与 _MA 不垂直：触碰点不在测球最前端，测得值因此有误差。

help-cycle979-measures-hole = 由圆周上的点求孔或其一段圆弧的直径和中心。
help-cycle979-measures-shaft = 由圆周上的点求轴（外圆）或其一段圆弧的直径和中心。
help-cycle979-measures-groove = 斜槽的宽度，以及它在 _STA1 直线上的中点。
help-cycle979-measures-web = 斜凸台的宽度，以及它在 _STA1 直线上的中点。
help-cycle979-before-near = 测球在测量高度靠近 P1，离轮廓的距离大于 _FA，到 P1 的直线路径上无障碍。从设定中心 _CPA、_CPO 看，P1 在角度 _STA1 的方向上。
help-cycle979-before-ball = 测头的有效测球直径已校准（CYCLE976，求出测球直径）。
help-cycle979-order-circle = 三点（_PRNUM 的第 4 位为 1 时四点），每点再转过 _INCA；点与点之间以 _RF 沿圆弧移动。
help-cycle979-order-outwards = 每次触碰背离设定中心。
help-cycle979-order-inwards = 每次触碰朝向设定中心。
help-cycle979-order-across = 先测 P1，沿直线到另一壁，再测 P2，全部在测量高度。
help-cycle979-order-over = 先测 P1，抬高 _ID，沿直线越过凸台，再下降，测 P2。
help-cycle979-order-fit = 由通过各点的圆求出直径和中心。
help-cycle979-order-end = 最后在测量高度，停在最后一点前 _FA 处。
help-cycle979-corrects-half = 半径按直径或宽度偏差的一半补偿。
help-cycle979-corrects-both = 补偿平面的两个轴；槽和凸台按中点沿该直线的偏移补偿。
help-cycle979-wrong-arc = 在圆弧段之外沿圆弧移动时，测头撞到工件：报警 61302。
help-cycle979-wrong-close = 各点太近：一点的微小误差会使中心产生数倍的偏移。_INCA 应取圆弧段允许的最大值。
help-cycle979-wrong-speed = _RF 为 0：报警 61365。
help-cycle979-wrong-skewed = _STA1 直线与两壁不垂直：测得的宽度偏大。
help-cycle979-wrong-lift = _ID 太短；长度算到测球中心（_CBIT[14]=0）时必须包含测球半径。

help-cycle997-measures-one = 一个球的球心。
help-cycle997-measures-three = 三个球的球心，并由此求出工件的平移和旋转。
help-cycle997-measures-diameter = 每个球的直径。
help-cycle997-before-above = 测球在球 1 设定球心上方的安全高度；从该高度能无碰撞地到达每个球。
help-cycle997-before-ball = 事先已用 CYCLE976 求出有效测球直径。
help-cycle997-before-frame = 有效零点偏移足够准确，使每个球离其设定位置不超过 _FA；没有比例系数，测三个球时也没有镜像。
help-cycle997-order-paraxial = 在设定球心的高度：先测横坐标正侧和负侧，然后经求出的中点测纵坐标正侧和负侧；点与点之间升到球上方 _FA。
help-cycle997-order-three-points = 在设定球心的高度：三点，第一点在 _STA1，每点再转过 _INCA，其间以 _RF 走圆弧。
help-cycle997-order-four-points = 在设定球心的高度：四点，第一点在 _STA1，每点再转过 _INCA，其间以 _RF 走圆弧。
help-cycle997-order-top = 然后在刚求出的球心上方触碰顶点。
help-cycle997-order-diameter = 再在求出的球心高度、沿横坐标正方向触碰一点，得出直径。
help-cycle997-order-repeat = 从求出的球心开始，把整个球再测一遍。
help-cycle997-order-next = 球 2 和球 3 以同样方式测量；到下一个球的路径在安全高度。
help-cycle997-order-end = 最后停在最后一个球上方的安全高度。
help-cycle997-corrects-shift = 由 _KNUM 指定的零点偏移，三个轴：使球处于设定坐标；旋转不变。_KNUM=0 不补偿。
help-cycle997-corrects-turn = _KNUM 大于 0 时补偿该零点偏移的粗偏移和旋转：使三个球处于设定位置。变形超过 _TNVL：报警 61414，不补偿。
help-cycle997-corrects-area = 任何偏差超过 _TSA，程序都以报警 61303 停止。
help-cycle997-wrong-holder = 球的支座位于测量点处或进刀路径上。
help-cycle997-wrong-no-ball = 校准测头时没有求测球直径：没有存储值时报警 61341；存储值有误时，接近球的各位置都偏移。
help-cycle997-wrong-line = 三个设定球心在一条直线上：报警 61411。

help-cycle998-measures-one = 一个角度：由两点求直边或表面相对于一个轴转过的角度。
help-cycle998-measures-two = 两个角度：由三点求平面绕横坐标和纵坐标的倾斜。
help-cycle998-before-opposite = 测球对着 P1，离 _SETVAL 的距离大于 _FA；P2 在偏移轴正方向 _ID 处。
help-cycle998-before-both-near = 测球对着 P1；两点在测量轴上离此位置都不超过两倍 _FA。
help-cycle998-before-over = 测球在 P1 上方，所在高度能到达 P2（横坐标再走 _ID）和 P3（纵坐标再走 _SETV[0]）。
help-cycle998-order-one-angle = 先测 P1，然后沿设定角度 _STA1、再偏离表面一个角度 _TSA 移到 P2，测 P2。
help-cycle998-order-one-paraxial = 沿 _MD 方向测 P1，退回起点，在偏移轴走 _ID，再测 P2；不用 _SETVAL。
help-cycle998-order-two-angle = 先测 P1，沿设定角度移到 P2 测量，按原路返回，再沿另一设定角度移到 P3 测量；各路径都再偏离表面一个角度 _TSA。
help-cycle998-order-two-paraxial = 始终从起始高度依次测 P1、P2、P3：沿横坐标移动，返回，再沿纵坐标移动。
help-cycle998-order-end = 最后停在最后一点前 _FA 处。
help-cycle998-order-end-height = 最后停在 P3 上方的起始高度。
help-cycle998-corrects-rotation = 由 _KNUM 指定的零点偏移的旋转（测一个角度时：_RA=0），补偿量为实际角度减设定角度。位置不变：请在之后测量位置。_KNUM=0 不补偿。
help-cycle998-corrects-axis = _RA 大于 0 时，改为补偿该回转轴的零点偏移；之后移动该回转轴。
help-cycle998-corrects-area = 测得的角度与设定角度相差超过 _TSA（以度计）时报警 61303。
help-cycle998-wrong-degrees = _TSA 仍是其他循环以 mm 为单位的值；这里的单位是度。
help-cycle998-wrong-near = 各点太近：两点相距 10 mm 时，0.01 mm 的毛刺就造成 0.06° 的误差。
help-cycle998-wrong-limit = 工件的转角超过 45°，循环不能测量；_STA1 超过 45° 时报警 61331。
help-cycle998-wrong-path = 某点在测量轴上离起点超过两倍 _FA：测头在该处不触发，报警 61301。
