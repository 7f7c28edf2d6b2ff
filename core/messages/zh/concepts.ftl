# Concepts, explained for somebody who is new to measuring cycles.

concept-group-basics = 基础

concept-measuring-cycles = 测量循环
concept-measuring-cycles-1 = 测量循环是现成的子程序，用测头完成测量。设好参数后调用，所有运动都由循环执行。
concept-measuring-cycles-2 = 测量循环分两类：工件测量时测头移向工件，刀具测量时刀具移向测头。
concept-measuring-cycles-3 = _MVAR 决定测量什么、补偿什么。设定值、测量轴和极限值由其他参数给出。
concept-measuring-cycles-4 = 结果在 _OVR（设定值、实际值、偏差）和 _OVI（循环号、测头号、报警号）中。需要时，循环还把结果写入刀具补偿或零点偏移。
concept-measuring-cycles-5 = 常见错误：某个参数仍是上次调用的值。每次调用前都应设好该任务的全部参数。

concept-workpiece-measurement = 工件测量
concept-workpiece-measurement-1 = 测头装在主轴或刀塔上，像刀具一样移向已装夹的工件。测头的 D 号必须有效。
concept-workpiece-measurement-2 = 加工前测量工件的位置，加工后测量工件的尺寸，都不必松开工件。
concept-workpiece-measurement-3 = _KNUM 决定补偿对象：刀具 _TNUM 的一个 D 号，或一个零点偏移。_KNUM=0 时只测量。
concept-workpiece-measurement-4 = _TNUM 是加工该表面的刀具，不是测头。循环对该刀具作补偿，使下一件工件尺寸正确。
concept-workpiece-measurement-5 = 常见错误：表面有切屑或切削液。循环会把它们一起测入；测量前应清洁工件。

concept-tool-measurement = 刀具测量
concept-tool-measurement-1 = 刀具移向刀具测头。刀具测头固定在机床上，或摆入加工区。
concept-tool-measurement-2 = 循环把测得的长度或半径写入当前刀具的补偿：_CHBIT[3]=0 时写入几何值，磨损置 0；_CHBIT[3]=1 时写入磨损。
concept-tool-measurement-3 = 刀具测头的位置按机床坐标存于 _TP，按工件坐标存于 _TPW。_PRNUM 选择测头。
concept-tool-measurement-4 = 偏差大于 _TZL 且小于 _TDIF 时才写入新值。刀具折断由此被发现。
concept-tool-measurement-5 = 常见错误：补偿中的初始长度只是粗略值。偏差达到 _TDIF 时不作补偿：新刀具应加大 _TDIF 和 _TSA。

concept-prerequisites = 调用的前提条件
concept-prerequisites-1 = 调用循环前，机床、数据和程序必须准备好。初次使用时的故障多半出在以下几点。
concept-prerequisites-2 = 机床：各轴符合 DIN 66217，机床数据已调整，已回参考点。
concept-prerequisites-3 = 数据：GUD5 和 GUD6 已生效，在 JOG 中测量还需要 GUD7。循环位于标准循环目录中。
concept-prerequisites-4 = 程序：G40 有效，参数已全部设好，调用不深于第 5 程序级。
concept-prerequisites-5 = 起点：测头沿直线无碰撞地到达。
concept-prerequisites-6 = 单位制：工艺数据可切换时，程序可不用基本单位制：公制控制系统用 G70 或 G700，英制控制系统用 G71 或 G710。
concept-prerequisites-7 = 常见错误：刀具半径补偿仍有效。调用前编程 G40。

concept-skip-and-simulation = 空运行、程序测试、程序段搜索、模拟
concept-skip-and-simulation-1 = 在某些运行方式下程序照常运行，但测量循环被跳过。此时既不测量，也不补偿。
concept-skip-and-simulation-2 = 空运行和程序测试时跳过；程序段搜索时也跳过，$A_PROTO=1 时除外。至 SW 6.2，模拟时一律跳过。
concept-skip-and-simulation-3 = SW 6.2 以后，HMI Advanced 的模拟执行循环；_MC_SIMSIM=0 时跳过。_MC_SIMDIFF 为模拟的测量点给出偏差。
concept-skip-and-simulation-4 = Jobshop 产品模拟测量，但不写补偿、不显示结果、不监控碰撞，也不写测量记录。
concept-skip-and-simulation-5 = 常见错误：_MC_SIMDIFF 大于调用中的极限值。模拟会以循环的报警停止。

concept-group-coordinates = 坐标系与平面

concept-coordinate-systems = 机床坐标系和工件坐标系
concept-coordinate-systems-1 = 机床坐标系（MCS）以机床零点 M 为原点。其实际值是刀具参考点 F 的位置。
concept-coordinate-systems-2 = 工件坐标系（WCS）以工件零点 W 为原点。其实际值是刀尖的位置，使用测头时通常是测球中心的位置。
concept-coordinate-systems-3 = 工件在 WCS 中测量，与图纸的标注一致。刀具在 MCS 中测量更方便，因为刀具测头在其中位置固定。
concept-coordinate-systems-4 = 两个坐标系可分别设为英制或公制。_TP 存放 MCS 中的刀具测头，_TPW 存放 WCS 中的刀具测头。
concept-coordinate-systems-5 = 常见错误：在 WCS 中校准刀具测头后又改变零点偏移。_TPW 中存储的触发点因此不再正确。

