# docs/ 中生成页面的句子；其中的循环、报警和数据各有自己的文字。

report-alarms = 报警和信息
report-generated = 由数据表生成，请勿编辑。
report-known-simulated = 表单、检查、程序文本和模拟。
report-known-stops = 表单、检查和程序文本；不模拟，运行时在调用处停止。
report-default-machine = 与机床相同
report-around = 测量调用前后的程序块
report-around-intro = 车间在测量前后手工编写的内容。`probewright write` 用 `--around NAME` 添加程序块，用 `--around NAME.FIELD=VALUE` 设置其字段；页面在表单中提供。标签以 PW 开头，标签和变量都是程序中未使用的。
report-jog = 在 JOG 中测量
report-jog-intro = 在 JOG 中测量的输入画面：各自的测量内容、按 NC 启动前测头的位置、写入的内容，以及各字段在 `probewright jog` 脚本中的名称。轴为 G17 的轴。
report-jog-mask = 脚本中：{ $mask }。来源：{ $source }。
report-jog-results = 结果：{ $names }。
report-jog-older = 至测量循环 SW 6.2
report-jog-older-intro = 机床数据 `PW-JOG` = 1 时使用这些输入画面，代替上面除测量刀具以外的画面。
report-machine = 机床数据
report-machine-intro = SINUMERIK：数据块 GUD5、GUD6、GUD7 的用户数据，以及测量循环所依赖的机床数据。末尾为 NCT：测量宏程序的变量和参数。由 `core/src/control` 中的表生成，请勿编辑。
report-own-setting = 无：Probewright 自己的设置
report-unit-active = mm 或 inch，按当前单位制
report-unit-basic = mm 或 inch，按基本单位制
report-feed-basic = mm/min 或 in/min，按基本单位制
report-speed-basic = m/min 或 ft/min，按基本单位制
report-alarms-raised = 报警
report-always = 始终
report-and = 且
report-between = { $from } 到 { $to }
report-every-variant = 所有测量方式
report-about = 帮助
report-of-channel = 通道
report-of-control = 控制系统
report-optional = 可选
report-optional-when = { $condition } 时可选
report-or = 或
report-parameters = 参数
report-raised = 引发来源：{ $cycles }。发现：{ $found }。出处：{ $source }。
report-required = 必需
report-required-when = { $condition } 时必需
report-results = 结果
report-source = 出处：{ $source }。
report-standard = { $old }；NCK 63 起 { $new }
report-unit-rpm = r/min
report-variants = 测量方式
report-when-digit = `{ $param }` 的第 { $place } 位 ∈ { $numbers }
report-when-given = 已给出 `{ $param }`
report-when-not = 非（{ $condition }）
report-when-tool = 刀具类型 { $from } 到 { $to }
report-when-variant = 测量方式 ∈ { $numbers }
report-column-block = 数据块
report-column-bounds = 极限值
report-column-called = 调用
report-column-cure = 措施
report-column-cycles = 循环
report-column-datum = 数据
report-column-default = 默认值
report-column-effective = 生效
report-column-jog = JOG
report-column-meaning = 含义
report-column-measures = 测量内容
report-column-name = 名称
report-column-need = 是否必需
report-column-number = 编号
report-column-range = 范围
report-column-source = 出处
report-column-standard = 默认值
report-column-type = 类型
report-column-unit = 单位
report-column-used = 此处采用
report-column-when = 条件


# 终端程序自身：使用错误时的提示，以及输出内容的名称。

