# Szenarien: Programme, mit dem erwarteten Ergebnis verglichen.

scenarios-title = Szenarien
scenarios-what = Ein Szenario enthält ein Programm, seine Maschine und das erwartete Ergebnis: Ergebnisse jedes Aufrufs, Korrekturen, Alarme, Protokoll. Nach jeder Änderung lässt es sich wieder ausführen. „Installation prüfen“ rechnet in diesem Browser nach: Beispiele und Zahlen der Handbücher sowie Gegenproben, die den Messtaster kalibrieren, korrigieren und noch einmal messen.
scenarios-note = Programm als Szenario speichern
scenarios-open-files = Szenarien ausführen …
scenarios-open-folder = Ordner ausführen …
scenarios-none = Unter diesen Dateien ist kein Szenario: In einem Ordner enden ihre Namen auf scenario.json.
scenarios-passed = Bestanden: { $good } von { $count }
scenarios-done = Ausgeführte Szenarien: { $done } von { $scenarios }
scenarios-time = Zeit: { $seconds } s
scenarios-stop = Anhalten
scenarios-good = bestanden
scenarios-bad = nicht bestanden
scenarios-from-example = Beispiel: { $source }
scenarios-from-vector = Zahlen: { $source }
scenarios-from-loop = Gegenprobe: { $source }
scenarios-unused = Dateien, die kein Szenario braucht: { $count }
scenarios-unused-why = Im Ordner endet der Name eines Szenarios auf scenario.json; die Programme, die es nennt, liegen daneben. Ist die Datei ein Szenario, sie umbenennen.
scenarios-unused-more = und { $count } weitere
