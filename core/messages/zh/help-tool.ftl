# Help pages of the cycles at a tool probe.

help-tool-in-use = 刀具已换上，其 D 号有效；已编程平面和 G40。刀具长度已输入刀具数据：校准时须精确，否则近似即可。
help-tool-not-turned = 没有坐标旋转；测头各面平行于轴。
help-tool-parallel = 测头各面平行于机床轴。
help-tool-chip = 刀刃或测头上有切屑、冷却液：测头过早触发，结果不准。

help-cycle971-measures-side = 用长度和半径已知的刀具测出刀具测头一个面的位置。
help-cycle971-measures-sides = 用长度和半径已知的刀具，测出刀具测头上由 _TP[k,7]（工件坐标系：_TPW[k,7]）指定的各面的位置。
help-cycle971-measures-tool = 铣刀或钻头的长度 L1（_MA = 3、103、203），或铣刀的半径（_MA = 1、2）。
help-cycle971-before-still = 主轴静止，刀刃已转向测头；循环不转动主轴。
help-cycle971-before-rotating = 循环由 _CM[] 计算转速和进给，_CBIT[12]=1 时取自 _MFS[]。旋转的主轴保持方向，静止的主轴取 _CM[5] 的方向。
help-cycle971-before-clear = 刀具在要触碰的一侧，与测头保持距离：_MA = 3、103、203 时在其上方，否则在其旁边。
help-cycle971-before-parallel = 刀具轴平行于测头中心线。
help-cycle971-before-over = 刀具可从当前位置先上下移动到测头顶面上方 _FA 处，再横向移到测头中间，途中没有障碍。
help-cycle971-order-beside = 在侧面：先在另一轴移到测头中间，再到该面旁，下降到低于顶面 _TP[k,9] 或 _TPW[k,9] 处，触碰，退回。最后停在该深度。
help-cycle971-order-on-top = 在顶面（_MA = 3、103、203）：移到中间上方，下降，触碰；比测头宽的刀具沿横坐标（3、103）或纵坐标（203）向起点一侧偏移“半径减 _ID”，钻头不偏移。最后停在上方 _FA 处。
help-cycle971-order-centre-first = _MA = 102 或 201 时，先在另一轴方向触碰两次，求出测头在该轴上的中心。
help-cycle971-order-widest = 测半径时刀具再下降 _ID，以最大直径处触碰。
help-cycle971-order-turning = 触碰一到三次，由 _CM[6] 和 _CM[7] 决定，_CBIT[12]=1 时由 _MFS[] 决定；以最后一次为准。主轴原来静止时，测量后再次停止。
help-cycle971-order-all-sides = 各面均可触碰时：先触碰顶面，再触碰纵坐标两侧（求出纵坐标中心），在该中心处触碰横坐标两侧，再在求出的横坐标中心处触碰纵坐标两侧，最后再触碰顶面，停在其上方 _FA 处。
help-cycle971-wrong-depth = _TP[k,9]（工件坐标系：_TPW[k,9]）为 0：刀具在测头旁不会下降到低于测头上沿；测半径时报警 61349。
help-cycle971-wrong-unclear = 由刀具位置不能确定要触碰哪一面：报警 61332。
help-cycle971-wrong-edge = 刀刃没有转向测头：半径测得偏小，刀刃高度不同的刀具长度也偏小。
help-cycle971-wrong-master = 校准刀具尺寸不准：其误差会计入以后测量的每把刀具。
help-cycle971-wrong-no-data = 刀具的长度或半径为 0：报警 61351。
help-cycle971-wrong-direction = 主轴静止，而 _CM[5] 既不是 3 也不是 4：报警 61366。

help-cycle972-measures-side = 用刀沿位置 3 的校准刀具测出刀具测头一个面的位置。
help-cycle972-measures-length = 车刀的一个长度：横坐标上的 L2 或纵坐标上的 L1。
help-cycle972-order-travel = 在另一轴移到测头中间，再移到该面，触碰，退回。最后停在该面前 _FA 处。
help-cycle972-order-nose = 刀尖圆弧中心对着测头中间；触碰刀具起点所在一侧的面。
help-cycle972-order-tip = 刀刃按其刀沿位置，朝所指的方向触碰。

