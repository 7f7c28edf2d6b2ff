# 手册：页面周围的文字，由 `cargo xtask book` 读取。

book-title = Probewright 手册
book-spoken = 中文
book-about = 指南、概念与术语、JOG 方式下的测量、调试、报警、机床数据，以及每个测量循环和宏程序的说明页。
book-basics = 基础
book-reference = 参考
book-cycles = SINUMERIK 循环
book-macros = NCT 宏程序
book-skip = 跳到正文
book-contents = 目录
book-search = 在手册中搜索
book-results = 搜索结果
book-found = 找到：
book-none = 未找到任何内容。
book-absent = 无法加载搜索索引。
book-turn = 上一页和下一页
book-previous = 上一页
book-next = 下一页
