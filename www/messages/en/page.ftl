# Texts of the page itself. What the core says is in core/messages/.

app-name = Probewright
panels = Panels
panel-tasks = Measure
panel-form = Form
panel-program = Program
panel-view = 3D view
panel-results = Result
skip = Skip
skip-to = Go to { $panel }

control-sinumerik = SINUMERIK
control-nct = NCT

unit-mm = mm
unit-inch = inch
unit-deg = °
unit-mm-per-min = mm/min
unit-inch-per-min = inch/min

facts = Machine
machine = Machine at the start
machine-all-data = (feeds and data too)
machine-at-call = At the call: { $functions }
plane-g17 = X Y
plane-g18 = Z X
plane-g19 = Y Z
fact-control = Control
fact-unit = Units
fact-plane = Plane
fact-tool = Tool
fact-probe = Probe
fact-ball = ball Ø { $diameter } mm
fact-calibration = Calibration
fact-true = matches the probe
fact-deviates = probe deviates

setup-import = Open setup
setup-export = Save setup
link-copy = Copy link
theme-system = Theme: system
theme-light = Theme: light
theme-dark = Theme: dark
about-open = About

tasks-title = What to measure
tasks-search = Search by cycle number or words
tasks-search-hint = Number or words
tasks-none = Nothing found for “{ $search }”. Try fewer words or the number of a cycle.

form-opened = Edits { $cycle } in the program, lines { $from } to { $to }
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

program-title = Program
program-loading = The editor is loading.
program-editor = Part program
program-calls = Measuring calls in the program
program-call = { $cycle } · line { $line }
program-no-call = no measuring call
program-copy = Copy
program-open = Open
program-save = Save
program-file-sinumerik = program.mpf
program-file-nct = program.nc

activity-stop = Stop
activity-again = Try again
activity-seconds = { $seconds } s
reading-working = Reading the program
reading-working-on = Reading the program ({ $size } million characters). You can go on typing.
reading-stopped = The reading was stopped. The calls of this program are not known.
reading-failed = The program could not be read: { $why }
running-working = Running the program
running-working-on = Running the program ({ $size } million characters).
running-stopped = The run was stopped.
running-failed = The program could not be run: { $why }

view-title = 3D view
view-source = Shown motions
view-form = This call
view-program = Whole program
view-loading = The view is loading.
view-empty = Nothing to show yet: complete the form.
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
outcome-not-simulated = What { $cycle } does at the machine is not simulated yet. Form, checks and program text are complete.
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
problems-none = No problems found.
problem-place = line { $line }, column { $column }
log-none = Nothing was logged.

sliders-title = Errors
sliders-reset = All zero
sliders-part = Of the part
sliders-probe = Of the probe
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
notice-link = Link copied. It holds the form, the program and the errors.
notice-no-clipboard = The browser gave no access to the clipboard. Select the text and copy it by hand.
notice-not-kept = The browser does not keep this work. Save the program before you close the page.
notice-setup = Setup opened.
notice-no-setup = This file is no setup. Save one here to see what it has to hold.

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
keys-tree = Arrow keys, Home, End, Enter: move and choose in the task list
keys-tabs = Left and right arrow: change the result tab
keys-editor = In the editor Tab leaves; Ctrl+F searches; the call at the cursor opens its form

broken-title = Probewright has stopped
broken-kept = This is a defect of the program, not of your entries. Your form and your program are kept in this browser.
broken-reload = Reload