concept-bcs = 基本坐标系
concept-bcs-1 = 基本坐标系（BCS）介于机床坐标系和工件坐标系之间。零点偏移以它为基础。
concept-bcs-2 = 只有运动学变换（例如 TRANSMIT、TRACYL 或五轴变换）有效时，它才与 MCS 不同。
concept-bcs-3 = 循环的说明以没有变换有效为前提。此时 MCS 与 BCS 相同。
concept-bcs-4 = 常见错误：校准或测量时变换仍有效。校准和测量应在相同状态下进行。

concept-frames = 零点偏移和坐标框架
concept-frames-1 = 零点偏移是工件零点 W 在 MCS 中的位置。它与旋转、镜像和比例一起构成坐标框架。
concept-frames-2 = 基本、系统、可设定（G54）和可编程坐标框架构成一条链。整条链共同决定循环测量所用的 WCS。
concept-frames-3 = _KNUM 选择要补偿的坐标框架：1 到 4 为 G54 到 G57，5 到 99 为 G505 到 G599，9999 为有效坐标框架。
concept-frames-4 = 只有 9999 立即生效。使用其他编号时，请在循环后编程 G54 等指令，使新值生效。
concept-frames-5 = 比例系数不得有效：报警 61310。旋转和镜像只在部分循环中允许。
concept-frames-6 = 常见错误：循环补偿的是 G55，程序却用 G54。补偿已写入，但不起作用。

concept-planes = 平面、横坐标、纵坐标、垂直坐标
concept-planes-1 = 平面决定各轴的作用。横坐标和纵坐标是平面的第 1、第 2 轴，垂直坐标与平面垂直。
concept-planes-2 = G17：横坐标 X，纵坐标 Y，垂直坐标 Z。G18：Z、X、Y。G19：Y、Z、X。
concept-planes-3 = _MA 按此顺序计数：1 横坐标，2 纵坐标，3 垂直坐标。_MA=1 时，G17 中测 X，G18 中测 Z。
concept-planes-4 = 车床用 G18；G17 和 G19 用于车床上的铣削。因此 X 方向的直径对应 _MA=2。
concept-planes-5 = 常见错误：有效平面不对。循环因此移动另一个轴，刀具长度也作用在另一个轴上。

concept-tool-lengths = 刀具长度与平面、类型的关系
concept-tool-lengths-1 = 一把刀具最多有三个长度。每个长度作用在哪个轴上，由平面和刀具类型决定。
concept-tool-lengths-2 = 铣刀、钻头和测头（类型 1xy、2xy、710）：L1 作用在垂直坐标，L2 在纵坐标，L3 在横坐标。G17 为 Z、Y、X，G18 为 Y、X、Z，G19 为 X、Z、Y。
concept-tool-lengths-3 = L2 和 L3 只在特殊情况下使用，例如角度铣头。
concept-tool-lengths-4 = 车刀（类型 5xy）在 G18 中：L1 作用在 X（纵坐标），L2 作用在 Z（横坐标）。
concept-tool-lengths-5 = 车床上的钻头和铣刀通常使用 SD 42950 = 2：其长度的作用与车刀相同。
concept-tool-lengths-6 = 常见错误：加工时和测量时的 SD 42950 不同。测得的值因此写入了错误的长度。

concept-milling-on-lathe = 车床上的铣削
concept-milling-on-lathe-1 = 带动力刀具的车床可以铣削。没有 Y 轴时，用 TRANSMIT 铣端面，用 TRACYL 铣圆柱面。
concept-milling-on-lathe-2 = 循环原则上支持变换。支持到什么程度，见各循环的说明。
concept-milling-on-lathe-3 = 有第 3 几何轴的车床也能运行铣床的工件测量循环。此时测头类型为 5xy，刀沿位置为 5 到 8，SD 42950 为 2。
concept-milling-on-lathe-4 = 刀沿位置为 5 或 7 时在 G17 中测量，6 或 8 时在 G19 中测量。
concept-milling-on-lathe-5 = 常见错误：调用铣削测量循环时，车削用的 G18 仍有效。调用前编程平面和 D 号。

concept-group-probes = 测头

concept-probe-types = 测头类型：多向、双向、单向
concept-probe-types-1 = 触发式测头在测球偏转时改变信号。信号不得抖动，并且在偏转期间必须一直保持；只有脉冲不够。
concept-probe-types-2 = 多向测头在各方向都触发，双向测头在两个相反的方向触发，单向测头只在一个方向触发。
concept-probe-types-3 = 工件测量时，_PRNUM 的百位给出类型：0 为多向，1 为单向或双向。_PRNUM=102 表示使用第二组数据 _WP[1,…] 的单向测头。
concept-probe-types-4 = 工件测量把双向测头当作单向测头处理。两者用时都更长，因为循环要多次转动主轴。
concept-probe-types-5 = 常见错误：公差要求严却用单向测头。单向和双向测头只适合精度要求不高的测量。

