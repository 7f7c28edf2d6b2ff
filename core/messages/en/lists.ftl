# Calls with arguments in brackets: what is wrong with an argument, and what a list of newer controls says.

list-text-wanted = { $param } takes a text, and { $value } is a number.
list-text-wanted-hint = Write it in quotation marks.
list-number-wanted = { $param } takes a number, and “{ $value }” is a text.
list-number-wanted-hint = Write it without quotation marks.
list-text-unquoted = { $param }: { $value } stands without quotation marks, and the program declares no such variable.
list-text-unquoted-hint = Write it in quotation marks if this is the name itself.
list-arguments-many = { $name } has fewer parameters than this call has arguments: { $most } against { $count }.
list-arguments-many-hint = Count the commas, and take away what is too much.
list-selection = Argument { $place } of { $name } cannot be { $value }.
list-selection-hint = Choose one of { $choices }.

newer-open = { $param } = { $value }: what this means in the list of a newer control is not known here. It is kept as written, not checked and not simulated.
newer-target = { $value } stands in argument 2, where newer controls have the number of a zero offset, and this variant corrects none.
newer-target-hint = For a zero offset the third digit of argument 1 is 1. A tool target belongs in argument 3 (S_KNUM1): in argument 2 the control stops with alarm 61328. Else leave argument 2 empty.
write-newer-tool = The list of newer controls has the tool target in argument 3 (S_KNUM1), and its code there is not known here. In argument 2 the control would stop with alarm 61328.
write-newer-zero = Which zero offset { $value } is in the list of newer controls is not known here; only 1 to 99 and 9999 are.
write-newer = { $param } = { $value } means something else in the list of newer controls, or what it means there is not known here.
convert-newer = { $param } = { $value }: what this means in the list of newer controls the older one cannot say, or it is not known here.
convert-newer-hint = Write the call anew as assignments.
