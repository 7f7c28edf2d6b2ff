# 多次运行的程序（`probewright series`）。

series-runs = 运行 { $runs } 次，{ $finished } 次到达结尾，种子 { $seed }
series-figure = { $mean } ± { $deviation } { $unit }（平均值，标准偏差），95 % 在 { $low } 到 { $high }，全部在 { $min } 到 { $max }  { $label }
series-figure-one = { $mean } { $unit }（一个值）  { $label }
series-corrected-one = { $target } 补偿一次：{ $mean } { $unit }
series-capability = Cp { $cp }，Cpk { $cpk }（95 % 在 { $low } 到 { $high }）
series-corrected = { $target } 补偿 { $count } 次，{ $mean } ± { $deviation } { $unit }，从 { $min } 到 { $max }
series-share = { $count }（{ $share } ± { $error } %）
series-more = 程序测量 { $count } 次；此处列出前 { $shown } 次。要查看其余测量，请运行从这些测量开始的程序。
series-share-all = { $count }（100 %；以 95 % 的把握至少 { $least } %）
series-uncorrected = 同样的工件，没有补偿：
series-nothing = 没有进行任何测量。
series-no-alarm = 运行 { $runs } 次没有报警：以 95 % 的把握少于 { $most } %。

series-tilt-x = 绕 X 旋转误差
series-tilt-y = 绕 Y 旋转误差
series-tilt-z = 绕 Z 旋转误差
series-taper = 锥度
series-out-of-round = 圆度误差
series-ball-radius = 测球半径

certainty-touch = 测头的重复精度
certainty-calibration = 测头的校准
certainty-form = 工件的形状误差
certainty-temperature = 工件温度
certainty-value = { $value } ± { $expanded } { $unit }（k = { $coverage }）  { $label }
certainty-proof-good = 证明合格。
certainty-proof-undecided = 既未证明合格，也未证明不合格。
certainty-proof-bad = 证明不合格。
certainty-good = 合格 { $share } %
certainty-rework = 返工 { $share } %
certainty-scrap = 报废 { $share } %
certainty-beyond = 超出限值 { $share } %
certainty-stopped = 未到结尾就停止：{ $share } % 的运行。以下只统计其余运行。
certainty-largest = 最大来源：{ $source }，{ $share } %。
certainty-runs = 共运行 { $runs } 次。
certainty-no-call = 程序没有测量任何可给出不确定度的值。
certainty-nothing = 没有分散：请给出测头的重复性、工件的形状误差或温度。

series-choose-order = 按 _TZL < _TMV < 公差限 < _TDIF < _TSA 选择，使每个偏差由对应的限值处理。
series-choose-tzl = _TZL（零补偿区）：大于测量和加工的分散。低于此值时不补偿，只更新平均值。
series-choose-tmv = _TMV：约为公差的三分之二。偏差更大时立即全额补偿，并清除平均值存储器。
series-choose-k = _K（平均值加权系数）：取 1 时，超过 _TZL 的偏差全部补偿，会跟随偶然误差。取 3 到 10 时较慢地跟随趋势，单个工件不会改变刀具补偿。
series-warmth = 工件温度，K
series-wear = 逐件刀具磨损
series-warms = 工件逐件升温