concept-probe-assignment = 各类测头的用途
concept-probe-assignment-1 = 并非每种测头都适合每种机床。测头需要在几个方向触发，由任务决定。
concept-probe-assignment-2 = 多向测头处处可用：车床的刀具和工件、铣床的工件。
concept-probe-assignment-3 = 双向测头可测量车床和铣床的工件，单向测头只能测量铣床的工件。
concept-probe-assignment-4 = _PRNUM 必须与实际使用的测头一致。有些测量方式（例如差值测量）只能用多向测头。
concept-probe-assignment-5 = 常见错误：_PRNUM 设为多向，而测头只在一个方向触发。此时触碰而没有信号，测头可能损坏。

concept-mono-probe = 单向测头
concept-mono-probe-1 = 单向测头只在一个方向触发。循环转动主轴，使这个方向对着表面。
concept-mono-probe-2 = 主轴必须能够定位（SPOS），并且在 360° 的任意角度都能传送信号。
concept-mono-probe-3 = 在主轴中找正测头，使其在 0° 时于 G17 中朝 +X 测量，G18 中朝 +Z，G19 中朝 +Y。
concept-mono-probe-4 = 无法准确找正时，循环以角度 _CORA 修正主轴位置。只在 _CBIT[8]=1 时有效。
concept-mono-probe-5 = 常见错误：输入了 _CORA，但 _CBIT[8] 为 0。触碰偏离测头的触发方向，测得值因此分散。

concept-signal-transmission = 信号传送
concept-signal-transmission-1 = 测头信号从主轴传到机床立柱上的接收器：通过无线电、红外线或电缆。
concept-signal-transmission-2 = 有些型号只在特定的主轴位置或范围内能传送。以测头或机床制造商的说明为准。
concept-signal-transmission-3 = 使用单向测头、换向以及 _CHBIT[13]=1 且坐标系旋转时，循环会转动主轴。在这些角度上也必须能传输信号。
concept-signal-transmission-4 = 常见错误：手动触发正常，在工件深处却没有信号。没有信号时轴走到测量程序段终点，随后报警 61301。

concept-group-tools = 作为刀具的测头和校准刀具

concept-workpiece-probe-mill = 铣床的工件测头
concept-workpiece-probe-mill-1 = 测头是带 T 号和 D 号的刀具。类型为 710（3D 测头，自 SW 4）或 1xy。
concept-workpiece-probe-mill-2 = 输入长度 1（DP3）和测球半径（DP6），基本长度（DP21）只在需要时输入。磨损和其余各值为 0。
concept-workpiece-probe-mill-3 = _CBIT[14] 规定长度 1 的终点：0 为测球中心，1 为测球末端。输入的长度必须与此一致。
concept-workpiece-probe-mill-4 = 准确的触发特性不在刀具数据中，而在 _WP 中，由校准写入。
concept-workpiece-probe-mill-5 = 常见错误：L1 与 _CBIT[14] 不一致。长度因此相差一个测球半径：测球直径 6 mm 时为 3 mm。

concept-workpiece-probe-turn = 车床的工件测头
concept-workpiece-probe-turn-1 = 车床上的测头按车刀处理，类型 5xy，刀沿位置（SL）为 5 到 8。
concept-workpiece-probe-turn-2 = 刀沿位置表示测球的朝向。两个长度都到测球中心，而车刀的长度到刀尖。
concept-workpiece-probe-turn-3 = 输入长度 1、长度 2 和测球半径。磨损和其余各值为 0；基本长度只在需要时输入。
concept-workpiece-probe-turn-4 = 刀沿位置 7 和 8 的测头可用 CYCLE973 在基准槽中校准。结果存入 _WP。
concept-workpiece-probe-turn-5 = 常见错误：像车刀那样把长度量到测球边缘。校准之前，每个位置都差一个测球半径。

concept-calibration-tool-mill = 铣床刀具测头的校准刀具
concept-calibration-tool-mill-1 = 校准刀具测头需要尺寸准确已知的刀具，通常是圆柱销。
concept-calibration-tool-mill-2 = 以类型 1xy 输入长度 1 和半径，磨损和其余各值为 0。在 JOG 中测量使用类型 120。
concept-calibration-tool-mill-3 = CYCLE971 用它触碰测头，把触发点存入 _TP 或 _TPW。
concept-calibration-tool-mill-4 = 常见错误：圆柱销的长度不准。其长度误差为 0.01 mm 时，以后测量的每把刀具的长度都差 0.01 mm。

