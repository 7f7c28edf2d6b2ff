# Sentences of the generated pages in docs/; the cycles, alarms and data on them have words of their own.

report-alarms = Alarms and messages
report-generated = Generated from the catalogue; do not edit.
report-known-simulated = Form, checks, program text and simulation.
report-known-stops = Form, checks and program text; not simulated, a run stops at the call.
report-default-machine = as on the machine
report-around = Blocks around a measuring call
report-around-intro = What a shop writes by hand around a measurement. `probewright write` adds a block with `--around NAME` and sets its fields with `--around NAME.FIELD=VALUE`; the page has them in the form. Labels begin with PW, and labels and variables are ones that the program does not use.
report-jog = Measuring in JOG
report-jog-intro = The masks of measuring in JOG: what each measures, where the probe is before NC start, what is written, and its fields with the names that a script of `probewright jog` uses. Axes are those of G17.
report-jog-mask = In a script: { $mask }. Source: { $source }.
report-jog-results = Results: { $names }.
report-jog-older = Up to measuring cycles SW 6.2
report-jog-older-intro = These masks are there with `PW-JOG` = 1 in the machine data, instead of those above but for Measure tool.
report-machine = Machine data
report-machine-intro = SINUMERIK: user data of the blocks GUD5, GUD6 and GUD7 and the machine data that measuring cycles depend on. NCT, at the end: variables and parameters of the probing macros. Generated from the tables in `core/src/control`; do not edit.
report-own-setting = none: a setting of Probewright
report-unit-active = mm or inch, active
report-unit-basic = mm or inch, basic
report-feed-basic = mm/min or in/min, basic
report-speed-basic = m/min or ft/min, basic
report-alarms-raised = Alarms
report-always = always
report-and = and
report-between = { $from } to { $to }
report-every-variant = Every variant
report-about = Help
report-of-channel = channel
report-of-control = control
report-optional = optional
report-optional-when = optional if { $condition }
report-or = or
report-parameters = Parameters
report-raised = Raised by: { $cycles }. Detected: { $found }. Source: { $source }.
report-required = required
report-required-when = required if { $condition }
report-results = Results
report-source = Source: { $source }.
report-standard = { $old }; { $new } from NCK 63
report-unit-rpm = rpm
report-variants = Measuring variants
report-when-digit = { $place ->
        [1] 1st
        [2] 2nd
        [3] 3rd
       *[other] { $place }th
    } digit of `{ $param }` ∈ { $numbers }
report-when-given = `{ $param }` given
report-when-not = not ({ $condition })
report-when-tool = tool type { $from } to { $to }
report-when-variant = variant ∈ { $numbers }
report-column-block = block
report-column-bounds = limits
report-column-called = called
report-column-cure = remedy
report-column-cycles = cycles
report-column-datum = data item
report-column-default = default
report-column-effective = effective
report-column-jog = JOG
report-column-meaning = meaning
report-column-measures = measures
report-column-name = name
report-column-need = needed
report-column-number = number
report-column-range = range
report-column-source = source
report-column-standard = default
report-column-type = type
report-column-unit = unit
report-column-used = used here
report-column-when = when

# The terminal program itself: what it says about a wrong use, and names of what it prints.

terminal-error = error
terminal-language = there is no language { $code }; available: { $known }
terminal-cycle = there is no cycle { $name }; “probewright cycles” lists them
terminal-variant = { $cycle } has no variant { $number }
terminal-parameter = { $cycle } has no parameter { $name }
terminal-twice = { $name } is specified twice
terminal-around = { $cycle } has no block { $name } here; there are: { $known }
terminal-around-field = block { $name } has no field { $field }
terminal-around-problem = { $name }: { $problem }
terminal-pair = not NAME=VALUE: { $text }
terminal-alarm = there is no alarm or message { $name }
terminal-name = no cycle, data item, finding or alarm has this name: { $name }
terminal-large = larger than { $most } MB
terminal-text = not UTF-8 text
terminal-surface = the setup has no free surface that could be replaced
terminal-more = More findings: { $count }
terminal-raised = alarm { $alarm }
terminal-log = output
terminal-log-left = File { $name }, lines: { $lines }; --log FOLDER saves it
terminal-log-written = File written: { $path }, lines: { $lines }
terminal-log-exists = { $path } exists already and was not overwritten: delete it, or specify another folder
terminal-told-cause = cause
terminal-told-cure = remedy
terminal-told-effect = effect
terminal-told-sources = raised by
terminal-told-found = detected
terminal-told-source = source

# Help pages of the terminal program and what it says about wrong arguments; names of its files stay.

