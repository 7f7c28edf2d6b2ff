# Texts of the page itself. What the core says is in core/messages/.

app-name = Probewright
panels = Panels
panel-tasks = Measure
panel-form = Form
panel-program = Program
panel-view = 3D view
panel-results = Result
panel-help = Help
skip = Skip
skip-to = Go to { $panel }

control-sinumerik = SINUMERIK
control-nct = NCT

unit-mm = mm
unit-inch = inch
unit-deg = °
unit-mm-per-min = mm/min
unit-inch-per-min = inch/min
unit-m-per-min = m/min
unit-ft-per-min = feet/min
unit-rpm = 1/min
unit-percent = %
unit-kb = KB
unit-s = s
unit-hex = hex

facts = Machine
machine = Machine at the start
machine-all-data = (feeds and data too)
machine-at-call = At the call: { $functions }
plane-g17 = X Y
plane-g18 = Z X
plane-g19 = Y Z
fact-control = Control
fact-built = { $control }, built for { $unit }
fact-unit = Units
fact-plane = Plane
fact-tool = Tool
fact-probe = Probe
fact-ball = ball Ø { $diameter } { $unit }
fact-calibration = Calibration
fact-true = matches the probe
fact-deviates = probe deviates

machine-data-open = Machine
machine-data-title = Machine data
machine-data-basic = Built for
machine-data-basic-help = Machine data and, with some G functions, feeds count in it. A change converts what is set here; numbers in forms and programs stay as typed.
machine-data-search = Search machine data
machine-data-search-hint = Name or words, for example _WP or feed
machine-data-changed = Only what differs from delivery
machine-data-count = { $changed } of { $all } differ
machine-data-group-changed = { $changed } differ
machine-data-none = Nothing found. Try fewer words, or show all data.
machine-data-nothing = This control keeps nothing that is set once.
machine-data-delivered = { $value } (delivered)
machine-data-assignments = Copy as program
machine-data-definitions = Copy as definitions
machine-data-reset = All as delivered
machine-data-close = Done

setup-import = Open setup
setup-export = Save setup
setup-own = Default machine
link-copy = Copy link
theme-system = Theme: system
theme-light = Theme: light
theme-dark = Theme: dark
about-open = About

tasks-title = What to measure
tasks-search = Search cycles, parameters, results and alarms
tasks-search-hint = Cycle, alarm, words
tasks-coming = All other cycles are on their way.
tasks-absent = The other cycles could not be loaded. Reload the page to try again.
tasks-none = Nothing found for “{ $search }”. Try another word, or the number of a cycle or an alarm.

form-opened = Edits { $cycle } in the program, lines { $from } to { $to }
explain-more = More
explain-less = Less

help-open = Help
help-title = { $cycle } · { $name }
help-close = Close
help-coming = The help page is on its way.
help-absent = The help page could not be loaded. Close it and open it again to try once more.
help-no-variant = The help page follows the measuring variant: choose one in the form.
help-values-title = To be given
help-results-title = Results that it leaves ({ $count })
help-alarms-title = Alarms that can come ({ $count })

form-detach = Detach
form-check = Check
form-example = Worked example
form-snippet = Program text
form-comments = Comment each value
form-copy = Copy
form-insert = Insert at cursor
form-complete = Complete
form-incomplete = To be filled in
form-errors = { $count ->
    [one] 1 problem
   *[other] { $count } problems
 }

field-default = default { $value }
field-required = Required: { $reason }
field-optional = Optional: { $reason }
field-source = Source: { $source }.
choice-none = choose …
choice-default = default
choice-other = other number
choice-label = { $name }, choice
severity-error = Error
severity-warning = Doubt
severity-note = Note

picture-plane = Drawing of the measurement, seen onto the working plane
picture-section = Drawing of the measurement, section

editor-find = Find
editor-replace-with = Replace
editor-next = next
editor-previous = previous
editor-all = all
editor-match-case = match case
editor-regexp = regexp
editor-by-word = by word
editor-replace = replace
editor-replace-all = replace all
editor-close = close
editor-current-match = current match
editor-on-line = on line
editor-replaced = replaced match on line $
editor-replaced-all = replaced $ matches
editor-go-to-line = Go to line
editor-go = go
editor-problems = Problems
editor-no-problems = No problems
editor-deleted = Selection deleted
editor-control-character = Control character

language = Language
notice-no-language = The words of this language could not be fetched.

program-title = Program
program-loading = The editor is loading.
program-editor = Part program
program-calls = Measuring calls in the program
program-call-count = { $count ->
    [one] 1 call
   *[other] { $count } calls
 }