concept-calibration-tool-turn = 车床刀具测头的校准刀具
concept-calibration-tool-turn-1 = 车床上的校准刀具按车刀处理：类型 5xy，刀沿位置 3。
concept-calibration-tool-turn-2 = 长度 1、长度 2 和半径准确已知。磨损和其余各值为 0。
concept-calibration-tool-turn-3 = 其长度到测球圆周，不到测球中心。工件测头的长度则到中心。
concept-calibration-tool-turn-4 = CYCLE982 用它校准刀具测头，把触发点存入 _TP 或 _TPW。
concept-calibration-tool-turn-5 = 常见错误：长度输入到测球中心。各触发点以及以后测量的每把刀具都差一个测球半径。

concept-group-calibration = 校准

concept-calibration = 校准
concept-calibration-1 = 测头并不正好在接触处触发。校准用尺寸已知的物体求出触发位置，循环在计算中予以计入。
concept-calibration-2 = 工件测头求出触发点、位置偏差和有效测球直径，存入 _WP；刀具测头求出触发点，存入 _TP 或 _TPW。
concept-calibration-3 = 出厂时可存放 3 个测头的数据，最多 99 个。_PRNUM 选择数据。
concept-calibration-4 = 校准和测量应使用相同的进给和相同的条件。这样信号的延迟可相互抵消。
concept-calibration-5 = 首次使用前应校准；更换测针、发生碰撞、改变进给或重新装夹测头后应再次校准。
concept-calibration-6 = 常见错误：首次校准时 _WP 中的数据仍为 0。此时 _TSA 必须大于测球半径，否则循环以报警 61303 停止。

concept-calibration-bodies = 校准体
concept-calibration-bodies-1 = 校准体的位置或尺寸已知。测头触碰校准体，由偏差得出测头的触发特性。
concept-calibration-bodies-2 = 在铣床上，CYCLE976 使用直径已知的孔或环规，或形状准确、粗糙度小的表面。不需要专用校准体。
concept-calibration-bodies-3 = 在车床上，CYCLE973 通常使用固定在机床上的基准槽，也可用已知表面。槽的位置和尺寸在 _KB 中。
concept-calibration-bodies-4 = _CALNUM 选择一对槽；出厂时有 3 组数据。刀具测头则用校准刀具校准。
concept-calibration-bodies-5 = 常见错误：输入的尺寸不是真实尺寸。环规直径误差的一半计入各触发点：误差 0.02 mm 时为 0.01 mm。

concept-tool-probe-data = 校准前的刀具测头数据
concept-tool-probe-data-1 = 自动方式下循环自行移到刀具测头。因此首次校准前，_TP 或 _TPW 中必须已有近似的触发点。
concept-tool-probe-data-2 = _TP 存放 MCS 中的数据，_TPW 存放 WCS 中的数据（自 SW 6.3）。手动量出测头的位置并输入。
concept-tool-probe-data-3 = 朝负方向触碰的面位于测头的正侧。其数值必须大于相对一面的数值。
concept-tool-probe-data-4 = 铣床还应输入：_TP[k,6] 为边长或圆盘上部直径，_TP[k,8] 为形状（方块或圆盘），_TP[k,9] 为校准深度。
concept-tool-probe-data-5 = 常见错误：某个触发点仍为 0。循环会把刀具移到错误的位置；首次运行请用低倍率。

concept-positional-deviation = 位置偏差
concept-positional-deviation-1 = 测球中心与主轴轴线总有微小的距离，称为位置偏差。
concept-positional-deviation-2 = 校准把它存入 _WP[k,7]（横坐标）和 _WP[k,8]（纵坐标）：测球中心减主轴轴线。循环对其进行补偿。
concept-positional-deviation-3 = 如不补偿，0.02 mm 的位置偏差最多使测得的位置偏移 0.02 mm。用多向测头测宽度时两侧偏移相同，因此抵消。
concept-positional-deviation-4 = 多向测头以校准时的同一球面点触碰时精度最高。_CHBIT[13]=1 时主轴随平面的旋转而转动，_CHBIT[14] 决定方向。
concept-positional-deviation-5 = 常见错误：测头在主轴中的角度与校准时不同。每次调用前都应以相同方式使主轴定位。

concept-group-principle = 测量原理

concept-on-the-fly = 飞测（在线触发测量）
concept-on-the-fly-1 = 测头触发的瞬间，轴仍在移动，控制系统即存储位置。这称为飞测。
concept-on-the-fly-2 = 信号直接在 NC 中处理。延迟小，精度相同时可用较高的测量进给。
concept-on-the-fly-3 = 制动期间的行程不影响测得值，只使测头进一步偏转。
concept-on-the-fly-4 = 常见错误：按轴停止的位置判断结果。有效的值在 _OVR 中。

concept-probe-inputs = 测头输入
concept-probe-inputs-1 = 控制系统的 I/O 接口上有两个触发式测头输入。通常一个用于工件测头，另一个用于刀具测头。
concept-probe-inputs-2 = _CHBIT[0] 选择工件测量的输入，_CHBIT[1] 选择刀具测量的输入：0 为输入 1，1 为输入 2。
concept-probe-inputs-3 = 测试时用手偏转测头并观察 PLC 状态：输入 1 为 DB10 DBX107.0，输入 2 为 DB10 DBX107.1。
concept-probe-inputs-4 = 测头静止时该位为 1，说明 MD 13200 中的极性不对。
concept-probe-inputs-5 = 常见错误：该位选择了另一个输入。测头已触碰，循环却检测不到，随后报警 61301。

