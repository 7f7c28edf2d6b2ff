# 调用的数值有什么问题，以及如何纠正（-hint）。长度单位为 mm，原样引用的输入值除外。

check-missing = 缺少 { $param }。
check-delivered = 未设定 { $param }：按默认值 { $value }{ $unit }。
check-not-a-number = “{ $value }”不是数字。
check-not-a-number-hint = 请输入数字，小数用点或逗号，例如 12.5。
check-expression = “{ $value }”在程序运行时才能确定，因此不检查。
check-no-value = { $name } 在此处没有值，因此不模拟该调用。
check-no-value-hint = 请在调用之前为 { $name } 赋值，或在机床配置中设置。
check-too-large = { $value } 超出任何机床的范围。
check-too-large-hint = 请检查数字及其指数。
check-not-whole = { $value } 不是整数。
check-not-whole-hint = 请输入不带小数的值。
check-text-long = 文本超过 { $most } 个字符。
check-text-long-hint = 请把文本缩短到此长度。
check-text-characters = 文本中含有引号或控制字符。
check-text-characters-hint = 请输入不含引号和控制字符的文本。
check-range = { $param } 不能是 { $value }{ $unit }。
check-range-choice-hint = 请从 { $choices } 中选择。
check-range-both-hint = 请输入 { $min } 到 { $max }{ $unit } 之间的值。
check-range-from-hint = 请输入不小于 { $min }{ $unit } 的值。
check-range-above-hint = 请输入大于 { $min }{ $unit } 的值。
check-range-below-hint = 请输入小于 { $max }{ $unit } 的值。
check-unusual = { $param } 为 { $value }{ $unit } 不常见。
check-unusual-hint = 通常为 { $min } 到 { $max }{ $unit }。
check-variant = { $cycle } 没有测量方式 { $value }。
check-variant-pair = “{ $one }：{ $first }”和“{ $other }：{ $second }”不能同时选用：{ $cycle } 没有测量方式 { $value }。
check-variant-hint = 请从列表中选择测量方式。
check-variant-near-hint = 相近的测量方式：{ $near }。并非每种数位组合都有效。

check-knum-zero = { $code } 不是零点偏移的代码。
check-knum-zero-hint = 允许 0（无）、1 到 99（G54 等）、1000、1011 到 1026、1051 到 1066（基本）、2000（系统）、9999（有效坐标框架）。
check-knum-no-system = 此机床没有 { $code } 所指的系统坐标框架 $P_SETFR。
check-knum-no-system-hint = 请选择其他坐标框架，或设置 MD 28082 的第 0 位。
check-knum-is-tool-hint = 这是刀具补偿的代码。请输入坐标框架的代码，或选择带刀具补偿的测量方式（若有）。
check-knum-is-zero-hint = 这是零点偏移的代码。请输入允许的 D 号，或选择带零点偏移的测量方式（若有）。
check-knum-digit-4 = { $code } 从右起第 4 位（D 号为五位时第 6 位）取值不允许。
check-knum-digit-5 = { $code } 从右起第 5 位（D 号为五位时第 7 位）取值不允许。
check-knum-digit-6 = { $code } 从右起第 6 位（D 号为五位时第 8 位）取值不允许。
check-knum-digit-7 = { $code } 从右起第 7 位（D 号为五位时第 9 位）或更高位的取值不允许。
check-knum-edge-none = { $code } 不含 D 号。
check-knum-edge-large = { $code } 中的 D 号大于 { $largest }，即此控制系统的最大 D 号。
check-knum-seven-digits-hint = 从右向左：三位 D 号；一位长度（0、1）或半径（2）；一位取反（1）；一位 L1 到 L3（1 到 3）或半径（4）；一位补偿种类（0 到 3）。
check-knum-nine-digits-hint = 从右向左：五位 D 号；一位长度（0、1）或半径（2）；一位取反（1）；一位 L1 到 L3（1 到 3）或半径（4）；一位补偿种类（0 到 3）。

check-probe-number = 没有测头号 { $number }。
check-probe-number-hint = 请输入 1 到 { $fields } 的编号。
check-probe-type = 测头号从右起第 3 位不能是 { $type }。
check-probe-type-hint = 0 为多向测头，1 为单向或双向测头。
check-cora-off = 补偿角不起作用：_CBIT[8] 为 0。
check-cora-off-hint = 请设 _CBIT[8]=1，或将补偿角设为 0。
check-empirical-memory = 没有经验值存储器 { $number }：数组只有 { $size } 个元素。
check-mean-memory = 没有平均值存储器 { $number }：数组只有 { $size } 个元素。
check-memory-hint = 请输入较小的编号，或扩大数组并加大 { $array }。
check-mean-off = 平均值不会从一个工件保存到下一个工件：_CHBIT[4] 为 0。
check-mean-off-hint = 要保存平均值，请设 _CHBIT[4]=1。
check-tolerance-order = 公差上限 { $upper } mm 低于公差下限 { $lower } mm。
check-tolerance-order-hint = 请交换 _TUL 和 _TLL，或改正它们的符号。
check-band-difference = 公差带的一半 { $small } mm 大于 _TDIF { $large } mm：部分合格工件得不到补偿。
check-zero-mean = _TZL { $small } mm 大于 _TMV { $large } mm：永远不会按平均值补偿。
check-difference-safe = _TDIF { $small } mm 大于 _TSA { $large } mm：在 _TDIF 起作用之前程序就停止。
check-bands-hint = 请按从小到大的顺序设定：_TZL、_TMV、公差带的一半、_TDIF、_TSA。
check-rotation = 坐标旋转有效。
check-rotation-hint = 请在调用前取消旋转：此循环平行于机床轴测量。
check-infeed = 按进刀深度 { $infeed } mm，测头不会下降到被测要素。
check-infeed-hint = 请输入负值；若测头本体位于垂直坐标的负侧，请输入正值。

