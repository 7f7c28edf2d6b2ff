# Help pages of the cycles that calibrate a workpiece probe.

help-cycle976-measures-hole = 测头在平面内的触发点：触碰已知直径 _SETVAL 的环规或孔的壁。
help-cycle976-measures-one = 一个轴的一个方向：_MA 和 _MD。
help-cycle976-measures-two = 轴 _MA 的两个方向。
help-cycle976-measures-four = 两个轴的两个方向。
help-cycle976-measures-centre = 循环同时求出环规的中心。
help-cycle976-measures-surface = 测头在一个轴的一个方向上的触发点：触碰位于 _SETVAL 的表面。
help-cycle976-measures-length = 测头的长度 L1 及其在刀具轴上的触发点：触碰位于 _SETVAL 的表面。
help-cycle976-before-at-centre = 主轴轴线正好在孔中心，测球在校准深度。
help-cycle976-before-near-centre = 测球在校准深度，靠近中心，偏离不超过 _FA。
help-cycle976-before-spindle = 主轴可以定位，测头可随之转到 0 到 360° 的任意角度。
help-cycle976-before-opposite = 测球对着表面，距离大于 _FA。
help-cycle976-before-within = 表面离测球不超过两倍 _FA；测头的 L1 可以未知。
help-cycle976-before-radius = 测球半径已输入测头的刀具数据；没有镜像。
help-cycle976-order-one = 从起点触碰孔壁一次。
help-cycle976-order-two = 先 _MA 正方向，经中心退回，再负方向。
help-cycle976-order-four = 先横坐标正、负方向，再纵坐标正、负方向，每次都经中心退回。
help-cycle976-order-angle = 所有方向都转过 _STA1；两个轴同时移动。
help-cycle976-order-twice = 全部执行两遍；使用多向测头时，第一遍主轴转过 180°：两个中心之差的一半是位置偏差，平均值是中心。
help-cycle976-order-no-approach = 从起点沿 _MD 方向最多走两倍 _FA 触碰，然后退回。
help-cycle976-order-end-centre = 最后停在起点，即中心。
help-cycle976-order-end-found = 最后停在求出的中心。
help-cycle976-order-end-surface = 最后停在起点；_MA=3 时停在表面前 _FA 处。
help-cycle976-corrects-ball = 以及有效测球直径 _WP[k,0]，CYCLE979 和成角度测量的 CYCLE997 需要它；_CBIT[15]=1 时还有测头的半径。
help-cycle976-corrects-skew = 以及测针的位置偏差 _WP[k,7] 和 _WP[k,8]。
help-cycle976-corrects-length = 测头几何值中的 L1 按偏差补偿；_TSA 不监控它。
help-cycle976-wrong-off-centre = 主轴不在中心：此误差计入各触发点，并带入以后测得的每个位置。
help-cycle976-wrong-diameter = _SETVAL 不是环规的真实直径：误差的一半会计入各触发点。
help-cycle976-wrong-position = _SETVAL 不是表面在有效坐标系中的真实位置。

help-cycle973-measures-surface = 测头在一个轴的一个方向上的触发点：触碰工件上位于 _SETVAL 的表面。
help-cycle973-measures-groove-one = 测头在一个方向上的触发点：触碰基准槽的一个壁或槽底。
help-cycle973-measures-groove-two = 测头在一个轴的两个方向上的触发点：触碰基准槽的两个壁。
help-cycle973-before-surface = 测头刀沿位置为 5 到 8，对着表面，距离大于 _FA。
help-cycle973-before-groove = 测头刀沿位置为 7 或 8；从起点沿平行于轴的路径可无障碍地进入槽 _CALNUM。
help-cycle973-before-centre = 测头的 L1 和 L2 算到测球中心，测球半径已输入刀具数据。
help-cycle973-order-surface = 只有测量轴 _MA 沿方向 _MD 移动；最后停在表面前 _FA 处。
help-cycle973-order-into-groove = 按机床坐标。测头平行于轴移到槽中间的上方，再进入槽。
help-cycle973-order-one = 在轴 _MA 的方向 _MD 触碰；槽底只有负方向。
help-cycle973-order-two = 先触碰正方向的壁，横过槽，再触碰负方向的壁。
help-cycle973-order-end-groove = 最后停在槽中，距最后触碰的面 _FA 处。
help-cycle973-corrects-ball = 以及有效测球直径 _WP[k,0]。
help-cycle973-corrects-skew = 以及测量轴上的位置偏差 _WP[k,7] 或 _WP[k,8]。
help-cycle973-wrong-groove-data = _KB 中的槽数据在 X 上是直径：必须是半径。
help-cycle973-wrong-position = 测头的刀沿位置不是 7 或 8：报警 61315。
help-cycle973-wrong-shank = 在此方向会以测针杆而不是测球触碰。
