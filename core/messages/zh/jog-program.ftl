# 在 JOG 中的测量作为程序，调用作为输入画面：区别，以及没有对应项的原因。

jog-differs-expected = 循环要求工件距设定位置不超过 { $reach } mm，更远则报警 61301 或 61303。JOG 从测头所在位置开始寻找。
jog-differs-stand = 循环以调用时测头所在位置为设定位置，并沿通过该点的直线测量。JOG 在手动移动到的位置测量，设定位置在字段中输入。
jog-differs-points = 循环自动在各测量点之间移动，并在自己的位置触测。
jog-differs-up = 测头在各点之间抬起 { $path } mm（_ID）。JOG 不知道工件高度：请检查是否足够。
jog-differs-fourth = 循环需要第四点：位于 P3 与拐角之间。
jog-differs-around = 循环在测量高度绕凸台移动。在 JOG 中测头从上方越过。
jog-differs-angle = 循环最多测量 45° 的角度，超过则报警 61331。
jog-differs-skew = JOG 使测球而不是主轴轴线对准测量点。在倾斜的棱边上，循环的触测点会偏移测头的偏斜量。
jog-differs-spindle = 主轴是否跟随旋转的 WCS，在 JOG 中由 E_MESS_SETT[0] 决定，在循环中由 _CHBIT[13] 决定。两者设置不同。
jog-differs-corner-zero = 循环将拐角作为两个轴的零点。画面中的设定位置在循环中没有对应参数。
jog-differs-fine = JOG 写入粗偏移并清除精偏移。循环修正精偏移；_CHBIT[21] = 1 时与 JOG 相同。
jog-differs-active = 循环写入的值在程序再次调用零点偏移后生效。JOG 立即激活，或在激活画面中激活。
jog-differs-tool-data = 循环从自己的数据（_TP、_CM）读取刀具测头和转速，JOG 从 E_MESS_MT_… 和 E_MESS_… 读取。
jog-differs-tool-memory = JOG 按 _JM_B[0] 写入几何值或磨损值，循环按 _CHBIT[3] 写入。两者设置不同。
jog-program-points = 请先测量所有点：调用需要各点的位置。
jog-program-centres = 没有循环能测量多个孔或凸台并按其圆心修正零点偏移。CYCLE977 在 _KNUM = 0 时测量每个圆心，CYCLE116 计算通过三点或四点的圆。
jog-program-none = 没有功能相同的循环。
jog-program-step = 没有循环能测量朝向相同或位置颠倒的两条棱边。
jog-program-heights = 没有循环能沿进给轴测量槽或凸台。
jog-program-corner = 各点不在此拐角的棱边上。请检查位置，然后重新测量。
jog-back-tool = 此调用修正刀具。JOG 仅测量，或修正零点偏移。
jog-back-without = 画面中没有 { $names } 的字段。
jog-back-direction = 此调用从测头所在位置向设定位置测量。请在画面中选择方向。
jog-back-position = 此调用的设定位置是程序中测头所在的位置。请在画面中输入。