program-call-line = line { $line }
program-no-call = no measuring call
program-copy = Copy
program-open = Open
program-save = Save
program-file-sinumerik = program.mpf
program-file-nct = program.nc

activity-stop = Stop
activity-halt = Pause
activity-go-on = Go on
activity-again = Try again
activity-seconds = { $seconds } s
activity-share = { $percent } %
reading-working = Reading the program
reading-working-on = Reading the program ({ $size } million characters). You can go on typing.
reading-stopped = The reading was stopped. The calls of this program are not known.
reading-failed = The program could not be read: { $why }
running-working = Running the program
running-working-on = Running the program ({ $size } million characters).
running-halted = The run is paused.
running-stopped = The run was stopped.
running-failed = The program could not be run: { $why }

view-title = 3D view
view-source = Shown motions
view-form = This call
view-program = Whole program
view-loading = The view is loading.
view-failed = The view could not start: { $problem }
view-canvas = The part, the probe and its motions
view-fit = Fit
view-iso = Oblique
view-top = Top
view-front = Front
view-right = Right
legend = Legend
legend-measuring = measuring
legend-positioning = positioning
legend-rapid = rapid
legend-retract = back
legend-touch = touch, with normal
legend-crash = crash
legend-zone = protection zone
legend-limit = part with the largest errors that work
timeline-first = First step
timeline-back = Step back
timeline-play = Play
timeline-pause = Pause
timeline-on = Step on
timeline-last = Last step
timeline-scrub = Step
motions-none = No motions.
motions-block = Motions { $from } to { $to } of { $count }; the timeline leads to the others.
motions-line = line { $line }
motion-rapid = Rapid to { $to }
motion-positioning = Positioning to { $to }, F{ $feed }
motion-measuring = Measuring towards { $to }, F{ $feed }
motion-retract = Back to { $to }
step-touch = Touch at { $at }
step-crash = Crash at { $at }
step-orient = Spindle to { $angle }°
step-spin = Spindle { $direction }, { $speed } rpm
step-table = Rotary axis { $axis } to { $angle }°
step-tool = Tool T{ $tool } D{ $edge }
step-set = { $name }: { $before } becomes { $after }
step-call = { $cycle } begins, variant { $variant }
step-return = The cycle ends

tab-outcome = What would it do
tab-problems = Problems
tab-problems-count = Problems ({ $count })
tab-motions = Motions
tab-log = Log
outcome-alarms = Alarms
outcome-results = Results
outcome-changes = Tool wear and zero offset
outcome-decisions = Tolerance chain
outcome-no-changes = Nothing is corrected.
outcome-not-simulated = What { $cycle } does at the machine is not simulated in this version. Form, checks and program text work.
outcome-coming = The result is being worked out.
outcome-absent = What works out results and reads programs could not be loaded. The form of this cycle, its checks and its program text work; reload the page to try again.
outcome-incomplete = Complete the form and the result stands here.
outcome-missing = The result stands here as soon as these are right: { $names }
column-name = Name
column-what = What
column-meaning = Meaning
column-value = Value
column-unit = Unit
column-before = Before
column-after = After
column-difference = Change
problems-more = { $count } more. They are marked in the program, and come here when these are mended.
problems-none = No problems found.
problem-place = line { $line }, column { $column }
log-none = Nothing was logged.

sliders-title = Errors
sliders-reset = All zero
sliders-part = Of the part
sliders-probe = Of the probe
sliders-limits = Limits
sliders-limits-help = The largest errors of the part with which this measurement still comes to its end
slider-limits = works from −{ $low } to +{ $high }
slider-figure = { $name }, figure
error-part-size = Size
error-part-dx = Shift X
error-part-dy = Shift Y
error-part-dz = Shift Z
error-part-tilt = Tilt
error-part-taper = Taper
error-part-out-of-round = Out of round
error-probe-skew-x = Skew X
error-probe-skew-y = Skew Y
error-probe-radius = Ball radius
error-probe-pre-travel = Pre-travel
error-probe-repeatability = Repeatability

