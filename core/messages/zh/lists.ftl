# 括号内带参数的调用：参数有什么错，新型控制系统的参数表是什么意思。

list-text-wanted = { $param } 应为文本，而 { $value } 是数字。
list-text-wanted-hint = 请给该值加上引号。
list-number-wanted = { $param } 应为数字，而“{ $value }”是文本。
list-number-wanted-hint = 请去掉该值的引号。
list-text-unquoted = { $param }：{ $value } 没有引号，程序也没有声明这个变量。
list-text-unquoted-hint = 若这就是名称，请加上引号。
list-arguments-many = { $name } 有 { $most } 个参数，而此调用写了 { $count } 个。
list-arguments-many-hint = 请核对逗号，删去多余的参数。
list-selection = { $name } 的第 { $place } 个参数不能是 { $value }。
list-selection-hint = 请从 { $choices } 中选择。

newer-open = { $param } = { $value }：在新型控制系统参数表中的含义未知。保留原样，不检查，也不模拟。
newer-seen = { $param } = { $value }：新型控制系统的程序在此处用其他数值；该数值的含义未公布。
newer-beyond = { $cycle } 公开的参数有 { $most } 个。其后的内容按原样保留，含义未知。
newer-target = 第 2 个参数写了 { $value }：新型控制系统在该处写零点偏移号，而此测量方式不补偿零点偏移。
newer-target-hint = 请把第 1 个参数的第 3 位设为 1（零点偏移），或把刀具补偿写在第 3 个参数（S_KNUM1）；也可将第 2 个参数留空。
newer-target-perhaps = 第 2 个参数 { $value } 不是已知的零点偏移。在旧控制系统上，这样的数是刀具或另一种坐标框架。
newer-target-perhaps-hint = 零点偏移：1–99、10001–10099。刀具：第 3 个参数（S_KNUM1）。也可将第 2 个参数留空：不作补偿。
write-newer-tool = 新型控制系统的刀具补偿对象在第 3 个参数（S_KNUM1，见报警 61328），代码未知。
write-newer-zero = 新型控制系统参数表中零点偏移 { $value } 的含义未知；已知：1–99、10001–10099、9000、9999、19999。
write-newer = { $param } = { $value } 在新型控制系统参数表中含义不同或未知。
convert-newer = { $param } = { $value }：旧型参数表没有与新型参数表中此值对应的值，或其含义未知。
convert-newer-hint = 保持该调用不变，或在输入画面中重新输入这次测量。

