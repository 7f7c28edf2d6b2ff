# Ways of writing a call, and what they cannot say.

write-no-list = There is no call of this kind for { $cycle }.
write-no-list-variant = This variant or target of { $cycle } cannot be written as such a call.
write-variant-open = The arguments choose the measuring variant, and { $value } is known at run time only.
write-no-list-hint = Write it as assignments and the call.
write-zero = { $name }={ $value } stands as an assignment of its own: a 0 in CYCLE_PARA keeps the value of before.
write-beside = { $name }={ $value } stands as an assignment of its own: the call has no argument for it.
write-lost = { $name } is left out: the list of newer controls has no argument for it.
write-lost-hint = Write the call as assignments if the value matters, or set the datum at the control.
write-expression = { $name }={ $value } stands as an assignment of its own: should { $value } be 0, CYCLE_PARA would keep the value of before.
write-expression-lost = { $name }={ $value } would be lost: the list of newer controls has no argument for it.

convert-same = The call is written like that already.
convert-lost = Left out of the list: { $names }. The older control has no parameter for that.
convert-lost-hint = Check that the call does without it.
convert-others = { $cycle } in line { $line } relies on values of this call and would get others.
convert-others-hint = Convert that call as well, or write its values before it.
convert-argument = The argument { $value } of this call would be lost: nothing takes it in another way of writing.
convert-expression = The call stays as it is: { $value }, written to { $name }, may be worth something else where the new text would stand.
convert-expression-hint = Write { $name }={ $value } directly before the call, with nothing between that changes it.

revise-taken = The new variant does not know { $names }: taken out of the call.
revise-kept = { $name }={ $value } stays in the program although the new variant does not use it: it is an expression.