terminal-usage = Usage
terminal-any-options = [OPTIONS]
terminal-commands = Commands
terminal-arguments = Arguments
terminal-options = Options
terminal-probewright-about = Programming assistant for CNC measuring cycles
terminal-cycles-about = List measuring cycles and macros
terminal-explain-about = Explain a cycle, mask of measuring in JOG, alarm, finding, parameter, result or data item of the machine, for example CYCLE977, set_edge, 61303, PW135 or _SZA
terminal-alarms-about = Show meaning and remedy of an alarm; without a number, list all alarms
terminal-check-about = Check part programs; exit status 1 if there is an error, 2 if a file cannot be read
terminal-write-about = Write the program text of a call to standard output
terminal-read-about = List the measuring calls of a part program
terminal-run-about = Simulate a part program; exit status 1 if it has an error or does not reach its end
terminal-series-about = Run a program many times, with what the setup file lets vary (member series): spread of the results, shares of good, rework and scrap, alarms; exit status 1 if no run reaches its end
terminal-test-about = Run scenarios: programs with their machine and the expected outcome; exit status 1 if a case fails
terminal-jog-about = Carry out a session of measuring in JOG from a script; exit status 1 if a line is refused or an alarm is raised
terminal-machine-about = Check a machine by what its control exported: machine data, definition files, series archive as text; exit status 1 if there is an error
terminal-braking-about = Calculate the braking path of a feed, or the largest feed for a deflection that the probe allows
terminal-repeat-about = Write the test programs of a probe, and evaluate repeated touches: simulated, or values of a real machine
terminal-lsp-about = Serve an editor by the Language Server Protocol, on standard input and output: findings, explanations, completion, fixes
terminal-help-about = Show the help of a command
terminal-lang-text = Language of the output, for example zh; default: language of the environment, otherwise English
terminal-json-text = Output as JSON
terminal-cycles-json-text = Output as JSON, with variants, parameters and results
terminal-check-json-text = Output as JSON: the findings of each file
terminal-name-text = Name or number
terminal-variant-text = Measuring variant of the cycle, for example 101: shows its help page
terminal-number-text = Number, for example 61303, or message of an NCT control, for example “PROBE FAIL”
terminal-files-text = Part programs
terminal-file-text = Part program
terminal-control-text = Control: sinumerik (840D, 840Di, 810D) or nct; without it, recognised from the program
terminal-setup-text = Setup file, see docs/setup.schema.json; without it, a machine that fits the program is assumed and reported
terminal-with-text = Definition files (.DEF) and subprograms that belong to the program, or a folder of them
terminal-program-text = Program of the text to run, by its name; without it the first one
terminal-arg-text = Value for a parameter of the program itself, for example DEPTH=5
terminal-screens-text = Print the measuring result screen of each call that shows one (_CHBIT[10])
terminal-strict-text = Stop at a subprogram or a machine value that is missing
terminal-max-blocks-text = Stop after this number of blocks; long ones, arrays and motions in loops count several times
terminal-assumed-values = Machine values that were assumed: { $values }. Line numbers are in brackets.
terminal-progress = { $share }%, { $blocks } blocks
terminal-test-passed = ok
terminal-test-failed = FAILED
terminal-test-held = Passed: { $good } of { $count }
terminal-test-none = no scenario.json and no file with the ending .scenario.json in this folder
terminal-check-setup-text = Setup file of the machine, with its tools and data; without it, the default machine
terminal-cycle-text = Name of the cycle, for example CYCLE977
terminal-values-text = Values, for example _SETVAL=132
terminal-comments-text = Write a comment line for each parameter
terminal-around-text = Block around the call: NAME, its fields as NAME.FIELD=VALUE; may be repeated (see docs/around.md)
terminal-style-text = Call style: direct (assignments, then the call; default), indirect (CYCLE_PARA and a parameterising call), operate (argument list of newer controls)
terminal-print-text = File for the printout: what addresses V and W of NCT macros print
terminal-log-text = Folder for measurement logs and for files that the program writes; existing files are not overwritten
terminal-record-text = File for the record of all measurements: a table (.csv) or a document (.json, see docs/record.schema.json)
terminal-record-ending = the record is written as .csv or .json: choose one of these endings
terminal-measured-text = Protocol of a real machine: the log of the control or a table; its values are laid onto the calls of the program, and the record is that of these values
terminal-columns-text = Columns of this table, for example actual=Measured nominal=3; names: number, line, result, nominal, actual, deviation
terminal-column = not a column of a protocol: { $text }; for example actual=3
terminal-surface-text = Surface instead of the one in the setup file, of the same size: a PNG picture (white is highest), dome, waves, saddle or step; an STL file keeps its size
terminal-scan-nc-text = File for the output of digitizing: the NC program
terminal-scan-xyz-text = File for the points, as lines X Y Z in mm
terminal-scan-surface-text = File for the points of the surface, as lines X Y Z in mm: without the ball radius
terminal-script-text = Script: a line for each key, value or motion, for example “mask set_edge”, “zo = G54”, “move X-20 Y10”, “start”
terminal-series-setup-text = Setup file with the member series, see docs/setup.schema.json
terminal-series-json-text = Output as JSON: mean, deviation, quantiles and histogram of each result, shares, alarms
terminal-runs-text = Number of runs; without it, that of the setup file
terminal-seed-text = Seed of the random numbers; the same seed gives the same results
terminal-csv-text = File for a table: a line for each run, a column for each measured value
terminal-jog-setup-text = Setup file of the machine, with probe, part and zero offsets, see docs/setup.schema.json
terminal-random-text = Place the part at random: moved, rotated, of another size; the same number makes the same part
terminal-what-if-text = Also tell what the next key, NC start or Calculate, would do at the end of the script
terminal-masks-text = List the masks with their fields, and what they take
terminal-scenarios-text = Scenario files, or folders: of these, each scenario.json and each file with the ending .scenario.json
terminal-junit-text = File for the result in JUnit XML
terminal-as-program-text = Print the automatic cycle that does what the mask that is open does, and what differs
terminal-machine-files-text = Files that the control exported, or lines such as MD 18120 = 30; of data in several files the last one counts
terminal-without-text = What this machine does not use: jog, log, tool-probe; several with commas
terminal-ncu3-text = The control is an NCU 3: larger memories
terminal-changes-text = File for the lines to change, as the control reads them; an existing file is overwritten
terminal-machine-json-text = Output as JSON, with limits and sources
terminal-machine-limit = required: { $value } ({ $source }), otherwise { $severity }
terminal-machine-source = source: { $source }
terminal-machine-default = default: { $value }
terminal-machine-change = change: { $line }
terminal-machine-channel = channel { $channel }
terminal-machine-missing = Not in these files ({ $count }):
terminal-machine-deflection-text = Permitted deflection of the probe, mm: feeds whose braking path is longer are reported
terminal-delay-text = Time from the signal to the braking command, s: MD 10050 times MD 10070
terminal-acceleration-text = Deceleration, m/s²: the lowest MD 32300 of the axes
terminal-gain-text = Servo gain Kv, (m/min)/mm: the lowest MD 32200 of the axes
terminal-feed-text = Feed, mm/min: tells its braking path
terminal-deflection-text = Permitted deflection of the probe, mm: tells the largest feed
terminal-axis-text = Axis that moves: X, Y or Z; default: X
terminal-from-text = Where the motion begins; default: 0
terminal-to-text = Where it ends without a signal; default: 50
terminal-repeat-feed-text = Feed of the touch, per minute; default: 150 mm/min
terminal-input-text = Measuring input, 1 or 2; default: that of _CHBIT[0]
terminal-count-text = Number of touches; default: 10
terminal-mcs-text = Values in the machine coordinate system
terminal-parameters-text = Keep the values in R parameters from this one on; default: in an array of the program
terminal-m6-text = Change the tool with M6
terminal-repeat-program-text = Print the program of repeated touches
terminal-function-text = Print the program of the function test
terminal-repeat-json-text = Output as JSON, with both programs
terminal-value-axis = AXIS
terminal-value-position = POSITION
terminal-value-input = INPUT
terminal-value-count = COUNT
terminal-value-r = R
terminal-repeat-values-text = File with values of a real machine, separated by blanks or lines; default: run the program
terminal-help-text = Show help
terminal-version-text = Show the version
terminal-value-command = COMMAND
terminal-value-lang = LANGUAGE
terminal-value-folder = FOLDER
terminal-value-name = NAME
terminal-value-columns = COLUMNS
terminal-value-variant = VARIANT
terminal-value-number = NUMBER
terminal-value-files = FILES
terminal-value-file = FILE
terminal-value-control = CONTROL
terminal-value-setup = SETUP
terminal-value-cycle = CYCLE
terminal-value-values = VALUES
terminal-value-around = NAME[.FIELD=VALUE]
terminal-value-style = STYLE
terminal-value-scenarios = SCENARIOS
terminal-value-script = SCRIPT
terminal-value-uses = USES
terminal-value-seconds = SECONDS
terminal-value-deceleration = DECELERATION
terminal-value-gain = GAIN
terminal-value-feed = FEED
terminal-value-mm = MM
terminal-value-random = NUMBER
terminal-wrong-argument = there is no argument { $name }
terminal-wrong-command = there is no command { $name }
terminal-wrong-none = a command is missing
terminal-wrong-value = “{ $value }” is not permitted for { $name }; permitted: { $known }
terminal-wrong-empty = a value is missing: { $name }
terminal-wrong-number = “{ $value }” is not a number: { $name }
terminal-wrong-missing = missing: { $name }
terminal-wrong-conflict = { $name } and { $other } exclude each other
terminal-wrong-similar = Similar: { $known }
terminal-wrong-more = Help: --help

# The language server: what an editor shows.

server-malformed = not a message of the Language Server Protocol
server-length = the header of the message has no valid Content-Length
server-method = the server has no method { $name }
server-parameters = wrong parameters of { $name }: { $text }
server-early = the session has not begun: send initialize first
server-twice = the session has begun already
server-ended = the session has ended
server-cancelled = the request was cancelled
server-setting = setting “probewright”: { $text }
server-call = Call of { $cycle }
server-all = { $label } (all of this kind: { $count })
server-direct = Write as assignments and call
server-indirect = Write as parameterising call (CYCLE_PARA)
server-operate = Write as argument list of newer controls
server-every-direct = Write all calls as assignments and call
server-every-indirect = Write all calls as parameterising calls (CYCLE_PARA)
server-every-operate = Write all calls as argument lists of newer controls
server-unit = Unit: { $unit }
server-fallback = Default: { $value }
server-label = Label
server-subprogram = Subprogram call
server-program = Program
server-source = Source: { $source }
