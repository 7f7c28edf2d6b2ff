# CYCLE977：标题、搜索词、测量方式。

cycle977-title = 孔、轴、槽、凸台、矩形
cycle977-help = 从设定中心沿平行于轴的方向测量尺寸和中心：槽或凸台触碰两点，其余触碰四点。结果用于补偿刀具或零点偏移，也可只测量。
cycle977-words = 测量 工件 孔 镗孔 轴 圆凸台 槽 键槽 凸台 筋 型腔 岛 矩形 直径 宽度 中心 内 外 刀具补偿 磨损 零点 零偏 平行于轴 保护区 安全区 分中 外圆 内孔 刀补 磨耗 寻边 寻边器 四面分中 取中 找中心 圆心 内径 外径 探头 设零 工件坐标系 碰数

cycle977-hole-tool = 孔：补偿刀具
cycle977-shaft-tool = 轴（外圆）：补偿刀具
cycle977-groove-tool = 槽：补偿刀具
cycle977-web-tool = 凸台：补偿刀具
cycle977-pocket-tool = 内矩形：补偿刀具
cycle977-island-tool = 外矩形：补偿刀具
cycle977-hole-zero = 孔：补偿零点偏移
cycle977-shaft-zero = 轴（外圆）：补偿零点偏移
cycle977-groove-zero = 槽：补偿零点偏移
cycle977-web-zero = 凸台：补偿零点偏移
cycle977-pocket-zero = 内矩形：补偿零点偏移
cycle977-island-zero = 外矩形：补偿零点偏移
cycle977-hole-zone-tool = 孔，带保护区：补偿刀具
cycle977-shaft-zone-tool = 轴（外圆），带保护区：补偿刀具
cycle977-groove-zone-tool = 槽，带保护区：补偿刀具
cycle977-web-zone-tool = 凸台，带保护区：补偿刀具
cycle977-pocket-zone-tool = 内矩形，带保护区：补偿刀具
cycle977-island-zone-tool = 外矩形，带保护区：补偿刀具
cycle977-hole-zone-zero = 孔，带保护区：补偿零点偏移
cycle977-shaft-zone-zero = 轴（外圆），带保护区：补偿零点偏移
cycle977-groove-zone-zero = 槽，带保护区：补偿零点偏移
cycle977-web-zone-zero = 凸台，带保护区：补偿零点偏移
cycle977-pocket-zone-zero = 内矩形，带保护区：补偿零点偏移
cycle977-island-zone-zero = 外矩形，带保护区：补偿零点偏移
