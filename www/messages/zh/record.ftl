# 打印的测量报告。

record-sheet-title = 测量报告
record-sheet-part = 零件
record-sheet-order = 订单
record-sheet-program = 程序
record-sheet-machine = 机床
record-sheet-control = 控制系统
record-sheet-probe = 测头
record-sheet-ball = 测球 { $diameter } mm
record-sheet-clock = 控制系统日期
record-sheet-printed = 打印时间
record-sheet-inspector = 检验员
record-sheet-signature = 签名
record-fill = 打印报告的标题栏
record-sheet-picture = 测量要素
record-sheet-quantity = 要素
record-sheet-tolerance = 公差
record-sheet-used = 占用
