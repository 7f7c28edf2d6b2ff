# A program that is run many times (`probewright series`).

series-runs = { $runs } runs, { $finished } to the end, seed { $seed }
series-figure = { $mean } ± { $deviation } { $unit } (mean, standard deviation), 95 % from { $low } to { $high }, all from { $min } to { $max }  { $label }
series-capability = Cp { $cp }, Cpk { $cpk } (95 % from { $low } to { $high })
series-corrected = { $target } corrected { $count } times by { $mean } ± { $deviation } { $unit }, from { $min } to { $max }
series-share = { $count } ({ $share } ± { $error } %)
series-uncorrected = The same parts without corrections:
series-no-alarm = No alarm in { $runs } runs: less than { $most } % with 95 % confidence.

certainty-touch = repeatability of the probe
certainty-calibration = calibration of the probe
certainty-form = form error of the part
