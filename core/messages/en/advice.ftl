# Doubts about a program as a whole, each with its cure.

advice-insert = Insert { $text } before it
advice-insert-behind = Insert { $text } behind it
advice-insert-around = Insert { $before } before it and { $behind } behind it
advice-write = Write { $name }={ $value } for this call

advice-compensation = Tool radius compensation is on: { $word } in line { $line }.
advice-compensation-pass = Tool radius compensation is on from the pass before: { $word } in line { $line }.
advice-compensation-hint = The cycle has to be called with G40.
advice-compensation-open = G40 is not programmed before this call, and the program ends with tool radius compensation on: when it is run again, it may still be active.
advice-plane = No working plane is programmed before this call: the machine's reset state decides in which axes is measured.
advice-plane-hint = Program the plane, for example { $plane }.
advice-diameter = Neither DIAMON nor DIAMOF is programmed before this call: the machine's reset state decides whether values of the transverse axis are diameters.
advice-diameter-hint = Program DIAMON for diameters, DIAMOF for radii.
advice-edge-none = No D number is active: the probe's length does not count.
advice-edge-open = No D is programmed after the last T: machine data decide whether an offset is active.
advice-edge-hint = Program the D number of the probe behind the tool change.
advice-tool = The tool in use, T{ $tool }, is no workpiece probe (type { $type }).
advice-tool-hint = Change to the probe before the call, or correct the type in the tool list (710, or 580 on a lathe).
advice-tool-digit = T{ $tool } is of type { $type }: measuring cycles take 710 and types that end in 0, as the conditions of the call have it; elsewhere the manual names any type from 100 to 199.
advice-tool-digit-hint = Enter the probe as type 710; the control may refuse this one.
advice-tool-assignment = T{ $tool } is of type { $type }, the probe of a turning machine: this cycle takes it only where SD42950 is 2.
advice-tool-assignment-hint = Set SD42950 = 2 on a turning machine; on a milling machine the probe is of type 710.
advice-tool-position = T{ $tool } of type { $type } has cutting edge position { $position }: the probe of a turning machine has 5 to 8.
advice-tool-position-hint = Change to the probe, or enter its position: 5 or 7 stands on G17, 6 or 8 on G19.
advice-tool-plane = T{ $tool } has cutting edge position { $position }, so that it does not stand on the plane in which this cycle measures.
advice-tool-plane-hint = Measure in { $plane } with it, or with a probe that stands on this plane: 5 and 7 on G17, 6 and 8 on G19.
advice-length = None of the lengths of T{ $tool } counts along the tool axis: L1 of a turning machine's tools lies along the ordinate of the active plane, L2 along the abscissa, L3 along the applicate.
advice-length-hint = Enter the length along the tool axis as L3, in a D number for this plane. A machine may keep the lengths of G18 in every plane; then they are right.
advice-milled-diameter = DIAMON or DIAM90 is active, but this cycle knows no diameters of the transverse axis: positions in X count as they are, from the centre of rotation on.
advice-milled-diameter-hint = Enter them as radii, and program DIAMOF around the call.
advice-spindle = The spindle is turning: nothing stops it between M3 or M4 and this call.
advice-spindle-hint = Stop it with M5 before the probe comes near the part.
advice-open = What is in force at this call depends on another program or on the way through this one: { $words }.
advice-open-hint = Make sure that each program that comes here has them as the cycle needs them, or program them here.
advice-tool-none = No tool is programmed before this call: whatever is in the spindle or turret is used, with the D number that is active.
advice-tool-none-hint = Program T and D before the call.
advice-radius = With DIAMOF the setpoint { $value } is a radius: the diameter is { $diameter }.
advice-radius-hint = Program DIAMON before the call if the drawing's diameter was entered.
advice-calibration = No call of this program calibrates probe { $number }: what the control has in { $data } counts.
advice-calibration-hint = Check that the probe was calibrated on this machine, or call the calibration first.
advice-inherited = { $name }={ $value } was written for { $cycle } in line { $line }, where it has another unit.
advice-inherited-meaning = { $name }={ $value } was written for { $cycle } in line { $line }, where it means “{ $before }”; here it means “{ $now }”.
advice-inherited-hint = Write { $name } for this call.
advice-frame = The corrected { $frame } is not in force: the program goes on in the old one.
advice-frame-other = { $frame } was corrected, but the program goes on in { $other } and never takes it.
advice-frame-basic = The corrected basic frame is not in force: the program goes on with the old one.
advice-frame-hint = Program { $frame } again behind the call.
advice-frame-other-hint = Program { $frame } behind the call.
advice-overwritten = { $name } may have another value at the call: the program called in line { $line } writes it too.
advice-overwritten-hint = Write { $name } behind that call.
arrives = Written in line { $lines }.
arrives-hint = A change here changes it there.
arrives-shared-hint = Other calls take it from there too: a change here is written for this call.
arrives-many-hint = Many calls give it: change it where it is written.
arrives-differing = Differs by the way to this call: { $values }.
arrives-differing-hint = A change here would count for all of them. Change it where it is written; the line stands in brackets.
advice-level = The call stands on program level { $level }; measuring cycles run on the first five.
advice-level-hint = Call it from a program nearer to the main program.

advice-read-back = Read back by the control's support, this call becomes another one: { $changes }.
advice-read-back-hint = _MZ_MASK of the machine gives these values. Take them now, or change the mask if the values of the program are right.
advice-read-back-cure = Take the values of the mask
advice-mask = The settings were others when this call was written: { $changes }.
advice-mask-hint = What they change comes into the program as soon as the control reads the call back.
advice-mask-cure = Name the settings of this machine
advice-tool-programming = The control cannot read this call back into its form: { $changes } since it was written.
advice-tool-programming-hint = Write the call anew with the form, and look at tool and D number: they are programmed in another way now.
