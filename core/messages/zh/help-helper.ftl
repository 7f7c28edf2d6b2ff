# 不产生运动的循环的帮助页：测量记录（CYCLE100、101、105、106、113、118），圆和位置（CYCLE116、119）。

help-log-data = 记录的内容和格式由机床的用户数据决定，这些数据在各程序之间保持其值：只需写出不同之处。
help-log-title = 只写了一个标题行：第二行仍显示以前记录的标题。请在 _PROTVAL[1] 中写入带引号的空格。
help-log-column = 数值的宽度超过列宽：控制系统加宽该列并输出信息 62309；各列不再上下对齐。
help-log-line = 列数乘以列宽超过 200 个字符：报警 61371。
help-log-name = _PROTNAME[1] 指定文件名：字母、数字和下划线，以两个字母或一个字母加下划线开头。扩展名 MPF 会自动加上；目录是调用程序所在的目录。
help-log-files = 测量记录文件。超出 MD 11420 规定大小（KB）的内容写入后续文件，最多九个，其名称以下划线和一个数字结尾。
help-log-full = 第十个文件也写满：程序停止，要求输入新的记录名称；按 NC START 后继续。
help-log-refused = 文件没有名称（报警 61354），文件正被其他程序使用（61356），或其目录不存在（61353）。
help-log-header = 记录头：日期、时间和页码，程序 _PROTNAME[0]，自定义行 _HEADLINE[0] 等，标题行 _PROTVAL[0] 和 _PROTVAL[1]。_CBIT[11]=1 时只有自定义行。
help-log-block = 一个数值组：测量循环的名称及其 _MVAR（_CBIT[6]=1 时不写），然后是 _PROTFORM[4] 规定的数值行数。超出 _TSA、_TDIF、_TUL 或 _TLL 的实际值和偏差带有 _PROTSYM[1] 标记。
help-log-chosen = _PROTVAL[2] 到 _PROTVAL[5] 指定各行的内容：_OVR 中的结果、R 参数、文本。另一个测量循环或测量方式有不同的结果。

help-cycle100-does = 接通测量记录：从此调用到 CYCLE101，每个测量循环都加入一个数值组。轴不移动。
help-cycle100-values = 每次测量调用之前，请在 _PROTVAL[2] 到 _PROTVAL[5] 中指定各行的内容：另一个循环或测量方式有不同的结果。
help-cycle100-begin = 删除同名文件并重新创建；CYCLE100 为此调用 CYCLE106。
help-cycle100-each = 此后每次测量调用都自动写入其数值组；程序不必调用其他记录循环。
help-cycle100-lost = 上一个工件的记录没有读出：该记录会被删除。请为每个工件使用单独的文件名。
help-cycle100-old = 以前记录的后续文件保留，直到本次记录需要其名称：其内容不属于这个工件。

help-cycle101-does = 关闭由 CYCLE100 接通的测量记录。轴不移动。
help-cycle101-last = 应写入记录的最后一次测量调用已完成。
help-cycle101-flag = 清除记录已接通的标志；此后的测量循环不再写入。
help-cycle101-files = 记录文件，现在可以读出。
help-cycle101-missing = 缺少此调用：以后的测量也写入记录，并且文件不能读出。

help-cycle105-header = 不通过测量循环，把记录头写入记录。轴不移动。
help-cycle105-values = 不通过测量循环，把最多四行的数值组写入记录，例如在自己的计算之后。轴不移动。
help-cycle105-open = 记录已接通：已调用 CYCLE100。测量循环自动写入，不需要 CYCLE105。
help-cycle105-left-header = 记录文件中多一个记录头。
help-cycle105-left-values = 记录文件中多一个数值组。
help-cycle105-number = CYCLE106 的任务编号与此不同：其中 2 是数值组。手册的一个版本中这里的 0 和 1 顺序相反；请在控制系统上试一次。

help-cycle106-header = 把记录头写入记录，并管理其文件和页。轴不移动。
help-cycle106-values = 把数值组写入记录，并管理其文件和页。轴不移动。
help-cycle106-alone = 程序中没有测量循环而要作记录；有测量循环时，用 CYCLE100 和测量调用即可。
help-cycle106-keeps = 需要时删除同名的旧文件，文件写满时打开下一个文件，达到 _PROTFORM[0] 行后另起一页（为 0 时不另起）。
help-cycle106-number = PAR1 既不是 1 也不是 2：报警 61360。CYCLE105 的任务编号与此不同。