concept-measuring-sequence = 测量过程
concept-measuring-sequence-1 = 每次触碰的过程都相同。循环算出设定值前 _FA 处的起点，用 G0 或 G1 移到该处。
concept-measuring-sequence-2 = 从起点以测量进给 _VMS 最多走两倍 _FA：先到设定值，过后再走同样的距离。
concept-measuring-sequence-3 = 测头触发时，控制系统存储位置，停止轴，并删除剩余行程。轴退回起点。
concept-measuring-sequence-4 = 测头没有触发时，循环最多尝试五次（_CHBIT[15]=1 时一次），然后报警 61301。重复测量从起点开始。
concept-measuring-sequence-5 = 例：设定值 50 mm，沿正方向测量，_FA=2 时，应在 48 mm 与 52 mm 之间触发。
concept-measuring-sequence-6 = 常见错误：工件偏离设定值超过 _FA。此时测头碰不到工件，或在去起点的途中就碰到。

concept-measuring-path = 测量行程 _FA
concept-measuring-path-1 = _FA 是测量程序段起点到设定值的距离。过了设定值再走同样的距离为终点。
concept-measuring-path-2 = 默认值为 2：测头共搜索 4 mm。_FA 也是循环绕过工件或刀具测头时的距离。
concept-measuring-path-3 = _FA 始终以 mm 为单位，英制时也一样。0.1 inch 应输入 0.1 · 25.4 = 2.54。
concept-measuring-path-4 = _FA 大时，偏离较远的工件也能找到，但费时且需要空间。_VMS=0 且 _FA 大于 1 时，测量进给也从 150 mm/min 升到 300 mm/min。
concept-measuring-path-5 = 常见错误：_FA 按英制输入。_FA=0.1 即 0.1 mm，测头够不到工件。只有 CYCLE971 允许负值。

concept-measuring-feed = 测量进给 _VMS
concept-measuring-feed-1 = _VMS 是测头触碰时的进给。它决定测头偏转多少，以及测得值的精度。
concept-measuring-feed-2 = _VMS=0 时由循环选择：_FA=1 时 150 mm/min，_FA 大于 1 时 300 mm/min。基本单位制为英制时为 5.9055 inch/min 和 11.811 inch/min。
concept-measuring-feed-3 = 大于 0 的值直接使用。最高安全进给取决于轴的制动、测头的允许偏转量和信号延迟。
concept-measuring-feed-4 = _CHBIT[17]=1 且 _FA 大于 1 时，循环触碰两次：先以 _SPEED[3] 快速触碰，退回 2 mm，再以 _VMS 触碰。
concept-measuring-feed-5 = 常见错误：测量进给与校准时不同。触发点因此不再正确；两者应使用同一数值。

concept-deceleration = 制动距离（减速行程）
concept-deceleration-1 = 测头触发后，轴还会继续移动一段距离。测头必须能偏转这么多，否则会损坏。
concept-deceleration-2 = 由三部分相加：发出制动命令之前的距离、制动期间的距离和跟随误差。
concept-deceleration-3 = 它们取决于进给、插补周期（MD 10050 乘以 MD 10070）、加速度（MD 32300）和伺服增益（MD 32200）。取各参与轴的最小值。
concept-deceleration-4 = 例：300 mm/min、16 ms、1 m/s²、伺服增益 1：0.08 mm + 0.0125 mm + 0.3 mm = 0.3925 mm。6000 mm/min 时为 12.6 mm。
concept-deceleration-5 = 同一轴上，测头的允许偏转量为 1 mm 时，进给最大为 730 mm/min。要更快，只能加大允许偏转量或提高伺服增益。
concept-deceleration-6 = 常见错误：只检查 _VMS。_SPEED[1]、_SPEED[2] 以及 _CHBIT[17]=1 时的 _SPEED[3] 更快，轴也必须能及时停下。

concept-accuracy = 测量精度
concept-accuracy-1 = 测量精度不会高于机床和测头的重复精度。测量系统的分辨率也是限制。
concept-accuracy-2 = 飞测时，控制系统本身的重复精度为 ±1 µm。
concept-accuracy-3 = 从接触到存储位置，轴仍在移动：300 mm/min 时 1 ms 移动 0.005 mm，150 mm/min 时为其一半。进给低，误差小。
concept-accuracy-4 = 以相同进给校准可消除恒定部分。剩下的是分散；在同一位置触碰十次即可看出其大小。
concept-accuracy-5 = 主轴旋转时测量刀具另有偏差。CYCLE971 的补偿由 _MT_COMP 选择：循环内部补偿，或使用自己的补偿表。
concept-accuracy-6 = 常见错误：极限值小于分散。循环因此补偿偶然误差；_TZL 应与最大的偶然偏差相当。

