# 机床检查：机床数据和用户数据有何错误，以及后果。

machine-check-nothing = 此文本中没有测量所需的机床数据或用户数据：请选择机床数据文件（.TEA、INITIAL.INI）、定义文件或文本形式的批量调试存档。
machine-check-ending = 已比较的数据：{ $read }。错误：{ $errors }。警告：{ $warnings }。提示：{ $notes }。文件中的其他赋值：{ $others }。
machine-check-unread = 无法读取数值：{ $value } 请写成 7、(1,0,2)、SET(1,,2) 或 REP(0)。
machine-check-text = 此处应为数值，不是文本：{ $value }
machine-check-number = 此处应为带引号的文本：{ $value }
machine-check-whole = { $value } 不是整数。
machine-check-no-element = 从此元素起有 { $count } 个元素不存在：数组为 { $array }。
machine-check-no-index = { $name } 不是数组，没有下标。
machine-check-no-field = { $other } 只计 { $most } 个数据组：此元素不存在。
machine-check-unnamed = 此几何轴没有名称。
machine-check-unread-size = 无法读取数组的大小或下标：{ $value } 请写整数，例如 [2,10]。
machine-check-many = 列表有 { $value } 个值，而元素只有 { $before } 个：多余的值被丢弃。请缩短列表或加大数组。
machine-check-unlike = 编号 { $value } 属于另一个数据：控制系统读取标识符。
machine-check-renamed = 按编号读取：手册中的标识符是 { $before }。使用该标识符的控制系统不认识 { $value }。
machine-check-positive = { $value } 无效：该值必须大于 0，不用它计算制动距离。
machine-check-no-axis = 缺少 { $data }，不将进给率与允许偏转量比较。
machine-check-axis-metric = 此控制系统为英制；{ "MD32300" } 按 m/s² 计，{ "MD32200" } 按 (m/min)/mm 计。以 inch/s² 给出的减速度请乘以 0.0254。
machine-check-twice = 两次给出不同的值：先为 { $before }，后为 { $value }。以最后一个为准。
machine-check-low = { $value } 太小；至少为 { $limit }。
machine-check-high = { $value } 太大；最大为 { $limit }。
machine-check-not = { $value }，应为 { $limit }。
machine-check-between = { $value } 不在 1 至 { $limit } 之间。
machine-check-bits-missing = 以下各位必须为 1：{ $bits }。
machine-check-bits-set = 以下各位必须为 0：{ $bits }。
machine-check-range = { $value } 不在 { $min } 至 { $max } 之间。
machine-check-from = { $value } 太小；至少为 { $min }。
machine-check-above = { $value } 太小；必须大于 { $min }。
machine-check-choice = 不允许 { $value }；允许：{ $choices }。
machine-check-count = 数组 { $array } 定义为 { $size } 个元素。
machine-check-no-array = 数组 { $array } 不存在：其定义已成为注释。
machine-check-fields = 此数组的每个元素有 { $size } 个数据；定义中的个数不同。
machine-check-units = 基本尺寸系统为 { "MD10240" } = { $metric }：循环在下次调用时换算数据。
machine-check-needs = 没有 { $other } = { $value } 时不起作用。
machine-check-erases = 下次调用会将所有测头数据、经验值和平均值置为 0。
machine-check-version = 控制系统的软件版本缺失，或低于 3。
machine-check-uncalibrated = 此工件测头从未校准。首次校准时，{ "_TSA" } 必须大于测球半径。
machine-check-depth = 测量半径的深度为 0。
machine-check-axes = 三位数字各为 0 至 3：每个轴一位。
machine-check-size = 圆盘直径或边长为 0；校准和长度测量需要该值。
machine-check-own-speed = 采用用户的转速和进给率，但此值为 0。
machine-check-no-make = 测量值修正需要 { "_TP_CF" } 中的刀具测头制造商。
machine-check-no-table = 未填写：{ $tables }。修正表要求半径和速度按升序填写。
machine-check-assign = 必须输入刀具测头的这个尺寸。
machine-check-inputs = 自动方式与 JOG 使用不同的测量输入端：{ $other } = { $value }。
machine-check-probe = 只有 { $most } 个测头（{ $other }）。
machine-check-most = 最大为 { $most }。
machine-check-no-lines = 测量记录的数值行均未填写。
machine-check-skipped = 在模拟中，控制系统跳过测量循环。
machine-check-ratios = { $probes } 个工件测头只有 { $size } 个条目：其余测头的触发值不作修正。
machine-check-braking = 进给率为 { $feed } 时，测头偏转可达 { $path } mm，而允许值为 { $deflection } mm；最大为 { $largest }。

