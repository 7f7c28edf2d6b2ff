# 真实机床的测量记录。

protocol-title = 机床的测量记录
protocol-open = 来自机床
protocol-open-hint = 读入真实零件的控制系统测量记录或表格（CSV），并将数值对应到调用和零件上。
protocol-of = 机床实测：{ $name }
protocol-busy = 正在读取…
protocol-close = 返回模拟
protocol-unfit = 不相符的行：{ $count }
protocol-unfit-save = 全部保存
protocol-columns = 列
protocol-column-number = 调用序号
protocol-column-line = 程序行
protocol-column-result = 结果
protocol-column-nominal = 设定值
protocol-column-actual = 实际值
protocol-column-deviation = 偏差
protocol-too-large = 文件大于 { $most } MB：请选择单个零件的测量记录。
