# A protocol of a real machine: why a line or the whole of it is not taken, and what helps.

protocol-ending = { $fitted ->
    [one] 1 line of the protocol fits. Lines that do not fit: { $unfit }. Calls without a value: { $missing }.
   *[other] { $fitted } lines of the protocol fit. Lines that do not fit: { $unfit }. Calls without a value: { $missing }.
}
protocol-gap = { $name } is missing: what was measured in it has no value, or stands at another call. Choose all files of the log.
protocol-empty = The protocol is empty: choose the file that the machine wrote.
protocol-large = The protocol has more than { $most } lines: split it, a file for each part.
protocol-no-calls = The program measures nothing that a protocol could have values for: open the program that the machine carried out.
protocol-no-actual = The column of the actual value is missing: name it, or those of setpoint and deviation.
protocol-no-column = No line has a column “{ $name }”. The first line reads: { $fields }. Choose one of these names, or a number from 1.
protocol-no-value = No setpoint with an actual value in this line: if it has them, write them like 132.015 or 132,015, with “;” between them.
protocol-no-number = Column “{ $column }” holds no number but “{ $text }”: write it like 132.015 or 132,015, without a sign between thousands, or choose another column.
protocol-no-call = No call without a value has a setpoint from this line: check that the program belongs to the protocol, or choose the columns.
protocol-no-heading = No further call of { $cycle } with variant { $variant }: check that the program belongs to the protocol.
protocol-no-number-of-call = The program has no measurement { $number }: check the column of the number.
protocol-no-line = No call without a value is in line { $line } of the program: check the column of the line.
protocol-no-result = The call has no result { $name } without a value: check the column of the result.
protocol-differs = The deviation { $by } is not actual value minus setpoint, which is { $is }: check the columns.
protocol-contradicted = { $actual } is taken as the actual value of the setpoint { $set }, but { $by } is not their difference: check the line, or choose the columns.
protocol-ambiguous = { $actual } is taken as the actual value of the setpoint { $set }, but { $other } could be it too: check the line, or choose the columns.
protocol-marked = The machine marked { $actual } as beyond a limit; by the tolerance of this program it is within: check the tolerance, or the decimals of the log.
protocol-blank = Nothing stands in column “{ $column }”: fill it in, or choose another column.
protocol-above = This line stands above the headings of the table: move it below them, or choose the columns.
protocol-wide = { $cells } cells below { $heads } headings: a comma of the decimals may part them. Write “;” between the cells or a decimal point, or put values with a comma in quotes.
protocol-comma = A comma parts the numbers and could be that of the decimals: write “;” between them or a decimal point, or put them in quotes.
protocol-quote = A quote is opened and not closed: close it at the end of the value, or remove it.
protocol-other-line = Measurement { $number } is in line { $own } of the program, not in line { $line }: check the columns of number and line.
protocol-cells = { $cells } cells below { $heads } headings: give each column its heading, or put a value that holds the separator in quotes.
protocol-mark = “{ $text }” ends in the mark “{ $mark }” of values beyond a limit, or in a digit of its own: choose another sign for _PROTSYM[1].
protocol-again = The call has a value for the setpoint { $set } already: remove the line, or number each measurement anew.
protocol-two-columns = Columns { $first } and { $other } could both be “{ $name }”; column { $first } is taken: check it, or choose the column by its number.
protocol-same-column = Column “{ $name }” is chosen for two things: choose a column for each.