concept-group-strategy = 测量策略

concept-deviation-kinds = 三类偏差
concept-deviation-kinds-1 = 循环测得的偏差有多种原因。三类偏差的处理方法不同。
concept-deviation-kinds-2 = 无趋势的偏差：始终不变，例如测头与计量室结果之差。由经验值 _EV 消除。
concept-deviation-kinds-3 = 有趋势的偏差：逐件增大，例如由磨损或温度引起。只有这部分应成为刀具补偿；平均值 _MV 跟随它。
concept-deviation-kinds-4 = 偶然的偏差：每次不同，例如由污物或切削液引起。加权系数 _K 使其影响减小。
concept-deviation-kinds-5 = 常见错误：_K=1 时，超过 _TZL 的偏差全部补偿。刀具因此跟随偶然误差，尺寸比以前更分散。

concept-mean-value = 平均值
concept-mean-value-1 = 平均值汇集一批工件的偏差。它跟随趋势，并平滑偶然误差。
concept-mean-value-2 = 每件工件之后：新平均值 = 旧平均值 −（旧平均值 − 偏差）/_K。存储器 _MV 从 0 开始。
concept-mean-value-3 = 例：_K=3、_TZL=0.04 时，偏差 0.03 mm、0.05 mm、0.06 mm 得到平均值 0.010 mm、0.023 mm、0.036 mm，尚不补偿。_K=2 时第三个平均值为 0.046 mm，作补偿。
concept-mean-value-4 = 平均值一旦超过 _TZL，即成为刀具补偿，存储器清零。_K 大时反应慢而平稳，_K 小时反应快但波动大。
concept-mean-value-5 = 只用于补偿刀具的工件测量。只有 _CHBIT[4]=1 且 _EVNUM 中有存储器号时，才逐件保存。
concept-mean-value-6 = 常见错误：两个尺寸共用一个存储器号。应在 _EVNUM 中为每个测量尺寸指定各自的编号。

concept-empirical-value = 经验值
concept-empirical-value-1 = 经验值是某项测量已知的恒定偏差。循环先计入它，再检查各极限值。
concept-empirical-value-2 = 测头与计量室的结果总是相差同一数值时使用，例如因工件处于装夹状态或温度较高。
concept-empirical-value-3 = 数值在 _EV 中。_EVNUM=11 取 _EV[10]，_EVNUM=0 不取；_EVNUM=90012 取 _EV[11] 和平均值 _MV[8]。
concept-empirical-value-4 = _CHBIT[5]=0 时减去，为 1 时加上。例：测头测得 20.010 mm，计量室为 20.004 mm：_CHBIT[5]=0 时输入 0.006。
concept-empirical-value-5 = 适用于补偿刀具的工件测量、补偿零点偏移的单点测量和刀具测量。
concept-empirical-value-6 = 常见错误：符号错误。偏差因此加倍而不是消除；批量加工前先用一件工件检查。

concept-tolerance-bands = 公差链
concept-tolerance-bands-1 = 实际值与设定值之间的偏差落在某个范围内。每个范围有各自的反应，从不作处理到报警。
concept-tolerance-bands-2 = 极限值必须依次增大：_TZL < _TMV < _TUL 和 _TLL（绝对值）< _TDIF < _TSA。整条链用于补偿刀具的工件测量。
concept-tolerance-bands-3 = 不超过 _TMV 时由平均值起作用：超过 _TZL 才补偿。超过 _TMV 时按全部偏差补偿，平均值清零。
concept-tolerance-bands-4 = 超出 _TUL 或 _TLL 时工件尺寸偏大或偏小：信息 62304 或 62305。此时也按全部偏差补偿。
concept-tolerance-bands-5 = 超过 _TDIF 时不作补偿：信息 62306，刀具可能磨损或折断。超过 _TSA 时程序以报警 61303 停止，因为测头或设定值有误。
concept-tolerance-bands-6 = 不对称的公差被改为对称：_SETVAL=10、_TUL=0、_TLL=-0.004 时，_OVR[0] 中的设定值为 9.998，_OVR[8] 和 _OVR[12] 中为 0.002 和 -0.002。
concept-tolerance-bands-7 = 常见错误：_TLL 没有带符号。符号与图纸一致：0/-0.02 应输入 _TUL=0 和 _TLL=-0.02。

concept-repetition = 多次测量和重复测量
concept-repetition-1 = 循环在同一位置多次触碰的原因有三种：为了更好的平均值、测得值可疑，或没有信号。
concept-repetition-2 = _NMSP 是同一位置的测量次数；取算术平均值。_NMSP=3 时，20.001、20.003、20.002 得到 20.002。
concept-repetition-3 = 偏差超过 _TDIF 或 _TSA 且 _CBIT[0]=1 时，循环最多重复测量四次。_CBIT[1]=1 时每次重复前停止，以便清洁该处。
concept-repetition-4 = 没有信号时循环最多尝试五次，_CHBIT[15]=1 时一次。随后以报警 61301 停止。
concept-repetition-5 = 常见错误：表面脏污却只加大 _NMSP。每次都触碰同一切屑；平均值稳定，但不正确。

