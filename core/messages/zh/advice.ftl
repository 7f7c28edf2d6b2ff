# 对整个程序的疑问，各附纠正办法。

advice-insert = 在调用之前插入 { $text }
advice-insert-behind = 在调用之后插入 { $text }
advice-insert-around = 在调用之前插入 { $before }，之后插入 { $behind }
advice-write = 为此调用写入 { $name }={ $value }

advice-compensation = 刀具半径补偿有效：第 { $line } 行的 { $word }。
advice-compensation-pass = 刀具半径补偿从程序循环的上一遍起一直有效：第 { $line } 行的 { $word }。
advice-compensation-hint = 请在调用前编程 G40。
advice-compensation-open = 此调用之前没有编程 G40，而程序结束时刀具半径补偿仍有效：再次运行时补偿可能仍然有效。
advice-plane = 此调用之前没有编程工作平面：在哪些轴上测量由机床的复位状态决定。
advice-plane-hint = 请编程平面，例如 { $plane }。
advice-diameter = 此调用之前没有编程 DIAMON 或 DIAMOF：横向轴的值是否为直径由机床的复位状态决定。
advice-diameter-hint = 请编程 DIAMON（直径）或 DIAMOF（半径）。
advice-edge-none = 没有有效的 D 号：当前刀具的长度不生效。
advice-edge-open = 最后一个 T 之后没有编程 D：补偿是否有效由机床数据决定。
advice-edge-hint = 请在换刀之后编程当前刀具的 D 号。
advice-tool = 当前刀具 T{ $tool } 不是工件测头（类型 { $type }）。
advice-tool-hint = 请在调用前换上测头，或改正刀具表中的类型（710，车床为 580）。
advice-tool-digit = T{ $tool } 的类型为 { $type }：调用条件只允许 1x0 和 710，手册另一处允许 100 到 199。
advice-tool-digit-hint = 请换上测头，或把其类型设为 710；控制系统可能拒绝现在的类型。
advice-tool-assignment = T{ $tool } 的类型为 { $type }：仅当 SD 42950 = 2 时，此循环才允许使用车床测头（类型 5xy）。
advice-tool-assignment-hint = 请在车床上设 SD 42950 = 2；在铣床上把测头的类型设为 710。
advice-tool-position = T{ $tool }（类型 { $type }）的刀沿位置为 { $position }：车床测头的刀沿位置须为 5 到 8。
advice-tool-position-hint = 请换上测头，或改正其刀沿位置：5 或 7 垂直于 G17，6 或 8 垂直于 G19。
advice-tool-plane = T{ $tool } 的刀沿位置为 { $position }，因此不垂直于此循环测量所在的平面。
advice-tool-plane-hint = 请在 { $plane } 中测量，或换用垂直于当前平面的测头：5 和 7 对应 G17，6 和 8 对应 G19。
advice-length = T{ $tool } 没有沿刀具轴起作用的长度：此处 L1 沿当前平面的纵坐标，L2 沿横坐标，L3 沿垂直坐标。
advice-length-hint = 请在用于此平面的 D 号中把沿刀具轴的长度输入为 L3；若各平面都采用 G18 的长度分配，则不必更改。
advice-milled-diameter = DIAMON 或 DIAM90 有效，但此循环忽略它：X 的位置按半径计。
advice-milled-diameter-hint = 请按半径输入位置；调用前编程 DIAMOF，调用后编程 DIAMON 或 DIAM90。
advice-spindle = 主轴在旋转：M3 或 M4 与此调用之间没有停止主轴。
advice-spindle-hint = 请在测头接近工件之前用 M5 停止主轴。
advice-open = 此调用时的状态取决于另一个程序或本程序的执行路径：{ $words }。
advice-open-hint = 请在调用前编程这些指令，或确保每个调用本程序的程序都已设定。
advice-tool-none = 此调用之前没有编程刀具：循环使用主轴或刀塔中的刀具及其有效的 D 号。
advice-tool-none-hint = 请在调用之前编程 T 和 D。
advice-radius = DIAMOF 有效时设定值 { $value } 为半径：直径为 { $diameter }。
advice-radius-hint = 若输入的是图纸上的直径，请在调用前编程 DIAMON。
advice-calibration = 此程序在此调用之前不校准测头 { $number }：以 { $data } 中存储的数据为准。
advice-calibration-hint = 请先在此机床上校准测头，或在此测量之前调用校准。
advice-inherited = { $name }={ $value } 在第 { $line } 行写入，用于 { $cycle }，单位与此处不同。
advice-inherited-meaning = { $name }={ $value } 在第 { $line } 行写入，用于 { $cycle }，在该处表示“{ $before }”，在此处表示“{ $now }”。
advice-inherited-hint = 请为此调用写入 { $name }。
advice-frame = 补偿后的 { $frame } 尚未生效：程序仍按原来的值继续。
advice-frame-other = 已补偿 { $frame }，但程序在 { $other } 中继续，始终没有激活它。
advice-frame-basic = 补偿后的基本或系统坐标框架尚未生效：程序仍按原来的值继续。
advice-frame-hint = 请在调用之后用 { $frame } 激活。
advice-frame-other-hint = 请在调用之后编程 { $frame }。
advice-overwritten = { $name } 在调用时可能已是另一个值：第 { $line } 行调用的程序也写入它。
advice-overwritten-hint = 请在该调用之后写入 { $name }。
advice-log-again = 测量记录 { $file } 已在第 { $line } 行接通：此调用将删除此后写入的内容。
advice-log-again-hint = 请在 { $name } 中为此记录指定不同的名称，或两次测量共用一个记录。
arrives = 写在第 { $lines } 行。
arrives-lines = 写在第 { $lines } 行。
arrives-hint = 在此修改会同时改变该处写入的值。
arrives-shared-hint = 其他调用也使用此值：在此修改只为此调用写入新值。
arrives-many-hint = 此值写在许多行中：请在写入处修改。
arrives-differing = 随到达此调用的执行路径而不同：{ $values }。
arrives-differing-hint = 在此修改会对所有执行路径有效。请在写入该值的地方修改；括号中为行号。
advice-level = 调用位于程序级 { $level }；测量循环只能在前五级调用。
advice-level-hint = 请把调用移到更接近主程序的程序级。

