# 在 JOG 中测量：输入画面、字段、结果、拒绝的操作。用词与控制系统的画面一致。

jog-mask-set-edge = 设定棱边
jog-mask-align-edge = 找正棱边
jog-mask-distance = 2 条棱边的间距
jog-mask-corner-right = 直角拐角
jog-mask-corner-any = 任意拐角
jog-mask-pocket-rect = 矩形凹槽
jog-mask-hole-1 = 1 个孔
jog-mask-spigot-rect = 矩形凸台
jog-mask-spigot-1 = 1 个圆凸台
jog-mask-holes-2 = 2 个孔
jog-mask-spigots-2 = 2 个圆凸台
jog-mask-holes-3 = 3 个孔
jog-mask-spigots-3 = 3 个圆凸台
jog-mask-holes-4 = 4 个孔
jog-mask-spigots-4 = 4 个圆凸台
jog-mask-align-plane = 找正平面
jog-mask-cal-length = 校准测头：长度
jog-mask-cal-radius = 校准测头：半径
jog-mask-tool-cal = 校准刀具测头
jog-mask-tool-length = 测量刀具：长度
jog-mask-tool-radius = 测量刀具：半径

jog-field-zo = 零点偏移
jog-field-direction = 测量方向
jog-field-direction-2 = P2 的测量方向
jog-field-axis = 测量轴
jog-field-ref-axis = 参考轴
jog-field-angle-offset = 角度补偿
jog-field-spec-angle = 设定角
jog-field-corner = 拐角
jog-field-pos = 拐角位置
jog-field-l = 长度 L
jog-field-w = 宽度 W
jog-field-diameter = 直径
jog-field-contact-angle = 触碰角度
jog-field-dz = 进给深度 D{ $axis }
jog-field-x0 = { $axis }0
jog-field-y0 = { $axis }0
jog-field-x1 = { $axis }1
jog-field-y1 = { $axis }1
jog-field-z0 = { $axis }0
jog-field-d = 环规直径
jog-field-set-p1 = 设定 P1
jog-field-cal-kind = 校准内容
jog-field-v = 偏移量 V
jog-field-activate = 激活此零点偏移？
jog-field-position-axis = 定位回转轴？

jog-result-meas-x0 = 测得的 { $axis }0
jog-result-meas-y0 = 测得的 { $axis }0
jog-result-meas-l = 测得的 L
jog-result-meas-w = 测得的 W
jog-result-diameter = 测得的直径
jog-result-alpha = 角度 α
jog-result-beta = 角度 β

jog-line-inactive = { $offset } 已补偿，但未激活。
jog-line-tilted = 新的工件坐标系方向已改变。
jog-line-turned = 工件绕刀具轴旋转。在工件坐标系中移动时请注意。
jog-line-rotary = 回转轴 { $axis } 的零点偏移已补偿。该轴移动后工件才找正。
jog-line-start = 请按 NC 启动以激活。

jog-state-menu = 没有打开输入画面。
jog-state-mask = 已打开输入画面 { $mask }。
jog-state-ready = 所有点均已存储。请按“计算”。
jog-state-busy = 正在测量。
jog-state-activate = 激活画面等待 NC 启动。
jog-state-moving = 正在激活。
jog-state-alarm = 有报警。请按 RESET。

jog-refused = 此按键在当前状态下无效。
jog-mode = 此处不能切换运行方式。请先用 << 退出输入画面。
jog-open = 输入画面已打开。请先用 << 退出。
jog-pending = 有报警。请先用 RESET 应答。
jog-no-mask = 没有打开输入画面。请先打开，例如“mask set_edge”。
jog-all-stored = 所有点均已存储。请按“计算”，或拒绝一个点后重新测量。
jog-missing = 缺少点：{ $points }。请先按 NC 启动测量。
jog-at-once = 此输入画面只需 NC 启动即可测量并计算。请按 NC 启动。
jog-grey = { $point } 未存储，不能拒绝。
jog-nothing-to-activate = 没有可激活的内容。零点偏移已激活，或没有补偿。
jog-no-jog = 此控制系统没有在 JOG 中测量。请使用 SINUMERIK 的机床配置。
jog-no-function = 没有输入画面 { $name }。可用：{ $known }。
jog-no-field = 输入画面当前没有字段 { $field }。可用：{ $known }。
jog-no-tool = 没有带 D{ $edge } 的刀具 T{ $tool }。请在机床配置的刀具中输入。
jog-no-datum = 控制系统没有数据 { $name }。请检查名称和下标。
jog-wrong-number = { $field } 不是数字：{ $text }。请输入数字，例如 12.5。
jog-wrong-far = { $field } 不能为 { $value }。请输入不超过 { $limit } 的值。
jog-wrong-above = { $field } 不能为 { $value }。请输入大于 0 的值。
jog-wrong-below = { $field } 不能为 { $value }。请输入 0 或大于 0 的值。
jog-wrong-word = { $field } 不能为 { $text }。请输入其中之一：{ $known }。
jog-ball = 测球直径 { $value } mm，放不进去。请检查输入画面中的尺寸。
jog-same-place = 两点在参考轴上的位置相同。请拒绝其中一点，在更远处重新测量。
jog-in-line = 三点共线，或平面为竖直面。请拒绝其中一点，换一处测量。

jog-script-command = 没有命令“{ $text }”。
jog-script-command-hint = 请使用其中之一：{ $known }，或按 名称 = 值 输入字段。
jog-script-alone = “{ $word }”没有值：{ $text }
jog-script-alone-hint = 请单独写一行“{ $word }”。
jog-script-move = 不是轴的位置：{ $text }
jog-script-move-hint = 请写轴和数字，例如“move X10 Y-5.5”。
jog-script-point = 不是点：{ $text }
jog-script-point-hint = 请写 P1、P2、P3 或 P4。
jog-script-plc = 不是 PLC 的位：{ $text }
jog-script-plc-hint = 请写点和状态，例如“plc P2 on”。
jog-script-tool = 不是刀具：{ $text }
jog-script-tool-hint = 请写 T 号和 D 号，例如“tool T9 D1”。
jog-script-set = 不是带值的数据：{ $text }
jog-script-set-hint = 请写名称和值，例如“set _JM_I[4] = 1”。
jog-script-long = 脚本超过 { $limit } 行。
jog-script-long-hint = 请拆分成几个脚本。

jog-point = { $point }：{ $place }
jog-offset-active = 激活：{ $offset }
jog-truth = 工件按种子 { $seed } 放置：移动 X { $x }、Y { $y }、Z { $z } mm；旋转 X { $a }、Y { $b }、Z { $c }°；偏大 { $size } mm。
jog-takes = { $label }（{ $name }）
jog-takes-one-of = { $label }（{ $name }）：{ $words }

jog-area-edge = 棱边
jog-area-corner = 拐角
jog-area-hole = 凹槽/孔
jog-area-spigot = 凸台
jog-area-plane = 找正平面
jog-area-calibrate = 校准测头
jog-area-tool = 测量刀具

jog-word-none = 仅测量
jog-word-rotation = 坐标旋转
jog-word-yes = 是
jog-word-no = 否
jog-word-outside = 外拐角
jog-word-inside = 内拐角
jog-word-length = 仅长度
jog-word-length-and-diameter = 长度和直径

jog-show-translation = 平移
jog-show-rotation = 旋转
jog-show-turned = 回转轴
jog-show-measuring = 测量时生效的零点偏移

jog-crash-hint = 请反方向移开该轴，再用较小的增量靠近。
