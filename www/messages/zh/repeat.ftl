# 测头的测试程序。

repeat-intro = 两个用 MEAS 测量、不用循环的程序：测头是否触发，以及同一位置多次触碰的分散程度。第二个程序在此处用所选机床运行，被测面位于起点和终点的中间。
repeat-axis = 轴
repeat-from = 起点
repeat-to = 无信号时的终点
repeat-feed = 进给率
repeat-count = 触碰次数
repeat-parameters = 测量值存入 R 参数，起始编号（空：数组）
repeat-input = 测量输入
repeat-input-machine = 取自机床数据
repeat-machine = 机床坐标系中的值
repeat-changes = 用 M6 换刀
repeat-real = 实际机床的测量值（空：模拟）
repeat-histogram = { $from } 至 { $to } { $unit } 的频数
repeat-values-shown = { $count } 个测量值
repeat-program = 程序：重复精度
repeat-function = 程序：功能测试
repeat-save-program = 保存重复精度程序
repeat-save-function = 保存功能测试程序