concept-differential = 差值测量
concept-differential-1 = 循环两次触碰第一点，其中一次主轴转过 180°。两次的平均值不含测头的位置偏差。
concept-differential-2 = 这样也可使用未校准的测头。
concept-differential-3 = 需要多向测头和可用 SPOS 定位的主轴。单向和双向测头必须始终经过校准。
concept-differential-4 = CYCLE978 在 _MVAR 千位为 1 时、CYCLE998 在 _MVAR=1105 时进行差值测量。
concept-differential-5 = 常见错误：忽略测头的刀具数据。长度和测球半径仍参与计算，必须正确输入。

concept-protection-zone = 保护区
concept-protection-zone-1 = 保护区使测头避开障碍物，例如孔中间的凸台，或轴（外圆）旁的压板。
concept-protection-zone-2 = 在 CYCLE977 中，_MVAR 千位为 1 时启用。_SZA 是其尺寸；矩形时 _SZA 用于横坐标，_SZO 用于纵坐标。
concept-protection-zone-3 = 测内要素时，测头抬起并从上方越过保护区。测外要素时，保护区是连被测要素在内的可用空间，测头不得离开。
concept-protection-zone-4 = 在 CYCLE994 中，_SZA 和 _SZO 是从工件零点算起的边界，测头绕过它。数值应包含测球半径。
concept-protection-zone-5 = 常见错误：保护区与被测要素一样大。测球因此放不下，报警 61334。

concept-collision-monitoring = 碰撞监控
concept-collision-monitoring-1 = 两次触碰之间循环移到中间位置。_CHBIT[2]=1 时，途中监控测头信号。
concept-collision-monitoring-2 = 途中测头碰到物体时，各轴停止并报警 61302。测头和工件通常不会损坏。
concept-collision-monitoring-3 = 有监控时，平面内用 _SPEED[1]，进刀轴用 _SPEED[2]，默认值为 1000 mm/min。无监控时用 _SPEED[0]，为快速移动的百分比。
concept-collision-monitoring-4 = 1000 mm/min 时，加速度 1 m/s²、16 ms、伺服增益 1 的轴需要 1.4 mm 才能停下。测头的允许偏转量必须不小于此值。
concept-collision-monitoring-5 = 常见错误：在自己编写的程序段中依赖它。它只在循环内起作用，调用前到起点的路径不受监控。

concept-group-data = 参数和数据

concept-data-concept = 参数和数据
concept-data-concept-1 = 循环从变量读取输入，并把结果写入变量。这些变量是全局用户数据（GUD），位于 GUD5、GUD6 和用于 JOG 的 GUD7。
concept-data-concept-2 = 必需参数（如 _SETVAL、_MA、_KNUM）描述任务：每次调用前都要设定。附加参数（如 _VMS、_FA、_TSA）通常只设定一次。
concept-data-concept-3 = 数值来自程序、输入画面，或在“参数”操作区手动输入。结果在 _OVR 和 _OVI 中。
concept-data-concept-4 = GUD 由电池保持，断电后数值不变。局部用户数据（LUD）只在循环运行期间存在。
concept-data-concept-5 = 常见错误：沿用其他程序留下的值，例如 _KNUM 或 _NMSP。未设定的参数保持上一次的值。

concept-bits = 控制系统开关和通道开关（位）
concept-bits-1 = 这些开关（位）用于接通和关闭循环的功能。通常由机床制造商一次设定。
concept-bits-2 = _CBIT[] 在 NCK 中只有一份，对所有通道有效。_CHBIT[] 每个通道各有一份，只在该通道有效。
concept-bits-3 = 例：_CBIT[0]=1 时重复可疑的测量。_CHBIT[2]=1 时接通碰撞监控。
concept-bits-4 = 程序可以改变它们，断电后保持新状态。程序结束时应恢复原值。
concept-bits-5 = 常见错误：为一个通道改变 _CBIT[]。此后其他通道的测量也随之改变。

concept-units = 参数的单位
concept-units-1 = 控制系统有基本单位制，程序可切换到另一种单位制。并非所有参数都随之切换。
concept-units-2 = 按有效单位制：_SETVAL、_SETV、_ID、_CPA、_CPO、_SZA、_SZO、_TUL 和 _TLL。这些值来自图纸。
concept-units-3 = 按基本单位制：其余所有带单位的参数，例如 _TSA、_TDIF、_TZL 和 _VMS。_FA 始终以 mm 为单位。
concept-units-4 = 例：公制控制系统，G70 有效。_SETVAL=1 为 1 inch，_TSA=1 为 1 mm，_FA=1 为 1 mm。
concept-units-5 = 常见错误：全部按英制输入。在公制控制系统上 _TSA=0.04 只是 0.04 mm，合格工件也会报警 61303。

concept-group-modes = 运行方式

