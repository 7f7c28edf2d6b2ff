# 多次运行的程序（`probewright series`）。

series-runs = 运行 { $runs } 次，{ $finished } 次到达结尾，种子 { $seed }
series-figure = { $mean } ± { $deviation } { $unit }（平均值，标准偏差），95 % 在 { $low } 到 { $high }，全部在 { $min } 到 { $max }  { $label }
series-capability = Cp { $cp }，Cpk { $cpk }（95 % 在 { $low } 到 { $high }）
series-corrected = { $target } 补偿 { $count } 次，{ $mean } ± { $deviation } { $unit }，从 { $min } 到 { $max }
series-share = { $count }（{ $share } ± { $error } %）
series-uncorrected = 同样的工件，没有补偿：
series-no-alarm = 运行 { $runs } 次没有报警：以 95 % 的把握少于 { $most } %。

certainty-touch = 测头的重复精度
certainty-calibration = 测头的校准
certainty-form = 工件的形状误差
