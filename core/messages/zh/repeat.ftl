# 重复触碰同一位置：测头的测试程序及其评估。

repeat-control = 测试程序用于 SINUMERIK 控制系统。
repeat-value = { $name ->
    [axis] 轴必须是 X、Y 或 Z。
    [from] 起点必须是 -{ $most } 到 { $most } 的数。
    [to] 无信号时的终点必须是 -{ $most } 到 { $most } 的数，且不同于起点。
    [feed] 进给率必须大于 0，最大 { $most }。
    [input] 测量输入必须是 1 或 2。
    [count] 触碰次数必须是 { $least } 到 { $most } 的整数。
   *[parameters] 第一个 R 参数必须是 { $least } 到 { $most } 的整数。
    }
repeat-few = 至少需要两个值。
repeat-many = 最多评估 { $most } 个值。
repeat-not-a-number = { $value } 不是数字。
repeat-no-signal = 测头在移动中没有触发，因此没有测量值。
repeat-no-tool = 此机床没有刀具 T{ $tool } D{ $edge }，因此没有可用的测头：请在刀具表中输入，或将测头装入主轴。
repeat-no-probe = T{ $tool } D{ $edge } 的类型是 { $kind }，因此这里没有测头可以触碰：请将其类型输入为 710（刀塔中为 580），或将测头装入主轴。
repeat-behind = 在此方向上测球位于测针之后，无法触碰。请在起点的另一侧选择终点，例如 { $axis }{ $to }。
repeat-no-scatter = 这台机床的测头没有重复性误差：每次触碰的值都相同。请设置重复性，或粘贴实际机床的测量值。
repeat-diameters = 这些 X 值是直径：测头的重复精度是此偏差的一半。
repeat-drift = 测量值逐次漂移，不是随机偏差。请在机床预热后重新测试。
repeat-narrow = 三倍标准偏差为 { $three }，大于建议的 _TZL：触碰次数更多时会出现更大的偏差。
repeat-switched = 功能测试：测头在 { $axis } = { $value }{ $unit } 处触发；程序停在 M0，该值在 R1 中
repeat-not-switched = 功能测试：测头未触发；程序停在报文之后的 M0
repeat-mean = 触碰 { $count } 次，平均值 { $mean }{ $unit }
repeat-deviation = 标准偏差 s = { $one }{ $unit }；2 s = { $two }，3 s = { $three }
repeat-range = 最小值 { $smallest }，最大值 { $largest }，极差 { $range }{ $unit }
repeat-furthest = 与平均值的最大偏差 { $furthest }{ $unit }
repeat-slope = 逐次漂移 { $slope }{ $unit }（t = { $t }）
repeat-zone = 建议 _TZL = { $zone }{ $unit }：最大随机偏差向上取整；由两次触碰得出的直径或宽度为 { $two }{ $unit }
probe-test-function = 功能测试：手动或在工件上触发测头一次
probe-test-repeat = 重复精度：重复触碰同一位置
probe-test-switched = 测头已触发，R1 = WCS，R2 = MCS
probe-test-failed = 测头未触发
probe-test-done = 触碰全部完成，请读取测量值
