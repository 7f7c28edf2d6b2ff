# Texts of the page itself. What the core says is in core/messages/.

app-name = Probewright
panels = Panels
panel-tasks = Tasks
panel-form = Form
panel-program = Program
panel-view = 3D view
panel-results = Result
panel-help = Help
panel-more = More
splitter-form = Width of the form
splitter-dock = Height of the program and results
splitter-program = Width of the program
splitter-help = Drag to resize. Double-click to maximise or restore.
sheet = Program and results
sheet-help = Drag, or use the arrow keys: strip, half or full height.
sheet-up = Raise
sheet-down = Lower
sheet-peek = Strip
sheet-half = Half
sheet-full = Full height
skip = Skip
skip-to = Go to: { $panel }

control-sinumerik = SINUMERIK
control-nct = NCT

unit-mm = mm
unit-inch = inch
unit-deg = °
unit-mm-per-min = mm/min
unit-inch-per-min = in/min
unit-m-per-min = m/min
unit-ft-per-min = ft/min
unit-rpm = rpm
unit-percent = %
unit-kb = KB
unit-s = s
unit-hex = hex

facts = Machine
machine = Machine at program start
machine-all-data = (including feeds and data)
machine-at-call = At the call: { $functions }
plane-g17 = X Y
plane-g18 = Z X
plane-g19 = Y Z
fact-control = Control
fact-built = { $control }, basic system { $unit }
fact-unit = Units
fact-plane = Plane
fact-tool = Tool
fact-probe = Probe
fact-ball = ball Ø { $diameter } { $unit }
fact-calibration = Calibration
fact-true = matches the probe
fact-deviates = does not match the probe

list-pair = { $one }, { $other }
machine-data-title = Machine data
machine-data-basic = Basic system
machine-data-basic-help = Unit of the machine data and, with some G functions, of feeds. Changing it converts the machine data; values in forms and programs keep their numbers.
machine-data-search = Search machine data
machine-data-search-hint = Name or words, such as _WP or feed
machine-data-changed = Changed data only
machine-data-count = { $changed } of { $all } changed
machine-data-group-changed = { $changed } changed
machine-data-none = Nothing found. Enter fewer words, or show all data.
machine-data-nothing = This control has no machine data to set.
machine-data-delivered = { $value } (default)
machine-data-assignments = Copy as program
definitions-title = Definition files, value assignments
exported-title = Check a machine
repeat-title = Test a probe: repeat accuracy
user-program-title = Lines around measuring cycles (CYCLE198, CYCLE199)
machine-data-reset = Reset to defaults
machine-data-close = Done
machine-data-idle = No effect in the simulation.

link-copy = Copy link
theme-system = Theme: system
theme-light = Theme: light
theme-dark = Theme: dark
theme-contrast = Theme: high contrast
menu = Menu
handbook-open = Handbook
about-open = About

tasks-title = Measuring task
search-open = Search
tasks-search = Search cycles, parameters, results and alarms
tasks-search-hint = Cycle, alarm, words
tasks-coming = Loading the other cycles …
tasks-absent = The other cycles could not be loaded. Reload the page to try again.
tasks-none = Nothing found for “{ $search }”. Try another word, or a cycle or alarm number.

form-opened = Edits { $cycle } in the program, lines { $from } to { $to }
form-opened-line = Edits { $cycle } in the program, line { $line }
explain-more = More
explain-concept = Concept
explain-concept-hint = Explain the concept
explain-less = Less

help-open = Help
help-title = { $cycle } · { $name }
help-close = Close
help-coming = Loading the help page …
help-absent = The help page could not be loaded. Close and reopen it to try again.
help-no-variant = The help page depends on the measuring variant: choose one in the form.
help-values-title = Inputs
help-results-title = Results ({ $count })
help-alarms-title = Possible alarms ({ $count })

form-detach = Detach from program
form-check = Check
form-example = Worked example
screen-start = NC START
screen-halt = Halt here while playing
screen-open = Measuring result screen
around-open = Around the call
around-apply = Write into program
around-back = Back to program
around-none = The call has no blocks that suit it.
around-unsuited = Does not suit this call.
around-absent = Not on this control:
form-snippet = Program text
form-comments = Add comments
form-call = Call
form-copy-call = Copy call
form-more = More
form-variant-open = All tasks
form-copy = Copy
form-insert = Insert at cursor
form-complete = Complete
form-incomplete = Incomplete
form-errors = { $count ->
    [one] 1 problem
   *[other] { $count } problems
 }

