# 指南：Probewright 的某一部分有何用途、在哪里、要注意什么。引号中的文字就是页面上控件的文字。

guide-group-results = 使用测量结果

guide-record = 测量报告
guide-record-words = 报告, 测量报告, 检验报告, 测量表, 结果表, 表格, CSV, Excel, JSON, PDF, 打印, 客户, 质量, 判定, 首件
guide-record-1 = 报告列出一次运行测得的全部内容，每次测量一行：要素、设定值、实际值、限值及其占用比例、判定、补偿、测头及其校准状态、报警。
guide-record-2 = 在视图中选“整个程序”，表格在“测量”下。“最差优先”把最差的排到最前；单击一行，即转到它的程序行和它在 3D 视图中的步骤。
guide-record-3 = “CSV”用于电子表格，“JSON”用于其他程序，“打印报告”用于纸张或 PDF：含标题栏、偏差条和带编号要素的图。
guide-record-4 = 注意测头旁的校准状态：用别的测头的校准或旧的校准测得的值，可信程度不会高于该校准。

guide-measured = 实际机床的测量值
guide-measured-words = 导入, 读入, 测量记录, 实际值, 实测值, 实际机床, 真实机床, 控制系统的记录, CSV, Excel, 比较, 箭头
guide-measured-1 = 把机床实际测得的值对应到程序的各个调用：同样的表格和报告，实际偏差在 3D 视图中显示为箭头。
guide-measured-2 = 打开机床运行过的程序，显示“整个程序”。选“来自机床”，再选控制系统的测量记录或表格（CSV）。
guide-measured-3 = 每一行都对应到一个调用。如果仅凭数字看不出某列是什么，就在“列”下指定。
guide-measured-4 = 对应不上的行连同原因一起列出，一行也不丢。“返回模拟”重新显示模拟值。

guide-certainty = 测量有多可靠
guide-certainty-words = 可靠性, 测量不确定度, 不确定度, 扩展不确定度, 保护带, 保护区间, ISO 14253, ISO 14253-1, 蒙特卡洛, 包含因子, 概率, 证明, 符合性, 接收
guide-certainty-1 = 说明一个测量值能证明什么：测量值 ± 扩展不确定度（k = 2），来自测头的分散、测头的校准、工件的形状误差和温度。
guide-certainty-2 = 表单中的调用，其可靠性显示在结果行中。整个程序则选表格“测量”上方的“可靠性”：程序运行多次，每次都用同样的随机数。
guide-certainty-3 = 按 ISO 14253-1，测量值与每个限值都保持 1.645 倍标准不确定度的保护带，才能证明合格；超出限值同样多，才能证明不合格。介于两者之间则都无法证明。
guide-certainty-4 = 概率说明该工件合格、返修或报废的可能性。先改善最大的分量。
guide-certainty-5 = 结果取决于输入：在“误差”下输入测头的“重复性”，取测头测试所得的值。没有任何分散时，不显示可靠性。

guide-series = 批量工件
guide-series-words = 批量, 批量工件, 多个工件, 批次, 统计, SPC, Cp, Cpk, 过程能力, 能力指数, 废品率, 刀具磨损, 漂移, 趋势, 直方图, 平均值, 标准偏差
guide-series-1 = 对一个又一个工件运行打开的程序，误差随机抽取。可以看到实际值和补偿如何变化，以及没有补偿时哪些会报废。
guide-series-2 = 选表格“测量”上方的“批量”。“添加变化量”可选工件尺寸、刀具磨损、测头和任何数据，并给出各自的分散；然后选“运行批量”。
guide-series-3 = “每个工件”设为“沿用前一工件的补偿”时，看到的是生产中的闭环补偿；设为“重新开始”时，只看到分散。
guide-series-4 = Cp 比较分散与公差，Cpk 还考虑与公差中心的距离。注意它们的区间：工件少时说明不了什么。
guide-series-5 = 同一种子抽取同样的工件：改一个值再比较。“示例：平均值”运行手册中的表格。