notice-copied = Copied.
notice-inserted = Inserted. The form edits this call now.
notice-link-long = The program is too long for a link. Save it as a file instead.
notice-link = Link copied. It holds the form, the program and the errors.
notice-no-clipboard = The browser gave no access to the clipboard. Select the text and copy it by hand.
notice-not-kept = The browser does not keep this work. Save the program before you close the page.
notice-setup = Setup opened.
notice-own-setup = Back to the default machine.
notice-setup-outdated = The kept setup does not fit this version and was left out.
notice-nothing-to-save = There is no setup yet: what makes it is still on its way.
notice-opened = Program opened.
notice-opened-bytes = Program opened. It is not UTF-8: each byte is shown as one character and will be saved as it was.
notice-other-encoding = The program holds a character that its old encoding lacks. It was saved as UTF-8.
notice-example = Worked example in the form.
notice-no-errors = All errors are zero.
notice-set-saved = Values saved.
notice-set-replaced = Values saved in place of those of the same name.
notice-set-loaded = Values loaded.
notice-set-deleted = Values deleted.
notice-undone = Undone.
undo = Undo

refused-program-size = { $name } was not opened: it has { $size } MB, programs may have { $most } MB. Your program is unchanged.
refused-setup-size = { $name } was not opened: it has { $size } MB, a setup has at most { $most } MB. Your setup is unchanged.
refused-unreadable = { $name } was not opened: the browser cannot read it. It may have been moved or changed meanwhile.
refused-setup = { $name } was not opened, it is no setup: { $why }. “Save setup” writes one to compare. Your setup is unchanged.
refused-close = Close

sets-open = Value sets …
sets-title = Value sets of { $cycle }
sets-name = Name
sets-save = Save the present values
sets-none = Nothing saved yet. Give the present values a name to come back to them.
sets-rename = Name of { $name }
sets-load = Load
sets-load-named = Load { $name }
sets-delete = Delete
sets-delete-named = Delete { $name }
sets-name-taken = This name is taken, or empty.

about-title = About Probewright
about-what = An assistant for CNC measuring cycles: fill in a form, get the program text, watch the probe at work on a part with errors, read what the control would do.
about-offline = Everything happens in this browser. After the first load it works without a network.
about-prove-out = A simulation replaces no prove-out at the machine. Test every program there, with reduced feed and a hand on the override.
about-marks = SINUMERIK is a registered trademark of Siemens AG.
about-independent = Probewright is independent of Siemens and of NCT; neither has examined or approved it.
about-licence = Licence: MIT OR Apache-2.0, at your choice.
about-close = Close
keys-title = Keys
keys-f6 = F6 and Shift+F6: next and previous panel
keys-tab = Tab: next field; the drawing shows what it means
keys-tree = Arrow keys, Home, End, Enter: move and choose in the task list, in what the search found, and in the list of calls
keys-tabs = Left and right arrow: change the result tab
keys-undo = Ctrl+Z outside of a text: take back a replacement of work, such as another program or the worked example
keys-editor = In the editor Tab leaves; Ctrl+F searches; F8 goes to the next problem, Ctrl+Shift+M lists them with their cures; the call at the cursor opens its form

broken-title = Probewright has stopped
broken-kept = This is a defect of the program, not of your entries. Your form and your program are kept in this browser.
broken-reload = Reload

group-milling-workpiece = Milling: workpiece
group-milling-tool = Milling: tool
group-milling-calibrate = Milling: calibrate the probe
group-milling-none = Milling: without a probe
group-milling-log = Milling: log of measurements
group-turning-workpiece = Turning: workpiece
group-turning-tool = Turning: tool
group-turning-calibrate = Turning: calibrate the probe
group-turning-none = Turning: without a probe
group-turning-log = Turning: log of measurements
group-any-workpiece = Workpiece
group-any-tool = Tool
group-any-calibrate = Calibrate the probe
group-any-none = Without a probe
group-any-log = Log of measurements

found-measurement = Measurements ({ $count })
found-parameter = Parameters ({ $count })
found-result = Results ({ $count })
found-alarm = Alarms ({ $count })
found-more = { $count } more. A further word narrows it down.

card-result = Result { $code }
card-alarm = Alarm { $code }
card-cause = Why
card-cure = What helps
card-result-cycles = Left by
card-alarm-cycles = Raised by
card-close = Close

twin-open = The same task on the other control
twin-task = { $task }: there { $cycle }.
twin-shared = What both say
twin-differences = What is different there
twin-none = The other control has no such task for these values.

ways = Way of writing
ways-findings = What this way of writing cannot say
way-direct = direct
way-indirect = indirect
way-operate = newer controls
way-now = Written: { $way }
convert = Convert to

call-state-ok = no doubts
call-state-note = no doubts
call-state-warning = doubts
call-state-error = errors
call-variant-unknown = variant not known

notice-converted = Converted.
notice-mended = Mended.
