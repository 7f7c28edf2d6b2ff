# Terms of the manuals and what they mean.

term-actual-set-difference = 实际值与设定值之差（偏差）
term-actual-set-difference-is = 测量值减去设定值；手册公式中写作 D。循环用它与各极限比较，并由它算出补偿值；使用经验值时已计入其中。10/2004 手册中称“实际值额定值差值”。
term-additive-offset = 附加补偿（DL）
term-additive-offset-is = 一个 D 号在刀具某一使用位置上的补偿，在几何值和磨损之外起作用；它与设定补偿的关系，如同磨损与几何值的关系。由 _KNUM 选择（第 7 位为 1 或 3；D 号为 5 位时看第 9 位），_DLNUM 为其编号；_CHBIT[6]=0 且 _CHBIT[8]=0 时，循环把补偿值加到附加补偿上。10/2004 手册中称“总和补偿”。
term-asynchronous-subroutine = 异步子程序（ASUB，ASUP）
term-asynchronous-subroutine-is = 可由中断信号随时启动的程序，与当前程序的状态无关。在 JOG 中测量时以此方式运行：需要选件“跨运行方式动作”（Inter-modal actions）、MD 11602 的第 0 位，以及中断号 9（PLC SW 6.1 之前为 8），该中断号不得另作他用。
term-automatic-tool-offset = 自动刀具补偿
term-automatic-tool-offset-is = 循环自动把结果写入刀具 _TNUM 的补偿；_KNUM 含 D 号和要补偿的长度或半径，为 0 时只测量。各极限决定是否补偿、补偿多少；_CHBIT[6]=0 时写入磨损，为 1 时写入几何值。
term-basic-coordinate-system = 基本坐标系（BCS）
term-basic-coordinate-system-is = 介于机床坐标系和工件坐标系之间的坐标系。只有运动学变换（如 TRANSMIT、TRACYL、TRAORI）有效时，才与机床坐标系不同。
term-blank-measurement = 毛坯测量
term-blank-measurement-is = 加工前的工件测量：求出已装夹毛坯的位置和歪斜，并据此补偿零点偏移。即使毛坯装夹得不准，程序也在正确的位置加工。10/2004 手册中称“毛坯零件获取”。
term-calibrating-tool = 校准刀具
term-calibrating-tool-is = 尺寸准确已知的刀具，通常为圆柱销，用来求出刀具测头的触发点；铣床为类型 1xy（JOG 中为 120），车床为类型 5xy、刀沿位置 3，长度算到测球圆周。磨损为 0；其尺寸误差会计入以后测量的每把刀具。
term-calibration = 校准
term-calibration-is = 求出测头的触发位置并存入其数据：工件测头为 _WP，刀具测头为 _TP 或 _TPW。首次使用前以及测头每次改动后都要校准，进给、平面和主轴位置须与以后测量时相同。
term-collision-monitoring = 碰撞监控
term-collision-monitoring-is = _CHBIT[2]=1 时，循环在定位时监控测头信号：一旦碰到，各轴停止，报警 61302。此时以 _SPEED[1]、_SPEED[2] 定位，各轴须能在测头允许的偏转量内停下；_CHBIT[2]=0 时不监控。10/2004 手册中称“防撞监控装置”。
term-cutting-edge-position = 刀沿位置（SL）
term-cutting-edge-position-is = 表示刀尖或工件测头测球所处方向的代码。测量循环可测量刀沿位置 1 到 8 的车刀；车床上工件测头为 5 到 8，校准刀具为 3。
term-data-blocks-for-measuring-cycles = 测量循环数据块
term-data-blocks-for-measuring-cycles-is = 含循环全部数据的定义文件：GUD5 为调用参数、结果、经验值和平均值，GUD6 为机床设置和测头数据，GUD7 和 GUD7_MC 为在 JOG 中测量的数据。由机床制造商在调试时装入并调整；断电后数值仍保存。10/2004 手册中称“测量循环数据模块”。
term-deceleration-path = 减速行程，制动距离（sb）
term-deceleration-path-is = 测头触发后轴还要走过的距离：到发出制动命令的延迟、制动过程和跟随误差三部分。测头允许的偏转量不得小于它，否则测头会损坏；因此它限制测量进给。10/2004 手册中称“制动行程”。
term-delete-distance-to-go = 删除剩余行程（DDTG）
term-delete-distance-to-go-is = 测头触发时，控制系统使轴停止，并删除测量程序段的剩余行程。以触发瞬间存储的位置为准，而不是轴停下的位置。
term-differential-measurement = 差值测量
term-differential-measurement-is = 第一点触碰两次：主轴转过 180° 一次，原位置一次；位置偏差抵消，因此测头不必校准。需要多向测头和可定位的主轴；用于 CYCLE978（_MVAR 千位为 1）和 CYCLE998（_MVAR=1105）。
term-dimension-difference-check = 尺寸差检查（允许尺寸差）
term-dimension-difference-check-is = 偏差超过此极限时不作补偿：输出信息 62306，程序继续（_CBIT[2]=1 时按 NC START 后才继续）。原因多为刀具磨损或破损；_TDIF 应大于公差、小于 _TSA。10/2004 手册中称“尺寸差值控制”。
term-empirical-value = 经验值
term-empirical-value-is = 测量中已知的固定偏差，存于 _EV[]，由 _EVNUM 选择。检查各极限之前，循环先从测量值中减去经验值（_CHBIT[5]=1 时加上）：用于自动刀具补偿、补偿零点偏移的单点测量和刀具测量。
term-following-error = 跟随误差
term-following-error-is = 移动中的轴落后于指令位置的距离：速度除以伺服增益 Kv。它使减速行程变长，但不计入测量结果，因为存储的是实际位置。10/2004 手册中称“拖动距离”。
term-frame = 坐标框架（FRAME）
term-frame-is = 可同时包含旋转、镜像和比例的零点偏移；基本坐标框架、系统坐标框架、可设定和可编程坐标框架依次叠加。测量时不得有比例系数有效（报警 61310）；某些循环和测量方式也不允许旋转或镜像。
term-gauging-block = 校准体
term-gauging-block-is = 尺寸和位置已知的物体，在车床上用来校准工件测头：通常是一对基准槽，一个用于刀沿位置 7，一个用于 8。数据在 _KB[] 中，按机床坐标，X 为半径；_CALNUM 选择数据组。
term-log-of-measuring-results = 测量记录
term-log-of-measuring-results-is = 零件程序存储器中的文件，从 CYCLE100 到 CYCLE101，每个测量循环都把结果写入其中；文件名在 _PROTNAME[1] 中。可从控制系统读出，作为测量的凭证。10/2004 手册中称“测量结果记录”。
term-mean-value = 平均值
term-mean-value-is = 逐件偏差的加权移动平均值，跟随磨损等趋势：新值 = 旧值 −（旧值 − 偏差）/_K。不超过 _TMV 的偏差计入其中；超过 _TZL 时作为刀具补偿，存储器清零；只有 _CHBIT[4]=1 且 _EVNUM 大于 0 时才保存在 _MV[] 中。
term-measure-workpiece = 工件测量
term-measure-workpiece-is = 测头像刀具一样移到已装夹的工件处并触碰工件。结果可用来补偿加工该表面的刀具，或补偿零点偏移。10/2004 手册中称“测量工件”。
term-measurement-path = 测量行程
term-measurement-path-is = 从测量程序段起点到预期位置的距离；程序段终点在其后同样距离处，因此测头必须在两倍 _FA 之内触发，否则报警 61301。始终以 mm 为单位，英制时也一样。10/2004 手册中称“测量路径”。
term-measurement-result-display = 测量结果画面
term-measurement-result-display-is = 循环显示设定值、实际值和偏差的画面；_CHBIT[10]=1 时接通。_CHBIT[11]=1 时程序等待 NC START；为 0 时画面在循环结束时关闭，若 _CHBIT[18]=1 则保留到下一个测量循环。10/2004 手册中称“测量结果图”。
term-measuring-at-an-angle = 成角度测量
term-measuring-at-an-angle-is = CYCLE979 沿工件坐标系中由角度给定的方向测量孔、轴（外圆）、槽或凸台，而不是沿坐标轴。_STA1 为第一点与横坐标所成的角度，逆时针为正。10/2004 手册中称“在一定的角度下测量”。
term-measuring-accuracy = 测量精度
term-measuring-accuracy-is = 取决于机床和测头的重复精度以及测量系统的分辨率；在线触发测量时，控制系统另有 ±1 µm。信号延迟会使结果偏移，进给越低偏移越小；因此测量进给应与校准时相同。10/2004 手册中称“测量精确度”。
term-measuring-axis = 测量轴
term-measuring-axis-is = 测头测量时移动所沿的轴：1 横坐标，2 纵坐标，3 垂直坐标。对应哪些轴由平面决定：G17 为 X、Y、Z，G18 为 Z、X、Y，G19 为 Y、Z、X。
term-measuring-direction = 测量方向
term-measuring-direction-is = 测头沿测量轴移动的方向：0 正，1 负。起点不能决定方向时需要给出，例如在表面上校准工件测头时。10/2004 手册中称“测砧方向”。
term-measuring-in-jog = 在 JOG 中测量
term-measuring-in-jog-is = 铣床上的半自动测量：用软键选择任务，填写输入画面，把轴移到测量点附近，按 NC 启动。用来设定零点偏移、刀具长度或半径，也可校准测头；设置在 _JM_I[]、_JM_B[] 和各 E_MESS_… 数据中。
term-measuring-tool = 刀具测量
term-measuring-tool-is = 刀具移到固定安装或可转入加工区的刀具测头处，其长度或半径写入刀具补偿：_CHBIT[3]=0 时写入几何值，磨损清零；为 1 时把偏差写入磨损。_TP[] 为机床坐标系中的测头数据，_TPW[] 为工件坐标系中的测头数据。
term-measuring-variant = 测量方式
term-measuring-variant-is = 一个数字，各位决定循环测量什么、补偿什么；每个循环有各自的测量方式。循环没有的测量方式会引起报警 61307。10/2004 手册中称“测量方案”。
term-measuring-velocity = 测量速度，测量进给
term-measuring-velocity-is = 测量程序段中的进给。轴须能在测头允许的偏转量内停下；校准和测量应使用相同的进给。
term-mono-probe = 单向测头
term-mono-probe-is = 只在一个方向触发的测头；_PRNUM 的百位为 1。只用于铣床上的工件，且精度要求不高：主轴须能用 SPOS 定位，并为每个方向转动测头，因此费时；信号须在任何角度都能传送。10/2004 手册中称“单测量头”。
term-multi-probe = 多向测头
term-multi-probe-is = 在三个轴的各方向都触发的测头；_PRNUM 的百位为 0。用于铣床和车床上的工件，也用于车刀；若触碰点与校准时为测球上的同一点，结果最准。10/2004 手册中称“多测量头”。
term-multiple-measurement-at-one-place = 同一位置多次测量
term-multiple-measurement-at-one-place-is = 循环对每个点触碰 _NMSP 次，取算术平均值。可减小随机偏差，但不能消除固定误差，并且耗时更长。10/2004 手册中称“同一地点上多次测量”。
term-offset-angle-position = 补偿角
term-offset-angle-position-is = 循环修正单向测头主轴位置的角度，单位为度，使其触发方向正确；_CBIT[8]=1 时有效。CYCLE982 测量铣刀时，用来修正 180° 换向后的主轴位置。10/2004 手册中称“校正角位置”。
term-offset-axis = 偏移轴
term-offset-axis-is = 循环在两个测量点之间移动所沿的轴；_MA 的百位为其编号：102 表示偏移轴 1、测量轴 2。例如 CYCLE998 用于测角度时两点间的距离，CYCLE971 也使用。10/2004 手册中称“位移轴”。
term-on-the-fly-measurement = 在线触发测量（飞测）
term-on-the-fly-measurement-is = NC 直接处理测头信号，在触发瞬间存储轴的位置，此时轴仍在移动。延迟小，因此在同样精度下可用更高的测量进给。10/2004 手册中称“飞行测量”。
term-oversize = 尺寸偏大（超出公差上限）
term-oversize-is = 偏差超过公差上限 _TUL：信息 62304；_KNUM 不为 0 时立即补偿，不经平均值；_CBIT[2]=1 时程序等待 NC START。外圆偏大可以再加工，孔偏大则不能。10/2004 手册中称“加工余量”。
term-paraxial-measurement = 平行于轴的测量
term-paraxial-measurement-is = 沿平行于工件坐标系各轴的方向测量：CYCLE977 用于孔、轴（外圆）、槽、凸台或矩形，CYCLE978 用于表面。被测要素歪斜时结果错误：请先找正坐标系，或成角度测量。10/2004 手册中称“测量轴向平行”。
term-positional-deviation = 位置偏差
term-positional-deviation-is = 测球中心到主轴轴线的距离，按横坐标和纵坐标给出。由校准求出，测量循环将其计入；存储值只适用于校准时的主轴位置。
term-probe-ball-diameter = 测球直径
term-probe-ball-diameter-is = 循环计算所用的测球有效直径。它包含触碰到触发之间的行程，因此不等于千分尺测得的尺寸；由校准求出，CYCLE979 必须使用它。10/2004 手册中称“测量头球直径”。
term-probe-type = 测头类型
term-probe-type-is = 按触发方向分为多向、双向和单向测头；测量工件时双向测头按单向测头处理。须使用触发式测头，偏转期间信号持续且基本无抖动；短脉冲不行。10/2004 手册中称“测量头类型”。
term-protection-zone = 保护区
term-protection-zone-is = 以设定中心为中心的区域（CYCLE994 中给出其边界）。孔、槽内为测头不得进入的障碍物；外圆、凸台周围为测头不得离开的可用空间，被测要素也算在内；测球放不下时报警 61334。
term-reference-groove = 基准槽
term-reference-groove-is = 固定在机床上、位置准确已知的槽，在车床上用 CYCLE973 校准工件测头。槽边和槽底在 _KB[] 中，按机床坐标，X 为半径；其误差会计入以后的每次测量。
term-repeat-accuracy = 重复精度
term-repeat-accuracy-is = 重复触碰同一位置时的分散，包括机床、测头和信号传送。每台机床都应测定，至少触碰十次；_TZL 不应小于最大随机偏差。10/2004 手册中称“机床重复精度”。
term-safe-area = 安全区
term-safe-area-is = 最外层的极限：偏差超过它，说明测头、设定值或装夹有误，而不是尺寸不对；首次校准工件测头时，它必须大于测球半径。报警 61303 使程序停止，直到 NC RESET，不作补偿；_CBIT[0]=1 时先重复测量，最多四次。10/2004 手册中称“置信区域”。
term-servo-gain = 伺服增益（Kv）
term-servo-gain-is = 轴的速度与跟随误差之比，单位 (m/min)/mm。值越大，减速行程越短；以参与测量各轴中的最小值为准。10/2004 手册中称“回路放大”。
term-setpoint = 设定值
term-setpoint-is = 图纸上的位置或尺寸，测头应在此触发；_SETV[] 含其他设定值，如矩形的长度。按当前有效的单位制（英制或公制）给出；若有错误，会出现报警 61301 或 61303，或使没有问题的刀具被补偿。10/2004 手册中称“额定值”。
term-setup-offset = 设定补偿（DL）
term-setup-offset-is = 一个 D 号在某一使用位置上的补偿，调整机床时输入，选择方法与附加补偿相同；MD 18112 没有第 4 位时不可用（报警 61409）。_CHBIT[8]=1 时，循环把补偿值加到设定补偿上；_CHBIT[8]=0 且 _CHBIT[6]=1 时，附加补偿也并入其中，然后清零。10/2004 手册中称“设备补偿”。
term-tolerance-bottom-limit = 公差下限
term-tolerance-bottom-limit-is = 图纸给出的下限，带符号，相对于设定值，按当前有效的单位制。偏差低于它时输出信息 62305，刀具立即补偿，不经平均值。
term-tolerance-top-limit = 公差上限
term-tolerance-top-limit-is = 图纸给出的上限，带符号，相对于设定值，按当前有效的单位制。_TUL 与 _TLL 不对称时，循环以公差带的中值为设定值；大于 _TMV（通常为公差的三分之二）、不超过 _TDIF 的偏差立即补偿，平均值清零。
term-tool-environment = 刀具环境
term-tool-environment-is = 刀具工作时的条件（平面、长度分配、各项设置），用 TOOLENV 以名称存储，名称最多 32 个字符；从 NCK SW 6.3 起。以后测量时用 _TENV，可按刀具当时的使用条件补偿，即使平面或长度分配已改变；T 号、D 号和 DL 号可取自其中。
term-tool-name = 刀具名称
term-tool-name-is = 使用刀具管理时，可用名称代替编号指定要补偿的刀具。只有 _TNUM 为 0 时有效：以前调用设过的 T 号优先。
term-tool-number = 刀具号（T 号）
term-tool-number-is = 测量后要补偿的刀具的编号。必须是加工被测表面的刀具，而不是主轴中的测头。10/2004 手册中称“刀具号码”。
term-trigger-point = 触发点
term-trigger-point-is = 测头触发时的位置，按轴和方向分别存储。刀具测头存储的是位置本身，按机床坐标（_TP）或工件坐标（_TPW）；工件测头存储的是与表面真实位置的差值（_WP）。10/2004 手册中称“触发器点”。
term-undersize = 尺寸偏小（低于公差下限）
term-undersize-is = 偏差低于公差下限 _TLL：信息 62305；_KNUM 不为 0 时立即补偿，不经平均值；_CBIT[2]=1 时程序等待 NC START。孔偏小可以再加工，外圆偏小则不能。10/2004 手册中称“尺寸不足”。
term-variable-measuring-speed = 可变测量速度
term-variable-measuring-speed-is = 作为调用参数的测量进给：大于 0 时按输入值，单位为基本单位制的 mm/min 或 inch/min；为 0 时由循环选择，_FA=1 时 150 mm/min，行程更长时 300 mm/min。10/2004 手册中称“变量测量速度”。
term-weighting-factor = 加权系数
term-weighting-factor-is = 单个偏差使平均值移动多少：移动二者之差的 1/_K。为 1 时立即跟随每个偏差，值越大越平稳，但也越慢；为 0 时报警 61318。10/2004 手册中称“生成平均值的加权函数”。
term-wear = 磨损
term-wear-is = 刀具补偿的一部分，与几何值相加，用来存放补偿量，几何值不变。工件测量在 _CHBIT[6]=0 时写入磨损，刀具测量在 _CHBIT[3]=1 时写入；为另一值时写入几何值，磨损清零。
term-zero-offset = 零点偏移（ZO）
term-zero-offset-is = 工件零点在机床坐标系中的位置，用 G54 到 G57 或 G505 到 G599 调用。有粗偏移和精偏移时取两者之和；循环所作的补偿在重新编程 G 功能后生效，_KNUM=9999 时立即生效。
term-zero-offset-area = 零补偿区
term-zero-offset-area-is = 随机偏差的大小：不超过 _TZL 的值不作补偿，使补偿不跟随偶然误差；与零点偏移无关。自动刀具补偿时用平均值与它比较，平均值继续累计；刀具测量时用偏差本身比较。10/2004 手册中称“零校准区域”。
term-zo-determination = 零点偏移测定
term-zo-determination-is = 循环补偿 _KNUM 指定的零点偏移，使被测要素处于设定值。各极限中只有 _TSA 有效；有精偏移时补偿写入精偏移，但 _CHBIT[21]=1、_KNUM=2000 以及 CYCLE961 时写入粗偏移。10/2004 手册中称“NV 确定”。
term-computerized-numerical-control = 计算机数控（CNC）
term-computerized-numerical-control-is = 由计算机读取程序、计算轨迹并控制各轴的数控系统。现在与 NC 同义。10/2004 手册中称“计算机数字控制”。
term-central-processing-unit = 中央处理器（CPU）
term-central-processing-unit-is = 计算机中执行指令的部分。一套控制系统通常有多个：分别用于 NC、PLC 和操作界面。
term-german-industry-standard = 德国工业标准（DIN）
term-german-industry-standard-is = 测量循环要求机床轴符合 DIN 66217，即关于轴名称和方向的标准。
term-disk-operating-system = 磁盘操作系统（DOS）
term-disk-operating-system-is = 早期 PC 的操作系统，用键入的命令操作。在控制系统上也是一种文本格式的名称：测量结果画面的文本格式在文件 MBDDE.INI 中设定。
term-differential-resolver-function = 差动旋转变压器功能（DRF，手轮叠加）
term-differential-resolver-function-is = 程序运行时用手轮使轴产生附加偏移。它与测量无关。10/2004 手册中称“直接测量功能”。
term-function-module-numerical-control = 功能模块数控（FM-NC）
term-function-module-numerical-control-is = 小型 SINUMERIK 控制系统，做成 SIMATIC S7-300 PLC 的一个模块。10/2004 手册中称“功能模块数字控制”。
term-global-user-data = 全局用户数据（GUD）
term-global-user-data-is = 所有程序都可读写的变量，整个控制系统一份，或每个通道一份。断电后数值仍保留：调用没有写入的参数仍为以前调用的值。
term-input-output = 输入/输出（I/O）
term-input-output-is = 控制系统与机床之间的信号。其中两个输入用于触发式测头：_CHBIT[0] 选择工件测头的输入，_CHBIT[1] 选择刀具测头的输入。
term-start-up = 调试（IBN）
term-start-up-is = 装入循环和定义文件，设置机床数据，连接并测试测头。IBN 是德语 Inbetriebnahme 的缩写。10/2004 手册中称“开机调试”。
term-set-up-mode = JOG 方式
term-set-up-mode-is = 操作者用方向键或手轮移动各轴以调整机床的运行方式。10/2004 手册中称“Jog 运行调试运行”。
term-local-user-data = 局部用户数据（LUD）
term-local-user-data-is = 一个程序或循环的变量，只在其运行期间存在；测量循环用它们计算。为其预留的存储器（MD 28020、MD 28040）不足时，程序在调用处停止。
term-machine-coordinate-system = 机床坐标系（MCS）
term-machine-coordinate-system-is = 机床各轴的坐标系；位置从机床零点算起，与零点偏移无关。基准槽（_KB）和在机床坐标系中校准的刀具测头（_TP）按此坐标系存储。
term-machine-data = 机床数据（MD）
term-machine-data-is = 带编号的设置，机床制造商用来使控制系统适应机床。改变存储器分配会删除数据（报警 4400）：请先保存批量调试存档，之后重新读入。
term-man-machine-communication = 人机通讯（MMC）
term-man-machine-communication-is = SINUMERIK 操作界面及其硬件的旧称，用于操作、编程和模拟；后来称为 HMI。在 JOG 中测量需要 MMC 103 或 HMI Advanced。
term-microsoft = 微软（MS）
term-microsoft-is = 软件公司；该缩写见于 MS-DOS 等名称。
term-numerical-control = 数控（NC）
term-numerical-control-is = 用数字程序控制机床；也指控制系统中执行程序、移动各轴的部分，区别于 PLC 和操作界面。10/2004 手册中称“数字控制”。
term-numerical-control-kernel = 数控内核（NCK）
term-numerical-control-kernel-is = NC 的核心软件：处理程序段，计算运动，控制各轴。有效范围为 NCK 的用户数据（如 _CBIT[]）为所有通道共用一份。10/2004 手册中称“数字控制内核”。
term-numerical-control-unit = 数控单元（NCU）
term-numerical-control-unit-is = 运行 NCK 的硬件单元。10/2004 手册中称“数字控制单元”。
term-data-exchange-software = 数据交换软件（PCIN）
term-data-exchange-software-is = 西门子的 PC 软件，与控制系统交换程序、存档等数据，通常经由 V.24。10/2004 手册中称“与控制系统进行数据更换的软件名称”。
term-programming-device = 编程器（PG）
term-programming-device-is = 西门子便携式计算机，用于 PLC 的编程和测试。
term-programmable-logic-control = 可编程逻辑控制器（PLC）
term-programmable-logic-control-is = 控制系统中负责 NC 周边机床功能的部分，如换刀、冷却和装夹。可由它查看测头信号是否到达：DB10 DBX107.0 表示测头 1 已偏转，DBX107.1 表示测头 2。
term-subprogram = 子程序（SR，UP）
term-subprogram-is = 由其他程序调用的程序；测量循环就是子程序。最深可在第 5 级程序中调用，因为它们自己还要调用子程序。
term-software = 软件（SW）
term-software-is = 后面的数字为版本。NCK、操作界面和测量循环各有自己的版本：SW 6.2 起的循环需要 NCK SW 6.3 或更高版本。
term-tool-offset = 刀具补偿（TO）
term-tool-offset-is = 一个刀沿在其 D 号下的数据：刀具类型、刀沿位置、长度、半径及其磨损。控制系统由此计算刀具路径，因此这里的误差就是工件的误差。
term-tool-offset-active = 有效刀具补偿（TOA）
term-tool-offset-active-is = 控制系统保存刀具补偿的文件类型。10/2004 手册中称“刀具补偿有效”。
term-user-interface = 操作界面（UI，BOF）
term-user-interface-is = 操作者在控制系统上使用的画面和按键。
term-serial-interface = 串行接口（V.24）
term-serial-interface-is = 与 PC 逐位交换数据的接口，也称 RS-232-C。在较早的控制系统上用来装入循环和定义文件，读出测量记录文件。
term-workpiece-coordinate-system = 工件坐标系（WCS）
term-workpiece-coordinate-system-is = 工件的坐标系，由有效的坐标框架确定其在机床中的位置；程序和工件测量的设定值都以它为准。在其中校准的刀具测头（_TPW）只在校准时的零点偏移下正确。
