# Calls with arguments in brackets: what is wrong with an argument, and what a list of newer controls says.

list-text-wanted = { $param } needs a text, but { $value } is a number.
list-text-wanted-hint = Write the value in quotation marks.
list-number-wanted = { $param } needs a number, but “{ $value }” is a text.
list-number-wanted-hint = Write the value without quotation marks.
list-text-unquoted = { $param }: { $value } has no quotation marks, and the program declares no such variable.
list-text-unquoted-hint = If this is the name itself, write it in quotation marks.
list-arguments-many = Too many arguments for { $name }: { $most } permitted, { $count } in this call.
list-arguments-many-hint = Count the commas, and delete the surplus arguments.
list-selection = Argument { $place } of { $name } cannot be { $value }.
list-selection-hint = Permitted: { $choices }.

newer-open = { $param } = { $value }: its meaning in the argument list of a newer control is not known. It is kept as written, not checked and not simulated.
newer-seen = { $param } = { $value }: programs of newer controls have another number there; what this one means is not published.
newer-beyond = { $cycle } has { $most } published arguments. What is behind them is kept as written; its meaning is not known.
newer-target = { $value } is in argument 2, where newer controls expect the number of a zero offset, but this variant corrects no zero offset.
newer-target-hint = Zero offset: set the 3rd digit of argument 1 to 1. Tool: use argument 3 (S_KNUM1). Or leave argument 2 empty.
newer-target-perhaps = { $value } in argument 2 is no zero offset that is known. On older controls such a number is a tool or a frame of another kind.
newer-target-perhaps-hint = Zero offset: 1–99, 10001–10099. Tool: argument 3 (S_KNUM1). Or leave argument 2 empty: nothing is corrected.
write-newer-tool = Newer controls have the tool target in argument 3 (S_KNUM1, see alarm 61328); its code is not known.
write-newer-zero = Zero offset { $value } is not known in the list of newer controls: 1–99, 10001–10099, 9000, 9999, 19999 are.
write-newer = { $param } = { $value } has another meaning in the argument list of newer controls, or its meaning is not known.
convert-newer = { $param } = { $value }: the older argument list has no equivalent for this value of the newer one, or its meaning is not known.
convert-newer-hint = Keep the call as it is, or enter the measurement again in its form.

