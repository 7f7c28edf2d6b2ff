# Scenarios: programs held against the expected outcome.

scenarios-title = Scenarios
scenarios-what = A scenario holds a program, its machine and the expected outcome: results of each call, corrections, alarms, log. Run them again after every change. “Check this installation” runs in this browser: the worked examples of the manuals, their figures, and closed loops, which calibrate a probe, correct and measure again.
scenarios-note = Save program as scenario
scenarios-open-files = Run scenarios …
scenarios-open-folder = Run folder …
scenarios-none = There is no scenario among these files: in a folder, their names end in scenario.json.
scenarios-passed = Passed: { $good } of { $count }
scenarios-done = Scenarios run: { $done } of { $scenarios }
scenarios-time = Time: { $seconds } s
scenarios-stop = Stop
scenarios-good = passed
scenarios-bad = failed
scenarios-from-example = Worked example: { $source }
scenarios-from-vector = Figures: { $source }
scenarios-from-loop = Closed loop: { $source }
scenarios-unused = Files that no scenario needs: { $count }
scenarios-unused-why = A scenario in a folder has a name that ends in scenario.json; the programs that it names lie beside it. Rename the file if it is one.
scenarios-unused-more = and { $count } more