help-cycle982-measures-side = 用刀沿位置 3、长度和刀尖半径已知的校准刀具，测出车床刀具测头一个面的位置。
help-cycle982-measures-one-length = 车刀、铣刀或钻头的一个长度：_MA=1 为 L2，_MA=2 为 L1；SD 42950 = 0 时钻头总是 L1。
help-cycle982-measures-radius = 铣刀的半径；半径所在轴上的长度必须已知。
help-cycle982-measures-both = 铣刀的半径以及同一轴上的长度。
help-cycle982-measures-all = 车刀：两个长度，刀沿位置 5 到 8 时只有一个；铣刀：两个长度和半径（输入的半径为 0 时只测长度）；钻头：长度。
help-cycle982-measures-upper = 铣刀（例如槽铣刀）在靠近刀柄的上刀刃处的长度和半径。
help-cycle982-before-outside = 刀具在平面两个轴上都位于测头之外、要触碰的一侧；Y 轴对着测头中间。
help-cycle982-before-setting = 测铣刀和钻头时 SD 42950 为 2；在 G17、G19 中测钻头的一个长度时也可为 0。
help-cycle982-before-axial = 铣刀或钻头轴向安装：其轴沿横坐标，半径在纵坐标上。
help-cycle982-before-radial = 铣刀或钻头径向安装：其轴沿纵坐标，半径在横坐标上。
help-cycle982-order-calibrate = 在另一轴刀尖圆弧中心移到测头中间，再移到该面，触碰，退回。最后停在该面前 _FA 处。
help-cycle982-order-spindle = 测铣刀或钻头时，静止的铣削主轴先转到 _STA1，_CHBIT[20]=1 时不转。
help-cycle982-order-reversal = 每点触碰两次，第二次主轴再转 180° 加 _CORA：取两个刀刃的平均值。
help-cycle982-order-length = 在另一轴移到测头中间，再移到该面，以刀尖触碰（铣刀或钻头在垂直于其轴的方向以侧刃触碰），退回。最后停在该面前 _FA 处。
help-cycle982-order-radius = 在半径所在的轴上，以铣刀侧刃触碰。
help-cycle982-order-both = 铣刀侧刃先触碰起点一侧的面，再绕过测头触碰对面。不带 180° 换向时，静止的主轴为此转 180°，使同一刀刃触碰。
help-cycle982-order-all = 先横坐标，后纵坐标，绕测头移动，钻头只沿其轴测；不换向时，静止的主轴先转动，使同一刀刃朝向每个触碰面。最后停在起点。
help-cycle982-order-upper-behind = 在背离起点的一侧绕过测头，在该侧测长度，并测两侧：先测横坐标上的值。最后停在起点。
help-cycle982-order-upper-across = 先越过测头，朝起点方向返回测长度，并测两侧：先测横坐标上的值。最后停在起点。
help-cycle982-corrects-geometry = 当前刀具：测得的值写入几何值，磨损置 0，不论原值如何。
help-cycle982-wrong-axis = 半径不在 _MA 轴上：报警 61325。
help-cycle982-wrong-drill-radius = 刀具是钻头，循环不测量其半径：报警 61314。
help-cycle982-wrong-fast = 触碰时铣削主轴转速过高：会损坏刀刃和测头。请降低转速。
help-cycle982-wrong-wrong-side = 起点在错误的一侧，或在测头两侧面之间：报警 61332。
help-cycle982-wrong-nose = 校准刀具的刀尖半径或长度不对：误差会计入以后测量的每把刀具。

help-tool-probe-known = 校准时，_TP（工件坐标系：_TPW）中的触发点是测头各面的近似位置；测量刀具时，测头必须已校准。
help-tool-block = 对一个面：移到该面前 _FA 处，从那里最多走两倍 _FA 触碰，触发后退回。_NMSP 大于 1 时重复，取平均值。
help-tool-reach = 刀具数据或测头数据的误差超过 _FA：测头不触发（报警 61301），或途中碰撞（61302）。
help-tool-trigger = 测头数据：_TP（工件坐标系：_TPW）中的触发点，与存储值相差大于 _TZL 时更新。超过 _TSA：报警 61303，不存储。
help-tool-data = 当前刀具：写入几何值，磨损置 0；_CHBIT[3]=1 时只写磨损。偏差不超过 _TZL：不补偿；达到 _TDIF：信息 62306，不补偿；达到 _TSA：报警 61303。
help-tool-in-front = 刀具已对着要触碰的面，距离不超过两倍 _FA。校准时不需要测头的数据；测量刀具时，此面必须已校准。
help-tool-from-here = 从所在位置最多走两倍 _FA 触碰，退回起点；没有其他移动。
help-tool-trigger-always = 测头数据：_TP（工件坐标系：_TPW）中的触发点，不论原值如何都存储。
help-tool-unwatched = 结果没有极限值监控：刀具若碰到测头以外的物体，错误的值也会被存储。