advice-read-back = 控制系统的测量循环支持功能读回此调用时会作如下改动：{ $changes }。
advice-read-back-hint = 这些值由机床的 _MZ_MASK 规定。请采用这些值；若程序正确，则修改 _MZ_MASK。
advice-read-back-cure = 采用 _MZ_MASK 给出的值
advice-mask = 编写此调用时机床的设置与现在不同：{ $changes }。
advice-mask-hint = 控制系统一读回此调用，就会把这些改动写入程序。
advice-mask-cure = 把此机床的设置写入程序
advice-tool-programming = 控制系统不能把此调用读回输入画面。编写之后改变的内容：{ $changes }。
advice-tool-programming-hint = 请用表单重新编写此调用，并检查刀具和 D 号：两者的编程方式已改变。
nct-oriented = 调用时主轴未定向：自程序开头或上一个 M3、M4 之后没有 M19 或 M59。
nct-oriented-hint = 测针测量前请使主轴定向：未定向时不能使用这些宏程序。
nct-stylus-off = 调用时测针已断开：自程序开头或上一个 M55 之后没有 M59。
nct-stylus-off-hint = 请在调用前用 M59 接通测针。
nct-stylus-on = 主轴启动时，测针仍由 M59 接通。
nct-stylus-on-hint = 请先用 M55 断开测针。
nct-stylus-left = 程序结束时测针仍接通。
nct-level = O9920 在第 { $level } 级子程序中调用；自动方式下只允许在前两级调用。
nct-level-hint = 请把调用移到更接近主程序的程序级。
user-program-runs-before = { $name } 在此调用之前运行，从 { $label } 开始（第 { $line } 行）。
user-program-runs-before-whole = { $name } 在此调用之前从头运行（第 { $line } 行）：其中没有标签 { $label }。
user-program-runs-behind = { $name } 在此调用之后运行，从 { $label } 开始（第 { $line } 行）。
user-program-runs-behind-whole = { $name } 在此调用之后从头运行（第 { $line } 行）：其中没有标签 { $label }。
user-program-cycle = 没有名为 { $name } 的测量循环调用用户程序。
user-program-none = 请至少选择一个测量循环。
user-program-line = 标签与 M17 之间不能有此行：{ $line }
user-program-variable = { $name } 不是变量名。
user-program-own = 不是西门子的文件：它替换交货文件。手册没有给出其 CASE 的变量，请从交货文件中获取。
user-program-insert = 用于插入：每组行放在该循环的标签与其 M17 之间。
user-program-changes = { $name } 是测量循环的参数：在 CYCLE198 中写入的值会使循环测量别的内容。
user-program-before-line = { $cycle } 中测量之前
user-program-behind-line = { $cycle } 中测量之后