field-default = default { $value }
field-otherwise = default { $value }
field-required = Required: { $reason }
field-optional = Optional: { $reason }
field-source = Source: { $source }.
columns-list = Columns of { $name }
columns-remove = Remove column “{ $name }”
columns-choice = Column for { $name }
columns-add = Add column
columns-note = Results have the names that most cycles give them.
columns-printed = Preview of { $name }
columns-marked = Beyond a limit:
choice-none = choose …
choice-default = default
choice-other = other number
choice-label = { $name }, choice
severity-error = Error
severity-warning = Warning
severity-note = Note

picture-plane = Drawing of the measurement, view of the working plane
picture-section = Drawing of the measurement, section
picture-space = Drawing in space, from beside and above

editor-find = Find
editor-replace-with = Replace
editor-next = Next
editor-previous = Previous
editor-all = All
editor-match-case = Match case
editor-regexp = Regular expression
editor-by-word = Whole words
editor-replace = Replace
editor-replace-all = Replace all
editor-close = Close
editor-current-match = Current match
editor-on-line = on line
editor-replaced = Replaced match on line $
editor-replaced-all = Replaced $ matches
editor-go-to-line = Go to line
editor-go = Go
editor-problems = Problems
editor-no-problems = No problems
editor-deleted = Selection deleted
editor-control-character = Control character

language = Language
notice-no-language = This language could not be loaded.

program-title = Program
program-loading = Loading the editor …
program-editor = Part program
program-calls = Measuring calls in the program
program-call-count = { $count ->
    [one] 1 call
   *[other] { $count } calls
 }
program-call-line = line { $line }
program-no-call = no measuring call
program-file = File
program-copy-all = Copy program
program-copy = Copy
program-open = Open
program-save = Save
program-unsaved = Not saved to the file
program-file-sinumerik = program.mpf
program-file-nct = program.nc

encoding = File encoding
encoding-read = Read the file as
encoding-save = Save the text as
encoding-lacking = Line { $line }: { $encoding } has no “{ $character }”. The program cannot be saved in this encoding.
encoding-save-as = Save as { $encoding }
encoding-show = Show character
encoding-utf-8 = UTF-8
encoding-utf-8-marked = UTF-8 with BOM
encoding-utf-16le = UTF-16 LE
encoding-utf-16le-marked = UTF-16 LE with BOM
encoding-utf-16be = UTF-16 BE
encoding-utf-16be-marked = UTF-16 BE with BOM
encoding-gbk = GBK
encoding-gb18030 = GB 18030
encoding-big5 = Big5
encoding-shift_jis = Shift JIS
encoding-euc-kr = EUC-KR
encoding-windows-1252 = Windows-1252, Western
encoding-windows-1250 = Windows-1250, Central European
encoding-windows-1251 = Windows-1251, Cyrillic
encoding-latin-1 = ISO 8859-1

activity-stop = Stop
activity-halt = Pause
activity-go-on = Continue
activity-again = Try again
activity-seconds = { $seconds } s
activity-share = { $percent }%
opening-working = Opening the program …
opening-working-on = Opening the program ({ $size } MB) … The previous one remains until then.
laying-working = Loading the program into the editor …
laying-working-on = Loading the program into the editor ({ $size } million characters) …
laying-stopped = The program is still available, but the editor does not show it.
reading-working = Reading the program …
reading-working-on = Reading the program ({ $size } million characters) … You can continue typing.
reading-stopped = Reading was stopped. The calls of this program are not known.
reading-failed = The program could not be read: { $why }
running-working = Running the program …
running-working-on = Running the program ({ $size } million characters) …
running-halted = The run is paused.
running-stopped = The run was stopped.
running-failed = The program could not be run: { $why }

view-title = 3D view
view-source = Motions shown
view-form = This call
view-program = Whole program
view-loading = Loading the 3D view …
view-failed = The 3D view could not start: { $problem }
view-canvas = Simulated motions in 3D
view-fit = Fit
view-iso = Oblique
view-top = Top
view-front = Front
view-right = Right
view-back = Back
view-left = Left
view-bottom = Bottom
view-cube = View from
view-section = Section
view-central = Perspective
view-errors = Errors shown
view-errors-most = at most { $times }: above that, the part would be unrecognisable
view-nominal = dashed: nominal; labels and values are true
view-diameters = Diameters
view-diameters-help = Diameters as on a drawing: actual value, below it nominal value and deviation; at a touch point, the position read by the control. X as the control displays it. In mm.
legend = Legend
legend-measuring = measuring
legend-positioning = positioning
legend-rapid = rapid
legend-retract = retract
legend-touch = touch point with normal
legend-swept = space swept by the probe
legend-crash = crash
legend-zone = protection zone
legend-limit = maximum measurable error
legend-carrier = holder: not checked for collisions
legend-thinned = { $drawn } of { $points } points are drawn, evenly selected; figures and files contain all points
timeline-first = First step
timeline-back = Step back
timeline-play = Play
timeline-pause = Pause
timeline-on = Step forward
timeline-last = Last step
timeline-scrub = Step
timeline-speed = Speed
timeline-seconds = { $seconds } s
timeline-times = { $times } ×
motions-running = The motions appear here when the run has finished.
motions-none = No motions.
motions-block = Motions { $from } to { $to } of { $count }; use the timeline for the others.
motions-line = line { $line }
motion-rapid = Rapid to { $to }
motion-positioning = Positioning to { $to }, F{ $feed }
motion-measuring = Measuring towards { $to }, F{ $feed }
motion-retract = Retract to { $to }
step-touch = Touch at { $at }
step-touch-stylus = The stylus touches at { $at }
step-crash = Crash at { $at }
step-crash-stylus = Crash of the stylus at { $at }
step-crash-body = Crash of the probe body at { $at }
step-crash-cutter = Crash of the tool with the part at { $at }
step-orient = Spindle to { $angle }°
step-spin = Spindle { $direction }, { $speed } rpm
step-table = Rotary axis { $axis } to { $angle }°
step-tool = Tool T{ $tool } D{ $edge }
step-set = { $name }: from { $before } to { $after }
step-call = { $cycle } starts, variant { $variant }
step-call-only = { $cycle } starts
step-return = The cycle ends
step-file = File { $name } created

