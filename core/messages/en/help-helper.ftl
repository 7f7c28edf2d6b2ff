# Help pages of the cycles that move nothing: the log (CYCLE100, 101, 105, 106, 113, 118), circle and position (CYCLE116, 119).

help-log-data = What is printed, and how, stands in user data of the machine, which keep their values from program to program: write only what differs.
help-log-title = Only one title line is written: the second one still shows that of an earlier log. Put blanks in quotes into _PROTVAL[1].
help-log-column = A value is wider than its column: the control makes the column wider and tells it, message 62309; the columns no longer stand below each other.
help-log-line = Columns times width is more than 200 characters: alarm 61371.
help-log-name = _PROTNAME[1] names the file: letters, digits and underscores, two letters or a letter and an underscore first. The ending MPF comes by itself; the folder is that of the program that calls.
help-log-files = The log as a file. What does not fit into the kilobytes of MD 11420 goes into up to nine more files, whose names end in an underscore and a digit.
help-log-full = The tenth file is full as well: the program halts and asks for a new name of the log; started again, it goes on.
help-log-refused = The file has no name (61354), another program has it in use (61356), or its folder does not exist (61353).
help-log-header = The header: date, time and number of the page, the program _PROTNAME[0], your own lines _HEADLINE[0] and following, the title lines _PROTVAL[0] and _PROTVAL[1]. With _CBIT[11]=1 it is your own lines alone.
help-log-block = A block: name of the measuring cycle and its _MVAR, unless _CBIT[6]=1, then as many lines of values as _PROTFORM[4] says. _PROTSYM[1] marks an actual value and its difference beyond _TSA, _TDIF, _TUL or _TLL.
help-log-chosen = _PROTVAL[2] to _PROTVAL[5] name what the lines show: results in _OVR, R parameters, texts. Another measuring cycle or variant has other results.

help-cycle100-does = Switches the log of measurements on: from here to CYCLE101 every measuring cycle adds a block of values. Nothing moves.
help-cycle100-values = Before each measuring call, _PROTVAL[2] to _PROTVAL[5] name what its lines show: another cycle or variant has other results.
help-cycle100-begin = A file of that name is deleted and begun anew; CYCLE100 has CYCLE106 do that.
help-cycle100-each = Each measuring call that follows prints its block by itself; the program calls no other cycle of the log.
help-cycle100-lost = The log of the last part was not read out: it is deleted. Give each part a name of its own.
help-cycle100-old = Further files of an earlier log are left until this log needs their names: what they hold is not of this part.

help-cycle101-does = Switches the log off that CYCLE100 switched on. Nothing moves.
help-cycle101-last = The last measuring call that belongs into the log has been made.
help-cycle101-flag = The mark that the log is on is taken away; measuring cycles that follow print nothing.
help-cycle101-files = The files of the log, which can be read out now.
help-cycle101-missing = It is left out: what is measured later goes into the log too, and the file cannot be read out.

help-cycle105-header = Prints the header into the log by itself, without a measuring cycle. Nothing moves.
help-cycle105-values = Prints a block of up to four lines of values into the log by itself, without a measuring cycle, for example behind a calculation of your own. Nothing moves.
help-cycle105-open = The log is on: CYCLE100 was called. Measuring cycles print by themselves and need no CYCLE105.
help-cycle105-left-header = A header more in the file of the log.
help-cycle105-left-values = A block of values more in the file of the log.
help-cycle105-number = CYCLE106 numbers its jobs otherwise: there 2 is the block of values. One edition of the manual has 0 and 1 in the other order here; try it once on the control.

help-cycle106-header = Prints the header into the log and looks after its files and pages. Nothing moves.
help-cycle106-values = Prints a block of values into the log and looks after its files and pages. Nothing moves.
help-cycle106-alone = The program keeps a log without measuring cycles: with them, CYCLE100 and the measuring calls are enough.
help-cycle106-keeps = Where it is due, old files of the same name are deleted, the next file is opened when one is full, and a new page begins after _PROTFORM[0] lines.
help-cycle106-number = PAR1 is neither 1 nor 2: alarm 61360. CYCLE105 numbers its jobs otherwise.

