# What the reader of part programs did not understand.
syntax-unknown = This is not understood.
syntax-value = A value is missing here.
syntax-operand = A number, a variable or a bracket is expected here.
syntax-operator = An operator cannot begin a word.
syntax-equals = “=” is expected here.
syntax-bracket = A bracket is not closed.
syntax-index = An index holds one to three values.
syntax-text = A text is not closed with a quotation mark.
syntax-number = This number cannot be read.
syntax-comma = The control writes decimals with a point, not with a comma.
syntax-depth = Brackets and operators are nested too deeply.
syntax-comment = A comment is not closed.
syntax-too-large = The program is too large; the rest was not read.
syntax-exponent = The control writes an exponent as EX, for example 1.5EX-3.
block-twice = { $word } is programmed twice in this block: the control stops there.
block-twice-hint = Write one of them, or give each a block of its own.
block-axis-name = { $word } is an axis: a variable cannot have its name.
block-axis-name-hint = Choose a name that begins with two letters or an underscore.
syntax-write = Write { $value }.
syntax-behind-end = What stands behind the end of the file (character Ctrl-Z) is not read.
syntax-behind-end-hint = Take the character out if the lines behind it belong to the program.
program-names = A call finds this program as { $file }, the name of its file; its PROC says { $proc }.
program-names-hint = Give both the same name.
nct-foreign = { $word } calls no measuring macro here: no address of it is one that the macro takes. The block is passed over.
nct-foreign-hint = On this control { $cycle } measures. Take it out if the program was written for another control.
syntax-no-exponent = Numbers have no exponent on this control.
syntax-no-exponent-hint = Write all digits, for example 0.001.
