# The log of measurements: CYCLE100, 101, 105, 106, 113, 118.

cycle100-title = Log on
cycle100-help = Switches the measurement log on. From then on, every measuring cycle adds a block of values to the file, until CYCLE101.
cycle100-words = log protocol record print file report header switch on start logging measurement results
cycle100-on = Log on, header printed

cycle101-title = Log off
cycle101-help = Switches off the measurement log started with CYCLE100. The file can then be read out. No inputs are needed.
cycle101-words = log protocol record switch off stop end logging
cycle101-off = Log off

cycle105-title = Print to the log
cycle105-help = Prints the header or a block of values to the log, without a measuring cycle.
cycle105-words = log protocol print header block of values contents logging

cycle106-title = Log file control
cycle106-help = Prints the header or a block of values to the log and controls its files and pages. CYCLE100 calls it automatically.
cycle106-words = log protocol page follow-up continuation file sequence control logging

cycle113-title = Date or time as text
cycle113-help = Reads the date (yy/mm/dd) or the time (hh:mm:ss) of the control into a program variable.
cycle113-words = date time clock text string log
cycle113-date = Date
cycle113-time = Time
param-113-job = Date or time
param-113-job-help = 1 reads the date, 2 the time.
result-113-text = Date or time as text

cycle118-title = Number as text
cycle118-help = Converts a real number to a text, rounded to the specified decimal places, for a message or the log; up to ten R parameters at once.
cycle118-words = format real number decimals text string digits rounded message log
cycle118-format = Text of one or several numbers
param-118-number = Number
param-118-number-help = Number to be converted. Ignored if several R parameters are converted.
param-118-decimals = Decimal places
param-118-decimals-help = Number of decimal places to which the number is rounded. { "_DIGIT" } is the value used for the log.
param-118-count = Number of values
param-118-count-help = Above 1, the numbers are in consecutive R parameters; at most ten.
param-118-register = First R parameter
param-118-register-help = 11 for R11, R12 and so on.
need-118-one = One number is converted to text.
need-118-count = Not needed for one number.
need-118-registers = Several numbers are in R parameters.
result-118-text = Text of the only or last number
result-118-field = Text of one of several numbers

log-job-header = Header
log-job-values = Block of values
param-log-job = Log job
param-log-job-help = Header or block of values.
param-log-file = Log file
param-log-file-help = Name without extension: letters, digits and underscores, starting with two letters or with a letter and an underscore. A file of this name is overwritten.
param-log-program = Measuring program
param-log-program-help = Name printed in the header as program.
param-log-headline = User-defined header line
param-log-headline-help = Any text, also composed: { "\"Part number: \"<<PARTNUM" }. With { "_CBIT[11]" }=1 these lines are the whole header.
param-log-page = Lines per page
param-log-page-help = After this number of lines, including the header, a new page with a header starts. 0: one header at the start only.
param-log-line = Characters per line
param-log-line-help = At most 200. If a line needs more characters than entered, the cycle outputs a message.
param-log-first-page = First page number
param-log-first-page-help = First number of the page count in the header.
param-log-head-lines = User-defined header lines
param-log-head-lines-help = Number of lines of { "_HEADLINE[]" } to be printed.
param-log-value-lines = Value lines
param-log-value-lines-help = Number of lines per measurement, at most four.
param-log-column = Characters per column
param-log-column-help = 0: each column is as wide as its field in the first title line.
param-log-separator = Separator
param-log-separator-help = Character between two values in the log. In the lines that define the contents it is always a comma.
param-log-mark = Out-of-tolerance mark
param-log-mark-help = Printed after the actual value and the difference if { "_TSA" }, { "_TDIF" }, { "_TUL" } or { "_TLL" } is exceeded.
param-log-title = Title line
param-log-title-help = Column titles, separated by commas. If one line is enough, enter spaces in quotation marks in the second line; otherwise an old text would appear there.
param-log-values = Value line
param-log-values-help = Columns, separated by commas: { "_OVR[4]" } and other results, R27 and others, { "_TXT[0]" }, { "_AXIS" } (axis of { "_MA" }), { "_AXIS1" } to { "_AXIS3" } (axes of the plane), { "_TIME" }. Other text stays as it is.
param-log-digits = Decimal places
param-log-digits-help = Decimal places of all values.
need-log-file = The log needs a file.
need-log-header = Part of the header; if empty, the value in GUD6 applies.
need-log-values = Part of the values; if empty, the value in GUD6 applies.
need-log-titles = Part of the header; sets the column widths if “Characters per column” is 0.
need-log-format = Part of the format; if empty, the value in GUD6 applies.

check-log-file = This is not a permitted name for a log file.
check-log-file-hint = Use letters, digits and underscores; start with two letters or a letter and an underscore. No extension.
check-log-line = A line of the log has at most { $most } characters; the control uses that number.
check-log-line-hint = Enter at most { $most }.
check-log-empty = Nothing is logged: title lines and value lines are all empty.
check-log-empty-hint = Enter column titles, or in a value line what to log, for example { "_OVR[0],_OVR[4],_OVR[16]" }.
check-log-width = The first title line, which sets the column widths, is empty: all columns become 12 characters wide.
check-log-width-hint = Enter the first title line, or a width.
check-log-unknown = { $word } cannot be logged.
check-log-unknown-hint = Permitted: { "_OVR[0]" } to { "_OVR[31]" }, R parameters, { "_TXT[0]" } to { "_TXT[99]" }, { "_AXIS" }, { "_AXIS1" } to { "_AXIS3" }, { "_TIME" }.
check-log-narrow = Column { $column }, width { $width }, is too narrow: its text needs { $needed } characters.
check-log-narrow-hint = Make the column wider or the text shorter; otherwise the control widens the column and outputs a message.
check-log-long = The line has { $total } characters; the log permits at most { $most }.
check-log-long-hint = Reduce the column widths, or log fewer values per line.
check-log-longer = The line has { $total } characters, but only { $most } are permitted.
check-log-longer-hint = Increase the number of characters per line, or reduce the column widths.

log-column-time = Time
log-column-axis = Measuring axis, { "_MA" }
log-column-axis-place = { $place ->
    [1] Abscissa
    [2] Ordinate
   *[other] Applicate
 }, axis name
log-column-text = Text { $text }
log-column-number = R parameter { $text }
log-column-comment = Text “{ $text }”
log-column-unknown = { $text }: cannot be logged
log-column-free = Free text
