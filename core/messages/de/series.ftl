# Ein Programm, das viele Male läuft (`probewright series`).

series-runs = { $runs } Läufe, { $finished } bis zum Ende, Startwert { $seed }
series-figure = { $mean } ± { $deviation } { $unit } (Mittelwert, Standardabweichung), 95 % von { $low } bis { $high }, alle von { $min } bis { $max }  { $label }
series-figure-one = { $mean } { $unit } (ein Wert)  { $label }
series-corrected-one = { $target } einmal korrigiert um { $mean } { $unit }
series-capability = Cp { $cp }, Cpk { $cpk } (95 % von { $low } bis { $high })
series-corrected = { $target }: { $count } Mal korrigiert um { $mean } ± { $deviation } { $unit }, von { $min } bis { $max }
series-share = { $count } ({ $share } ± { $error } %)
series-more = Das Programm misst { $count }-mal; aufgeführt sind die ersten { $shown } Messungen. Für die übrigen ein Programm ausführen, das mit ihnen beginnt.
series-share-all = { $count } (100 %; mit 95 % Sicherheit mindestens { $least } %)
series-uncorrected = Dieselben Teile ohne Korrektur:
series-nothing = Es wurde nichts gemessen.
series-no-alarm = Kein Alarm in { $runs } Läufen: mit 95 % Sicherheit weniger als { $most } %.

series-tilt-x = Drehung um X, Abweichung
series-tilt-y = Drehung um Y, Abweichung
series-tilt-z = Drehung um Z, Abweichung
series-taper = Konizität
series-out-of-round = Unrundheit
series-ball-radius = Kugelradius

certainty-touch = Wiederholgenauigkeit des Messtasters
certainty-calibration = Kalibrierung des Messtasters
certainty-form = Formfehler des Werkstücks
certainty-temperature = Temperatur des Werkstücks
certainty-value = { $value } ± { $expanded } { $unit } (k = { $coverage })  { $label }
certainty-proof-good = Nachweislich gut.
certainty-proof-undecided = Weder gut noch schlecht ist nachgewiesen.
certainty-proof-bad = Nachweislich schlecht.
certainty-good = gut { $share } %
certainty-rework = Nacharbeit { $share } %
certainty-scrap = Ausschuss { $share } %
certainty-beyond = außerhalb der Grenzen { $share } %
certainty-stopped = Vorzeitig beendet: { $share } % der Läufe. Darunter zählen nur die anderen.
certainty-largest = Größter Beitrag: { $source }, { $share } %.
certainty-runs = Aus { $runs } Läufen.
certainty-no-call = Das Programm misst nichts, dessen Unsicherheit sich angeben ließe.
certainty-nothing = Nichts streut: Geben Sie dem Messtaster seine Wiederholgenauigkeit, dem Teil seinen Formfehler oder seine Temperatur.

series-choose-order = Wählen Sie _TZL < _TMV < Toleranzgrenzen < _TDIF < _TSA. Dann trifft jede Abweichung auf die Grenze, die für sie gedacht ist.
series-choose-tzl = _TZL, Nullkorrektur: größer als die Streuung von Messung und Prozess. Darunter wird nichts korrigiert, nur der Mittelwert läuft weiter.
series-choose-tmv = _TMV: etwa zwei Drittel der Toleranz. Eine größere Abweichung wird sofort und ganz korrigiert und löscht den Mittelwertspeicher.
series-choose-k = _K, Wichtungsfaktor: 1 korrigiert jede Abweichung über _TZL ganz und folgt dem Zufall. 3 bis 10 folgen einem Trend langsamer, und ein einzelnes Teil verstellt das Werkzeug nicht.
series-warmth = Temperatur des Werkstücks, K
series-wear = Werkzeugverschleiß von Teil zu Teil
series-warms = Werkstück wird von Teil zu Teil wärmer
