# 根据控制系统导出的内容检查机床。

exported-intro = 请粘贴或拖入控制系统导出的内容：机床数据（.TEA、INITIAL.INI）、定义文件、批量调试存档的文本；或输入如 MD 18120 = 30 的各行。任何内容都不会离开此浏览器。
exported-text = 控制系统的导出内容
exported-open = 打开文件
exported-remove = 移除 { $name }
exported-has = 此机床具有
exported-jog = JOG 测量
exported-log = 测量记录
exported-tool-probe = 刀具测头
exported-large = NCU 3
exported-error = 错误：{ $count }
exported-warning = 警告：{ $count }
exported-note = 提示：{ $count }
exported-clean = 已比较的数据中没有缺失。
exported-channel = 通道 { $channel }
exported-alarm = 报警 { $number }：{ $text }
exported-limit-error = 需要：{ $value }
exported-limit-warning = 建议：{ $value }
exported-limit-note = 通常：{ $value }
exported-default = 默认值：{ $value }
exported-place = { $file }，第 { $line } 行
exported-missing = 需要但导出内容中没有：{ $count }
exported-more = 未显示：{ $count }
exported-save = 保存待更改的行
exported-print = 打印
exported-close = 关闭
exported-too-large = 文件大于 { $most } MB：请只选择机床数据和定义文件。
exported-braking = 制动距离
exported-deflection = 测头允许的偏转量，mm
exported-delay = 从信号到制动的时间，s（MD 10050 × MD 10070）
exported-acceleration = 最小减速度，m/s²（MD 32300）
exported-gain = 最小伺服增益 Kv，(m/min)/mm（MD 32200）
exported-feed = 进给率，mm/min
