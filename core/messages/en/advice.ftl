# Doubts about a program as a whole, each with its cure.

advice-insert = Insert { $text } before the call
advice-insert-behind = Insert { $text } after the call
advice-insert-around = Insert { $before } before and { $behind } after the call
advice-write = Write { $name }={ $value } for this call

advice-compensation = Tool radius compensation is on: { $word } in line { $line }.
advice-compensation-pass = Tool radius compensation is still on from the previous pass: { $word } in line { $line }.
advice-compensation-hint = Program G40 before the call.
advice-compensation-open = No G40 before this call, and the program ends with tool radius compensation on: it may be on at the next run.
advice-plane = No working plane is programmed before this call: the machine's reset state decides which axes are measured.
advice-plane-hint = Program the plane, for example { $plane }.
advice-diameter = No DIAMON or DIAMOF before this call: the reset state decides whether transverse-axis values are diameters.
advice-diameter-hint = Program DIAMON for diameters, DIAMOF for radii.
advice-edge-none = No D number is active, so the length of the active tool is not applied.
advice-edge-open = No D is programmed after the last T: machine data decide whether an offset is active.
advice-edge-hint = Program the D number of the active tool after the tool change.
advice-tool = The active tool, T{ $tool }, is not a workpiece probe (type { $type }).
advice-tool-hint = Change to the probe before the call, or correct the type in the tool list (710, or 580 on a turning machine).
advice-tool-digit = T{ $tool } is of type { $type }. The call conditions permit 1x0 and 710; elsewhere the manual permits 100 to 199.
advice-tool-digit-hint = Change to the probe, or enter it as type 710; the control may reject the present type.
advice-tool-assignment = T{ $tool } is of type { $type }: this cycle accepts a probe of a turning machine (type 5xy) only with SD 42950 = 2.
advice-tool-assignment-hint = Set SD 42950 = 2 on a turning machine; on a milling machine, enter the probe as type 710.
advice-tool-position = T{ $tool } of type { $type } has cutting edge position { $position }: a probe on a turning machine needs 5 to 8.
advice-tool-position-hint = Change to the probe, or correct its cutting edge position: 5 or 7 is perpendicular to G17, 6 or 8 to G19.
advice-tool-plane = T{ $tool } has cutting edge position { $position }, so it is not perpendicular to the plane in which this cycle measures.
advice-tool-plane-hint = Measure in { $plane }, or use a probe perpendicular to the active plane: 5 and 7 for G17, 6 and 8 for G19.
advice-length = T{ $tool } has no length along the tool axis: here L1 is in the ordinate, L2 in the abscissa, L3 in the applicate.
advice-length-hint = Enter the tool-axis length as L3 in a D number for this plane, unless the G18 assignment applies everywhere.
advice-milled-diameter = DIAMON or DIAM90 is active, but this cycle ignores it: positions in X are radii.
advice-milled-diameter-hint = Enter the positions as radii; program DIAMOF before the call and DIAMON or DIAM90 after it.
advice-spindle = The spindle is rotating: it is not stopped between M3 or M4 and this call.
advice-spindle-hint = Stop the spindle with M5 before the probe approaches the part.
advice-open = The state at this call depends on another program or on the path through this one: { $words }.
advice-open-hint = Program them before the call, or make sure that every calling program sets them.
advice-tool-none = No tool is programmed before this call: the cycle uses the tool in the spindle or turret, with its active D.
advice-tool-none-hint = Program T and D before the call.
advice-radius = With DIAMOF the setpoint { $value } is a radius: the diameter is { $diameter }.
advice-radius-hint = If you entered the diameter from the drawing, program DIAMON before the call.
advice-calibration = This program does not calibrate probe { $number } before this call: the data stored in { $data } apply.
advice-calibration-hint = Calibrate the probe on this machine first, or call the calibration before this measurement.
advice-inherited = { $name }={ $value } was written for { $cycle } in line { $line }, where it has another unit.
advice-inherited-meaning = { $name }={ $value } was written for { $cycle } in line { $line }, where it means “{ $before }”; here it means “{ $now }”.
advice-inherited-hint = Write { $name } for this call.
advice-frame = The corrected { $frame } is not active: the program continues with the old values.
advice-frame-other = { $frame } was corrected, but the program continues in { $other } and never activates it.
advice-frame-basic = The corrected basic or system frame is not active: the program continues with the old values.
advice-frame-hint = Activate it with { $frame } after the call.
advice-frame-other-hint = Program { $frame } after the call.
advice-overwritten = { $name } may have another value at the call: the program called in line { $line } also writes it.
advice-overwritten-hint = Write { $name } after that call.
advice-log-again = The log { $file } was already switched on in line { $line }: this call deletes what was logged in it since.
advice-log-again-hint = Give this log its own name in { $name }, or use one log for both measurements.
arrives = Written in line { $lines }.
arrives-lines = Written in lines { $lines }.
arrives-hint = A change here also changes what is written there.
arrives-shared-hint = Other calls use this value too: a change here is written for this call only.
arrives-many-hint = This value is written in many lines: change it there.
arrives-differing = Depends on the path to this call: { $values }.
arrives-differing-hint = A change here would apply to all paths. Change the value where it is written; line numbers are in brackets.
advice-level = The call is on program level { $level }; measuring cycles may be called on the first five levels only.
advice-level-hint = Move the call to a program level nearer to the main program.

