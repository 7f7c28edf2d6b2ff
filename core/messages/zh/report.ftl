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