tab-outcome = Result
tab-problems = Problems
tab-problems-count = Problems ({ $count })
tab-motions = Motions
tab-log = Log
outcome-alarms = Alarms
outcome-results = Results
outcome-changes = Offsets and calibration data
outcome-decisions = Evaluation
outcome-screens = Measuring result screens ({ $count })
outcome-no-changes = No correction.
outcome-not-simulated = This version does not simulate { $cycle }. Form, checks and program text are available.
outcome-running = Results of the whole program appear here when the run has finished.
outcome-coming = Calculating the result …
outcome-absent = The core could not be loaded: without it there is no check, no program text and no result. Reload the page to try again.
outcome-incomplete = Complete the form to see the result.
outcome-newer = The argument list of this newer control is not fully known, so the call is not simulated.
outcome-missing = The result appears here once these are correct: { $names }
outcome-earlier = not written by this call
outcome-assumed = These values depend on the path through the program. Calculated with the first values reached: { $values }
outcome-assumed-value = { $name } = { $value } (line { $line })
outcome-unknown = Known only when the program runs: { $names }. Run the whole program in the 3D view, or enter a number.
column-name = Name
column-what = Item
column-meaning = Meaning
column-value = Value
column-unit = Unit
column-before = Before
column-after = After
column-difference = Change
problems-more = { $count } more, marked in the program; listed here once the problems above are fixed.
problems-none = No problems found.
problem-place = line { $line }, column { $column }
log-save = Save as file
log-save-file = Save { $name }
log-lines = { $count ->
    [one] { $shown } of { $count } line
   *[other] { $shown } of { $count } lines
 }
log-none = Nothing was logged.

sliders-open = Errors
sliders-open-help = Simulated errors of part and probe
sliders-title = Simulated errors
sliders-reset = Reset to zero
sliders-part = Part errors
sliders-probe = Probe errors
sliders-limits = Limits
sliders-limits-help = Maximum errors of part or tool probe at which this measurement still completes
slider-limits = −{ $low } to +{ $high }
slider-figure = { $name }, value
error-part-size = Size
error-part-dx = Shift X
error-part-dy = Shift Y
error-part-dz = Shift Z
error-part-tilt = Angle
error-part-taper = Taper
error-part-out-of-round = Out-of-roundness
sliders-tool-part = Tool probe errors
sliders-tool-probe = Tool and signal errors
error-tool-probe-skew-x = Length L1
error-tool-probe-skew-y = Length L2
error-tool-probe-radius = Tool radius
error-probe-skew-x = Skew { $axis }
error-probe-skew-y = Skew { $axis }
error-probe-radius = Ball radius
error-probe-pre-travel = Pre-travel
error-probe-repeatability = Repeatability

