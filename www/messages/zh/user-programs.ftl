# CYCLE198 和 CYCLE199。

user-program-intro = CYCLE198 在每次测量之前运行，CYCLE199 在测量之后运行，从测量循环的标签到其 M17。可在此写入接通和断开测头、主轴定向或打开护盖的程序行。本页中含有它们的程序会在每个调用处显示前后运行哪些行。
user-program-cycles = 测量循环
user-program-lines-before = 测量之前的行，例如 M27
user-program-lines-behind = 测量之后的行，例如 M28
user-program-case = 交货文件中 CASE 的变量（空：用于插入的行）
user-program-save = 保存 { $name }