help-cycle113-date = Reads the date of the control as a text. Nothing moves.
help-cycle113-time = Reads the time of the control as a text. Nothing moves.
help-cycle113-variable = A variable takes the text: DEF STRING[10] PAR2 at the begin of the program, or the name of your own variable in the call.
help-cycle113-year = The date is written as year, month, day, two digits each with strokes between them.
help-cycle113-hour = The time is written as hours, minutes, seconds, two digits each with colons between them.
help-cycle113-left = The text in the variable of the call, and nothing else.
help-cycle113-short = The variable is declared with fewer than 10 characters: the text does not fit.

help-cycle118-does = Makes a text of a real number, with so many decimals; of up to 10 numbers at once. Nothing moves.
help-cycle118-variable = A variable takes the text: DEF STRING[12] PAR3 at the begin of the program, or the name of your own variable in the call.
help-cycle118-registers = Several numbers stand in R parameters that follow each other; PAR5 is the number of the first, PAR4 how many there are.
help-cycle118-rounds = One number: PAR1 is rounded to PAR2 decimals and written as a text.
help-cycle118-many = Several numbers: the R parameters are rounded to PAR2 decimals, one after the other; PAR1 is not looked at.
help-cycle118-left = The text in the variable of the call. Several numbers leave their texts in _TXT[0] to _TXT[9], and the last one is in the variable too.
help-cycle118-count = PAR4 is above 10: alarm 61362.
help-cycle118-length = A number with its decimals takes more than 12 characters: the text does not fit.

help-cycle116-does = Computes centre and radius of a circle from three or four points, for example from points that were measured one by one. Nothing moves.
help-cycle116-variables = Both variables are declared at the begin of the program: DEF REAL _DATE[13] and DEF INT _ALM.
help-cycle116-points = _DATE[0] says how many points there are; abscissa and ordinate of each stand in pairs in _DATE[1] to _DATE[8].
help-cycle116-circle = Three points determine the circle; of four all count.
help-cycle116-left = Centre in _DATE[9] and _DATE[10], radius in _DATE[11], state in _DATE[12], number of the alarm in _ALM: both are 0 when the circle was found. No tool and no zero offset is corrected.
help-cycle116-line = The points lie in line or upon each other: _ALM is 61316.
help-cycle116-count = _DATE[0] is neither 3 nor 4: _ALM is 61317.
help-cycle116-unseen = The program goes on with a wrong circle when _ALM is not looked at behind the call: the alarm does not stop it.

help-cycle119-does = Computes how a part lies in space: where three points should be, the reference triangle, and where they were measured. Corrects a frame by shift and rotation, where _COR asks for it. Nothing moves.
help-cycle119-variables = The variables are declared at the begin of the program: DEF REAL _SETPOINT[3,3], _MEASPOINT[3,3], _RES, DEF INT _ALARM and DEF FRAME _REFRAME.
help-cycle119-points = The points were measured one by one, for example with CYCLE977 or CYCLE997; _SETPOINT and _MEASPOINT hold them in the same order, X, Y and Z of each, in the active frame.
help-cycle119-alarm = _ALARM is 0.
help-cycle119-frame = The frame between both triangles is computed. What they differ in shape, the deviations of the three points added up, becomes _RES; below 0 there is no frame.
help-cycle119-decides = With _COR=0 that is all. Otherwise a frame is corrected, if _RES is below _RESLIM.
help-cycle119-left = _RES, the frame in _REFRAME, which chained to the active one brings the measured points to their set coordinates, and in _ALARM 0 or the number of an alarm.
help-cycle119-frame-moved = The frame that _COR names, in shift and rotation: 1 to 99 a settable one, 1000 the last active channel basic frame, 1011 to 1026 a channel basic frame, 2000 the system frame of setting actual values, 9999 the active one.
help-cycle119-again = The corrected frame counts when its G function (G54 …) is programmed again, with _COR=9999 as well.
help-cycle119-line = Three points lie on one line or upon each other: _ALARM is 61411.
help-cycle119-distorted = The triangles differ by _RESLIM or more: _ALARM is 61414, nothing is corrected.
help-cycle119-order = The points do not stand in the same order both times: the triangles do not fit each other.
help-cycle119-mirrored = The frame mirrors or scales: _ALARM is 61411.
help-cycle119-absent = The frame is not there: _ALARM is 61321. With _COR=1000, or 9999 while G500 is active, and no channel basic frame it is 61412.
help-cycle119-unseen = The program goes on with an uncorrected frame when _ALARM is not looked at behind the call: the alarm does not stop it.