notice-copied = Copied.
notice-inserted = Inserted. The form now edits this call.
notice-link-long = The program is too long for a link. Save it as a file.
notice-link = Link copied: form, program, setup and simulated errors.
notice-no-clipboard = No access to the clipboard. Select and copy manually.
notice-not-kept = The browser does not store your work. Save the program.
notice-given = Added to the machine.
notice-setup = Setup opened.
notice-own-setup = Default machine restored.
notice-setup-outdated = The stored setup does not fit this version: not loaded.
notice-nothing-to-save = Nothing to save yet: the setup is still loading.
notice-opened = Program opened.
notice-opened-empty = Opened: the file is empty.
notice-written = Saved to the file.
notice-denied = No permission to write to the file. Saved as a download.
notice-changed = Another program changed the file. Saved as a download.
notice-failed = The file could not be written. Saved as a download.
notice-example = Worked example loaded into the form.
notice-no-errors = All errors reset to zero.
notice-set-saved = Values saved.
notice-set-replaced = Values saved; the set of the same name was replaced.
notice-set-loaded = Values loaded.
notice-set-deleted = Values deleted.
notice-kept = The program stays as it is: the typed value was not taken.
notice-undone = Undone.
notice-redone = Redone.
print-lines = Lines omitted: { $more }. The saved file contains all { $all }.
print-sheet = Print setup sheet
print-report = Print report
paper-report = Measuring report
paper-line = Line { $line }
paper-more = Calls omitted: { $more }.
undo = Undo
redo = Redo
history = History
history-begin = Start
history-undo = Undo: { $step }
history-undo-none = Nothing to undo
history-redo = Redo: { $step }
history-redo-none = Nothing to redo
step-open = Open { $file }
step-insert = Insert call
step-convert = Convert call
step-fix = Apply change
step-kept = { $field } = { $value } not taken
step-assign = Change variable
step-example = Load worked example
step-set-load = Load value set
step-program = Edit line { $line }
step-field = { $field } = { $value }
step-values = Change { $cycle }
step-task = Choose { $cycle }
step-encoding = Encoding { $encoding }
step-errors = Simulated errors
step-machine = Machine
step-sets = Value sets

refused-program-size = { $name } was not opened: it has { $size } MB, more than this browser can hold. Your program is unchanged.
refused-setup-size = { $name } was not opened: it has { $size } MB, but a setup may have at most { $most } MB. Your setup is unchanged.
refused-no-program = { $name } was not opened: { $why }. Your program is unchanged.
refused-no-text = { $name } was not opened: { $why }. Nothing else has changed.
refused-markup = it is { $kind }, not a program; choose the program file
refused-no-blocks = { $name } was opened, but no line in it reads as a block. It may not be a program.
refused-unreadable = { $name } was not opened: the browser cannot read it. The file may have been moved or changed.
refused-folder = { $name } was not opened: it is a folder without files.
refused-setup = { $name } is not a setup and was not opened: { $why } “Export setup” writes one for comparison. Your setup is unchanged.
refused-place = line { $line }, column { $column }: { $text }
refused-other-control = { $name } was opened. It begins like a program for { $control }: calls for { $control } are not read here.
refused-under = Open under { $control }
refused-close = Close

sets-open = Value sets …
sets-title = Value sets: { $cycle }
sets-name = Name
sets-save = Save current values
sets-none = Nothing saved yet. Name the current values to reload them later.
sets-rename = Name of value set { $name }
sets-load = Load
sets-load-named = Load { $name }
sets-delete = Delete
sets-delete-named = Delete { $name }
sets-name-taken = This name is empty or already used.

continuing-title = Which work do you want to continue?
continuing-why = Probewright is open in another tab. Each tab keeps its own work. The next visit opens the work changed last.
continuing-copy = Copy of { $name }, changed { $when }
continuing-anew = Start over with the worked example

about-title = About Probewright
about-what = An assistant for CNC measuring cycles: fill in a form, get the program text, watch the probe measure a part with errors, and read what the control would do.
about-offline = Everything runs in this browser. After the first load, Probewright works without a network.
about-prove-out = A simulation does not replace proving out at the machine. Prove out every program there, with reduced feed and a hand on the override.
about-marks = SINUMERIK is a registered trademark of Siemens AG.
about-independent = Probewright is independent of Siemens and of NCT; neither company has examined or approved it.
about-licence = Licence: MIT OR Apache-2.0, at your option.
about-close = Close
scenarios-open = Scenarios
scenarios-check = Check this installation
keys-title = Keys
keys-close = Close
keys-page = Everywhere
keys-page-save = Save the program
keys-page-open = Open a program
keys-page-undo = Undo the last step
keys-page-redo = Redo
keys-page-next-panel = Next panel
keys-page-previous-panel = Previous panel
keys-page-keys = This list (outside a text field)
keys-page-close = Close help, menu or dialog
keys-form = Form
keys-form-next-field = Next field; the drawing shows its meaning
keys-form-previous-field = Previous field
keys-form-ask = Go to a proposed change
keys-form-refuse = Cancel a proposed change
keys-list = Tasks, search results, calls
keys-list-next = Next line
keys-list-previous = Previous line
keys-list-next-page = Next page of the list of calls
keys-list-previous-page = Previous page of the list of calls
keys-list-first = First line
keys-list-last = Last line
keys-list-unfold = Expand a task
keys-list-fold = Collapse a task
keys-list-choose = Select
keys-list-leave = Clear the search; from the results, return to the search
keys-tabs = Result tabs
keys-tabs-next-tab = Next tab
keys-tabs-previous-tab = Previous tab
keys-editor = Program editor
keys-editor-leave-editor = Leave the editor
keys-editor-find = Find
keys-editor-next-problem = Next problem
keys-editor-problems = All problems, with remedies
keys-editor-tell = Explain the argument at the cursor
keys-editor-untell = Close the explanation
keys-splitter = Dividers between areas
keys-splitter-nearer = Move left or up
keys-splitter-further = Move right or down
keys-splitter-least = Smallest
keys-splitter-most = Largest
keys-splitter-maximise = Maximise or restore
keys-jog = Machine in JOG
keys-jog-x-minus = X minus
keys-jog-x-plus = X plus
keys-jog-y-minus = Y minus
keys-jog-y-plus = Y plus
keys-jog-z-minus = Z minus
keys-jog-z-plus = Z plus
keys-jog-start = NC start
keys-view = 3D view
keys-view-turn = Rotate
keys-view-shift = Move
keys-view-zoom-in = Zoom in
keys-view-zoom-out = Zoom out
keys-view-fit = Fit
keys-view-top = Top view
keys-view-front = Front view
keys-view-right = View from the right
keys-view-oblique = Oblique view
key-ctrl = Ctrl
key-shift = Shift
key-enter = Enter
key-space = Space
key-home = Home
key-end = End
key-pageup = Page Up
key-pagedown = Page Down