guide-limits = 选择 _TZL、_TMV 和 _K
guide-limits-words = _TZL, _TMV, _K, 零补偿区, 零补偿, 平均值, 经验值, 加权系数, 补偿限值, 公差, 振荡
guide-limits-1 = 这些值决定哪个偏差会补偿刀具、补偿多少。过小则补偿跟随偶然误差，过大则工件逐渐超出公差。
guide-limits-2 = 在“批量”中试一试：同样的工件，分别用 _K=1 和 _K=3。“测试测头：重复精度”会给出 _TZL 的建议值。

guide-screens = 测量结果画面
guide-screens-words = 画面, 结果画面, 测量结果画面, 测量结果显示, 确认, NC 启动, 停止, 等待, M0, 操作者, CYCLE102, CYCLE103, _CHBIT[10], _CHBIT[11], _CHBIT[18]
guide-screens-1 = 在控制系统上，测量循环可以用一个画面显示设定值、实际值和偏差。这里显示操作者看到的内容。
guide-screens-2 = _CHBIT[10]=1 打开画面。_CHBIT[11]=1 时程序等待 NC START；_CHBIT[18]=1 时画面保留到下一次测量调用。可在程序中或“机床数据”下设置。
guide-screens-3 = 运行到相应步骤时，画面显示在 3D 视图上。选项卡“结果”列出全部画面，单击即可打开。
guide-screens-4 = 勾选“播放时在此停止”：播放到每个会在机床上等待的画面时停下，直到按“NC START”。
guide-screens-5 = 无人值守生产时，等待的画面会让机床在每个工件上停下：这时应设 _CHBIT[11]=0。

guide-log = 运行产生的测量记录和文件
guide-log-words = 测量记录, 记录文件, 日志, 文件, MPF, WRITE, 打印, CYCLE100, CYCLE101, CYCLE106, _PROTNAME, 后续文件, 续文件, 溢出, LEN_PROTOCOL_FILE
guide-log-1 = 运行留下与控制系统相同的文件：CYCLE100 与 CYCLE101 之间的测量记录、程序用 WRITE 写的内容，以及 NCT 宏打印的内容。
guide-log-2 = 选项卡“测量记录”显示每个文件如何随运行增长，并以它在控制系统上的名称保存。
guide-log-3 = _PROTNAME[1] 是不带扩展名的文件名。文件达到 MD 11420 的大小后，最多再接续九个文件，名称后加下划线和一位数字；之后控制系统停止，要求新的名称。
guide-log-4 = 在测量记录循环的表单中，列通过选择组成（“添加列”），并预览打印出来的各行。放不进列宽的值会报告。
guide-log-5 = 日期和时间是控制系统的，不是本计算机的：在机床中用“运行开始的日期和时间”设置。

guide-group-programs = 运行和扩充程序

guide-run-modes = 运行方式
guide-run-modes-words = 方式, 运行方式, 空运行, 程序测试, 程序段搜索, 仿真, 模拟, HMI Advanced, Jobshop, ShopMill, 跳过, _MC_SIMSIM, _MC_SIMDIFF
guide-run-modes-1 = 显示在控制系统跳过测量循环或只作仿真时，程序会做什么。
guide-run-modes-2 = 在视图中选“整个程序”，再在“运行方式”下选“自动”、“空运行”、“程序测试”、“程序段搜索”或控制系统的某种仿真。
guide-run-modes-3 = 被跳过的循环不测量：其结果仍是先前调用的值，程序用这些值继续运行。每个调用都会说明。
guide-run-modes-4 = 用“程序段搜索”时，要确认目标行之后的内容不需要之前的测量结果。
guide-run-modes-5 = 在控制系统的仿真中，_MC_SIMSIM=0 跳过循环，_MC_SIMDIFF 加到每个测得的位置上。