newer-lost = An argument before place { $place } is missing: everything behind it is one place too early.
newer-lost-between = An argument is missing between places { $place } and { $until }: everything behind it is one place too early.
newer-lost-hint = Add a comma for the missing argument.
newer-many = A surplus argument is at place { $place }: everything behind it is one place too late.
newer-many-between = A surplus argument is between places { $place } and { $until }: everything behind it is one place too late.
newer-many-hint = Delete the surplus comma.
newer-places = { $cycle } is published with 5 places, two of them without a name. With { $count } arguments it is open which of them are S_PROT and S_PATH.
newer-lost-perhaps = { $name } = { $value } is in no published program. With one more argument, between places { $place } and { $until }, the call would be as programs have it.
newer-many-perhaps = { $name } = { $value } is in no published program. With one comma less, between places { $place } and { $until }, the call would be as programs have it.
newer-perhaps-hint = Count the arguments. If the call is right as it stands, leave it.
newer-inch = S_FA = { $value } is 25.4 times { $meant }: a measuring path in mm was converted as if it were in inches.
newer-inch-hint = Enter the measuring path in mm.
newer-set-variant = Set argument 1 to { $value }
newer-set-none = Empty argument 2
newer-set-path = Set S_FA to { $value }
newer-set-close = Close the bracket
newer-set-lost = Insert an empty argument { $place }
newer-set-many = Delete the empty argument { $place }
argument-list = Argument list of { $cycle } on newer controls
argument-place = Argument { $place } of { $cycle }
argument-name = { $name }: { $meaning }
argument-screen = On the screen: { $name }
argument-older = On older controls: { $name }
argument-no-older = Older controls have no equivalent.
argument-values = Known from programs that run on such controls.
argument-alarm = Named by alarm { $alarm }.
argument-name-known = Only its name and its place are published.
argument-open = Its digits are not published: it is kept as written, and never written anew.
argument-zero = Zero offset that is corrected
argument-zero-help = Empty: measure only. 1 to 4: G54 to G57; 5 to 99: G505 to G599; plus 10000: coarse offset. 9999 and 19999: active frame. 9000 is in use, its meaning is not published.
argument-zero-fine = { $name }, fine
argument-zero-coarse = { $name }, coarse
argument-zero-used = In use, meaning not published
argument-tool = Tool that is corrected
argument-ball = Diameter of the calibration ball
argument-probe = Number of the probe
argument-tool-probe = Number of the tool probe
argument-points = Distances X1 and X2, or points P1 (X1, Y1) to P4 (X4, Y4)
argument-points-help = The variant decides which; its numbers are not published.
argument-safe = Safe area
argument-safe-help = Alarm 61303 names it; from where it counts in this cycle is not published.
argument-vectors = Limit of the calculated vectors
argument-vectors-help = Rotary axis positions less than 20 degrees apart are unreliable (alarm 61430, G).
argument-probing-angle = Probing angle
argument-probing-angle-help = From −359 to 359 degrees. Older controls have none in this cycle.
argument-infeed = Infeed to the measuring height
argument-infeed-help = Programs disagree about the sign that leads down. 1 stands where there is no infeed.
argument-direction = Measuring direction
argument-direction-help = 1: plus; 2: minus.
argument-direction-open = Measuring direction
argument-direction-open-help = Its numbers are published for CYCLE978 and CYCLE998 only.
argument-carrier = Orientable tool carrier
argument-centre-x = Centre, 1st axis of the plane
argument-centre-x-help = Where the probe starts beside it; _AMODE is then 11.
argument-centre-y = Centre, 2nd axis of the plane
argument-centre-y-help = Where the probe starts beside it; _AMODE is then 11.
argument-bits = Measuring options
argument-bits-help = Programs leave it empty.
argument-plane = Working plane
argument-plane-help = Programs write 1.
argument-mode = Mode
argument-mode-help = Programs write 1; 11 where S_XM and S_YM give the centre.
argument-name-only = Meaning not published
argument-unnamed = Not even a name is published for this place
argument-direction-plus = Plus direction
argument-direction-minus = Minus direction
argument-probe-help = Number of the probe, 1 to 12: its data are setting data from SD 54600 on.
argument-tool-probe-help = Number of the tool probe, 1 to 6: its data are setting data from SD 54625 on.
argument-help-older = This page describes the cycle on older controls. In the list of newer controls other numbers and arguments count: zero offsets (10000 and more: coarse), probe, measuring direction S_MD. _CHBIT, _CBIT and digits of _KNUM are of the older control. Where no zero offset is corrected, the call only measures.
write-direction = S_MD is empty: the older call does not say in which direction is measured.
write-direction-hint = Enter 1 (plus) or 2 (minus), as programs of machine users always do.
write-infeed = S_ID = { $value } keeps its sign. On newer controls programs disagree about the sign that leads down.
write-infeed-hint = Check the sign with a program that runs on this machine, before the first run.
write-rotary = S_RA = { $value }: which number stands for which rotary axis on newer controls is not published. Programs write 6.
write-rotary-hint = Check S_RA on the control before the first run.
convert-infeed = S_ID = { $value } keeps its sign as { "_ID" }. On newer controls programs disagree about the sign that leads down.
convert-infeed-hint = Check the sign before the first run, well above the part.
convert-rotary = S_RA = { $value } becomes { "_RA" } = { $value }, but which number stands for which rotary axis on newer controls is not published.
convert-rotary-hint = Enter the number of the rotary axis in { "_RA" }: its number among the axes of the older control.
generation-list = { $cycle } is called with the argument list of newer controls, but the machine is of generation { $generation }.
generation-list-hint = Convert the calls, or set PW-GENERATION to 3 in the machine data.
generation-assigned = { $cycle } is called as on older controls, but the machine is of generation { $generation }, which takes argument lists.
generation-assigned-hint = Convert the calls. If assignments run on this machine too, set PW-GENERATION to 0.
generation-setting-data = { $name } is a datum of newer controls, but the machine is of generation { $generation }.
generation-setting-data-hint = Use the user data of this machine, or set PW-GENERATION to 2 or 3 in the machine data.
generation-user-data = { $name }[] is user data of older controls, but the machine is of generation { $generation }, which has setting data instead.
generation-user-data-hint = Use the setting data from SD 54600 and SD 55630, or correct PW-GENERATION in the machine data.
argument-shown = Argument { $place } of the list: { $name }.
argument-shown-screen = Argument { $place } of the list: { $name }, on the screen { $screen }.
newer-cycle995 = Measures how far a spindle is out of square
newer-cycle996 = Measures the kinematics of rotary axes, one position
newer-cycle9960 = Measures the kinematics as a whole
newer-cycle150 = Shows the results on the screen and writes the log
newer-unsimulated = { $param } is written and not simulated.
newer-omitted = { $param } is omitted, and so 0: what the control does then is not published, and the call is not simulated.
newer-alone = { $cycle } is not simulated: older controls have no such cycle, and the digits of its arguments are not published.
newer-infeed = { "S_ID" } = { $value }: which sign leads down is not published, so that the call is not simulated.
newer-infeed-hint = Programs of newer controls disagree about the sign. Try it on the machine, well above the part.
newer-away = { "S_MD" } = { $value } leads away from the setpoint: the probe is on its other side. What the control does then is not published; the run stops here.
newer-away-hint = Position the probe on the other side of the surface, or change the measuring direction.
newer-fine = { $value } corrects the coarse part, and the fine part is not 0. MD 51740 bit 5 (coarse offset absolute) has to do with it; how is not published, so the run stops here.
newer-fine-hint = Delete the fine part of the zero offset before the call, or correct the fine part.
newer-centre-missing = { "_AMODE" } = 11 says that the call gives the centre, but S_XM and S_YM are empty.
newer-centre-missing-hint = Enter the centre in S_XM and S_YM, or set { "_AMODE" } to 1.
newer-centre-unused = S_XM and S_YM give the centre, but { "_AMODE" } is { $value }: programs then have 11 there.
newer-centre-unused-hint = Set { "_AMODE" } to 11, or leave S_XM and S_YM empty.
newer-no-list = { $cycle } with numbers as arguments: the older control takes variables here, and the list of newer controls is not published.
newer-no-list-hint = Older control: write the names of the variables. Otherwise the call stays as it is, unchecked, not simulated.
write-assigned = { $cycle } is written as assignments: the digits of argument 1 of its list are not published.
write-assigned-hint = Whether this machine takes assignments too, a test on it tells.
write-coarse = Argument 2 = { $value } means the fine part of the zero offset; here { "_CHBIT[21]" } = 1 corrects the coarse part.
write-coarse-hint = Write { $coarse } to correct the coarse part.