newer-ready = A new version is ready. Reloading keeps your work.
newer-reload = Reload
newer-later = Later

broken-title = Probewright has stopped
broken-kept = This is a bug in Probewright, not a mistake in your input. Your form and your program are saved in this browser.
broken-reload = Reload

group-milling-workpiece = Milling: workpiece
group-milling-tool = Milling: tool
group-milling-calibrate = Milling: calibrate the probe
group-milling-none = Milling: without a probe
group-milling-log = Milling: measurement log
group-turning-workpiece = Turning: workpiece
group-turning-tool = Turning: tool
group-turning-calibrate = Turning: calibrate the probe
group-turning-none = Turning: without a probe
group-turning-log = Turning: measurement log
group-any-workpiece = Workpiece
group-any-tool = Tool
group-any-calibrate = Calibrate the probe
group-any-none = Without a probe
group-any-log = Measurement log

found-measurement = Measurements ({ $count })
found-around = Blocks around the call ({ $count })
found-parameter = Parameters ({ $count })
found-result = Results ({ $count })
found-guide = Guides ({ $count })
found-connection = Connections ({ $count })
found-concept = Concepts ({ $count })
found-term = Terms ({ $count })
found-alarm = Alarms ({ $count })
found-elsewhere = Newer controls, other makers ({ $count })
found-more = { $count } more. Add a word to narrow the search.

card-result = Result { $code }
card-alarm = Alarm { $code }
card-elsewhere = { $code }
card-cause = Cause
card-cure = Remedy
card-result-cycles = Returned by
card-alarm-cycles = Raised by
card-elsewhere-cycles = Calls with it
card-parts = Arguments and parameters
card-close = Close

twin-open = The same task on other controls
twin-task = { $task }: on { $control }, { $cycle }.
twin-shared = What is the same
twin-differences = What is different
twin-none = Other controls have no equivalent task for these values.

ways = Call style
ways-findings = About this call style
way-direct = direct
way-indirect = indirect
way-operate = newer controls
way-now = Call style: { $way }
convert = Convert to

call-state-ok = OK
call-state-note = OK
call-state-warning = warnings
call-state-error = errors
call-state-explained = explained, has no form
call-variant-unknown = measuring variant unknown

notice-converted = Converted.
notice-mended = Fixed.

tab-scan = Scan
view-scan = Scan
scan-surface = Surface
scan-examples = Examples
scan-example-waves = Hills and hollows
scan-example-dome = Dome
scan-example-saddle = Saddle
scan-example-step = Step
scan-open = Open STL or picture …
scan-begin = Scan
scan-scanning-working = Scanning …
scan-taking-working = Preparing the points …
scan-taking-working-on = Preparing the points ({ $size } million) …
scan-writing-working = Writing the file …
scan-writing-working-on = Writing the file ({ $size } million points) …
scan-none = Scans the whole surface with the values of the form. A file replaces the example: an STL file, used unchanged, or a picture whose bright areas are high.
scan-incomplete = Complete the form to scan.
scan-done = { $points } points in { $lines } lines.
scan-outdated = The form was changed after this scan.
scan-failed = Scanning is not possible: { $problem }
scan-file-size = { $name } has { $size } MB; permitted: at most { $most } MB.
scan-file-sort = { $name } is neither an STL file nor a picture.
scan-deviations = Distance from the true surface, mm
scan-points = Points
scan-greatest = Maximum
scan-mean = Root mean square
scan-shown-sent = As output: lowest point of the ball
scan-shown-surface = Ball removed: surface
scan-outside = outside
scan-level = on the surface
scan-inside = inside
scan-save-program = Save NC program
scan-save-points = Save XYZ as output
scan-save-surface = Save surface XYZ

