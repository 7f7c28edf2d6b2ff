# Ways of writing a call, and what they cannot say.

write-no-list = { $cycle } cannot be written in this call style.
write-no-list-variant = This variant or target of { $cycle } cannot be written in this call style.
write-unpublished = The argument list of { $cycle } is not written: the digits of argument 1 are not published.
write-unpublished-variant = Variant { $value } of { $cycle } is not written as an argument list: its digits are not published.
write-unpublished-alone = { $cycle } is not written: older controls have no such cycle, and the digits of its arguments are not published.
write-variant-open = The arguments determine the measuring variant, and { $value } is known only when the program runs.
write-no-list-hint = Write assignments and the call instead.
write-zero = { $name }={ $value } is written as a separate assignment: 0 in CYCLE_PARA keeps the previous value.
write-beside = { $name }={ $value } is written as a separate assignment: the call has no argument for it.
write-lost = { $name } is omitted: the argument list of newer controls has no argument for it.
write-lost-hint = If the value matters, write the call as assignments, or set it on the control.
write-expression = { $name }={ $value } is written as a separate assignment: if { $value } were 0, CYCLE_PARA would keep the previous value.
write-expression-lost = { $name }={ $value } would be lost: the argument list of newer controls has no argument for it.
write-plane = _DMODE = 1 is written in plane { $plane } too: which number names which plane is not published.
write-plane-hint = Check the plane on the control before the first run.

convert-same = The call is already written in this style.
convert-lost = No parameter on the older control, therefore omitted: { $names }.
convert-lost-hint = Check that the call works without these values.
convert-others = { $cycle } in line { $line } uses values of this call and would get different ones.
convert-others-hint = Convert that call too, or write its values before it.
convert-argument = Argument { $value } of this call would be lost: no other call style has a place for it.
convert-argument-hint = Write the number instead of { $value } in the call, then convert the call.
convert-expression = The call is unchanged: { $value }, assigned to { $name }, may have a different value at the position of the new text.
convert-expression-hint = Write { $name }={ $value } directly before the call, with nothing in between that changes it.
convert-skipped = The call is unchanged: { $name } is assigned on some paths to the call only; in the converted call it would always count.
convert-skipped-hint = Assign { $name } on every path, or directly before the call.
convert-skip-block = The call is unchanged: { $name } is assigned in a skippable block (/); in the converted call it would always count.
convert-skip-block-hint = Assign { $name } without “/”, or put the call into the same skip level.
convert-stays = Left as written, but not read by the argument list: { $names }. Newer controls use setting data instead, where known.
convert-read = Left as written, since other statements read them (line): { $names }.
convert-variable = The call reads these variables itself, since several assignments lead to it: { $names }.
convert-read-hint = A newer control may not have these variables: check the statements that read them.
convert-overwrites = The call is unchanged: line { $line } reads { $name }, and the converted call would assign another value to it.
convert-overwrites-hint = Use a variable of another name instead of { $name } there, then convert the call.
convert-called = The call is unchanged: { $program }, called between the assignment of { $name } and the call, may read or change it.
convert-called-hint = Assign { $name } directly before the call.
convert-unused = { $cycle } does not use these values in this variant, therefore omitted: { $names }.
convert-no-variant = The call is unchanged: this program assigns nothing to { $name }, so what is measured is known only to the calling program.
convert-no-variant-hint = Assign { $name } before the call, or open the calling program too.
convert-added = The list needs values that this program does not assign; written now: { $names }. Until now, what stood in the data of the control counted.
convert-added-hint = Check these values, or assign them before the call and convert it again.
convert-macro = The call is unchanged: a macro supplies more than one of its values.
convert-macro-hint = Replace the macro with its text in the program first.

revise-taken = The new variant does not use { $names }: removed from the call.
revise-shared = { $names } remain in the program, although the new variant does not use them: a later call reads them.
variable-before = { $name } cannot be changed: no line of the program assigns it before the call.
variable-several = { $name } cannot be changed: it is assigned in several places (lines { $lines }), depending on the path through the program.
variable-unclear = { $name } cannot be changed: a call, a loop or an index determines its value.
variable-calculated = { $name } cannot be changed: it is calculated in line { $lines }.
variable-number = { $name } can be changed once a number is entered.
variable-unsolved = { $name } cannot be changed: no value for it follows from the expression and the entered number.
variable-same = { $name } already has this value.

revise-around = Lines { $lines } around the call are changed with it.
revise-around-left = The lines around the call do not belong to it any more (line { $lines }).
revise-around-left-hint = Remove these lines “around the call” in the form, or change them by hand.
around-stray = These lines around { $name } belong to a call with another work offset or in another plane.
around-stray-hint = Apply the change below, or remove the lines if they are not about this call.
around-stray-cure = Lines for this call