advice-read-back = When the control's measuring cycle support reads this call back, it changes: { $changes }.
advice-read-back-hint = _MZ_MASK of the machine sets these values. Use them, or change the mask if the program is correct.
advice-read-back-cure = Use the values of _MZ_MASK
advice-mask = This call was written with other machine settings: { $changes }.
advice-mask-hint = The control writes these changes into the program as soon as it reads the call back.
advice-mask-cure = Enter the settings of this machine
advice-tool-programming = The control cannot read this call back. Changed since it was written: { $changes }.
advice-tool-programming-hint = Write the call again with the form, and check tool and D number: they are now programmed differently.
nct-oriented = The spindle is not oriented at this call: no M19 or M59 since the start of the program or the last M3 or M4.
nct-oriented-hint = Orient the spindle before the stylus measures: without orientation the macros cannot be used.
nct-stylus-off = The stylus is switched off at this call: no M59 since the start of the program or the last M55.
nct-stylus-off-hint = Switch the stylus on with M59 before the call.
nct-stylus-on = The spindle starts while the stylus is still switched on with M59.
nct-stylus-on-hint = Switch the stylus off with M55 first.
nct-stylus-left = The program ends with the stylus switched on.
nct-level = O9920 is called on subroutine level { $level }; in automatic mode it may be called on the first two only.
nct-level-hint = Move the call nearer to the main program.
user-program-runs-before = { $name } runs before this call, from { $label } (line { $line }).
user-program-runs-before-whole = { $name } runs before this call, from its start (line { $line }): it has no label { $label }.
user-program-runs-behind = { $name } runs after this call, from { $label } (line { $line }).
user-program-runs-behind-whole = { $name } runs after this call, from its start (line { $line }): it has no label { $label }.
user-program-cycle = No measuring cycle calls the user programs under the name { $name }.
user-program-none = Choose at least one measuring cycle.
user-program-line = This line is not possible between label and M17: { $line }
user-program-variable = { $name } is no name of a variable.
user-program-own = Not Siemens’ file: it replaces the original. The manual does not print the variable of its CASE: take it from the original file.
user-program-insert = To insert: each group of lines between the label of the cycle and its M17.
user-program-changes = { $name } is a parameter of the measuring cycle: a value written in CYCLE198 makes the cycle measure something else.
user-program-before-line = before measurement in { $cycle }
user-program-behind-line = after measurement in { $cycle }

# Programs of older versions.

older-call = { $word } with R parameters is a measuring call of an 840C, today { $cycle }. Its parameters: { $names }.
older-call-hint = Convert the program, then check user and machine data and calibrate the probe again.
older-convert = Convert to { $cycles }
older-open-id = { $text }: is this the infeed _ID to measuring height? For this variant of { $cycles } the manual prints { $other } beside the same R parameter.
older-open-sza = { $text }: is this the protection zone _SZA? For this variant of { $cycles } the manual prints { $other } beside the same R parameter.
older-open-md = { $text }: is this the measuring direction _MD? For this variant of { $cycles } the manual prints { $other } beside the same R parameter.
older-open-ra = { $text }: is this the number of the rotary axis _RA? For this variant of { $cycles } the manual prints { $other } beside the same R parameter.
older-open-rf = { $text }: is this the feed _RF on the circular path? For this variant of { $cycles } the manual prints { $other } beside the same R parameter.
older-open-hint = The drawing or the author knows. If the variant needs both, write the other one by hand.
older-open-first = { $text }: is this the setpoint _SETVAL of { $cycles }? { $other } sets it too, to another value.
older-open-second = { $text }: is this the setpoint _SETVAL of { $cycles }, and not { $other }? Both set it, to different values.
older-setpoint-hint = The manual does not say which one counts. Choose one: the other is removed.
older-answer = Write { $name } for { $text }
older-unused = { $text } is not used by this variant of { $cycles }: the conversion leaves it out.
older-result = { $name } is read after a measuring call: on the 840C it may hold a result. The manual names no equivalent.
older-result-hint = Read the result from _OVR[] or _OVI[]; the help page of the cycle lists them.
older-unclear = { $text }: which R parameters reach a measuring call of the 840C cannot be followed from here, so the program is not converted.
older-unclear-hint = Assign an R parameter with a fixed number, outside loops and macros, then convert.
older-subroutine = { $name } belongs to the measuring cycles: { $what }
subroutine-result = shows the measuring result (today switched by _CHBIT[10]).
subroutine-dialogue = asks for the parameters in dialogue before the measuring call (SW 3.2 to 4.5). Since then the values are written in the program; the call can be deleted. Up to SW 4.4 it needed the MMC interface (REM removed in line 2 of comic.nsk on an MMC 102).
subroutine-interface = internal, interface of the measuring cycles. Programs do not call it.
subroutine-messages = outputs messages, internal, up to SW 6.2. Gone from SW 6.3.
subroutine-alarms = outputs alarms, internal, up to SW 6.2. Gone from SW 6.3.
subroutine-transfer = transfers data, internal, from SW 4.5. Programs do not call it.
subroutine-plausibility = checks the parameters, internal. Programs do not call it.
subroutine-measuring = measuring functions, internal. Programs do not call it.
subroutine-milling = measuring functions of the workpiece cycles on milling machines, internal. Programs do not call it.
subroutine-tool = loads the tool offset, internal; up to SW 6.2 also the zero offset. Programs do not call it.
subroutine-zero = loads the zero offset, internal, from SW 6.2. Programs do not call it.
subroutine-approach = pre-positions on turning machines, internal. Programs do not call it.