form-placed = In program, line { $line }
field-reset = { $value } was cleared: it was entered for “{ $before }”.
field-unfit = { $value } was cleared: this measuring variant does not permit it.
field-pointed = Decimal point in the program: { $value }

asks-title = { $count ->
    [one] This changes a line outside the call
   *[other] This changes { $count } lines outside the call
}
asks-more = This changes more than this value
asks-show = Show the change
asks-line = Line { $line }
asks-before = old
asks-after = new
asks-apply = Apply
asks-cancel = Cancel
notice-applied = Applied.
replaced-title = The program contains { $text } here, currently { $worth }.
replaced-open = The program contains { $text } here.
replaced-uses = { $name } is used in { $count ->
    [one] 1 line:
   *[other] { $count } lines:
}
replaced-more = and { $count } more
replaced-assign = Change { $name } to { $value }
replaced-here = Replace here
replaced-remove = Remove here
replaced-keep = Keep { $text }
notice-assigned = Variable changed.
notice-revised = The call now has another measuring variant.
of-call = { $cycle }, line { $line }
of-program = Set by the program
outcome-more = Not shown: { $count }. The record has every measurement with its verdict.
results-more = More results, not listed: { $count }.
# The line that says what a call came to.
certain-value = { $value } ± { $expanded } (k = { $coverage })
certain-share = { $share }%
certain-less = < { $share }%
certain-more = > { $share }%
certain-good = good { $share }
certain-rework = rework { $share }
certain-scrap = scrap { $share }
certain-beyond = beyond the limits { $share }
certain-proof-good = Proven good.
certain-proof-undecided = Neither good nor bad is proven.
certain-proof-bad = Proven bad.
certain-largest = Largest contribution: { $source }, { $share }.
certain-stopped = Stops before the end: { $share }.
bar-title = Result of the measurement
bar-corrects = Corrects
bar-corrects-what = Corrects { $what }
bar-nothing = nothing
bar-new = new values
bar-none = The result appears here when the call can be simulated.
bar-unmeasured = This call measures nothing and comes to its end.
bar-gauge = { $needles }; limits { $low } to { $high }
# The worked example, told in steps.
practice-title = Practise measuring in JOG
practice-lead = Move the probe by hand, measure and write a zero offset, as in JOG at the machine.
practice-start = Go to the machine
practice-rail = Practise
practice-call = Practise in JOG
story-title = Try the example
story-lead = A part is shifted. Measure it, correct its zero offset, measure again: five steps.
story-start = Start the example
story-back = Back
story-next = Next
story-leave = Leave
story-count = Example, step { $step } of { $of }
story-part = The part is shifted by X { $x } and Y { $y } mm; the view shows the shift 100 times as large. The zero offset does not include it yet.
story-call = The form contains the measuring call. Each entry rewrites it, below the form and in the program.
story-probe = The probe touches the hole at four points, at the same feed as on the machine.
story-correct = The cycle corrects { $corrected }: the zero offset moves to where the part really is.
story-again = The program measures once more with the corrected offset. Now it corrects: { $left }.
notice-story-left = The example stays open.
# The measurements of a whole program.
whole-title = Measurements
whole-counts = { $all ->
    [one] 1 call: { $parts }
   *[other] { $all } calls: { $parts }
 }
whole-count-within = { $count } within
whole-count-beyond = { $count } out
whole-count-measured = { $count } measured
whole-count-missing = { $count } without a value
whole-count-alarm = { $count } with alarm
whole-count-stopped = { $count } not simulated
whole-certain = Certainty
whole-certain-hint = Run the program many times: how certain each value is, and what it proves
whole-certain-stop = Stop
whole-certain-busy = The program is run many times: { $share }%
whole-certain-row = Row { $row }: { $told }
whole-certain-told = Proven good: { $good }. Neither good nor bad: { $undecided }. Proven bad: { $bad }. From { $runs } runs.
runs-open = Series
runs-open-hint = Run this program for many parts, with what varies.
protocol-open = From the machine
protocol-open-hint = Read the log of the control or a table (CSV) of the real part, and lay its values onto calls and part.
whole-worst = Worst first
whole-csv = CSV
whole-csv-hint = Save as CSV: UTF-8, decimal point, fields separated by commas
whole-error = Stopped at { $cycle } in line { $line } ({ $feature }): { $why }
whole-error-in-file = Stopped at { $cycle } in { $file }, line { $line } ({ $feature }): { $why }
whole-number = #
whole-number-name = Number
whole-feature = Element
whole-feature-name = Element
whole-line = Line
whole-line-name = Line
whole-nominal = Setpoint
whole-nominal-name = Setpoint
whole-actual = Actual
whole-actual-name = Actual
whole-limits = Limits
whole-limits-name = Share of the limits used
whole-deviation = Deviation
whole-deviation-name = Deviation
whole-verdict = Verdict
whole-verdict-name = Verdict
whole-corrects = Corrects
whole-corrects-name = Corrects
whole-used = { $share } %
whole-between = Limits of the deviation: { $low } to { $high }
whole-probe = Probe
whole-probe-name = Probe and its calibration
whole-json = JSON
whole-json-hint = Save as JSON, as docs/record.schema.json describes it
whole-print = Print record
whole-print-hint = Print the record, or save it as PDF