guide-around = 调用前后的程序块
guide-around-words = 调用前后, 程序块, 返修, 返工, 再加工, 循环, 破损, 断刀, 停止, 跳转, 信息, 自定义报警, 半精加工, 平均值, 反转, 保存结果, 跳过, 按结果
guide-around-1 = 加入车间在测量前后手写的内容：按结果停止、显示信息、报警或跳转，返工循环，半精加工和精加工，刀具破损检查，多次测量的平均值，把结果写入变量或测量记录，已测量则跳过。
guide-around-2 = 在表单中打开“调用前后”，勾选程序块并填写其参数。它们随调用一起插入；对程序中已有的调用，选“写入程序”。
guide-around-3 = 程序块可从其程序行识别出来，以后还能更改和删除。
guide-around-4 = 调用程序的块需要该程序：例如返工程序要让测头返回起始位置。
guide-around-5 = 每个分支都试一遍：在“误差”下给工件一个误差，运行“整个程序”。

guide-user-programs = 每次测量前后的程序行
guide-user-programs-words = CYCLE198, CYCLE199, 用户程序, 测量前, 测量后, 打开测头, 关闭测头, M27, M28, 防护罩
guide-user-programs-1 = CYCLE198 在每次测量之前运行，CYCLE199 在之后运行：用于机床此时总要做的事，例如打开和关闭测头。
guide-user-programs-2 = “测量循环前后的程序行（CYCLE198、CYCLE199）”按所选循环和程序行写出它们：供插入，或作为完整文件。
guide-user-programs-3 = 如果程序或其相关文件含有它们，每个调用都会说明前后运行哪些行。
guide-user-programs-4 = 它们在机床的每个程序中都起作用。只属于某一次测量的内容，写在该调用的前后。

guide-group-proof = 验证程序和安装

guide-scenarios = 场景：始终经过验证的程序
guide-scenarios-words = 场景, 测试, 回归测试, JUnit, CI, 构建服务器, 文件夹, 预期结果, 验证, 证明
guide-scenarios-1 = 场景包含一个程序、它的机床和应得的结果：每个调用的结果、补偿、报警、测量记录。每次更改程序或机床数据后再运行一遍。
guide-scenarios-2 = 在菜单中选“场景”。“将程序保存为场景”用页面当前显示的内容生成一个；“运行场景…”和“运行文件夹…”运行您自己的场景。
guide-scenarios-3 = 文件夹中的文件名以 scenario.json 结尾。有差异的排在最前，并给出预期值和所得值。
guide-scenarios-4 = 在终端中，有情况未通过时退出状态为 1，--junit 写出 JUnit XML，因此服务器也能运行您的程序。
guide-scenarios-5 = 为合格工件保存一个场景，再为程序必须拦住的每种情况各保存一个：尺寸偏大、没有孔、刀具破损。

guide-installation = 检查本安装
guide-installation-words = 自检, 自测, 检查, 安装, 验证, 确认, 证明, 手册示例, 向量, 闭环
guide-installation-1 = 在您自己的浏览器中证明 Probewright 的计算与手册一致：手册的示例及其数值，以及校准、补偿、再测量的闭环。
guide-installation-2 = 选“关于”，再选“检查本安装”。可以看到有多少项一致、各自的出处和所用时间；有差异的排在最前。
guide-installation-3 = 每次更新版本后都做一遍。它证明的是计算，不是您的机床：每个程序仍要在机床上试切验证。

guide-group-machine = 机床和测头

guide-machine-check = 检查机床
guide-machine-check-words = 机床数据, INITIAL.INI, TEA, 批量调试, 存档, 导出, 备份, MD, 存储器, 缺少数据, 报警
guide-machine-check-1 = 把控制系统导出的内容与测量循环的要求对照，说明缺少什么、什么过小或互相矛盾，以及会引起哪个报警。
guide-machine-check-2 = 选“检查机床”，拖入机床数据（.TEA、INITIAL.INI）、定义文件或存档的文本，或输入 MD 18120 = 30 这样的行。
guide-machine-check-3 = 指明机床有什么，例如“JOG 测量”或“刀具测头”；否则会要求它并不需要的数据。
guide-machine-check-4 = “保存待更改的行”只写这些行。读入之前先将控制系统存档：配置存储器的数据会清除存储器。

