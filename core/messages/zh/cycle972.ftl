# CYCLE972：标题、搜索词、测量方式。

cycle972-title = 车床刀具测量头：校准、测量车刀
cycle972-help = 在各面平行于机床轴的刀具测量头上，测量刀沿位置 1 到 8 的车刀的长度 L1 或 L2，或用刀沿位置 3、长度和刀尖半径已知的刀具校准该测量头的一面。当前刀具位于它将触碰的那一侧，朝正方向测量的校准刀具还要离开其直径的距离；不得有旋转。循环先在另一轴移动，直到刀尖对着测量头中心，再在测量轴移到该面前 _FA 处，在两倍测量行程内触碰并退回；最后停在触碰面前 _FA 处。校准把触发值存入 _TP；测量补偿当前刀具的长度：几何值（磨损置 0），或在 _CHBIT[3]=1 时只补偿磨损。最常见的错误：缺少测量头的近似数据或其各面颠倒；起点在错误的一侧；刀具数据中的刀沿位置或刀尖半径不对；测量头是在别的条件下校准的。CYCLE982 功能相同且更多，手册推荐使用它。
cycle972-words = 测量 刀具 setter setting preset 车床 车削 测量头 cube 校准 长度 L1 L2 insert nose tip cutting 边 位置 磨损 geometry 触发 点

cycle972-calibrate = 校准刀具测量头
cycle972-calibrate-words = 校准 刀具 测量头 车床 车削 触发 点 machine _TP side
cycle972-measure = 测量车刀
cycle972-measure-words = 测量 车削 刀具 车床 长度 L1 L2 insert 磨损 geometry machine
