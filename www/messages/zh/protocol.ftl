# 真实机床的测量记录。

protocol-title = 机床的测量记录
protocol-of = 机床实测：{ $name }
protocol-busy = 正在读取…
protocol-close = 返回模拟
protocol-unfit = 不相符的行：{ $count }
protocol-doubtful = 需要检查的行：{ $count }
protocol-unfit-save = 全部保存
protocol-columns = 列
protocol-columns-ask = 没有可自动对应的行：请选择各列的内容，至少选择实际值。
protocol-column-number = 调用序号
protocol-column-line = 程序行
protocol-column-result = 结果
protocol-column-nominal = 设定值
protocol-column-actual = 实际值
protocol-column-deviation = 偏差
protocol-too-large = 文件大于 { $most } MB：请选择单个零件的测量记录。
