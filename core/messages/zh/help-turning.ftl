# Help pages of the cycles that measure a workpiece on turning machines.

help-turning-probe = 测头（类型 5xy）在工作位置，其 D 号和 G40 有效；没有旋转和比例系数。
help-turning-diameter = 直径和半径混淆：DIAMON 有效时 X 的设定值以及测量时的公差是直径，_FA、触发点和补偿量不是。

help-cycle974-measures-point = 车削件上一点的位置：从一侧测的直径、端面，或第 3 轴上的一点。
help-cycle974-before-opposite = 测球对着该点，距离大于 _FA；从该处朝 _SETVAL 测量。
help-cycle974-before-chuck = 夹持工件的主主轴可以定位。
help-cycle974-order-axis = 测头只沿测量轴移动；最后停在表面前 _FA 处。
help-cycle974-order-reversal = 主轴转到 _STA1 触碰该点，再转 180° 触碰一次。取平均值，因此跳动抵消。
help-cycle974-corrects-half = 长度按其所在轴上的偏差补偿；测直径时为直径偏差的一半。
help-cycle974-corrects-one-axis = 只补偿测量轴；_CHBIT[19]=1 时，在 G18 中补偿 X 而不是 Y。
help-cycle974-wrong-side = 起点在错误的一侧，或到表面的距离不大于 _FA。
help-cycle974-wrong-run-out = 工件有跳动：结果取决于主轴位置。补偿刀具时请用带换向的测量方式。

help-cycle994-measures-diameter = 由相对的两点测量车削件以工件零点为中心的直径。
help-cycle994-before-plus-side = 测球对着正侧的点，距离大于 _FA。
help-cycle994-before-inside = 测球在孔内；_SZA 和 _SZO 描述孔内的障碍物，并包含测球半径。
help-cycle994-before-either = 起点决定内外：比设定值靠外则测外径，绕过保护区 _SZA、_SZO（包含测球半径）；靠内则测内径。
help-cycle994-before-calibrated = 测头已在此平面内、沿各测量方向校准，且校准进给与测量进给相同；_CHBIT[7]=1 时只需存储的测球直径。
help-cycle994-order-plus-first = 先触碰正侧的点，再触碰负侧的点；最后停在后者前 _FA 处。
help-cycle994-order-round-inside = 在孔内沿保护区移动：到 _SZO，再到 _SZA，横过，返回（_MA=1 时先到 _SZA）。
help-cycle994-order-round-outside = 测外径时退到 _SZO，移到 _SZA，横过，返回（_MA=1 时先到 _SZA）；测内径时直接穿过孔。
help-cycle994-corrects-half = 长度按直径偏差的一半补偿。
help-cycle994-wrong-zone = 保护区沿用以前的调用，或放不下测球：测头撞到工件（报警 61302），或没有可行的路径（61334）。
help-cycle994-wrong-ball = _CHBIT[7]=1 时用存储的测球直径代替两个触发点：该直径必须正确。
