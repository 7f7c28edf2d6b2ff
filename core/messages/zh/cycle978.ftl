# CYCLE978：标题、搜索词、测量方式。

cycle978-title = 表面
cycle978-help = 测量横在一个轴上的表面的一点。测量头在其对面，距离大于测量行程；它所在的一侧决定方向。
cycle978-words = 测量 工件 表面 端面 边 平面 壁 点 位置 单点 触碰 刀具 补偿 磨损 零点 零偏 平行于轴 差分
cycle978-each-words = 一 点 个 边 端面

cycle978-tool = 表面：补偿刀具
cycle978-zero = 表面：补偿零点偏移
cycle978-differential-tool = 表面，差分：补偿刀具
cycle978-differential-zero = 表面，差分：补偿零点偏移
