# Commissioning, step by step.
steps-path = 机床
steps-done = 已完成 { $done } / { $all }
steps-if = 适用条件
steps-check = 检查
steps-softkeys = 软键和行
steps-files = 文件
steps-versions = 版本
steps-versions-title = 可配合使用的版本
steps-connections = 测头接线
steps-print = 打印
steps-reset = 重新开始
