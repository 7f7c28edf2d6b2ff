# Help pages of the probing macros of the NCT controls.

help-stylus = 测针在主轴中，其长度补偿有效，且没有触碰任何物体。
help-oriented = 主轴已定向（M19）；若机床用 M 功能开关测针，则测针已接通（M59，同时使主轴定向）。主轴启动前用 M55 断开。
help-levels-none = 它不调用其他宏程序，子程序调用 2 级。再加上调用程序所在的级数；上限见控制系统的说明书。
help-levels-one = 它调用 1 级宏程序和 2 级子程序。再加上调用程序所在的级数；上限见控制系统的说明书。
help-levels-two = 它调用 2 级宏程序和 2 级子程序。再加上调用程序所在的级数；上限见控制系统的说明书。
help-guarded = 测针用 G101 移到该处，途中若有碰撞便会停止。
help-steps = 一次触碰分三步：快速接近直到触发，以中等速度退回，再以很低的速度前进；以最后一步为准。
help-position-lost = 上一次 G101 没有到达目标：OUT OF POSITION。
help-result = 编程 S 时，工件偏置按测量值减公称值补偿；编程 T 时补偿刀具寄存器，使下一个工件合格；M 仅用于存储偏差，有余量为正。S 和 T 都省略则不补偿。
help-limits = 偏差大于 H 时显示 OUT OF TOLERANCE；大于 U 时显示 UPPER TOL EXEEDED，不作补偿。
help-both-targets = 同时编程了 S 和 T：FORMAT ERROR。偏差只能补偿其中之一。
help-middle-tolerance = 公称尺寸不是公差带的中值：H 向两侧计算（20 +0.1/−0.3 写成 19.9 和 H0.2）。
help-one-system = 校准一部分用英制、一部分用公制：全部应在同一单位制中进行。

help-g101-measures-nothing = 不测量：把测针移到 X、Y、Z，并监控途中的每个信号。
help-g101-before-free = 测针的长度补偿有效，且没有触碰任何物体。
help-g101-order-straight = 以 F 直线移动，默认 1500 mm/min；有信号立即停止。
help-g101-corrects-nothing = 不补偿。停止后存储“未到达目标”，在下一次 G101 成功之前拒绝执行各测量宏程序。
help-g101-wrong-obstructed = 路径上有障碍物：PATH OBSTRUCTED。请手动移开测针，换一条路径。
help-g101-wrong-incremental = G91 有效时，各地址是增量而不是位置。

help-g102-measures-offset = 测球相对主轴轴线在平面两个轴上的偏移。
help-g102-before-ring = 主轴已定向，位于其刚镗出的孔的轴线上，孔径大于 20 mm；或 #510 中有使主轴转 180° 的 M 功能，且测球在环规中间，偏离不超过 10 mm。
help-g102-order-walls = 触碰两个轴的四个壁；#510 中有 M 功能时，主轴转 180° 后再触碰一遍。
help-g102-corrects-offset = #504 和 #505：平面第 1 轴和第 2 轴的径向偏置。
help-g102-wrong-moved = 主轴已不在孔的轴线上，且 #510 为 0（不转 180°）：孔位的误差被存为径向偏置。

help-g103-measures-radius = 平面两个轴正负方向的有效测球半径。
help-g103-before-ring = 已执行 G102；测球在环规中间，偏离不超过 10 mm，处于测量深度。
help-g103-order-centre = 触碰四个壁求出环规中心，再从中心触碰每个壁各一次。
help-g103-corrects-radius = 第 1 轴正、负方向为 #500 和 #501，第 2 轴为 #502 和 #503。
help-g103-wrong-size = D 只是近似值：误差的一半会计入各半径。请输入环规的精确尺寸。

help-g104-measures-length = 测针的长度：触碰刀具轴坐标已知的表面。
help-g104-before-above = 测球在表面上方；长度寄存器中的长度误差不超过 5 mm。
help-g104-order-down = 向下触碰，最多到给定坐标下方 10 mm 处。
help-g104-corrects-register = 长度寄存器 T：之后在测球触碰处控制系统显示给定坐标。
help-g104-wrong-coordinate = 该坐标属于另一个工件偏置，而不是有效的工件偏置。

help-g105-measures-surface = 垂直于平面一个轴的表面的位置。
help-g105-before-side = 测球在表面无材料的一侧：在测量深度；编程了刀具轴地址时在其上方。
help-g105-order-touch = 编程了刀具轴地址时，先移到表面前 R 处并下降；然后朝公称坐标触碰，越过该坐标的距离不大于 Q。
help-g105-corrects-radius = T 是半径寄存器，按全部偏差补偿。
help-g105-wrong-far = 表面位于公称坐标后方，且距离大于 Q：PROBE FAIL。

