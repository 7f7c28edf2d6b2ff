# 调用的写法，以及各写法不能表达的内容。

write-no-list = { $cycle } 不能用这种书写方式。
write-no-list-variant = { $cycle } 的此测量方式或补偿对象不能用这种书写方式。
write-unpublished = 不生成 { $cycle } 的参数列表：参数 1 各位数字的含义未公布。
write-unpublished-variant = 不以参数列表生成 { $cycle } 的测量方式 { $value }：其各位数字的含义未公布。
write-unpublished-alone = 不生成 { $cycle }：旧版控制系统没有这样的循环，其参数各位数字的含义未公布。
write-variant-open = 参数决定测量方式，而 { $value } 在程序运行时才能确定。
write-no-list-hint = 请改写成赋值和调用。
write-zero = { $name }={ $value } 单独写成赋值：CYCLE_PARA 中的 0 保留原来的值。
write-beside = { $name }={ $value } 单独写成赋值：该调用没有对应的参数。
write-lost = 略去 { $name }：新型控制系统的参数表中没有对应的参数。
write-lost-hint = 若此值重要，请写成赋值和调用，或在控制系统上设置该数据。
write-expression = { $name }={ $value } 单独写成赋值：若 { $value } 为 0，CYCLE_PARA 会保留原来的值。
write-expression-lost = { $name }={ $value } 会丢失：新型控制系统的参数表中没有对应的参数。
write-plane = _DMODE = 1 在平面 { $plane } 中同样写入：哪个数值表示哪个平面未公布。
write-plane-hint = 首次运行前请在控制系统上检查平面。

convert-same = 调用已经是这种书写方式。
convert-lost = 参数表中的 { $names } 略去：旧型控制系统没有对应的参数。
convert-lost-hint = 请检查没有这些值时此调用能否正常工作。
convert-others = 第 { $line } 行的 { $cycle } 使用此调用的值，转换后会得到不同的值。
convert-others-hint = 请一并转换该调用，或在该调用之前写出这些值。
convert-argument = 此调用的参数 { $value } 会丢失：其他书写方式没有对应的位置。
convert-argument-hint = 请先在调用中把 { $value } 写成数字，然后再转换此调用。
convert-expression = 调用保持不变：赋给 { $name } 的 { $value } 在新文本所在处的值可能不同。
convert-expression-hint = 请把 { $name }={ $value } 直接写在调用前面，其间不要改变该值。
convert-skipped = 调用保持不变：只有部分路径给 { $name } 赋值；转换后该值会始终生效。
convert-skipped-hint = 请在每条路径上给 { $name } 赋值，或直接在调用前赋值。
convert-skip-block = 调用保持不变：{ $name } 在可跳过的程序段（/）中赋值；转换后该值会始终生效。
convert-skip-block-hint = 请不带“/”给 { $name } 赋值，或把调用放在同一跳过级。
convert-stays = 保持原样，但参数表不读取：{ $names }。较新的控制系统改用设定数据（就已公开的而言）。
convert-read = 保持原样，因为其他语句读取（行号）：{ $names }。
convert-variable = 调用自身读取这些变量，因为有多处赋值到达此调用：{ $names }。
convert-read-hint = 较新的控制系统可能没有这些变量：请检查读取它们的语句。
convert-overwrites = 调用保持不变：第 { $line } 行读取 { $name }，转换后的调用会给它赋其他值。
convert-overwrites-hint = 请在该处改用 { $name } 以外的变量名，然后再转换此调用。
convert-called = 调用保持不变：在 { $name } 的赋值与此调用之间调用的 { $program } 可能读取或更改该值。
convert-called-hint = 请在调用前直接给 { $name } 赋值。
convert-unused = { $cycle } 在此方式下不使用这些值，因此省略：{ $names }。
convert-no-variant = 调用未改变：本程序没有给 { $name } 赋值，只有调用它的程序才知道测量什么。
convert-no-variant-hint = 请在调用前给 { $name } 赋值，或同时打开调用它的程序。
convert-added = 参数表需要本程序没有赋值的数据；现已写入：{ $names }。此前以控制系统数据中的值为准。
convert-added-hint = 请检查这些值，或在调用前赋值后重新转换。
convert-macro = 调用保持不变：一个宏同时包含此调用的多个值。
convert-macro-hint = 请先在程序中用宏的文本代替该宏。

revise-taken = 新的测量方式不使用 { $names }：已从调用中删去。
revise-shared = 新的测量方式不使用 { $names }，但后面的调用要读取，仍留在程序中。
variable-before = 无法更改 { $name }：调用之前没有为其赋值的程序行。
variable-several = 无法更改 { $name }：其值取决于执行路径，来自多处（第 { $lines } 行）。
variable-unclear = 无法更改 { $name }：其值由调用、程序循环或下标决定。
variable-calculated = 无法更改 { $name }：其值在第 { $lines } 行中计算得出。
variable-number = 输入数字后可更改 { $name }。
variable-unsolved = 无法更改 { $name }：由该表达式求不出此数字对应的值。
variable-same = { $name } 已是此值。

revise-around = 调用前后的第 { $lines } 行随之更改。
revise-around-left = 调用前后的程序行不再属于该调用（第 { $lines } 行）。
revise-around-left-hint = 请在窗体的“调用前后”中删除这些行，或手动更改。
around-stray = { $name } 前后的这些程序行属于使用其他零点偏移或位于其他平面的调用。
around-stray-hint = 请应用下面的更改；如果这些行与此调用无关，请将其删除。
around-stray-cure = 适用于此调用的程序行
