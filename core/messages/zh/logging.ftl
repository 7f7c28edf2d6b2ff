# 测量记录：CYCLE100、101、105、106、113、118。

cycle100-title = 测量记录：开
cycle100-help = 接通测量记录。此后每个测量循环都向文件加入一个数值组，直到 CYCLE101。
cycle100-words = 记录 测量记录 打印 文件 报告 记录头 打开 开始 测量结果 检测报告 测量报告 日志 接通
cycle100-on = 测量记录：开，写入记录头

cycle101-title = 测量记录：关
cycle101-help = 关闭由 CYCLE100 接通的测量记录。之后可以读出文件。无需输入。
cycle101-words = 记录 关闭 停止 结束 日志 测量记录
cycle101-off = 测量记录：关

cycle105-title = 写入测量记录
cycle105-help = 不通过测量循环，把记录头或数值组写入记录。
cycle105-words = 记录 打印 记录头 数值 内容 日志 测量记录

cycle106-title = 测量记录文件控制
cycle106-help = 把记录头或数值组写入记录，并管理其文件和页。CYCLE100 会自动调用此循环。
cycle106-words = 记录 页 后续文件 日志 测量记录 分页

cycle113-title = 日期或时间的文本
cycle113-help = 把控制系统的日期（yy/mm/dd）或时间（hh:mm:ss）读入程序的一个变量。
cycle113-words = 日期 时间 时钟 文本 字符串 记录
cycle113-date = 日期
cycle113-time = 时间
param-113-job = 日期或时间
param-113-job-help = 1 读日期，2 读时间。
result-113-text = 日期或时间文本

cycle118-title = 数值转换为文本
cycle118-help = 把一个实数按给定的小数位数四舍五入，转换为文本，用于信息或记录；也可一次转换最多十个 R 参数。
cycle118-words = 格式化 实数 小数位 文本 字符串 四舍五入 信息 记录
cycle118-format = 一个或多个数值的文本
param-118-number = 数值
param-118-number-help = 要转换为文本的数值。转换多个 R 参数时忽略。
param-118-decimals = 小数位数
param-118-decimals-help = 数值四舍五入后保留的小数位数。记录使用 { "_DIGIT" } 的值。
param-118-count = 数值个数
param-118-count-help = 大于 1 时，数值位于连续的 R 参数中；最多十个。
param-118-register = 第一个 R 参数
param-118-register-help = 11 表示 R11、R12 等。
need-118-one = 转换一个数值。
need-118-count = 只有一个数值时不需要。
need-118-registers = 多个数值位于 R 参数中。
result-118-text = 数值文本；多个数值时为最后一个
result-118-field = 多个数值之一的文本

log-job-header = 记录头
log-job-values = 数值组
param-log-job = 测量记录任务
param-log-job-help = 记录头或数值组。
param-log-file = 测量记录文件
param-log-file-help = 不带扩展名的名称：字母、数字和下划线，以两个字母或一个字母加下划线开头。同名文件会被覆盖。
param-log-program = 测量程序
param-log-program-help = 记录头中显示的程序名称。
param-log-headline = 自定义记录头行
param-log-headline-help = 任意文本，也可以组合：{ "\"Part number: \"<<PARTNUM" }。{ "_CBIT[11]" }=1 时，这些行就是整个记录头。
param-log-page = 每页行数
param-log-page-help = 达到该行数（包括记录头）后另起一页并写记录头。0：只在开头写记录头。
param-log-line = 每行字符数
param-log-line-help = 最多 200。某行的字符数超过此值时输出信息。
param-log-first-page = 首页页码
param-log-first-page-help = 记录头的页码从此数开始。
param-log-head-lines = 自定义记录头行数
param-log-head-lines-help = 要写入的 { "_HEADLINE[]" } 行数。
param-log-value-lines = 数值行数
param-log-value-lines-help = 每次测量的行数，最多四行。
param-log-column = 每列字符数
param-log-column-help = 0：各列的宽度与第一标题行中相应字段相同。
param-log-separator = 分隔符
param-log-separator-help = 记录中两个数值之间的字符。在指定内容的各行中始终用逗号。
param-log-mark = 超差标记
param-log-mark-help = 超出 { "_TSA" }、{ "_TDIF" }、{ "_TUL" } 或 { "_TLL" } 时，写在实际值和偏差之后。
param-log-title = 标题行
param-log-title-help = 各列的名称，用逗号分开。若只需一行，请在第二行中写入带引号的空格，否则会出现旧的文本。
param-log-values = 数值行
param-log-values-help = 各列的内容，用逗号分开：{ "_OVR[4]" } 等结果，R27 等 R 参数，文本 { "_TXT[0]" }，{ "_AXIS" }（{ "_MA" } 的轴），{ "_AXIS1" } 到 { "_AXIS3" }（平面的各轴），{ "_TIME" }。其他内容照原样写入。
param-log-digits = 小数位数
param-log-digits-help = 所有数值小数点后的位数。
need-log-file = 测量记录要写入一个文件。
need-log-header = 属于记录头；为空时采用 GUD6 中的值。
need-log-values = 属于数值组；为空时采用 GUD6 中的值。
need-log-titles = 属于记录头；“每列字符数”为 0 时还决定各列的宽度。
need-log-format = 属于记录格式；为空时采用 GUD6 中的值。

check-log-file = 此名称不能用作测量记录文件的名称。
check-log-file-hint = 请用字母、数字和下划线，以两个字母或一个字母加下划线开头。不写扩展名。
check-log-line = 测量记录的一行最多有 { $most } 个字符；控制系统按此值执行。
check-log-line-hint = 请输入不大于 { $most } 的数。
check-log-empty = 没有要记录的内容：标题行和数值行都是空的。
check-log-empty-hint = 请输入列标题，或在数值行中输入要记录的内容，例如 { "_OVR[0],_OVR[4],_OVR[16]" }。
check-log-width = 决定列宽的第一标题行为空：各列均为 12 个字符宽。
check-log-width-hint = 请输入第一标题行，或输入列宽。
check-log-unknown = { $word } 不能记录。
check-log-unknown-hint = 可用 { "_OVR[0]" } 到 { "_OVR[31]" }、R 参数、{ "_TXT[0]" } 到 { "_TXT[99]" }、{ "_AXIS" }、{ "_AXIS1" } 到 { "_AXIS3" }、{ "_TIME" }。
check-log-narrow = 第 { $column } 列宽 { $width } 个字符，而其文本需要 { $needed } 个。
check-log-narrow-hint = 请加宽该列或缩短文本；否则控制系统会加宽该列并输出信息。
check-log-long = 该行有 { $total } 个字符；测量记录最多允许 { $most } 个。
check-log-long-hint = 请减小列宽，或在一行中少记录几个值。
check-log-longer = 该行有 { $total } 个字符，而只允许 { $most } 个。
check-log-longer-hint = 请增大每行字符数，或减小列宽。

log-column-time = 时间
log-column-axis = 测量轴 { "_MA" }
log-column-axis-place = { $place ->
    [1] 横坐标
    [2] 纵坐标
   *[other] 垂直坐标
 }，轴名称
log-column-text = 文本 { $text }
log-column-number = R 参数 { $text }
log-column-comment = 文本“{ $text }”
log-column-unknown = { $text }：不能记录
log-column-free = 自由文本
