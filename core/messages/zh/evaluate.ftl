# 测量循环测量后的判断。数字单位为 mm。

evaluate-safe-area = 偏差 { $difference } mm 超出安全区：不作补偿。
evaluate-safe-area-angle = 偏差 { $difference }° 超出安全区：不作补偿。
evaluate-difference = 偏差 { $difference } mm 超出允许尺寸差：不作补偿。
evaluate-oversize = 偏差 { $difference } mm 超过公差上限：{ $follows }。
evaluate-undersize = 偏差 { $difference } mm 低于公差下限：{ $follows }。
evaluate-whole = 偏差 { $difference } mm 在公差内，但超出平均值范围：{ $follows }。
evaluate-mean = 由偏差 { $difference } mm 得到平均值 { $mean } mm，超出零补偿区：{ $follows }。
# 以上四种情况的结果。
evaluate-corrects-whole = 补偿全部偏差
evaluate-corrects-both = 按两个偏差的平均值补偿
evaluate-corrects-zero = 两个偏差的平均值为 0，不作补偿
evaluate-corrects-mean = 按平均值补偿
evaluate-corrects-nothing = 未选择补偿，不作补偿
evaluate-corrects-simulated = 此仿真不作补偿
evaluate-restarts = 平均值重新开始计算：{ $name } 设为 0。
evaluate-small = 由偏差 { $difference } mm 得到平均值 { $mean } mm，仍在零补偿区内：不作补偿。
evaluate-kept = 与存储值相差不大于 { $limit } mm（_TZL），因此保持不变：{ $data }。
evaluate-repeat = 偏差过大，重新测量，第 { $count } 次重复，最多 4 次。
evaluate-halt = 编程停止（M0）：操作者按 NC START 继续。
evaluate-activated = 补偿后的坐标框架立即生效。
evaluate-not-activated = 补偿后的坐标框架在程序再次调用它（G54、G500 …）时生效。
evaluate-distortion = 测得的三角形与设定三角形相差 { $distortion } mm；小于 { $limit } mm 时才补偿坐标框架。
evaluate-handed-back = 循环不报警：{ $name } 设为 { $alarm }，程序继续。
evaluate-tool-safe-area = 偏差 { $difference } mm 不小于安全区 { $limit } mm：该值不作补偿。
evaluate-tool-difference = 偏差 { $difference } mm 不小于允许尺寸差 { $limit } mm：该值不作补偿。
evaluate-tool-small = 偏差 { $difference } mm 不大于零补偿区 { $limit } mm：该值不作补偿。
evaluate-tool-geometry = 偏差 { $difference } mm 和原磨损值一并计入几何值，磨损值清零。
evaluate-tool-wear = 偏差 { $difference } mm 补偿到磨损值中。
evaluate-tool-simulated = 偏差 { $difference } mm 未补偿：此仿真不作补偿。
evaluate-compensation-make = 该型号测头（_TP_CF = { $make }）的补偿表在控制系统内部，手册中没有：模拟不作扣除。_MT_COMP = 2 时使用 _MT_EC_R 和 _MT_EC_L 中的用户自定义表。
evaluate-compensation = 按表 { $table } 从测量值中扣除 { $amount } mm。
evaluate-screen = 控制系统显示测量结果画面，直到循环结束。
evaluate-screen-stays = 控制系统显示测量结果画面，直到调用下一个测量循环；程序继续。
evaluate-screen-halt = 控制系统显示测量结果画面。编程停止（M0）：操作者按 NC START 继续。
evaluate-log-full = 测量记录 { $file } 及其九个后续文件都已写满，不再写入。控制系统停止，要求在 _PROTNAME[1] 中输入新的名称。
evaluate-log-deleted = 本次运行的测量记录 { $file } 重新开始：已有的 { $lines } 行被删除。
evaluate-log-none = 此调用之前没有开始测量记录：CYCLE105 不写入任何内容。CYCLE100 可开始测量记录。
# 调用在测量之前对机床的数据所做的处理。
check-erases = _CBIT[13]=1：此调用先将 _TP[]、_TPW[]、_WP[]、_KB[]、_EV[]、_MV[] 和该位本身设为 0。
check-erases-hint = 请在调用前将 _CBIT[13] 设为 0，或在调用后重新输入数据并重新校准。
check-converts = { $bit } 与机床的基本单位制（MD 10240）不一致：此调用先将 { $data } { $value ->
        [1] 从 inch 换算为 mm
       *[other] 从 mm 换算为 inch
    }。
check-converts-hint = 若这些数据本来就正确，请在调用前将 { $bit } 设为 { $value }。
evaluate-erased = _CBIT[13]=1：_TP[]、_TPW[]、_WP[]、_KB[]、_EV[]、_MV[] 和该位本身现为 0。
evaluate-converted = { $bit } 与机床的基本单位制不一致：{ $data } 已{ $value ->
        [1] 从 inch 换算为 mm
       *[other] 从 mm 换算为 inch
    }，该位现为 { $value }。

# A measurement in one line: what was measured.
answer-diameter = 直径
answer-width = 宽度
answer-length = 长度
answer-centre = 中心
answer-position = 位置
answer-angle = 角度
answer-corner = 拐角
answer-tool-length = 刀具长度
answer-radius = 半径
answer-trigger = 触发点
answer-skew = 测头位置偏差
answer-probe-length = 测头长度
answer-value = 测量值
# What is corrected.
answer-frame = { $frame }
answer-frame-fine = { $frame } 精偏移
answer-tool = T{ $tool } D{ $edge }
answer-tool-offset = T{ $tool } D{ $edge } DL{ $offset }
answer-register = 寄存器 { $register }
answer-probe = 测头数据
# What follows.
answer-within = 在限值内
answer-within-area = 在安全区内
answer-beyond = 超出限值
answer-rework = 返工
answer-scrap = 报废
answer-alarm = 报警 { $code }
answer-stopped = 模拟未继续
answer-measured = 已测量
answer-why-within = 偏差不超过 { $limit }{ $unit ->
        [deg] °
        [inch]  inch
       *[mm]  mm
    }。
answer-why-area = 未设置公差。偏差在安全区 { $limit }{ $unit ->
        [deg] °
        [inch]  inch
       *[mm]  mm
    } 之内。
answer-why-measured = 此测量未设置限值。

screen-tool-probe = 校准刀具测头
screen-tool = 测量刀具
screen-probe = 校准工件测头
screen-workpiece = 工件测量
screen-set = 设定值
screen-actual = 实际值
screen-difference = 差值
screen-until-end = 显示到循环结束。
screen-until-start = 等待 NC START：请确认测量结果画面。
screen-until-next = 显示到调用下一个测量循环。
screen-waits = 程序等待 NC START。