machine-need-gud = 无法激活定义文件 GUD5、GUD6 和 GUD7。更改存储器会触发报警 4400：请保存批量调试存档并重新读入。
machine-need-reserve = 仅供测量循环已足够；手册建议更大的值。
machine-need-functions = 控制系统不能识别所有带参数的循环。
machine-need-lud = 循环的局部变量容纳不下：程序在调用处停止。
machine-need-system-frame = 任何测量循环都不能运行。
machine-need-basic-frame = 不能修正基本坐标框架：JOG 中不能，{ "_KNUM" } = 2000 时也不能。
machine-need-channel-frame = 拒绝对通道基本坐标框架的修正。
machine-need-fine = 修正写入粗偏移；已有的精偏移计入其中并被删除。
machine-need-level = 仅适用于偏转时为 0 V 的测头；否则测头在静止时即视为已偏转。
machine-need-central = 在 840D sl 上，接在 { "X122" } 的测头不能测量。
machine-need-hmi-time = 测量结果显示的应答太迟。
machine-need-log-file = 记录文件很快写满：记录在文件 _1 至 _9 中继续，之后要求输入新名称。
machine-need-mirror = 镜像时，工件测量的结果错误。
machine-need-additive = 拒绝附加补偿。
machine-need-setup-offset = 拒绝设定补偿。
machine-need-environment = 没有刀具环境（{ "_TENV" }）。
machine-need-jog-start = JOG 测量无法启动。
machine-need-geometry = JOG 测量缺少一个几何轴。
machine-need-reset-length = 复位和上电后，测头的刀具长度或基本坐标框架未激活。
machine-need-start-length = 程序启动时丢失刀具长度补偿。
machine-need-tool-change = 复位和启动时，刀具管理不会将测头保持为当前刀具。
machine-need-basic-reset = 复位时丢失基本参考。
machine-need-length-type = 在带钻头或铣刀的车床上，刀具长度沿错误的轴计算；2 用于此类机床。

# 定义文件。

definitions-none = 与出厂状态没有差别。
definitions-memory = 用户数据存储器
definitions-share = { $name }：{ $bytes } 字节（出厂时 { $default }）
definitions-share-channel = { $name }：每个通道 { $bytes } 字节（出厂时 { $default }）
definitions-need = 仅测量循环就要求 { $number } 至少为 { $value }，{ $source }
definitions-insert = 在出厂的 { $files } 中替换同名的行：这些行不是完整的文件。
definitions-save = 请先保存 NC 中有效的用户数据：激活定义文件会复位其数值。
definitions-activate = 请按此顺序逐个激活：{ $files }。
definitions-load = 请用“Load HD → NC”装载 GUD7_MC.DEF，不要激活。然后激活 GUD7.DEF，GUD7_MC.DEF 随之生效。
definitions-reset = 然后请执行 NC 复位，再读回用户数据。
definitions-older = 测量循环 6.02.16 及以下版本，GUD7_MC.DEF 的行属于 GUD7.DEF。
definitions-enter = 在 JOG 方式下测量前，请输入每个刀具测头的尺寸，否则出现报警 61230：{ $names }
definitions-program = 然后装载 { $name }，在进行测量的通道（{ $channels } 个）中以自动方式各运行一次：许多数据属于通道。之后校准测头。
definitions-read = 读入 { $read } 个数值，其中 { $changed } 个有改动，{ $problems } 个未被接受。
definitions-other-channel = 未读入 { $count } 个数值：只读入第一个通道的数值。
definitions-not-there = 从此数据起有 { $count } 个数值未读入：此机床没有这些数据。
definitions-sizes = 随机床保存的数组大小：{ $names }。
definitions-read-newer = 读取了 { $read } 个值，更改 { $changed } 个，未接受 { $problems } 个。这些是设定数据：机床现为第 3 代（PW-GENERATION）。840D sl 2.5 和 2.6 以及 828D 4.3 及以下请选 2。
definitions-settings = 将这些行作为调试文件读入，或把数值输入机床数据和设定数据；CHANDATA(1) 之后的行用于进行测量的通道（{ $channels } 个）。之后校准测头。
definitions-channels = 控制系统有 1 至 { $most } 个通道。
