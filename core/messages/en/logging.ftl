# The log of measurements: CYCLE100, 101, 105, 106, 113, 118.

cycle100-title = Log on
cycle100-help = Switches the log of measurements on. From then on every measuring cycle adds a block of values to the file, until CYCLE101.
cycle100-words = log protocol record print file report header switch on start logging measurement results
cycle100-on = Log on, header printed

cycle101-title = Log off
cycle101-help = Switches the log of measurements off that CYCLE100 switched on. The file can be read out after that. Nothing has to be given.
cycle101-words = log protocol record switch off stop end logging
cycle101-off = Log off

cycle105-title = Print into the log
cycle105-help = Prints the header or a block of values into the log, without a measuring cycle.
cycle105-words = log protocol print header block of values contents logging

cycle106-title = Keep the log
cycle106-help = Prints the header or a block of values into the log, and looks after its files and pages. CYCLE100 calls it by itself.
cycle106-words = log protocol page follow-up file sequence control logging

cycle113-title = Date and time as a text
cycle113-help = Reads the date (yy/mm/dd) or the time (hh:mm:ss) of the control into a variable of the program.
cycle113-words = date time clock text string log
cycle113-date = Date
cycle113-time = Time
param-113-job = Date or time
param-113-job-help = 1 reads the date, 2 the time.
result-113-text = Date or time as a text

cycle118-title = Number as a text
cycle118-help = Makes a text of a real number, rounded to so many decimals, for a message or for the log; of up to ten R parameters at once.
cycle118-words = format real number decimals text string digits rounded message log
cycle118-format = Text of one number or of several
param-118-number = Number
param-118-number-help = The number that becomes a text. Not looked at where several R parameters are taken.
param-118-decimals = Decimals
param-118-decimals-help = Digits behind the point; the text is rounded. { "_DIGIT" } is what the log uses.
param-118-count = How many numbers
param-118-count-help = Above 1 the numbers stand in consecutive R parameters; ten at most.
param-118-register = First R parameter
param-118-register-help = 11 for R11, R12 and so on.
need-118-one = One number becomes a text.
need-118-count = May be left out for one number.
need-118-registers = Several numbers stand in R parameters.
result-118-text = Text of the number, of the last one of several
result-118-field = Text of a number out of several

log-job-header = Header
log-job-values = Block of values
param-log-job = What is printed
param-log-job-help = Header or block of values.
param-log-file = Log file
param-log-file-help = Name without ending: letters, digits and underscores, beginning with two letters or with a letter and an underscore. A file of this name is overwritten.
param-log-program = Measuring program
param-log-program-help = Name that the header shows as program.
param-log-headline = Own header line
param-log-headline-help = Any text, also put together: { "\"Part number: \"<<PARTNUM" }. With { "_CBIT[11]" }=1 these lines are the whole header.
param-log-page = Lines of a page
param-log-page-help = After so many lines, header included, a new page with a header begins. 0: a header at the begin only.
param-log-line = Characters of a line
param-log-line-help = 200 at most. A longer line is told by a message.
param-log-first-page = First page number
param-log-first-page-help = The header counts pages from here.
param-log-head-lines = Own header lines
param-log-head-lines-help = How many of the lines { "_HEADLINE[]" } are printed.
param-log-value-lines = Lines of values
param-log-value-lines-help = How many lines a measurement gets, four at most.
param-log-column = Characters of a column
param-log-column-help = 0: each column is as wide as its field in the first title line.
param-log-separator = Separator
param-log-separator-help = Character between two values in the log. In the lines that say what is printed it is always a comma.
param-log-mark = Mark of a value out of tolerance
param-log-mark-help = Stands behind the measured value and the difference when { "_TSA" }, { "_TDIF" }, { "_TUL" } or { "_TLL" } is exceeded.
param-log-title = Title line
param-log-title-help = Names of the columns, parted by commas. If one line is enough, put blanks in quotes into the second one, since an old text would appear there otherwise.
param-log-values = Line of values
param-log-values-help = What the columns show, parted by commas: { "_OVR[4]" } and other results, R27 and other R parameters, texts { "_TXT[0]" }, { "_AXIS" } (axis of { "_MA" }), { "_AXIS1" } to { "_AXIS3" } (axes of the plane), { "_TIME" }. Anything else is printed as it stands.
param-log-digits = Decimals
param-log-digits-help = Digits behind the point of all values.
need-log-file = The log needs a file.
need-log-header = Belongs to the header; what the machine has counts when nothing is entered.
need-log-values = Belongs to the values; what the machine has counts when nothing is entered.
need-log-titles = Belongs to the header, and gives the widths of the columns.
need-log-format = Belongs to the format; what the machine has counts when nothing is entered.

check-log-file = This cannot be the name of a log file.
check-log-file-hint = Take letters, digits and underscores only, and begin with two letters or with a letter and an underscore. The ending comes by itself.
check-log-line = A line of the log has { $most } characters at most; the control takes that.
check-log-line-hint = Enter { $most } or less.
check-log-empty = Nothing is to be logged: title lines and lines of values are all empty.
check-log-empty-hint = Enter what is to be printed, for example { "_OVR[0],_OVR[4],_OVR[16]" }.
check-log-width = The columns cannot be as wide as their titles, because there is no title line; all become 12 characters wide.
check-log-width-hint = Enter a title line, or a width.
check-log-unknown = { $word } cannot be logged.
check-log-unknown-hint = The log knows { "_OVR[0]" } to { "_OVR[31]" }, R parameters, { "_TXT[0]" } to { "_TXT[99]" }, { "_AXIS" }, { "_AXIS1" } to { "_AXIS3" } and { "_TIME" }. Put other values into an R parameter first.
check-log-narrow = Column { $column } is { $width } characters wide, and its text has { $needed }.
check-log-narrow-hint = Make the column wider or the text shorter; the control makes it wider and tells it.
check-log-long = The line becomes { $total } characters long; no log takes more than { $most }.
check-log-long-hint = Lower the width of the columns, or log fewer values in a line.
check-log-longer = The line becomes { $total } characters long, and only { $most } are allowed.
check-log-longer-hint = Raise the characters of a line, or lower the width of the columns.