terminal-error = 错误
terminal-language = 没有语言 { $code }；可用：{ $known }
terminal-cycle = 没有循环 { $name }；用“probewright cycles”列出全部循环
terminal-variant = { $cycle } 没有测量方式 { $number }
terminal-parameter = { $cycle } 没有参数 { $name }
terminal-twice = { $name } 重复给出
terminal-around = { $cycle } 在此没有程序块 { $name }；可用：{ $known }
terminal-around-field = 程序块 { $name } 没有字段 { $field }
terminal-around-problem = { $name }：{ $problem }
terminal-pair = 不是 NAME=VALUE 的形式：{ $text }
terminal-alarm = 没有报警或信息 { $name }
terminal-name = 没有这个名称的循环、数据、检查结果或报警：{ $name }
terminal-large = 大于 { $most } MB
terminal-text = 不是 UTF-8 文本
terminal-surface = 机床配置中没有可替换的自由曲面
terminal-more = 另有 { $count } 条检查结果
terminal-raised = 报警 { $alarm }
terminal-log = 输出
terminal-log-left = 文件 { $name }，{ $lines } 行；可用 --log 文件夹 保存
terminal-log-written = 已写入文件：{ $path }，{ $lines } 行
terminal-log-exists = { $path } 已存在，未覆盖：请删除它，或指定另一个文件夹
terminal-told-cause = 原因
terminal-told-cure = 措施
terminal-told-effect = 影响
terminal-told-sources = 引发来源
terminal-told-found = 发现方式
terminal-told-source = 出处

# Help pages of the terminal program and what it says about wrong arguments; names of its files stay.

