# docs/ 中生成页面的句子；其中的循环、报警和数据各有自己的文字。

report-alarms = 报警和信息
report-generated = 由循环目录生成，请勿编辑。
report-known-simulated = 表单、检查、程序文本和仿真。
report-known-passed = 表单、检查和程序文本；不仿真，运行时跳过。
report-known-stops = 表单、检查和程序文本；不仿真，运行时在调用处停止。
report-default-machine = 与机床相同
report-machine = 机床数据
report-machine-intro = SINUMERIK：数据块 GUD5、GUD6、GUD7 的用户数据，以及测量循环所依赖的机床数据。末尾为 NCT：测量宏程序的变量和参数。由 `core/src/control` 中的表生成，请勿编辑。
report-own-setting = 无：Probewright 自己的设定
report-unit-active = mm 或 inch，按当前单位制
report-unit-basic = mm 或 inch，按基本单位制
report-feed-basic = mm/min 或 inch/min，按基本单位制
report-speed-basic = m/min 或 feet/min，按基本单位制

# 终端程序自身：使用错误时的提示，以及输出内容的名称。

terminal-error = 错误
terminal-language = 没有语言 { $code }；可用：{ $known }
terminal-cycle = 没有循环 { $name }；用“probewright cycles”列出全部循环
terminal-variant = { $cycle } 没有变型 { $number }
terminal-parameter = { $cycle } 没有参数 { $name }
terminal-twice = { $name } 重复给出
terminal-pair = 不是 NAME=VALUE 的形式：{ $text }
terminal-alarm = 没有报警或信息 { $name }
terminal-name = 没有这个名称的循环、数据、提示或报警：{ $name }
terminal-large = 大于 { $most } MB
terminal-text = 不是 UTF-8 文本
terminal-surface = 设置文件中没有可替换的自由曲面
terminal-more = 另有 { $count } 条提示
terminal-told-cause = 原因
terminal-told-cure = 处理方法
terminal-told-effect = 影响
terminal-told-sources = 来源
terminal-told-found = 发现方式
terminal-told-source = 出处
