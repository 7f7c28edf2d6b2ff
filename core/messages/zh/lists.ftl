# 括号内带参数的调用：参数有什么错，新型控制系统的参数表是什么意思。

list-text-wanted = { $param } 应为文本，而 { $value } 是数字。
list-text-wanted-hint = 请给该值加上引号。
list-number-wanted = { $param } 应为数字，而“{ $value }”是文本。
list-number-wanted-hint = 请去掉该值的引号。
list-text-unquoted = { $param }：{ $value } 没有引号，程序也没有声明这个变量。
list-text-unquoted-hint = 若这就是名称，请加上引号。
list-arguments-many = { $name } 有 { $most } 个参数，而此调用写了 { $count } 个。
list-arguments-many-hint = 请核对逗号，删去多余的参数。
list-selection = { $name } 的第 { $place } 个参数不能是 { $value }。
list-selection-hint = 请从 { $choices } 中选择。

newer-open = { $param } = { $value }：在新型控制系统参数表中的含义未知。保留原样，不检查，也不模拟。
newer-target = 第 2 个参数写了 { $value }：新型控制系统在该处写零点偏移号，而此测量方式不补偿零点偏移。
newer-target-hint = 请把第 1 个参数的第 3 位设为 1（零点偏移），或把刀具补偿写在第 3 个参数（S_KNUM1）；也可将第 2 个参数留空。
write-newer-tool = 新型控制系统的刀具补偿对象在第 3 个参数（S_KNUM1，见报警 61328），代码未知。
write-newer-zero = 新型控制系统参数表中零点偏移 { $value } 的含义未知；已知的只有 1 到 99 和 9999。
write-newer = { $param } = { $value } 在新型控制系统参数表中含义不同或未知。
convert-newer = { $param } = { $value }：旧型参数表没有与新型参数表中此值对应的值，或其含义未知。
convert-newer-hint = 请把调用重新写成赋值形式。
