# 在 JOG 中的测量作为程序，调用作为输入画面：区别，以及没有对应项的原因。

jog-differs-expected = 循环要求工件距设定位置不超过 { $reach } mm，更远则报警 61301 或 61303。JOG 从测头所在位置开始寻找。
jog-differs-stand = 循环以调用时测头所在位置为设定位置，并沿通过该点的直线测量。JOG 在手动移动到的位置测量，设定位置在字段中输入。
jog-differs-points = 循环自动在各测量点之间移动，并在自己的位置触测。
jog-differs-up = 测头在各点之间抬起 { $path } mm（_ID）。JOG 不知道工件高度：请检查是否足够。
jog-differs-fourth = 循环需要第四点：位于 P3 与拐角之间。
jog-differs-around = 循环在测量高度绕凸台移动。在 JOG 中测头从上方越过。
jog-differs-angle = 循环最多测量 45° 的角度，超过则报警 61331。
jog-differs-skew = JOG 使测球而不是主轴轴线对准测量点。在倾斜的棱边上，循环的触测点会偏移测头的偏斜量。
jog-differs-corner-zero = 循环将拐角作为两个轴的零点。画面中的设定位置在循环中没有对应参数。
jog-differs-fine = JOG 写入粗偏移并清除精偏移。循环修正精偏移；_CHBIT[21] = 1 时与 JOG 相同。
jog-differs-active = 循环写入的值在程序再次调用零点偏移后生效。JOG 立即激活，或在激活画面中激活。
jog-differs-tool-data = 循环从自己的数据（_TP、_CM）读取刀具测头和转速，JOG 从 E_MESS_MT_… 和 E_MESS_… 读取。
jog-differs-spindle = WCS 旋转时，主轴是否跟随，在循环中由 { $cycle } = { $there } 决定（1：跟随），在 JOG 中由 { $jog } = { $here } 决定（0：跟随）。
jog-differs-tilted = 在倾斜的 WCS 中，即使 _CHBIT[13] = 1，循环中主轴也不跟随；在 JOG 中主轴跟随。
jog-differs-tool-memory = 循环按 { $cycle } = { $there } 写入，JOG 按 { $jog } = { $here } 写入：0 几何尺寸，1 磨损。
jog-differs-input = 循环读取测头的输入（{ $cycle } = { $there }）与 JOG（{ $jog } = { $here }）不同：0 为输入 1，1 为输入 2。
jog-differs-watched = { $cycle } = { $there } 时，循环不监控各点之间的路径（61302），并以快速移动行进。JOG 始终监控。
jog-differs-attempts = 没有信号时，循环按 { $cycle } = { $there } 重试，JOG 按 { $jog } = { $here }：0 五次，1 一次。
jog-differs-attempts-tool = 没有信号时，循环尝试五次（{ $cycle } = { $there }）。JOG 只触碰刀具测头一次。
jog-differs-return = 循环按 { $cycle } = { $there } 从测点返回，JOG 按 { $jog } = { $here }：0 以定位进给，1 以快速移动。
jog-differs-return-tool = 循环以快速移动从测点返回（{ $cycle } = { $there }），JOG 以定位进给返回。
jog-differs-touches = 循环按 { $cycle } = { $there } 触碰，JOG 按 { $jog } = { $here }：0 一次，1 先以 _SPEED[3] 快速触碰。
jog-differs-touches-tool = 循环先以 _SPEED[3] 快速触碰（{ $cycle } = { $there }）。JOG 对刀具有自己的进给。
jog-differs-screen = { $cycle } = { $there } 时，循环显示测量结果画面，_CHBIT[11] = 1 时还等待 NC 启动。JOG 在屏幕中显示结果。
jog-differs-repeats = { $cycle } = { $there } 时，循环在超出极限时最多重复测量四次，_CBIT[1] = 1 时先执行 M0。JOG 没有极限。
jog-differs-offset-angle = { $cycle } = { $there } 时，循环还把单向测头转动 _CORA。JOG 不转动。
jog-differs-speeds = { $cycle } = { $there } 时，循环从 _MFS[] 读取旋转刀具的转速和进给。JOG 由 E_MESS_MAX_V 等数据计算。
jog-differs-erases = { $cycle } = { $there } 时，循环先删除 _WP[]、_TP[] 和其他测头数据。JOG 保留这些数据。
jog-differs-watches-calibration = { $cycle } = { $there } 时，循环也用以其他方式校准的测头测量。JOG 拒绝这种测头（61341）。
jog-differs-feeds = 在各点之间，循环以 _SPEED[1] = { $plane } mm/min 和 _SPEED[2] = { $depth } mm/min 行进，JOG 以 E_MESS_F = { $feed } 和 E_MESS_FZ = { $infeed } 行进。
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
