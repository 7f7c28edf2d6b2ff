# CYCLE978：标题、搜索词、测量方式。

cycle978-title = 表面
cycle978-help = 测量垂直于一个轴的表面上的一点。测头从表面对面开始，离表面的距离大于测量行程；起点所在的一侧决定测量方向。
cycle978-words = 测量 工件 表面 端面 边 平面 壁 点 位置 单点 触碰 刀具补偿 磨损 零点 零偏 平行于轴 差分 碰边 刀补 磨耗 寻边 寻边器 抓边 单边 碰数 高度 顶面 设零 Z 探头 工件坐标系 差值
cycle978-each-words = 一点 边 端面 寻边 碰边 单边

cycle978-tool = 表面：补偿刀具
cycle978-zero = 表面：补偿零点偏移
cycle978-differential-tool = 表面，差值测量：补偿刀具
cycle978-differential-zero = 表面，差值测量：补偿零点偏移
cycle978-measured = 表面：仅测量