newer-lost = 第 { $place } 位之前缺少一个参数：其后的所有参数都提前了一位。
newer-lost-between = 第 { $place } 位与第 { $until } 位之间缺少一个参数：其后的所有参数都提前了一位。
newer-lost-hint = 为缺少的参数补一个逗号。
newer-many = 第 { $place } 位多了一个参数：其后的所有参数都推后了一位。
newer-many-between = 第 { $place } 位与第 { $until } 位之间多了一个参数：其后的所有参数都推后了一位。
newer-many-hint = 删除多余的逗号。
newer-places = { $cycle } 公布了 5 个位置，其中两个没有名称。只有 { $count } 个参数时，无法确定哪个是 S_PROT、哪个是 S_PATH。
newer-lost-perhaps = 已公布的程序中没有 { $name } = { $value }。若在第 { $place } 位与第 { $until } 位之间多一个参数，调用就与这些程序一致。
newer-many-perhaps = 已公布的程序中没有 { $name } = { $value }。若在第 { $place } 位与第 { $until } 位之间少一个逗号，调用就与这些程序一致。
newer-perhaps-hint = 请数一下参数。如果调用本来正确，就不用改。
newer-inch = S_FA = { $value } 是 { $meant } 的 25.4 倍：以 mm 为单位的测量行程被当作英寸换算了。
newer-inch-hint = 以 mm 为单位输入测量行程。
newer-set-variant = 将参数 1 设为 { $value }
newer-set-none = 清空参数 2
newer-set-path = 将 S_FA 设为 { $value }
newer-set-close = 补上右括号
newer-set-lost = 插入空参数 { $place }
newer-set-many = 删除空参数 { $place }
argument-list = 新型控制系统中 { $cycle } 的参数列表
argument-place = { $cycle } 的参数 { $place }
argument-name = { $name }：{ $meaning }
argument-screen = 屏幕上：{ $name }
argument-older = 旧版控制系统：{ $name }
argument-no-older = 旧版控制系统中没有对应项。
argument-values = 来自在此类控制系统上运行的程序。
argument-alarm = 报警 { $alarm } 中提到。
argument-name-known = 只公布了名称和位置。
argument-open = 各位数字的含义未公布：保持原样，不会重新写入。
argument-zero = 要补偿的零点偏移
argument-zero-help = 空：只测量。1 至 4：G54 至 G57；5 至 99：G505 至 G599；加 10000：粗偏移。9999 和 19999：有效坐标框架。9000 也在使用，其含义未公布。
argument-zero-fine = { $name }，精调
argument-zero-coarse = { $name }，粗调
argument-zero-used = 有程序使用，含义未公开
argument-tool = 要补偿的刀具
argument-ball = 校准球直径
argument-probe = 测头的编号
argument-tool-probe = 刀具测头的编号
argument-points = 距离 X1 和 X2，或点 P1 (X1, Y1) 至 P4 (X4, Y4)
argument-points-help = 由测量方式决定；其编号没有公布。
argument-safe = 安全区
argument-safe-help = 报警 61303 提到它；在此循环中从何处算起没有公布。
argument-vectors = 计算矢量的界限
argument-vectors-help = 回转轴位置相差不足 20 度时结果不可靠（报警 61430，G）。
argument-probing-angle = 探测角度
argument-probing-angle-help = 从 −359 到 359 度。旧版控制系统的此循环中没有。
argument-infeed = 到测量高度的进给
argument-infeed-help = 哪个符号表示向下因程序而异。没有进给时写 1。
argument-direction = 测量方向
argument-direction-help = 1：正；2：负。
argument-direction-open = 测量方向
argument-direction-open-help = 其数值只公布了 CYCLE978 和 CYCLE998 的。
argument-carrier = 可定向刀架
argument-centre-x = 中心，平面第 1 轴
argument-centre-x-help = 测头从旁边起动时填写；此时 _AMODE 为 11。
argument-centre-y = 中心，平面第 2 轴
argument-centre-y-help = 测头从旁边起动时填写；此时 _AMODE 为 11。
argument-bits = 测量选项
argument-bits-help = 程序中留空。
argument-plane = 工作平面
argument-plane-help = 程序中写 1。
argument-mode = 模式
argument-mode-help = 程序中写 1；由 S_XM 和 S_YM 给出中心时写 11。
argument-name-only = 含义未公布
argument-unnamed = 此位置连名称也未公布
argument-direction-plus = 正方向
argument-direction-minus = 负方向
argument-probe-help = 测头的编号，1 至 12：其数据是 SD 54600 起的设定数据。
argument-tool-probe-help = 刀具测头的编号，1 至 6：其数据是 SD 54625 起的设定数据。
argument-help-older = 本页说明旧版控制系统上的循环。在新型控制系统的参数表中，数值和参数有所不同：零点偏移（10000 以上为粗偏移）、测头、测量方向 S_MD。_CHBIT、_CBIT 和 _KNUM 的各位数字属于旧版控制系统。不补偿零点偏移时，该调用仅测量。
write-direction = S_MD 为空：旧的调用没有说明测量方向。
write-direction-hint = 输入 1（正）或 2（负），机床用户的程序总是写入该值。
write-infeed = S_ID = { $value } 保持其符号。在新型控制系统上，哪个符号表示向下因程序而异。
write-infeed-hint = 首次运行前，请与在本机床上运行的程序核对符号。
write-rotary = S_RA = { $value }：新型控制系统中哪个数字代表哪个回转轴未公布。程序中写 6。
write-rotary-hint = 首次运行前在控制系统上检查 S_RA。
convert-infeed = S_ID = { $value } 以相同符号写入 { "_ID" }。在新型控制系统上，各程序对哪个符号表示向下的写法并不一致。
convert-infeed-hint = 首次运行前，请在工件上方足够高处检查符号。
convert-rotary = S_RA = { $value } 写成 { "_RA" } = { $value }；新型控制系统上哪个数字表示哪个回转轴没有公布。
convert-rotary-hint = 请在 { "_RA" } 中输入该回转轴在旧版控制系统中的轴号。
generation-list = { $cycle } 使用了新型控制系统的参数列表，而机床属于第 { $generation } 代。
generation-list-hint = 转换这些调用，或在机床数据中将 PW-GENERATION 设为 3。
generation-assigned = { $cycle } 按旧版控制系统的方式调用，而机床属于第 { $generation } 代，使用参数列表。
generation-assigned-hint = 转换这些调用。如果赋值方式在本机床上也能运行，请将 PW-GENERATION 设为 0。
generation-setting-data = { $name } 是新型控制系统的数据，而机床属于第 { $generation } 代。
generation-setting-data-hint = 使用本机床的用户数据，或在机床数据中将 PW-GENERATION 设为 2 或 3。
generation-user-data = { $name }[] 是旧版控制系统的用户数据，而机床属于第 { $generation } 代，用设定数据代替。
generation-user-data-hint = 使用从 SD 54600 和 SD 55630 开始的设定数据，或改正机床数据中的 PW-GENERATION。
argument-shown = 列表的参数 { $place }：{ $name }。
argument-shown-screen = 列表的参数 { $place }：{ $name }，屏幕上为 { $screen }。
newer-cycle995 = 测量主轴的垂直度
newer-cycle996 = 测量回转轴的运动系统，一个位置
newer-cycle9960 = 完整测量运动系统
newer-cycle150 = 在屏幕上显示结果并写入测量记录
newer-unsimulated = { $param } 会写入，但不模拟。
newer-omitted = { $param } 被省略，即为 0：控制系统此时的动作没有公布，因此不模拟该调用。
newer-alone = 不模拟 { $cycle }：旧版控制系统没有这样的循环，其参数各位数字的含义未公布。
newer-infeed = { "S_ID" } = { $value }：哪个符号向下没有公布，因此不模拟该调用。
newer-infeed-hint = 新型控制系统的程序对符号不一致。请在机床上远离工件处试验。
newer-away = { "S_MD" } = { $value } 背离设定值：测头在另一侧。控制系统此时的动作没有公开，运行在此停止。
newer-away-hint = 把测头定位到表面的另一侧，或更改测量方向。
newer-fine = { $value } 补偿粗偏移，而精偏移不为 0。这与 MD 51740 位 5（粗偏移绝对值）有关；具体作用没有公布，因此运行在此停止。
newer-fine-hint = 在调用之前清除零点偏移的精偏移，或改为补偿精偏移。
newer-centre-missing = { "_AMODE" } = 11 表示调用给出了中心，但 S_XM 和 S_YM 为空。
newer-centre-missing-hint = 请在 S_XM 和 S_YM 中输入中心，或将 { "_AMODE" } 设为 1。
newer-centre-unused = S_XM 和 S_YM 给出了中心，但 { "_AMODE" } 为 { $value }：程序此时写 11。
newer-centre-unused-hint = 请将 { "_AMODE" } 设为 11，或将 S_XM 和 S_YM 留空。
newer-no-list = { $cycle } 的参数写了数字：旧版控制系统在此处使用变量，而新型控制系统的参数表没有公开。
newer-no-list-hint = 在旧版控制系统上请写变量名。否则调用保持原样，不检查，也不模拟。
write-assigned = { $cycle } 用赋值写出：其参数列表第 1 个参数的数位没有公开。
write-assigned-hint = 这台机床是否也接受赋值，要在机床上试过才知道。
write-coarse = 参数 2 = { $value } 表示零点偏移的精偏移；此处 { "_CHBIT[21]" } = 1 补偿粗偏移。
write-coarse-hint = 写成 { $coarse } 以补偿粗偏移。
