# A program that is run many times.

runs-title = Series of parts
runs-intro = Runs the open program on the machine in use, part after part. Say what varies from part to part; all else stays the same.
runs-count = Parts
runs-seed = Seed
runs-mode = Each part
runs-production = finds the corrections of the part before
runs-independent = begins anew
runs-vary = Varies: { $number }
runs-what = What
runs-asked = Parts and what varies
runs-answered = What the series came to
runs-of-part = of part { $part }
runs-of-probe = of the probe
runs-of-name = another, by its name
runs-name = Name in the setup file, or data. and a variable
runs-units = Lengths in mm, angles in degrees, times in seconds.
runs-as = Spread
runs-normal = normal
runs-uniform = uniform
runs-triangular = triangular
runs-arcsine = arcsine
runs-sigma = Standard deviation
runs-half = Half width
runs-offset = Mean
runs-drift = Drift per part
runs-per = Drawn
runs-part = Part
runs-series = once for all
runs-follows = Follows corrections (variable=factor; …)
runs-follow = { $name } ({ $variable }), factor { $factor }
runs-follow-add = Follow a correction of the program
runs-values = Values one after the other: { $values }
runs-add = Add what varies
runs-preset = Add by name
runs-remove = Remove
runs-choose = Choose limits and weight
runs-program = Program of the example
runs-example = Example: mean value
runs-example-hint = Run the table of the manual: the same parts with weight 3 and with weight 1.
runs-run = Run series
runs-stop = Stop
runs-print = Print
runs-close = Close
runs-progress = Progress of the series
runs-running = The series is running.
runs-stopped = The series was stopped.
runs-no-program = There is no program: open one, or run the example.
runs-in-file = In the setup file: { $name }
runs-nothing = { $place }: “{ $name }” varies by nothing. Enter a standard deviation or half width, a mean or a drift.
runs-no-number = This is no number: { $text }
runs-whole = { $field }: enter a whole number from { $least } to { $most }
runs-ending =
    { $runs ->
        [one] 1 part
       *[other] { $runs } parts
    }, { $finished } to the end of the program, seed { $seed }
runs-first = Charts and table show the first { $count } parts; all figures are over all parts.
runs-no-call = Nothing was measured.
runs-call = { $cycle }, line { $line }: { $feature }
runs-weight = { $named }, { $name } = { $value }
runs-part-at = Part { $part }
runs-parts = parts
runs-actual = Actual value
runs-set = Setpoint
runs-limit = Limit
runs-mean = Setpoint + mean value { $name }
runs-empirical = Setpoint + empirical value { $name }
runs-spread = Mean { $mean }, standard deviation { $deviation }, from { $min } to { $max }
runs-capability = Cp { $cp } ({ $cpLow } to { $cpHigh }), Cpk { $cpk } ({ $cpkLow } to { $cpkHigh }), intervals of 95 %
runs-correction = Correction at each part: { $name }
runs-correction-sum = Correction so far: { $name }
runs-corrected =
    { $count ->
        [one] Corrected at 1 part
       *[other] Corrected at { $count } parts
    }
runs-shares = Verdicts
runs-with = With corrections
runs-without = The same parts without corrections
runs-alarms = Alarms
runs-no-alarm = No alarm.
