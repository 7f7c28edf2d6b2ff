# CYCLE972：标题、搜索词、测量方式。

cycle972-title = 车床刀具测头：校准，测量车刀
cycle972-help = 在各面平行于轴的刀具测头上测量车刀（刀沿位置 1 到 8）的长度 L1 或 L2，或用刀沿位置 3 的已知刀具校准测头的一个面。宜优先使用 CYCLE982。
cycle972-words = 测量 刀具 车床 车削 测量头 测头 校准 长度 L1 L2 边 位置 磨损 触发点 对刀 对刀仪 车刀 刀尖 刀补 磨耗 刀长 对刀臂 标定

cycle972-calibrate = 校准刀具测头
cycle972-calibrate-words = 车床 车削 触发点 _TP
cycle972-measure = 测量车刀
cycle972-measure-words = 车削 刀具 车床 长度 L1 L2 磨损
