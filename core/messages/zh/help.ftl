# Help pages: what all or most SINUMERIK cycles have in common, and the headings.

help-section-measures = 测量内容
help-section-does = 功能
help-section-before = 调用前测头的位置
help-section-before-tool = 调用前刀具的位置
help-section-before-call = 调用前的条件
help-section-order = 执行顺序
help-section-corrects = 补偿内容
help-section-leaves = 输出结果
help-section-wrong = 容易出错之处
help-values = 输入参数：{ $names }。
help-alarms = 可能出现的报警：{ $names }。

help-probe-loaded = 测头在主轴中（刀具类型 710 或 1x0），其 D 号有效；已编程 G40，没有比例系数。
help-probe-turning = 在有第三直线轴的车床上，测头类型为 5xy，长度算到测球中心，SD 42950 为 2。刀沿位置 5 或 7 在 G17 中测量，6 或 8 在 G19 中测量。即使 DIAMON 有效，X 的位置也是半径。
help-wrong-tool = _TNUM 或 _KNUM 中的 D 号不属于加工此表面的刀具：没有问题的刀具会得到错误的补偿。
help-wrong-chip = 表面上的切屑或毛刺使尺寸失真：测量前请清洁表面，并设定 _TDIF，使这样的值不用于补偿。
help-wrong-conditions = 校准测头时的进给或主轴位置与测量时不同：结果有固定的误差。平面不同时也是如此，_CBIT[16]=1 时报警。
help-wrong-kept = 此调用没有写入的参数仍为以前调用的值：极限、保护区或角度。
help-order-block = 一次触碰：移到设定位置前 _FA 处，从那里以测量进给最多走两倍 _FA，触发后退回。_NMSP 大于 1 时重复触碰，取平均值。
help-ends-at-start = 最后停在起点。
help-wrong-reach = 表面位于设定位置后方，且距离大于 _FA：测头不触发，报警 61301。
help-wrong-in-the-way = 路径上有障碍物：_CHBIT[2]=1 时，定位时碰撞则报警 61302。
help-corrects-tool = 刀具（_TNUM、_TNAME 或 _TENV）：补偿写入磨损，_CHBIT[6]=1 时写入几何值。_KNUM 指定刀沿、长度或半径，也可改为设定补偿或附加补偿。_KNUM=0 不补偿。
help-corrects-chain = 偏差超过 _TSA：报警 61303，程序停止。超过 _TDIF：信息 62306，不补偿。超出 _TUL、_TLL 或 _TMV：补偿全部偏差。在 _TMV 以内：以 _K 加权的平均值，大于 _TZL 时才补偿。
help-corrects-zero = 由 _KNUM 指定的零点偏移，移动量为实际值减设定值；旋转不变。机床有精偏移时写入精偏移，_CHBIT[21]=1 或 _KNUM=2000 时写入粗偏移。_KNUM=0 不补偿。
help-corrects-zero-area = 偏差超过 _TSA 时报警 61303：程序停止，不作补偿。
help-corrects-when = 重新编程零点偏移的 G 功能（G54 …）后，补偿才生效；只有 _KNUM=9999 时立即生效。
help-corrects-trigger = 测头数据：触发点与 _WP 中的值相差大于 _TZL 时更新。超过 _TSA：报警 61303，不存储。
help-wrong-first = 首次校准：存储值为 0，_TSA 必须大于测球半径。
help-wrong-later = 以后测量时的进给、平面、主轴位置或（铣削测量循环中）_CBIT[14] 与校准时不同：存储的值不适用。
help-calibrated = 测头已在此平面内、沿此测量的各方向校准，且校准进给与测量进给相同。
help-uncalibrated = 测头不必校准；它各方向都能触发，主轴可以定位，测量轴在平面内。
help-turned-over = 第一点先在主轴转过 180° 时触碰，再在主轴原位置触碰。取平均值，因此位置偏差抵消。
help-turned-over-stored = 位置偏差和此方向的触发点（其中含位置偏差）也存入 _WP，只对主轴当前的角度有效。
help-no-spindle = 主轴不能定位：报警 61372。

# 表单在控制系统上的位置。
where-title = 在控制系统上的什么位置？
where-from = 该表单从测量循环 SW { $version } 起提供。
where-editor = 程序编辑器：{ $softkeys }（测量循环 SW 6.2 及以上）。
where-older = 程序编辑器：{ $softkeys }（测量循环 SW 5.4 及以下）。循环支持写入 { $call }()。
where-older-call = 程序编辑器，测量循环 SW 5.4 及以下：循环支持写入 { $call }()。手册未给出相应软键。
where-jog-newer = 在 JOG 中，测量循环 SW 6.3 及以上：{ $softkeys }。
where-jog-older = 在 JOG 中，测量循环 SW 6.2 及以下：{ $softkeys }。
where-jog-both = 在 JOG 中：{ $softkeys }。
where-jog-needs = 如果没有这些软键：需要 HMI Advanced（PCU 50）或 MMC 103、选件“跨运行方式动作”，并且 MA_JOG.COM 中相应的行不带分号。
where-jog-files = SW 6.3 及以上的软键和输入屏幕文件：COM_FILE.COM，以及 MC_CST0.ARC 或 MC_CST1.ARC。
where-jog-files-older = SW 6.2 及以下的软键和输入屏幕文件：MA_JOG.COM、JOG_MEAS.COM 和 BMP_FILE.ARC。
where-jog-settings = 该输入屏幕没有设定画面。预设值和运行方式由用户数据设定：GUD6 中的 _JM_I[] 和 _JM_B[]，GUD7 中的 E_MESS_…。
where-jog-settings-tool = 该输入屏幕没有设定画面。刀具测头及其逼近由 E_MESS_MT_…（GUD7）设定，结果写入的位置由 _JM_B[0]（GUD6）设定。
where-settings = “调试 > 测量循环 > 自动测量”设定输入屏幕提供的内容（_MZ_MASK）。如果没有这些软键，参见调试步骤。
where-files = HMI Advanced 上输入屏幕的文件：MCSUPP.COM、AEDITOR.COM、STARTUP.COM。
where-files-older = SW 5.4 及以下的文件：MCSUPP_1.COM 和 MCSUPP_2.COM，包含 COV.COM（软键）、SC.COM（输入屏幕）和辅助循环。
where-none-replaced = SW 6.2 起没有输入屏幕。请使用车床刀具测量的输入屏幕，或直接写入调用。
where-none-log = 没有输入屏幕。请将调用写入程序；记录本身在其用户数据中设置。
where-none-helper = 没有输入屏幕。请将调用写入程序。
where-none-block = 没有输入屏幕。请将程序段写入程序，或在 MDI 中输入。