guide-definitions = 定义文件和赋值程序
guide-definitions-words = GUD, GUD5, GUD6, GUD7_MC, DEF, 定义文件, 数组大小, 赋值, 存储器, 读回, 测头数量
guide-definitions-1 = 写出您的机床在测量循环定义文件中要更改的内容：数组大小和其他值、给它们赋值的程序，以及所需的存储器。
guide-definitions-2 = 选“定义文件和赋值程序”，保存每个文件。其中只有待更改的行：把它们写入控制系统的文件。
guide-definitions-3 = “读回文件”把控制系统的值读入这里的机床，也可从启动文件读入。
guide-definitions-4 = 激活定义文件之前先备份控制系统的数据，之后运行赋值程序。

guide-braking = 测头的制动距离
guide-braking-words = 制动距离, 制动, 减速, 超程, 偏摆量, 测针, 最大进给, 测量进给, _VMS, Kv, 伺服增益, MD32300, MD32200
guide-braking-1 = 信号之后轴还要走一段距离才停下，测头必须承受这段距离。这里计算某一进给的这段距离，或测头允许偏摆量下的最大进给。
guide-braking-2 = 选“检查机床”并打开“制动距离”。延时、减速度和伺服增益取自控制系统的导出内容，也可手动输入。
guide-braking-3 = 机床有了这些数据后，进给过高的调用会给出警告和允许的最大进给。
guide-braking-4 = 测量值在信号到来时采集，这段距离不影响它，但决定测针会不会损坏；进给减半，距离减少一半以上。

guide-repeat = 测试测头：重复精度
guide-repeat-words = 重复精度, 重复性, 分散, 测头测试, 功能测试, MEAS, 漂移, 标准偏差, 直方图, 检查校准
guide-repeat-1 = 两个不用测量循环的测试程序：一个显示测头是否发出信号，另一个显示在同一位置多次触测的分散程度。
guide-repeat-2 = 选“测试测头：重复精度”，输入轴、起点、终点和进给。“保存功能测试程序”和“保存重复精度程序”写出供机床使用的程序。
guide-repeat-3 = 把机床测得的值粘贴到“实际机床的测量值（空：模拟）”下，即可得到平均值、标准偏差、极差、漂移和 _TZL 的建议值。
guide-repeat-4 = 把标准偏差作为测头的“重复性”输入：可靠性和批量的计算就以您的测头为准。
guide-repeat-5 = 如果测量值漂移，说明机床未热透或测头松动：先排除，再测一次。

guide-commissioning = 调试与升级
guide-commissioning-words = 调试, 在机床上安装, 安装, 升级, HMI Advanced, HMI Embedded, PCU 50, MMC, TCU, 插头, X121, 接线, 连接，兼容性，版本搭配
guide-commissioning-1 = 按操作面板和版本列出在机床上安装或升级测量循环的步骤，附软键、文件和检查方法。
guide-commissioning-2 = 选“调试与升级”，在“机床”下选对应的步骤表。勾选已完成的步骤，页面会记住。“测头接线”列出插头和信号。
guide-commissioning-3 = 步骤要求机床数据时，“检查机床”会说明它们是否足够。

guide-background = 指南、概念与术语
guide-background-words = 帮助, 指南, 词汇表, 词典, 概念, 术语, 含义, 说明, 手册
guide-background-1 = 说明如何使用 Probewright，以及测量循环手册默认读者已知的内容。
guide-background-2 = 按 Ctrl+K，选“指南、概念与术语”，输入任意词。输入栏旁的“概念”打开相关概念，对话框中的问号打开其指南。
guide-background-3 = 每种测量方式都有自己的帮助页：表单旁的“帮助”。