# The start screen
start-place = Start
start-title = What do you want to measure?
start-lead = Choose the element, then what to correct. Probewright writes the call and shows what the machine does.
start-corrects = What is corrected?
start-coming = Loading …
start-open-form = Open form
start-others = More ways to start
start-program = Open a program
start-drop = Drop a program here
start-stays = The program stays on this computer.
start-open = Open
start-variants = All variants by number
start-recent = Recent
start-counts = Calls: { $calls }, lines: { $lines }
start-form = { $cycle }, form
start-remove = Remove { $name } from the list

difference-convert = Line { $line }: convert the call to “{ $way }”
difference-convert-all = { $count ->
    [one] Convert one call to “{ $way }”
   *[other] Convert { $count } calls to “{ $way }”
}
difference-cure = { $count ->
    [one] Fix one problem
   *[other] Fix { $count } problems
}
difference-left = { $count ->
    [one] One problem of this kind remains: its fix alone does not resolve it.
   *[other] { $count } problems of this kind remain: their fixes alone do not resolve them.
}
difference-typed = Change { $name } to { $value }
difference-typed-several = Change { $count } values
difference-summary = { $count ->
    [0] Nothing changes.
    [one] 1 place in the program changes.
   *[other] { $count } places in the program change.
}
difference-values-none = No value is added, lost or changed.
difference-added = Added
difference-lost = Lost
difference-changed = Different value
difference-findings = Check
difference-value = { $name } = { $value }
difference-becomes = { $name } = { $before } → { $after }
difference-lines = { $count ->
    [one] line { $lines }
   *[other] { $count } calls: lines { $lines }
}
difference-more = { $count } more
difference-scope = Which calls
difference-scope-one = This call
difference-scope-all = All { $count } calls
difference-before = Now
difference-after = After
difference-line = Line
difference-list = Changed lines
difference-gone = removed:
difference-came = new:
difference-changed-from = before:
difference-changed-to = after:
difference-next = Next change
difference-previous = Previous change
difference-place = { $number } of { $count }
difference-further = { $count ->
    [one] Show one more change
   *[other] Show { $count } more changes
}
difference-undo = Undo reverts this
difference-close = Close
problems-cure-all = Fix all { $count } of this kind …

keys-difference = Comparison before a change
keys-difference-apply = Apply
keys-difference-cancel = Cancel
keys-difference-next-change = Next change
keys-difference-previous-change = Previous change

palette = Search or run
palette-hint = Command, task, line, parameter, alarm …
palette-results = Search results
palette-recent = Recently used
palette-command = Commands
palette-line = Go to line { $line }
palette-field = Fields of this form
palette-call = Calls in the program
palette-measurement = Measuring tasks
palette-parameter = Parameters
palette-result = Results
palette-around = Blocks around the call
palette-guide = Guides
palette-connection = Connections
palette-concept = Concepts
palette-term = Terms
palette-alarm = Alarms
palette-elsewhere = Newer controls, other makers
palette-finding = Problems
palette-help = Help pages
palette-datum = User and machine data
command-copy-call = Copy call
command-copy-program = Copy program
command-convert = Convert call to “{ $way }” …
command-convert-all = { $count ->
    [one] Convert the call of the program to “{ $way }” …
   *[other] Convert all { $count } calls to “{ $way }” …
}
command-panel = Go to: { $panel }
command-run-form = Simulate this call
command-run-program = Simulate the whole program
command-measurements = Measurements of the program: record, certainty, series, result screens, values of the real machine
command-print = Print
keys-page-palette = Search or run anything
# Sections of the form.
topic-task = Task
topic-correction = Correction
topic-approach = Approach
topic-tolerances = Tolerances
chain-title = Limits on one scale
chain-measured = Actual
topic-statistics = Statistics
topic-probe = Probe
topic-list = Argument list
group-more = { $count } more
group-as-delivered = defaults
fields-all = All fields

