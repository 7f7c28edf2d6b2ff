# CYCLE982：标题、搜索词、测量方式，及其自有参数、选项和检查。

cycle982-title = 车床刀具测头：校准，测量车刀、铣刀和钻头
cycle982-help = 在各面平行于轴的刀具测头上测量车刀、铣刀或钻头的长度 L1 和 L2 以及铣刀的半径，或用刀沿位置 3 的已知刀具校准测头的一个面。
cycle982-words = 测量 刀具 对刀仪 对刀 预调 车床 车削 车铣 动力刀具 刀具测量头 测头 方块 校准 长度 L1 L2 半径 直径 刀片 刀尖 刀沿位置 钻头 立铣刀 槽铣刀 T形槽铣刀 反转 增量 自动 磨损 几何 触发点 车刀 刀补 磨耗 刀长 断刀检测 标定 换向
cycle982-each-words = 车床 测量 刀具

cycle982-calibrate = 校准刀具测头
cycle982-calibrate-workpiece = 校准刀具测头（工件坐标系）
cycle982-incremental-calibrate = 增量校准刀具测头
cycle982-incremental-calibrate-workpiece = 增量校准刀具测头（工件坐标系）
cycle982-measure = 测量：车刀、轴向铣刀或钻头的长度 L1 或 L2
cycle982-measure-reversal = 测量：轴向铣刀或钻头的长度 L1 或 L2，180° 换向
cycle982-measure-radius = 测量：轴向铣刀的半径
cycle982-measure-radius-reversal = 测量：轴向铣刀的半径，180° 换向
cycle982-measure-both = 测量：轴向铣刀的长度和半径
cycle982-measure-both-reversal = 测量：轴向铣刀的长度和半径，180° 换向
cycle982-measure-radial = 测量：径向铣刀或钻头的长度 L1 或 L2
cycle982-measure-radial-reversal = 测量：径向铣刀或钻头的长度 L1 或 L2，180° 换向
cycle982-measure-radius-radial = 测量：径向铣刀的半径
cycle982-measure-radius-radial-reversal = 测量：径向铣刀的半径，180° 换向
cycle982-measure-both-radial = 测量：径向铣刀的长度和半径
cycle982-measure-both-radial-reversal = 测量：径向铣刀的长度和半径，180° 换向
cycle982-measure-workpiece = 测量：车刀、轴向铣刀或钻头的长度 L1 或 L2（工件坐标系）
cycle982-measure-reversal-workpiece = 测量：轴向铣刀或钻头的长度 L1 或 L2，180° 换向（工件坐标系）
cycle982-measure-radius-workpiece = 测量：轴向铣刀的半径（工件坐标系）
cycle982-measure-radius-reversal-workpiece = 测量：轴向铣刀的半径，180° 换向（工件坐标系）
cycle982-measure-both-workpiece = 测量：轴向铣刀的长度和半径（工件坐标系）
cycle982-measure-both-reversal-workpiece = 测量：轴向铣刀的长度和半径，180° 换向（工件坐标系）
cycle982-measure-radial-workpiece = 测量：径向铣刀或钻头的长度 L1 或 L2（工件坐标系）
cycle982-measure-radial-reversal-workpiece = 测量：径向铣刀或钻头的长度 L1 或 L2，180° 换向（工件坐标系）
cycle982-measure-radius-radial-workpiece = 测量：径向铣刀的半径（工件坐标系）
cycle982-measure-radius-radial-reversal-workpiece = 测量：径向铣刀的半径，180° 换向（工件坐标系）
cycle982-measure-both-radial-workpiece = 测量：径向铣刀的长度和半径（工件坐标系）
cycle982-measure-both-radial-reversal-workpiece = 测量：径向铣刀的长度和半径，180° 换向（工件坐标系）
cycle982-automatic = 自动测量：两个长度和半径；车刀、轴向铣刀或钻头
cycle982-automatic-reversal = 自动测量：两个长度和半径；轴向铣刀或钻头，180° 换向
cycle982-automatic-upper = 自动测量：上刀刃；轴向铣刀
cycle982-automatic-upper-reversal = 自动测量：上刀刃；轴向铣刀，180° 换向
cycle982-automatic-opposite = 自动测量：上刀刃，逆接近方向测长度；轴向铣刀
cycle982-automatic-opposite-reversal = 自动测量：上刀刃，逆接近方向测长度；轴向铣刀，180° 换向
cycle982-automatic-radial = 自动测量：两个长度和半径；径向铣刀或钻头
cycle982-automatic-radial-reversal = 自动测量：两个长度和半径；径向铣刀或钻头，180° 换向
cycle982-automatic-upper-radial = 自动测量：上刀刃；径向铣刀
cycle982-automatic-upper-radial-reversal = 自动测量：上刀刃；径向铣刀，180° 换向
cycle982-automatic-opposite-radial = 自动测量：上刀刃，逆接近方向测长度；径向铣刀
cycle982-automatic-opposite-radial-reversal = 自动测量：上刀刃，逆接近方向测长度；径向铣刀，180° 换向
cycle982-automatic-workpiece = 自动测量：两个长度和半径；车刀、轴向铣刀或钻头（工件坐标系）
cycle982-automatic-reversal-workpiece = 自动测量：两个长度和半径；轴向铣刀或钻头，180° 换向（工件坐标系）
cycle982-automatic-upper-workpiece = 自动测量：上刀刃；轴向铣刀（工件坐标系）
cycle982-automatic-upper-reversal-workpiece = 自动测量：上刀刃；轴向铣刀，180° 换向（工件坐标系）
cycle982-automatic-opposite-workpiece = 自动测量：上刀刃，逆接近方向测长度；轴向铣刀（工件坐标系）
cycle982-automatic-opposite-reversal-workpiece = 自动测量：上刀刃，逆接近方向测长度；轴向铣刀，180° 换向（工件坐标系）
cycle982-automatic-radial-workpiece = 自动测量：两个长度和半径；径向铣刀或钻头（工件坐标系）
cycle982-automatic-radial-reversal-workpiece = 自动测量：两个长度和半径；径向铣刀或钻头，180° 换向（工件坐标系）
cycle982-automatic-upper-radial-workpiece = 自动测量：上刀刃；径向铣刀（工件坐标系）
cycle982-automatic-upper-radial-reversal-workpiece = 自动测量：上刀刃；径向铣刀，180° 换向（工件坐标系）
cycle982-automatic-opposite-radial-workpiece = 自动测量：上刀刃，逆接近方向测长度；径向铣刀（工件坐标系）
cycle982-automatic-opposite-radial-reversal-workpiece = 自动测量：上刀刃，逆接近方向测长度；径向铣刀，180° 换向（工件坐标系）
cycle982-incremental-measure = 增量测量：车刀、轴向铣刀或钻头的长度 L1 或 L2
cycle982-incremental-measure-reversal = 增量测量：轴向铣刀或钻头的长度 L1 或 L2，180° 换向
cycle982-incremental-measure-radius = 增量测量：轴向铣刀的半径
cycle982-incremental-measure-radius-reversal = 增量测量：轴向铣刀的半径，180° 换向
cycle982-incremental-measure-radial = 增量测量：径向铣刀或钻头的长度 L1 或 L2
cycle982-incremental-measure-radial-reversal = 增量测量：径向铣刀或钻头的长度 L1 或 L2，180° 换向
cycle982-incremental-measure-radius-radial = 增量测量：径向铣刀的半径
cycle982-incremental-measure-radius-radial-reversal = 增量测量：径向铣刀的半径，180° 换向
cycle982-incremental-measure-workpiece = 增量测量：车刀、轴向铣刀或钻头的长度 L1 或 L2（工件坐标系）
cycle982-incremental-measure-reversal-workpiece = 增量测量：轴向铣刀或钻头的长度 L1 或 L2，180° 换向（工件坐标系）
cycle982-incremental-measure-radius-workpiece = 增量测量：轴向铣刀的半径（工件坐标系）
cycle982-incremental-measure-radius-reversal-workpiece = 增量测量：轴向铣刀的半径，180° 换向（工件坐标系）
cycle982-incremental-measure-radial-workpiece = 增量测量：径向铣刀或钻头的长度 L1 或 L2（工件坐标系）
cycle982-incremental-measure-radial-reversal-workpiece = 增量测量：径向铣刀或钻头的长度 L1 或 L2，180° 换向（工件坐标系）
cycle982-incremental-measure-radius-radial-workpiece = 增量测量：径向铣刀的半径（工件坐标系）
cycle982-incremental-measure-radius-radial-reversal-workpiece = 增量测量：径向铣刀的半径，180° 换向（工件坐标系）