check-ball = { $ball } mm 的测球放不进去。
check-ball-hint = 请改正所输入的尺寸，或换用测球较小的测头。
check-path-long = 测量行程会从对面的壁内开始：测球只有 { $free } mm 的行程。
check-path-long-hint = 请把 _FA 减小到小于 { $free } mm。
check-zone-wide = 保护区 { $zone } mm 不小于被测要素 { $size } mm。
check-zone-wide-hint = 请把保护区减小到小于 { $limit } mm，使旁边放得下测球。
check-zone-none-hint = 内部放不下保护区：请选择不带保护区的测量方式，或用更小的测球。
check-zone-narrow = 保护区 { $zone } mm 不大于被测要素 { $size } mm。
check-zone-narrow-hint = 请把保护区加大到大于 { $limit } mm，使被测要素旁放得下测球。
check-zone-ball = 被测要素与保护区之间容不下 { $ball } mm 的测球。
check-zone-shortens = 保护区把测量行程缩短到 { $free } mm。
check-zone-shortens-hint = 请改变保护区以留出更多行程，或以此值为工件的最大偏差。
check-differential-mono = 差值测量要转动主轴，而单向测头只能朝一个方向测量。
check-differential-mono-hint = 请用多向测头，或选不带差值测量的测量方式。
check-differential-axis = 差值测量只能在平面内进行。
check-differential-axis-hint = 请把测量轴设为 1 或 2。
check-mono-spindle = 单向测头每次触碰前都要转动，而此主轴不能定位。
check-mono-spindle-hint = 请用多向测头。
check-differential-spindle = 差值测量要转动主轴，而此主轴不能定位。
check-differential-spindle-hint = 请选不带差值测量的测量方式，并使用校准过的测头。
check-knum-no-additive = 此机床没有附加补偿。
check-knum-no-additive-hint = 请改为补偿长度或半径，或设置 MD 18080 的第 8 位。
check-target-not-offered = { $param } = { $value } 不在此机床输入画面所提供的补偿对象之中。
check-target-not-offered-hint = 请选择可设定的零点偏移或最后一个基本坐标框架，补偿刀具时输入 D 号，或把 GUD6 中的 { $entry } 设为 1。
check-knum-no-setup = 此机床没有设定补偿。
check-knum-no-setup-hint = 请改为补偿长度或半径，或设置 MD 18112 的第 4 位。

check-knum-rotation = 全局基本坐标框架 { $code } 不能存储旋转。
check-knum-rotation-hint = 请选择可设定坐标框架或通道基本坐标框架。
check-lathe-length = 5xy 类型测头的长度算到测球中心，而 _CBIT[14]=1 表示算到测球圆周。
check-lathe-length-hint = 请设 _CBIT[14]=0，并输入到测球中心的长度。
check-mirror-datum = 有轴被镜像，而 MD 10610 不为 0：测量循环只允许在 MD 10610=0 时镜像。
check-mirror-datum-hint = 请取消镜像后测量，或设 MD 10610=0。
check-multi-probe = 此测量需要多向测头：单向测头只在一个方向触发。
check-multi-probe-hint = 请使用多向测头：{ "_PRNUM" } 为两位数。
check-angles-sum = 起始角与全部增量角不计符号之和为 { $sum }°，大于 360°。
check-angles-sum-hint = 请减小增量角，或输入更接近 0 的起始角（可为负）。
check-angles-same = 用此增量角各点会重合：求不出圆。
check-angles-same-hint = 请输入不超过 120°（三点）或不超过 90°（四点）的值，但不能为 0。
check-angles-wide = 测量 { $points } 点时，增量角大于 { $useful }° 没有意义。
check-angles-wide-hint = 请输入不超过 { $useful }° 的值。
check-ball-unknown = 此测头的测球直径未知：每个测得的尺寸都会差一个测球直径。
check-ball-unknown-hint = 请在孔中校准测头，并求出测球直径。
check-spread-circle = 各点靠得太近：直径的不确定度是单个测量点的 { $diameter } 倍，圆心的是 { $centre } 倍。
check-spread-centre = 各点靠得太近：圆心的不确定度是单个测量点的 { $centre } 倍。
check-spread-circle-hint = 请使各点分布在更长的圆弧上。
check-spread-corner = 拐角的不确定度是单个测量点的 { $factor } 倍：各点离拐角太远或彼此太近，或者两边夹角太小。
check-spread-corner-hint = 请加大各点之间的距离，并使各点靠近拐角。
check-spread-angle = 各点靠得太近：方向在 { $length } mm 长度上的不确定度是单个测量点的 { $factor } 倍。
check-spread-angle-hint = 请使两点相距不小于 { $needed } mm。
check-spread-triangle = 三点几乎在一条直线上：离直线 { $length } mm 处，坐标框架的不确定度是单个测量点的 { $factor } 倍。
check-spread-triangle-hint = 请使其中一点离另两点的连线更远。
check-braking = { $name } = { $feed }{ $unit } 时，触发信号之后轴还要移动 { $path } mm；测头允许 { $deflection } mm。
check-braking-hint = { $name } 最大设为 { $largest }{ $unit }。
