# CYCLE116：由点求圆。

cycle116-title = 由点求圆
cycle116-help = 由平面上的三点或四点（例如逐个测得的点）计算圆心和半径。
cycle116-words = 圆 圆心 中心 半径 三点 四点 计算 圆弧 孔 轴 辅助
cycle116-circle = 由点求圆心和半径
cycle116-three = 三点
cycle116-four = 四点
cycle116-no-circle = 各点共线或重合：求不出圆。
cycle116-no-circle-hint = 请在圆上选相距较远的点，例如每点相隔三分之一圆周。

param-116-count = 点数
param-116-count-help = 三点确定一个圆；四点时全部参与计算，个别不准的点影响较小。
param-116-abscissa = 测量点横坐标
param-116-abscissa-help = 该点在平面第 1 轴上的坐标。
param-116-ordinate = 测量点纵坐标
param-116-ordinate-help = 该点在平面第 2 轴上的坐标。
need-116-points = 求圆至少需要三点。
need-116-fourth = 选择了四点。

result-116-abscissa = 圆心，横坐标
result-116-ordinate = 圆心，纵坐标
result-116-radius = 半径
result-116-status = 0：已求出圆；1：没有圆
result-116-alarm = 0，或没有圆时的报警号