concept-measuring-jog = 在 JOG 中测量
concept-measuring-jog-1 = 在 JOG 中测量是半自动的，用于铣床。用软键选择任务，填写输入画面，然后按 NC 启动。
concept-measuring-jog-2 = 用于设定工件（棱边、拐角、凹槽、孔、凸台、平面）、校准测头和测量刀具。
concept-measuring-jog-3 = 用方向键或手轮把测头移到测量点附近。按 NC 启动后以 E_MESS_FM 触碰，最多走两倍 E_MESS_D_M，然后退回。
concept-measuring-jog-4 = 结果写入零点偏移或刀具补偿。设定在 _JM_I（编号）、_JM_B（开关）和 E_MESS 数据中。
concept-measuring-jog-5 = 常见错误：测头太远，或输入画面中的方向背离工件。报警 61301：请按 RESET，移近后重新启动。

concept-group-tasks = 测量任务

concept-overview-milling = 铣床的测量任务
concept-overview-milling-1 = 首先校准：CYCLE976 校准工件测头，CYCLE971 校准刀具测头。CYCLE971 还测量刀具的长度和半径。
concept-overview-milling-2 = CYCLE978 测量表面上的一点。CYCLE977 测量平行于轴的孔、轴（外圆）、槽、凸台和矩形。
concept-overview-milling-3 = CYCLE979 成角度测量孔、轴（外圆）、槽和凸台，圆由三点或四点测出。
concept-overview-milling-4 = CYCLE998 测量表面的角度，也可测空间角度。CYCLE961 测量拐角，CYCLE997 测量 1 个球或 3 个球。
concept-overview-milling-5 = CYCLE977、CYCLE978 和 CYCLE979 补偿刀具或零点偏移，后三个循环只补偿零点偏移。
concept-overview-milling-6 = 常见错误：槽不平行于轴却用 CYCLE977。测得的宽度偏大；请用 CYCLE979，或先找正工件。

concept-overview-turning = 车床的测量任务
concept-overview-turning-1 = 首先校准：CYCLE973 在基准槽中或表面上校准工件测头，CYCLE982 校准刀具测头。
concept-overview-turning-2 = CYCLE982 在刀具测头上测量车刀、钻头和铣刀。CYCLE972 也可校准，但只测量车刀。
concept-overview-turning-3 = CYCLE974 测量一点：从一侧测直径、端面或长度。带换向时主轴把工件转过 180°，跳动抵消。
concept-overview-turning-4 = CYCLE994 在相对的两点测量直径。测头从外部绕过工件，或穿过孔到另一侧。
concept-overview-turning-5 = 常见错误：半径与直径混淆。DIAMON 有效时 X 的设定值是直径，而 _FA 和长度的补偿量不是。

# 可拖动的图：拖动的量及其结果。
concept-drag-difference = 差值
concept-drag-feed = 测量进给率
concept-drag-offset = 零点偏移 G54 的 X 值
concept-drag-plane = 平面（17、18 或 19）
concept-told-systems = F 相对 M（MCS）：{ $machine }。测球中心相对 W（WCS）：{ $workpiece }。零点偏移使 W 和工件一起移动：测头在 WCS 中的数值不变。
concept-told-lengths = { $plane }，类型 1xy、2xy、710：L1 在 { $first }，L2 在 { $second }，L3 在 { $third }。旁边是 G18 中的车刀（5xy）：L1 在 { $turning }，L2 在 { $along }。F 是刀具参考点。
concept-told-mean = { $count ->
        [0] 采用该加权系数时，十个工件均不引起补偿。
       *[other] 十个工件中有 { $count } 个引起补偿。每次补偿后，平均值从 0 重新开始。
    }
concept-told-latched = 存储的值停在测头触发的位置。轴在其后 { $path } mm 处停下，该位置不被读取。
concept-told-travel = 1 ms 内轴移动 { $path } mm。控制系统本身的重复精度为 ±0.001 mm（色带）。
concept-told-units = 公制控制系统，G70 有效：_SETVAL={ $inches } 为 { $length } mm，_TSA=1 和 _FA=1 各为 1 mm。
concept-told-empirical = 测得的差值 { $measured } mm 按 { $counts } mm 计算。
concept-told-mono = { $beside ->
        [0] 测头沿其触发方向接触。
       *[other] 测头偏离其触发方向 { $beside }° 接触。
    }
concept-told-repeated = { $count ->
        [1] 一次触碰，距该处 { $mean } µm；测头的离散为 { $scatter } µm。
       *[other] { $count } 次触碰的平均值距该处 { $mean } µm。其离散为 { $scatter } µm，单次为 { $single } µm。
    }

# 概念没有图的原因。
concept-still-conditions = 无图：这些是条件，没有运动。
concept-still-skipped = 无图：循环被跳过时没有运动。
concept-still-same = 无图：没有坐标变换时，它就是机床坐标系。
concept-still-transformation = 无图：工件上看不到坐标变换。
concept-still-table = 无图：这取决于机床，而不是位置。
concept-still-electrical = 无图：这是电气内容，没有运动。
concept-still-memory = 无图：这是控制系统的存储器。