task-measure-axis = 在一个轴测量
task-measure-axis-words = 测量 刀片 动力刀具 立铣刀
task-measure-all = 自动测量：全部值
task-measure-all-words = 自动 全部 值 刀片 动力刀具 立铣刀
mvar-edges = 180° 换向（铣刀、钻头）
second-edge-without = 不换向
second-edge-with = 换向：主轴转 180° 后每点再触碰一次
second-edge-with-words = 两刃 平均值 180°
mvar-extent = 铣刀测量项
extent-plain = 一个长度；自动时：两个长度和半径
extent-plain-words = 长度 L1 L2
extent-radius = 只测半径；用于单次测量
extent-radius-words = 直径
extent-length-radius = 长度和半径，从两个面；用于单次测量，非增量
extent-length-radius-words = 直径 两点
extent-upper = 上刀刃，绕到对侧；只用于自动测量
extent-upper-words = 槽铣刀 T形槽铣刀 圆盘 长度 半径
extent-upper-opposite = 上刀刃，逆接近方向测长度；只用于自动测量
extent-upper-opposite-words = 槽铣刀 T形槽铣刀 圆盘 长度 半径 相反方向
mvar-tool-axis = 铣刀或钻头安装位置
tool-axis-axial = 轴向：半径在纵坐标（G18：X）
tool-axis-radial = 径向：半径在横坐标（G18：Z）
ma-lathe-radius = 半径，在横坐标触碰（G18：Z）
ma-lathe-radius-ordinate = 半径，在纵坐标触碰（G18：X）
ma-lathe-l2-radius = L2 和半径，在横坐标触碰（G18：Z）
ma-lathe-l1-radius = L1 和半径，在纵坐标触碰（G18：X）