terminal-usage = 用法
terminal-any-options = [选项]
terminal-commands = 命令
terminal-arguments = 参数
terminal-options = 选项
terminal-probewright-about = 数控测量循环的编程助手
terminal-cycles-about = 列出测量循环和宏程序
terminal-explain-about = 说明循环、JOG 测量的输入画面、报警、检查结果、参数、结果、用户数据或机床数据，例如 CYCLE977、set_edge、61303、PW135 或 _SZA
terminal-alarms-about = 显示报警的含义和措施；不给编号时列出全部报警
terminal-check-about = 检查零件程序；有错误时退出状态为 1，文件无法读取时为 2
terminal-write-about = 把一个调用的程序文本写到标准输出
terminal-read-about = 列出零件程序中的测量调用
terminal-run-about = 模拟零件程序；有错误或没有到达程序结尾时退出状态为 1
terminal-test-about = 运行场景：程序、机床及预期结果；有不符时退出状态为 1
terminal-jog-about = 按脚本执行在 JOG 中测量的操作；有一行被拒绝或有报警时退出状态为 1
terminal-help-about = 显示命令的帮助
terminal-lang-text = 输出语言，例如 zh；默认用环境的语言，否则用英语
terminal-json-text = 以 JSON 输出
terminal-cycles-json-text = 以 JSON 输出，包括测量方式、参数和结果
terminal-check-json-text = 以 JSON 输出每个文件的检查结果
terminal-name-text = 名称或编号
terminal-variant-text = 循环的测量方式，例如 101：显示其帮助页
terminal-number-text = 报警号，例如 61303，或 NCT 控制系统的信息，例如“PROBE FAIL”
terminal-files-text = 零件程序（可多个）
terminal-file-text = 零件程序
terminal-control-text = 控制系统：sinumerik（840D、840Di、810D）或 nct；省略时由程序识别
terminal-setup-text = 机床配置文件，见 docs/setup.schema.json；省略时假定一台与程序相符的机床，并输出所作的假定
terminal-with-text = 属于该程序的定义文件（.DEF）和子程序，或包含它们的文件夹
terminal-program-text = 要运行的程序的名称；不指定时为文本中的第一个
terminal-arg-text = 程序自身参数的值，例如 DEPTH=5
terminal-screens-text = 输出每个显示测量结果画面的调用的画面（_CHBIT[10]）
terminal-strict-text = 缺少子程序或机床的值时停止
terminal-max-blocks-text = 运行超过此程序段数时停止；长程序段、数组以及程序循环中的运动按多段计
terminal-assumed-values = 假定的机床值：{ $values }。括号中为行号。
terminal-progress = { $share }%，{ $blocks } 个程序段
terminal-test-passed = 通过
terminal-test-failed = 不符
terminal-test-held = 通过：{ $good } / { $count }
terminal-test-none = 此文件夹中没有 scenario.json，也没有以 .scenario.json 结尾的文件
terminal-check-setup-text = 机床配置文件，包括刀具和数据；省略时用默认机床
terminal-cycle-text = 循环名称，例如 CYCLE977
terminal-values-text = 参数值，例如 _SETVAL=132
terminal-comments-text = 为每个参数写一行注释
terminal-around-text = 调用前后的程序块：NAME，字段为 NAME.FIELD=VALUE；可重复（见 docs/zh/around.md）
terminal-style-text = 书写方式：direct（先赋值，后调用；默认），indirect（CYCLE_PARA 和参数化调用），operate（新型控制系统的参数表）
terminal-print-text = 打印输出文件：NCT 宏程序的地址 V 和 W 所打印的内容
terminal-log-text = 存放测量记录和程序所写文件的文件夹；不覆盖已有文件
terminal-record-text = 存放全部测量结果报告的文件：表格（.csv）或文档（.json，见 docs/record.schema.json）
terminal-record-ending = 测量报告只能写成 .csv 或 .json：请选用其中一种扩展名
terminal-measured-text = 真实机床的测量记录：控制系统的记录文件或表格；其数值与程序的调用逐一对应，报告由这些数值生成
terminal-columns-text = 该表格的列，例如 actual=实测 nominal=3；名称：number、line、result、nominal、actual、deviation
terminal-column = 不是测量记录的列：{ $text }；例如 actual=3
terminal-surface-text = 代替机床配置中的曲面，大小相同：PNG 图片（白色最高）、dome、waves、saddle 或 step；STL 文件保持自身大小
terminal-scan-nc-text = 数字化输出文件：数控程序
terminal-scan-xyz-text = 点文件，每行 X Y Z，单位 mm
terminal-scan-surface-text = 曲面点文件，每行 X Y Z，单位 mm：已扣除测球半径
terminal-script-text = 脚本：每行一个按键、数值或移动，例如“mask set_edge”、“zo = G54”、“move X-20 Y10”、“start”
terminal-jog-setup-text = 机床配置文件，含测头、工件和零点偏移，见 docs/setup.schema.json
terminal-random-text = 随机放置工件：移动、旋转、尺寸不同；同一数字得到同一工件
terminal-what-if-text = 同时说明脚本结束后下一个按键（NC 启动或“计算”）将会做什么
terminal-masks-text = 列出输入画面及其字段和可输入的内容
terminal-scenarios-text = 场景文件或文件夹：文件夹中的每个 scenario.json 和以 .scenario.json 结尾的文件
terminal-junit-text = 以 JUnit XML 保存结果的文件
terminal-as-program-text = 输出与打开的画面功能相同的自动循环及其区别
terminal-help-text = 显示帮助
terminal-version-text = 显示版本
terminal-value-command = 命令
terminal-value-lang = 语言
terminal-value-folder = 文件夹
terminal-value-name = 名称
terminal-value-columns = 列
terminal-value-variant = 测量方式
terminal-value-number = 编号
terminal-value-files = 文件
terminal-value-file = 文件
terminal-value-control = 控制系统
terminal-value-setup = 文件
terminal-value-cycle = 循环
terminal-value-values = 值
terminal-value-around = 名称[.字段=值]
terminal-value-style = 书写方式
terminal-value-scenarios = 场景
terminal-value-script = 脚本
terminal-value-random = 数字
terminal-wrong-argument = 没有参数 { $name }
terminal-wrong-command = 没有命令 { $name }
terminal-wrong-none = 缺少命令
terminal-wrong-value = { $name } 不允许“{ $value }”；允许：{ $known }
terminal-wrong-empty = 缺少值：{ $name }
terminal-wrong-number = “{ $value }”不是数字：{ $name }
terminal-wrong-missing = 缺少：{ $name }
terminal-wrong-conflict = { $name } 和 { $other } 不能同时使用
terminal-wrong-similar = 相近：{ $known }
terminal-wrong-more = 帮助：--help
