# 使用刀具测头的循环的共同内容：参数、选项、结果、检查。

mvar-task = 任务
task-calibrate = 校准测头
task-calibrate-words = 校准 测量头 测头 对刀仪 触发点 边 面 标定
task-still = 测量刀具，主轴静止
task-still-words = 长度 半径 钻头 立铣刀 边
task-rotating = 测量刀具，主轴旋转
task-rotating-words = 长度 半径 旋转 最大 边 铣刀 端面 转速 进给 速度
mvar-reference = 坐标系
reference-machine = 机床坐标系（_TP）
reference-machine-words = 机床 _TP
reference-setting = 工件坐标系（_CBIT[5]=1，_TP）
reference-workpiece = 工件坐标系（_TPW）
reference-workpiece-words = 工件 WCS 坐标框架 _TPW
ma-lathe-l2 = L2，在横坐标触碰（G18：Z）
ma-lathe-l1 = L1，在纵坐标触碰（G18：X）
mvar-approach = 接近方式
approach-normal = 由循环定位
approach-incremental = 增量：只有测量运动
approach-incremental-words = 未知 位置 首次 几何 JOG
approach-automatic = 自动：各面
approach-automatic-words = 自动 全部 轴 方向 中心

param-prnum-tool = 刀具测头
param-prnum-tool-help = 刀具测头的编号：数据在 _TP[n-1,…] 中，测量方式使用 _TPW 时在 _TPW[n-1,…] 中。
param-evnum-tool = 经验值存储器
param-evnum-tool-help = 修正测量值的存储器 _EV[n-1] 的编号 n；0：无。大于 9999 时只取后四位，因为不形成平均值。
param-tzl-tool = 零补偿区
param-tzl-tool-help = 偏差不超过此值时不作补偿，也不报警。
param-tdif-tool = 允许尺寸差
param-tdif-tool-help = 偏差达到或超过此值时不作补偿并输出信息 62306；程序继续，_CBIT[2]=1 时按 NC START 后才继续。
param-tsa-tool-probe = 触发点安全区
param-tsa-tool-probe-help = 触发点与存储值相差大于此值时，程序以报警 61303 停止，不存储任何值。
param-tsa-tool = 刀具安全区
param-tsa-tool-help = 长度或半径的偏差达到或超过此值时不作补偿，程序以报警 61303 停止。
param-fa-tool = 测量行程
param-fa-tool-help = 从测量程序段起点到预期触发点的距离；过了该点再走同样的距离。绕行测头时也是安全距离。始终以 mm 为单位，X 轴按半径计。
param-ma-lathe-length = 被测长度
param-ma-lathe-length-help = 要测量的长度，也决定在哪个轴触碰。起点对着刀刃要触碰的那一面。
param-ma-calibrate = 校准轴
param-ma-calibrate-help = 触碰测头所沿的轴。起点决定方向，垂直坐标则始终为负方向（增量接近方式除外）。

result-trigger-minus-1 = 负方向触发点，第 1 几何轴
result-trigger-minus-1-difference = 负方向触发点偏差，第 1 几何轴
result-trigger-plus-1 = 正方向触发点，第 1 几何轴
result-trigger-plus-1-difference = 正方向触发点偏差，第 1 几何轴
result-trigger-minus-2 = 负方向触发点，第 2 几何轴
result-trigger-minus-2-difference = 负方向触发点偏差，第 2 几何轴
result-trigger-plus-2 = 正方向触发点，第 2 几何轴
result-trigger-plus-2-difference = 正方向触发点偏差，第 2 几何轴
result-trigger-minus-3 = 负方向触发点，第 3 几何轴
result-trigger-minus-3-difference = 负方向触发点偏差，第 3 几何轴
result-trigger-plus-3 = 正方向触发点，第 3 几何轴
result-trigger-plus-3-difference = 正方向触发点偏差，第 3 几何轴
result-actual-l1 = 实际长度 L1
result-difference-l1 = 长度 L1 偏差
result-actual-l2 = 实际长度 L2
result-difference-l2 = 长度 L2 偏差

check-tool-probe-number-hint = 请输入 1 到 { $fields } 的编号，或建立更多测头数据并加大 { $array }。
check-tool-limits = { $small } 为 { $low } mm，不小于 { $large } 的 { $high } mm：两者之间没有任何偏差值。
check-tool-limits-hint = 请按从小到大的顺序设定：_TZL、_TDIF、_TSA。
check-tool-speed = { $name } 为 0 或负值：循环无法定位刀具。
check-tool-speed-hint = 请将 _SPEED[0] 设为快速移动的百分比；有碰撞监控（_CHBIT[2]=1）时，将 _SPEED[1]、_SPEED[2] 设为大于 0 的进给。
check-tool-probe-empty = 刀具测头的位置未设定：{ $names } 为 0。
check-tool-probe-empty-hint = 请在 GUD6 中输入刀具测头各面的近似位置；循环由此计算路径。
check-tool-probe-sides = { $minus } 不大于 { $plus }：朝负方向触碰的面必须在测头的正侧。
check-tool-probe-sides-hint = 请交换两个值，或输入缺少的一个。
check-tool-probe-in-use = 当前刀具是工件测头。
check-tool-probe-in-use-hint = 请在调用前换上要测量的刀具或校准刀具。
check-tool-type = 这里不允许刀具类型 { $type }。
check-tool-type-hint = 请换上要测量的刀具或校准刀具，并检查 $TC_DP1。
check-turning-type-hint = 请用车刀（类型 5xy），在其 D 号有效时调用循环，并检查 $TC_DP1。
check-tip = 这里不允许刀沿位置 { $tip }。
check-tip-calibration-hint = 请用刀沿位置 3 的刀具校准测头，并检查 $TC_DP2。
check-tip-hint = 请用刀沿位置 1 到 8 的刀具，并检查 $TC_DP2。
check-tip-axis = 刀沿位置 { $tip } 的刀具在此轴方向上没有刀刃。
check-tip-axis-hint = 请只在横坐标测量刀沿位置 5、7 的刀具，只在纵坐标测量刀沿位置 6、8 的刀具。
check-tool-radius-negative = 当前刀具的半径与磨损之和为 { $radius } mm。不存在这样的刀具：模拟时半径取 0。
check-tool-radius-negative-hint = 请改正刀具数据中的半径或半径磨损。