param-ma-lathe-measured = 被测尺寸
param-ma-lathe-measured-help = 要测量的尺寸，也决定在哪个轴触碰。轴向刀具的半径在纵坐标，径向刀具的半径在横坐标。起点对着要触碰的面。
param-md-incremental = 测量方向
param-md-incremental-help = 刀具从当前位置移向测头的方向。
param-sta1-milling-spindle = 铣削主轴起始角
param-sta1-milling-spindle-help = 静止的铣削主轴在第一次触碰前转到的角度，使一个刀刃对着测头。主轴旋转时和 _CHBIT[20]=1 时无效。
param-cora-second-edge = 第二刀刃补偿角
param-cora-second-edge-help = 第二刀刃不正好在对面时，加到第二次触碰前主轴所转的 180° 上。
param-fa-present-position = 测量行程
param-fa-present-position-help = 刀具位于测头前，必须在此距离的两倍之内触碰。始终以 mm 为单位，X 轴按半径计。

need-axis-ignored = 忽略：该钻头的长度沿垂直坐标计（设定数据 42950 = 0）。
need-direction-incremental = 增量方式不按起点确定测量方向。
need-start-angle-spindle = 静止的铣削主轴转到此角度；省略时沿用上次调用的值。
need-start-angle-milling = 对铣刀有效。
need-second-edge = 对 180° 换向的第二次触碰有效。

check-tool-reference = _CBIT[5]=1：_TP 的值按有效工件坐标系，尽管 _MVAR 第 2 位为机床坐标系。
check-tool-reference-hint = 请把 _CBIT[5] 设为 0，或选择工件坐标系的测量方式（_TPW），然后重新校准。
check-lathe-tool-type-hint = 请用车刀（类型 5xy）、铣刀（1xy、711 到 799）或钻头（2xy），并检查 $TC_DP1。
check-turning-digits = { $value } 的第 3 到 5 位用于铣刀和钻头，而当前是车刀。
check-turning-digits-hint = 车刀请选 { $plain }，或在调用前换上铣刀。
check-tip-direction = 刀沿位置 { $tip } 的刀具朝向相反：背面会碰到测头。
check-tip-direction-hint = 请从测头的另一侧开始，并把 _MD 改为相反方向，或检查 $TC_DP2。
check-drill-radius = 循环不测量钻头的半径。
check-drill-radius-hint = 请选第 4 位为 0 的测量方式，或换上铣刀，并检查 $TC_DP1。
check-drill-plane = 设定数据 42950 = 0 时，G18 中钻头的长度沿 Y 计，而循环不在该轴测量。
check-drill-applicate = 设定数据 42950 = 0 时，循环只测量钻头的长度：在一个轴，不带 180° 换向。
check-drill-applicate-hint = 请在 G17（钻头沿 Z）或 G19（沿 X）中选 1、11、100001 或 100011，或把设定数据 42950 设为 2 并用 G18。
check-length-assignment = 设定数据 42950 为 { $value }：铣刀和钻头的 L1、L2 分配与车刀不同。
check-length-assignment-hint = 请在调用前把设定数据 42950（$SC_TOOL_LENGTH_TYPE）设为 2；G17 或 G19 中的钻头也可以用 0。
check-spindle-stays = 此测量方式要转动主轴或测量两次，而 _CHBIT[20]=1 禁止主轴定位。
check-spindle-stays-hint = 请把 _CHBIT[20] 设为 0，或选 xxx0x1（x 为 0 或 1）的测量方式：一点，不带 180° 换向。
check-spindle-turns = 铣削主轴须转到 _STA1，但主轴不能定位。
check-spindle-turns-hint = 请把刀刃转向测头，把 _CHBIT[20] 设为 1 并选 xxx0x1 的测量方式：一点，不带 180° 换向。
check-side-radius = 刀具用侧面触碰，但其半径为 0：求不出长度。
check-side-radius-hint = 请在刀具数据中输入半径，或在沿刀具的轴上测量。
check-radius-length = 刀具的 { $length } 为 0，而半径由该长度计算。
check-radius-length-hint = 请先测量或输入该长度，或同时测长度和半径（第 4 位 = 2，非增量方式）。
