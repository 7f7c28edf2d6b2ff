# 轴的制动距离。

braking-path = 制动距离为 { $sum } mm：到发出制动命令为 { $delay } mm，制动期间为 { $braking } mm，跟随误差为 { $following } mm。
braking-feed = 此偏转量允许的最大进给率：{ $feed } mm/min。
braking-value =
    { $name ->
        [delay] 延迟时间
        [acceleration] 减速度
        [gain] 伺服增益
        [feed] 进给率
       *[deflection] 偏转量
    } { $value } 无效：请输入{ $name ->
        [delay] 不小于 0
       *[other] 大于 0
    } 的数。