help-cycle113-date = 以文本形式读出控制系统的日期。轴不移动。
help-cycle113-time = 以文本形式读出控制系统的时间。轴不移动。
help-cycle113-variable = 由一个变量接收文本：在程序开头声明 DEF STRING[10] PAR2，或在调用中写入自己的变量名。
help-cycle113-year = 日期写为年、月、日，各两位数字，用斜线分开。
help-cycle113-hour = 时间写为时、分、秒，各两位数字，用冒号分开。
help-cycle113-left = 只有调用中变量里的文本。
help-cycle113-short = 声明的变量少于 10 个字符：循环要求 STRING[10]。

help-cycle118-does = 把一个实数按给定的小数位数转换为文本；一次最多 10 个数值。轴不移动。
help-cycle118-variable = 由一个变量接收文本：在程序开头声明 DEF STRING[12] PAR3，或在调用中写入自己的变量名。
help-cycle118-registers = 多个数值位于连续的 R 参数中；PAR5 是第一个的编号，PAR4 是个数。
help-cycle118-rounds = 一个数值：PAR1 四舍五入到 PAR2 位小数，写为文本。
help-cycle118-many = 多个数值：各 R 参数依次四舍五入到 PAR2 位小数；忽略 PAR1。
help-cycle118-left = 调用中变量里的文本。多个数值的文本在 _TXT[0] 到 _TXT[9] 中，最后一个也在该变量中。
help-cycle118-count = PAR4 大于 10：报警 61362。
help-cycle118-length = 数值连同小数位超过 12 个字符：变量容纳不下该文本。

help-cycle116-does = 由三点或四点（例如逐个测得的点）计算圆心和半径。轴不移动。
help-cycle116-variables = 请在程序开头声明两个变量：DEF REAL _DATE[13] 和 DEF INT _ALM。
help-cycle116-points = _DATE[0] 是点数；各点的横坐标和纵坐标成对写在 _DATE[1] 到 _DATE[8] 中。
help-cycle116-circle = 三点确定一个圆；四点时全部参与计算。
help-cycle116-left = 圆心在 _DATE[9] 和 _DATE[10] 中，半径在 _DATE[11] 中，状态在 _DATE[12] 中，报警号在 _ALM 中：求出圆时两者都为 0。不补偿刀具，也不补偿零点偏移。
help-cycle116-line = 各点共线或重合：_ALM 为 61316。
help-cycle116-count = _DATE[0] 既不是 3 也不是 4：_ALM 为 61317。
help-cycle116-unseen = 调用之后若不判断 _ALM，程序就带着错误的圆继续运行：报警不会使程序停止。

help-cycle119-does = 由三个点的设定位置和测得位置计算工件在空间中的位置。_COR 指定时，对一个坐标框架作平移和旋转补偿。轴不移动。
help-cycle119-variables = 请在程序开头声明各变量：DEF REAL _SETPOINT[3,3], _MEASPOINT[3,3], _RES、DEF INT _ALARM 和 DEF FRAME _REFRAME。
help-cycle119-points = 各点已逐个测量，例如用 CYCLE977 或 CYCLE997；_SETPOINT 和 _MEASPOINT 按相同的顺序包含各点在有效坐标框架中的 X、Y、Z。
help-cycle119-alarm = _ALARM 为 0。
help-cycle119-frame = 计算两个三角形之间的坐标框架。两者形状的差别，即三个点的偏差之和，写入 _RES；小于 0 表示没有坐标框架。
help-cycle119-decides = _COR=0 时不作补偿。否则在 _RES 小于 _RESLIM 时补偿一个坐标框架。
help-cycle119-left = _RES；_REFRAME 中的坐标框架，与有效坐标框架级联后把测得的各点移到设定坐标；_ALARM 中为 0 或报警号。
help-cycle119-frame-moved = _COR 指定的坐标框架的平移和旋转。1 到 99 为可设定坐标框架，1000 为最后一个有效的通道基本坐标框架，1011 到 1026 为通道基本坐标框架，2000 为系统坐标框架 $P_SETFR，9999 为有效坐标框架。
help-cycle119-again = 重新编程其 G 功能（G54 …）后，补偿后的坐标框架才生效，_COR=9999 时也是如此。
help-cycle119-line = 三个点共线，或其中两点重合：_ALARM 为 61411。
help-cycle119-distorted = 两个三角形相差不小于 _RESLIM：_ALARM 为 61414，不作补偿。
help-cycle119-order = 两组点的顺序不同：两个三角形不相符。
help-cycle119-mirrored = 坐标框架含镜像或比例：_ALARM 为 61411。
help-cycle119-absent = 没有该坐标框架：_ALARM 为 61321。没有通道基本坐标框架，而 _COR=1000，或 G500 有效时 _COR=9999：_ALARM 为 61412。
help-cycle119-unseen = 调用之后若不判断 _ALARM，程序就带着未补偿的坐标框架继续运行：报警不会使程序停止。
