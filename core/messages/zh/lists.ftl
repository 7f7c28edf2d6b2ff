# 括号内带参数的调用：参数有什么错，新型控制系统的参数表是什么意思。

list-text-wanted = { $param } 应为文本，而 { $value } 是数。
list-text-wanted-hint = 请加上引号。
list-number-wanted = { $param } 应为数，而 “{ $value }” 是文本。
list-number-wanted-hint = 请去掉引号。
list-text-unquoted = { $param }：{ $value } 没有引号，程序也没有声明这个变量。
list-text-unquoted-hint = 如果这就是名称，请加上引号。
list-arguments-many = { $name } 的参数少于此调用所写：{ $most } 个，而写了 { $count } 个。
list-arguments-many-hint = 请核对逗号，删去多余的参数。
list-selection = { $name } 的第 { $place } 个参数不能是 { $value }。
list-selection-hint = 请选择 { $choices } 之一。

newer-open = { $param } = { $value }：它在新型控制系统参数表中的含义这里不清楚。保留原样，不检查，也不模拟。
newer-target = 第 2 个参数写了 { $value }：新型控制系统在这里写零点偏移号，而此测量方式不修正零点偏移。
newer-target-hint = 零点偏移：参数 1 第 3 位设为 1；刀具补偿写在参数 3（S_KNUM1）；否则参数 2 留空。
write-newer-tool = 新型控制系统的参数表把刀具补偿对象放在第 3 个参数（S_KNUM1），其编码这里不清楚。写在第 2 个参数，控制系统会以报警 61328 停止。
write-newer-zero = 在新型控制系统的参数表中 { $value } 是哪个零点偏移，这里不清楚；已知的只有 1 至 99 和 9999。
write-newer = { $param } = { $value } 在新型控制系统的参数表中含义不同，或这里不清楚。
convert-newer = { $param } = { $value }：它在新型控制系统参数表中的含义在旧型上无法表达，或这里不清楚。
convert-newer-hint = 请重新写成赋值和调用。
