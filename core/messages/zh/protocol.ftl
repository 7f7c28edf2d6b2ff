# 真实机床的测量记录：为何某一行或整个记录不能采用，以及如何处理。

protocol-ending = 测量记录中相符的行：{ $fitted }。不相符的行：{ $unfit }。没有数值的调用：{ $missing }。
protocol-gap = 缺少 { $name }：其中的测量没有数值，或被放到另一次调用上。请选择该记录的所有文件。
protocol-empty = 测量记录为空：请选择机床写出的文件。
protocol-large = 测量记录超过 { $most } 行：请拆分，每个零件一个文件。
protocol-no-calls = 此程序不测量任何内容，测量记录中不会有相应数值：请打开机床执行的程序。
protocol-no-actual = 缺少实际值列：请指定该列，或指定设定值列和偏差列。
protocol-no-column = 没有任何一行含有列“{ $name }”。第一行为：{ $fields }。请选用其中一个名称，或从 1 起的列号。
protocol-no-value = 此行没有设定值和实际值：若有，请写成 132.015 或 132,015，并用“;”分隔。
protocol-no-number = 列“{ $column }”不是数字，而是“{ $text }”：请写成 132.015 或 132,015，不用千位分隔符，或选择其他列。
protocol-no-call = 没有尚缺数值的调用具有此行中的设定值：请检查程序与测量记录是否相符，或指定各列。
protocol-no-heading = 没有更多测量变体为 { $variant } 的 { $cycle } 调用：请检查程序与测量记录是否相符。
protocol-no-number-of-call = 程序中没有第 { $number } 次测量：请检查序号列。
protocol-no-line = 程序第 { $line } 行没有尚缺数值的调用：请检查行号列。
protocol-no-result = 该调用没有尚缺数值的结果 { $name }：请检查结果列。
protocol-differs = 偏差 { $by } 不等于实际值减设定值，后者为 { $is }：请检查各列。
protocol-contradicted = { $actual } 被当作设定值 { $set } 的实际值，但 { $by } 不是两者之差：请检查该行，或选择各列。
protocol-ambiguous = { $actual } 被当作设定值 { $set } 的实际值，但 { $other } 也可能是：请检查该行，或选择各列。
protocol-marked = 机床将 { $actual } 标记为超出极限，但按此程序的公差它在公差内：请检查公差或记录的小数位数。
protocol-blank = 列“{ $column }”为空：请填写，或选择其他列。
protocol-above = 此行在表格标题行之上：请移到标题行之下，或选择各列。
protocol-wide = { $heads } 个标题下有 { $cells } 个单元格：小数逗号可能将其分开。请用“;”分隔单元格，或使用小数点，或将带逗号的数值放在引号内。
protocol-comma = 逗号分隔了数字，但也可能是小数逗号：请用“;”分隔，或使用小数点，或放在引号内。
protocol-quote = 引号打开后没有关闭：请在数值末尾关闭引号，或将其删除。
protocol-other-line = 第 { $number } 次测量在程序第 { $own } 行，而不在第 { $line } 行：请检查序号列和行号列。
protocol-cells = { $heads } 个标题下有 { $cells } 个单元格：请为每列加上标题，或将含分隔符的数值放在引号内。
