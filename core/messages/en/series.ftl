# A program that is run many times (`probewright series`).

series-runs = { $runs } runs, { $finished } to the end, seed { $seed }
series-figure = { $mean } ± { $deviation } { $unit } (mean, standard deviation), 95 % from { $low } to { $high }, all from { $min } to { $max }  { $label }
series-figure-one = { $mean } { $unit } (one value)  { $label }
series-corrected-one = { $target } corrected once by { $mean } { $unit }
series-capability = Cp { $cp }, Cpk { $cpk } (95 % from { $low } to { $high })
series-corrected = { $target } corrected { $count } times by { $mean } ± { $deviation } { $unit }, from { $min } to { $max }
series-share = { $count } ({ $share } ± { $error } %)
series-more = The program measures { $count } times; listed are the first { $shown } measurements. For the others, run a program that begins with them.
series-share-all = { $count } (100 %; at least { $least } % with 95 % confidence)
series-uncorrected = The same parts without corrections:
series-nothing = Nothing was measured.
series-no-alarm = No alarm in { $runs } runs: less than { $most } % with 95 % confidence.

series-tilt-x = Rotation about X, error
series-tilt-y = Rotation about Y, error
series-tilt-z = Rotation about Z, error
series-taper = Taper
series-out-of-round = Out-of-roundness
series-ball-radius = Ball radius

certainty-touch = repeatability of the probe
certainty-calibration = calibration of the probe
certainty-form = form error of the part
certainty-temperature = temperature of the part
certainty-value = { $value } ± { $expanded } { $unit } (k = { $coverage })  { $label }
certainty-proof-good = Proven good.
certainty-proof-undecided = Neither good nor bad is proven.
certainty-proof-bad = Proven bad.
certainty-good = good { $share } %
certainty-rework = rework { $share } %
certainty-scrap = scrap { $share } %
certainty-beyond = beyond the limits { $share } %
certainty-stopped = Stopped before the end: { $share } % of the runs. Below, only the others count.
certainty-largest = Largest contribution: { $source }, { $share } %.
certainty-runs = From { $runs } runs.
certainty-no-call = The program measures nothing whose certainty could be told.
certainty-nothing = Nothing spreads: give the probe its repeatability, the part its form error or its temperature.

series-choose-order = Choose _TZL < _TMV < tolerance limits < _TDIF < _TSA. Then each deviation meets the limit that is meant for it.
series-choose-tzl = _TZL, zero compensation area: set it above the scatter of measurement and process. Below it nothing is corrected, only the mean value goes on.
series-choose-tmv = _TMV: about two thirds of the tolerance. A larger deviation is corrected at once and whole, and empties the mean value memory.
series-choose-k = _K, weight of the mean value: 1 corrects each deviation above _TZL whole and follows chance. 3 to 10 follow a trend more slowly and keep single parts from moving the tool.
series-warmth = Temperature of the part, K
series-wear = Tool wear from part to part
series-warms = Part gets warmer from part to part
