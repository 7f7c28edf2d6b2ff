# CYCLE119：空间位置。

cycle119-title = 由三点求空间位置
cycle119-help = 由三个点的设定位置和测得位置计算工件在空间中的位置；需要时对一个坐标框架作平移和旋转补偿。
cycle119-words = 空间位置 框架 三点 三角形 找正 对齐 平面 旋转 平移 零点偏移 辅助
cycle119-position = 由三个设定点和三个测量点求坐标框架

check-119-set-line = 三个设定点共线或重合：求不出工件的旋转。
check-119-measured-line = 三个测量点共线或重合：求不出工件的旋转。
check-119-line-hint = 请选构成宽大三角形的三个点，设定点和测量点按相同的顺序输入。

param-119-set-x = 设定点，第 1 几何轴
param-119-set-x-help = 该点的设定位置，工件坐标系中的 X。第一个下标是点（0 到 2），第二个是轴（0：X，1：Y，2：Z）。
param-119-set-y = 设定点，第 2 几何轴
param-119-set-y-help = 该点的设定位置，工件坐标系中的 Y。
param-119-set-z = 设定点，第 3 几何轴
param-119-set-z-help = 该点的设定位置，工件坐标系中的 Z。
param-119-measured-x = 测量点，第 1 几何轴
param-119-measured-x-help = 同一点测得的位置，工件坐标系中的 X；通常是前面测量的结果，例如 { "_OVR[5]" }。
param-119-measured-y = 测量点，第 2 几何轴
param-119-measured-y-help = 同一点测得的位置，工件坐标系中的 Y。
param-119-measured-z = 测量点，第 3 几何轴
param-119-measured-z-help = 同一点测得的位置，工件坐标系中的 Z。
param-119-limit = 变形极限
param-119-limit-help = 两个三角形的形状不会完全相同。只有三个点的偏差之和小于此值时才补偿坐标框架；否则 { "_ALARM" } 为 61414。
need-119-corrected = 补偿坐标框架需要极限值。

result-119-alarm = 0，或报警号
result-119-distortion = 三点偏差之和；小于 0：未算出坐标框架
result-119-frame-x = 结果坐标框架（与有效坐标框架级联，把测得的三角形移到设定位置）：X 平移
result-119-frame-y = 结果坐标框架：Y 平移
result-119-frame-z = 结果坐标框架：Z 平移
result-119-turn-x = 结果坐标框架：绕 X 旋转
result-119-turn-y = 结果坐标框架：绕 Y 旋转
result-119-turn-z = 结果坐标框架：绕 Z 旋转