# 旧版本的程序。

older-call = 带 R 参数的 { $word } 是 840C 的测量调用，现在是 { $cycle }。其参数：{ $names }。
older-call-hint = 请转换程序，然后检查用户数据和机床数据，并重新校准测头。
older-convert = 转换为 { $cycles }
older-open-id = { $text }：这是进刀深度 _ID 吗？对于 { $cycles } 的这个测量方式，手册在同一 R 参数旁还印有 { $other }。
older-open-sza = { $text }：这是保护区 _SZA 吗？对于 { $cycles } 的这个测量方式，手册在同一 R 参数旁还印有 { $other }。
older-open-md = { $text }：这是测量方向 _MD 吗？对于 { $cycles } 的这个测量方式，手册在同一 R 参数旁还印有 { $other }。
older-open-ra = { $text }：这是回转轴编号 _RA 吗？对于 { $cycles } 的这个测量方式，手册在同一 R 参数旁还印有 { $other }。
older-open-rf = { $text }：这是圆弧路径进给 _RF 吗？对于 { $cycles } 的这个测量方式，手册在同一 R 参数旁还印有 { $other }。
older-open-hint = 请查图纸或询问编写者。测量方式同时需要两者时，请手动写入另一个参数。
older-open-first = { $text }：这是 { $cycles } 的设定值 _SETVAL 吗？{ $other } 也给出设定值，但数值不同。
older-open-second = { $text }：{ $cycles } 的设定值 _SETVAL 是它而不是 { $other } 吗？两者都给出设定值，数值不同。
older-setpoint-hint = 手册没有说明哪一个有效。请选择一个：另一个会被删除。
older-answer = 把 { $text } 写成 { $name }
older-unused = { $cycles } 的这个测量方式不使用 { $text }：转换时省略。
older-result = 测量调用之后读取 { $name }：在 840C 上其中可能是测量结果。手册没有给出对应的结果变量。
older-result-hint = 请从 _OVR[] 或 _OVI[] 读取结果；循环的帮助页列出了这些变量。
older-unclear = { $text }：从这里起无法确定哪些 R 参数会传到 840C 的测量调用，因此不转换程序。
older-unclear-hint = 请在循环和宏之外给固定编号的 R 参数赋值，然后转换。
older-subroutine = { $name } 属于测量循环：{ $what }
subroutine-result = 显示测量结果画面（现在由 _CHBIT[10] 控制）。
subroutine-dialogue = 在测量调用之前以对话方式输入参数（SW 3.2 至 4.5）。此后数值直接写在程序中，该调用可以删除。SW 4.4 及以下还需要 MMC 接口（在 MMC 102 上删除 comic.nsk 第 2 行的 REM）。
subroutine-interface = 内部程序，测量循环的接口。程序不调用它。
subroutine-messages = 内部程序，输出信息，至 SW 6.2。从 SW 6.3 起取消。
subroutine-alarms = 内部程序，输出报警，至 SW 6.2。从 SW 6.3 起取消。
subroutine-transfer = 内部程序，传送数据，从 SW 4.5 起。程序不调用它。
subroutine-plausibility = 内部程序，检查参数。程序不调用它。
subroutine-measuring = 内部程序，测量功能。程序不调用它。
subroutine-milling = 内部程序，铣床工件测量循环的测量功能。程序不调用它。
subroutine-tool = 内部程序，装载刀具补偿；至 SW 6.2 还装载零点偏移。程序不调用它。
subroutine-zero = 内部程序，装载零点偏移，从 SW 6.2 起。程序不调用它。
subroutine-approach = 内部程序，在车床上预定位。程序不调用它。