profile-own = Default machine
profile-new = Machine 1
profile-list = Machine profiles
profile-edit = Edit machine …
profile-name = Name
profile-create = New machine …
profile-copy = Duplicate
profile-delete = Delete
profile-export = Export setup
profile-import = Import setup …
notice-profile-new = New machine profile.
notice-profile-deleted = Machine profile deleted.
step-profile-delete = Delete machine profile
step-profile-name = Rename machine: { $name }
step-equip-set = { $row }: { $cell }
step-equip-use = Use { $row }
step-equip-move = Move { $row }
step-equip-copy = Duplicate { $row }
step-equip-remove = Delete { $row }
step-equip-add-tools = Add tool
step-equip-add-offsets = Add zero offset
step-equip-add-part = Add { $shape }
step-equip-measured = Add what the call measures
equipment-title = Machine
equipment-of = Machine: { $name }
equipment-tab-machine = Machine
equipment-tab-tools = Tools
equipment-tab-offsets = Zero offsets
equipment-tab-probe = Probe
equipment-tab-toolprobes = Tool probes
equipment-tab-part = Part
equipment-offset = Zero offset
equipment-actions = Actions
equipment-use = Active
equipment-copy = Duplicate
equipment-remove = Delete
equipment-earlier = Move up
equipment-later = Move down
equipment-add-tools = Add tool
equipment-add-offsets = Add zero offset
equipment-add-part = Add
equipment-measured = Add what the open call measures
equipment-shape = Element
equipment-empty = No tools yet. Add the first one.
equipment-no-toolprobes = No tool probe yet.
equipment-no-part = No part yet. Add an element, or what the open call measures.

beside-title = Files with the program
beside-add = Add files
beside-add-help = Add files: subprograms and definition files (.DEF) that belong to the program
beside-shown = { $name } is shown
beside-show = Show { $name }
beside-remove = Remove { $name }
beside-define = Add to machine …
beside-line = { $file }, line { $line }
beside-place = { $file }: { $place }
notice-beside = Files added.
notice-beside-removed = File removed.
notice-defined = Definitions added to the machine.
step-beside = Files with the program
step-given = Program parameters
step-define = Add { $file } to the machine
step-machine-value = { $name }
define-title = Add { $name } to { $machine }?
define-what = { $count ->
    [one] This definition is added to the machine. It then applies to every program.
   *[other] These { $count } definitions are added to the machine. They then apply to every program.
 }
define-nothing = The machine already has these definitions, or the file contains none.
define-apply = Add to machine
define-cancel = Cancel
given-title = Run
given-program = Program
given-program-first = First program of the text
given-strict = Stop if anything is missing
given-mode = Mode
given-mode-automatic = Automatic
given-mode-dry-run = Dry run
given-mode-program-test = Program test
given-mode-block-search = Block search
given-mode-simulation = Simulation (HMI Advanced)
given-mode-jobshop = Simulation (Jobshop)
given-target = Block search up to line
given-mode-dry-run-told = Measuring cycles are skipped; results keep the values of earlier calls. Feeds below 5000 mm/min become 5000 mm/min.
given-mode-program-test-told = Measuring cycles are skipped; results keep the values of earlier calls. On the machine no axis moves.
given-mode-block-search-told = Measuring cycles before this line are skipped; results keep the values of earlier calls.
given-mode-simulation-told = Measuring cycles are executed unless _MC_SIMSIM is 0. _MC_SIMDIFF is added to each measured position.
given-mode-jobshop-told = Measuring cycles are executed unless _MC_SIMSIM is 0, but correct nothing, show no result and write no log. _MC_SIMDIFF is added to each measured position.
given-assumed = { $count ->
    [one] One value of the machine was assumed: { $values }.
   *[other] { $count } values of the machine were assumed: { $values }.
 }
given-enter-values = Enter values
given-enter-value = Enter value
given-missing = Not found: { $names }.
given-open-files = Open files
given-open = Open { $names }
machine-values-title = Values from the machine
machine-values-help = Programs read these values, but only the machine has them. An entered value applies to every run; if the field is empty, the assumed value applies.
machine-values-state = Source
machine-values-typed = entered
machine-values-assumed = assumed
machine-values-where = Used in

# Guides, concepts and terms of the manuals.
terms-title = Guides, concepts and terms
terms-open = Guides, terms
terms-search = Search guides, concepts and terms
terms-search-hint = Trigger point, mean value, Cpk
terms-drag = Drag or enter: { $what }
terms-no-number = Enter a number.
terms-range = Enter { $from } to { $to }{ $unit }.
terms-whole = Enter a whole number from { $from } to { $to }.
terms-limits = { $from } … { $to }
terms-shown = { $what }: { $value }.
terms-print = Print page
terms-terminal = In a terminal
guide-go = Go there
guide-open = Guide
terms-list = Terms
terms-none = No guide, concept or term has these words.

steps-title = Commissioning and upgrade
