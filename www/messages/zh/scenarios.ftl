# 场景：将程序与预期结果比较。

scenarios-title = 场景
scenarios-what = 场景包含程序、机床和预期结果：每次调用的结果、补偿、报警、记录。每次修改后可再次运行。“检查本安装”在此浏览器中运行手册中的计算示例和数据，以及闭环检验：校准测头、补偿，再次测量。
scenarios-note = 将程序保存为场景
scenarios-open-files = 运行场景…
scenarios-open-folder = 运行文件夹…
scenarios-none = 这些文件中没有场景：文件夹中的场景文件名以 scenario.json 结尾。
scenarios-passed = 通过：{ $good } / { $count }
scenarios-done = 已运行场景：{ $done } / { $scenarios }
scenarios-time = 时间：{ $seconds } s
scenarios-stop = 停止
scenarios-good = 通过
scenarios-bad = 不符
scenarios-from-example = 计算示例：{ $source }
scenarios-from-vector = 数据：{ $source }
scenarios-from-loop = 闭环检验：{ $source }
scenarios-unused = 没有场景用到的文件：{ $count }
scenarios-unused-why = 文件夹中场景的文件名以 scenario.json 结尾，所引用的程序与其放在一起。若该文件是场景，请重命名。
scenarios-unused-more = 另有 { $count } 个
