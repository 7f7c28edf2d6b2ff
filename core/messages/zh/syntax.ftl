# 读程序时没有看懂的内容。

syntax-unknown = 无法识别此处的内容。
syntax-value = 这里缺少数值。
syntax-operand = 这里应为数字、变量或括号。
syntax-operator = 字不能以运算符开头。
syntax-equals = 这里应为“=”。
syntax-bracket = 括号没有闭合。
syntax-index = 下标有一到三个值。
syntax-text = 文本缺少右引号。
syntax-number = 这个数字无法读取。
syntax-comma = 控制系统用小数点，不用逗号。
syntax-depth = 括号和运算符嵌套超过 { $most } 层。
syntax-comment = 注释没有闭合。
syntax-too-large = 程序大于 { $most } GB，其余部分没有读取。
syntax-exponent = 控制系统的指数写作 EX，例如 1.5EX-3。
block-twice = 此程序段中 { $word } 编程了两次：控制系统会在此处停止。
block-twice-hint = 请删除其中一个，或分别写入各自的程序段。
block-axis-name = { $word } 是轴：变量不能使用此名称。
block-axis-name-hint = 请使用以两个字母或下划线开头的名称。
syntax-write = 请写成 { $value }。
syntax-behind-end = 文件结束符（Ctrl-Z）之后的内容不会被读取。
syntax-behind-end-hint = 若其后的行属于本程序，请删除该字符。
program-names = 调用按文件名 { $file } 找到本程序，但其 PROC 的名称为 { $proc }。
program-names-hint = 请使两者同名。
nct-foreign = { $word } 不调用测量宏程序：其地址都不属于该宏程序。跳过此程序段。
nct-foreign-hint = 若要用 { $cycle } 测量，请补上其地址；若程序是为其他控制系统编写的，则删除该程序段。
syntax-no-exponent = 此控制系统的数字没有指数。
syntax-no-exponent-hint = 请写出全部数位，例如 0.001。
syntax-character = 控制系统没有此字符（{ $number }）。
syntax-character-blank = 请换成普通空格。
syntax-lone-return = 没有换行符的回车不结束程序段：其后的内容属于本行。
syntax-lone-return-hint = 请用换行符保存文件。
file-picture = 它是图片，不是零件程序
file-archive = 它是压缩包（例如 ZIP 或办公文档），不是零件程序
file-pdf = 它是 PDF 文档，不是零件程序
file-document = 它是办公文档，不是零件程序
file-binary = 其中没有文本，不是零件程序
