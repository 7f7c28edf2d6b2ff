# 轴的制动距离。

braking-path = 制动距离为 { $sum } mm：到发出制动命令为 { $delay } mm，制动期间为 { $braking } mm，跟随误差为 { $following } mm。
braking-feed = 此偏转量允许的最大进给率：{ $feed } mm/min。
braking-value = { $name } = { $value } 不可能：请输入正数。