help-g106-measures-surface = 垂直于刀具轴的表面的高度。
help-g106-before-above = 测球在触碰点上方。
help-g106-order-down = 向下触碰，最多到公称坐标下方 Q 处。
help-g106-corrects-length = T 是长度寄存器，按全部偏差补偿。
help-g106-wrong-low = 测球已在公称坐标下方，距离不小于 Q：NO MOVEMENT。

help-g107-measures-corner = 内拐角两个壁的交点。
help-g107-before-inside = 测球在内拐角中，处于测量深度，不接触两壁；两壁平行于轴。
help-g107-order-walls = 先触碰垂直于第 1 轴的壁，退回，再触碰垂直于第 2 轴的壁；越过公称坐标的距离不大于 Q。
help-g107-corrects-offset = 工件偏置 S（省略 S 时为有效的工件偏置），两个轴：使拐角处于公称坐标。
help-g107-wrong-turned = 工件装夹歪斜：只补偿拐角的位置，不补偿方向。

help-g108-measures-corner = 外拐角两个壁的交点。
help-g108-before-before = 测球在外拐角前，处于测量深度，在两个壁之外。起点在拐角前多远，就在拐角后多远处触碰。
help-g108-order-walls = 越过拐角，触碰垂直于第 1 轴的壁并返回，第 2 轴同样；越过公称坐标的距离不大于 Q。
help-g108-corrects-offset = 工件偏置 S（省略 S 时为有效的工件偏置），两个轴，按拐角的偏差补偿。
help-g108-wrong-close = 起点离拐角太近：只碰到倒圆或倒角。

help-g109-measures-pocket = 槽在平面一个轴上的宽度和中线。
help-g109-measures-web = 凸台在平面一个轴上的宽度和中线。
help-g109-before-inside = 测球在槽的公称中线上，处于测量深度。
help-g109-before-above = 测球在凸台公称中线的上方。
help-g109-order-outwards = 先向外触碰一壁，再触碰对面的壁；越过公称位置的距离不大于 Q。
help-g109-order-inwards = 在每侧移到壁旁 R 处，下降，向内触碰；越过公称位置的距离不大于 Q。
help-g109-corrects-half = S 按中线的偏移补偿；T 为半径，按宽度偏差的一半补偿。
help-g109-wrong-width = 没有宽度或为 0：FORMAT ERROR。
help-g109-wrong-room = 补偿后的刀具放不进槽：TOOL DIA OFFS TOO LARGE。

help-g110-measures-bore = 孔的直径及其中心。
help-g110-measures-boss = 圆凸台的直径和中心。
help-g110-before-inside = 测球在孔的公称中心，处于测量深度。
help-g110-before-above = 测球在圆凸台公称中心的上方。
help-g110-order-outwards = 先第 1 轴的两壁，再第 2 轴的两壁，向外触碰；越过公称位置的距离不大于 Q。
help-g110-order-inwards = 先第 1 轴的两壁，再第 2 轴的两壁：每次移到壁旁 R 处，下降，向内触碰；越过公称位置的距离不大于 Q。
help-g110-corrects-half = S 按中心在两个轴上的偏移补偿；T 为半径，按直径偏差的一半补偿。
help-g110-wrong-room = 补偿后的刀具放不进孔：TOOL DIA OFFS TOO LARGE。

help-p9920-measures-probe = 对刀仪圆盘的位置和直径。
help-p9920-measures-length = 刀具长度。
help-p9920-measures-both = 刀具长度和直径。
help-p9920-before-reference = 已返回参考点，且对刀仪轴线与 Z 平行。
help-p9920-before-centre = 直径准确已知的标准刀具位于圆盘中心上方。
help-p9920-before-above = 刀具在 Z 方向位于对刀仪上方，且对刀仪已校准。
help-p9920-order-rim = 依次在 +X、−X、+Y、−Y 方向：从中心向外移动两直径之和的一半加 E，下降 Z，触碰边缘，再上升。
help-p9920-order-face = 然后在中心上方下降到圆盘，再回到起点。
help-p9920-order-length = 在 +X 方向移到距中心 D/2 处，再下降，最多 Z，直到触碰。
help-p9920-order-diameter = 从触碰处抬起 K，在 +X 方向移到距中心两直径之和的一半加 E 处，下降到比触碰处低 K，触碰边缘。
help-p9920-corrects-probe = 圆盘位置存入 #506、#507、#508，其直径存入 #509，标准刀具长度存入 #513。
help-p9920-corrects-length = 寄存器 T 的长度，由 G43 使用。
help-p9920-corrects-radius = 寄存器 T 的半径。
help-p9920-wrong-length = 宏程序结束后 G49 有效，进给和转速可能已改变：在 Z 方向移动前须重新使长度补偿生效。
help-p9920-wrong-turning = 旋转着下降（M3、M4）的刀具可能打掉圆盘。
help-p9920-wrong-lift = 抬起量小于 2 mm 时，刀具可能碰不到圆盘边缘。
help-p9920-wrong-disk = 圆盘直径与 #509 的 40 mm 相差超过 2 mm：校准之前宏程序按错误的直径计算。
