# Ein Programm, das viele Male läuft (`probewright series`).

series-runs = { $runs } Läufe, { $finished } bis zum Ende, Startwert { $seed }
series-figure = { $mean } ± { $deviation } { $unit } (Mittelwert, Standardabweichung), 95 % von { $low } bis { $high }, alle von { $min } bis { $max }  { $label }
series-capability = Cp { $cp }, Cpk { $cpk } (95 % von { $low } bis { $high })
series-corrected = { $target }: { $count } Mal korrigiert um { $mean } ± { $deviation } { $unit }, von { $min } bis { $max }
series-share = { $count } ({ $share } ± { $error } %)
series-uncorrected = Dieselben Teile ohne Korrektur:
series-no-alarm = Kein Alarm in { $runs } Läufen: mit 95 % Sicherheit weniger als { $most } %.

certainty-touch = Wiederholgenauigkeit des Messtasters
certainty-calibration = Kalibrierung des Messtasters
certainty-form = Formfehler des Werkstücks
