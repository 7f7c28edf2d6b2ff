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
newer-target = { $value } is in argument 2, where newer controls expect the number of a zero offset, but this variant corrects no zero offset.
newer-target-hint = Zero offset: set the 3rd digit of argument 1 to 1. Tool: use argument 3 (S_KNUM1). Or leave argument 2 empty.
write-newer-tool = Newer controls have the tool target in argument 3 (S_KNUM1, see alarm 61328); its code is not known.
write-newer-zero = The zero offset { $value } in the list of newer controls is not known; only 1 to 99 and 9999 are.
write-newer = { $param } = { $value } has another meaning in the argument list of newer controls, or its meaning is not known.
convert-newer = { $param } = { $value }: the older argument list has no equivalent for this value of the newer one, or its meaning is not known.
convert-newer-hint = Write the call again as assignments.
