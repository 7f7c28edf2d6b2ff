# Help pages of the cycles that move nothing: the log (CYCLE100, 101, 105, 106, 113, 118), circle and position (CYCLE116, 119).

help-log-data = The user data of the machine define what is printed, and how. They keep their values from program to program: write only what differs.
help-log-title = Only one title line is written: the second line still contains the title of an earlier log. Write spaces in quotation marks into _PROTVAL[1].
help-log-column = A value is wider than its column: the control widens the column and outputs message 62309; the columns are no longer aligned.
help-log-line = Number of columns times column width exceeds 200 characters: alarm 61371.
help-log-name = _PROTNAME[1] is the file name: letters, digits, underscores; two letters first, or a letter and an underscore. MPF is added automatically; the folder is that of the calling program.
help-log-files = The log as a file. Text above the kilobytes of MD 11420 goes into up to nine more files, whose names end in an underscore and a digit.
help-log-full = The tenth file is also full: the program stops and requests a new log name; it continues with NC START.
help-log-refused = The file has no name (alarm 61354), is in use by another program (61356), or its folder does not exist (61353).
help-log-header = The header: date, time and page number, the program _PROTNAME[0], your own lines from _HEADLINE[0], the title lines _PROTVAL[0] and _PROTVAL[1]. With _CBIT[11]=1 only your own lines.
help-log-block = A block: cycle and its _MVAR, unless _CBIT[6]=1, then as many value lines as _PROTFORM[4] specifies. _PROTSYM[1] marks actual value and difference outside _TSA, _TDIF, _TUL or _TLL.
help-log-chosen = _PROTVAL[2] to _PROTVAL[5] specify the contents of the lines: results in _OVR, R parameters, texts. Another measuring cycle or variant returns other results.

help-cycle100-does = Switches the measurement log on: from this call to CYCLE101 every measuring cycle adds a block of values. Nothing moves.
help-cycle100-values = Before each measuring call, set _PROTVAL[2] to _PROTVAL[5] to the contents of its lines: another cycle or variant has other results.
help-cycle100-begin = A file of this name is deleted and created again; CYCLE100 calls CYCLE106 for this.
help-cycle100-each = Each measuring call that follows prints its block automatically; the program calls no other cycle of the log.
help-cycle100-lost = The log of the last part was not read out: it is deleted. Use a separate name for each part.
help-cycle100-old = Continuation files of an earlier log remain until this log needs their names: their contents do not belong to this part.

help-cycle101-does = Switches off the log that CYCLE100 switched on. Nothing moves.
help-cycle101-last = The last measuring call of the log is complete.
help-cycle101-flag = The marker for an active log is reset; measuring cycles that follow print nothing.
help-cycle101-files = The files of the log can now be read out.
help-cycle101-missing = The call is missing: later measurements also go into the log, and the file cannot be read out.

help-cycle105-header = Prints the header to the log, without a measuring cycle. Nothing moves.
help-cycle105-values = Prints a block of up to four value lines to the log, without a measuring cycle, for example after your own calculation. Nothing moves.
help-cycle105-open = The log is on: CYCLE100 was called. Measuring cycles print automatically and need no CYCLE105.
help-cycle105-left-header = An additional header in the log file.
help-cycle105-left-values = An additional block of values in the log file.
help-cycle105-number = CYCLE106 numbers its jobs differently: there, 2 is the block of values. One edition of the manual has 0 and 1 in reverse order here; test it once on the control.

help-cycle106-header = Prints the header to the log and controls its files and pages. Nothing moves.
help-cycle106-values = Prints a block of values to the log and controls its files and pages. Nothing moves.
help-cycle106-alone = The program keeps a log without measuring cycles: with measuring cycles, CYCLE100 and the measuring calls are sufficient.
help-cycle106-keeps = If required, old files of the same name are deleted, the next file is opened when one is full, and a new page starts after _PROTFORM[0] lines (0: no new page).
help-cycle106-number = PAR1 is neither 1 nor 2: alarm 61360. CYCLE105 numbers its jobs differently.

help-cycle113-date = Reads the date of the control as a text. Nothing moves.
help-cycle113-time = Reads the time of the control as a text. Nothing moves.
help-cycle113-variable = A variable receives the text: DEF STRING[10] PAR2 at the start of the program, or the name of your own variable in the call.
help-cycle113-year = The date is written as year, month, day, two digits each, separated by slashes.
help-cycle113-hour = The time is written as hours, minutes, seconds, two digits each, separated by colons.
help-cycle113-left = Only the text in the variable of the call.
help-cycle113-short = The variable is declared with fewer than 10 characters: the cycle requires STRING[10].

help-cycle118-does = Converts a real number with the specified decimal places to a text; up to 10 numbers at once. Nothing moves.
help-cycle118-variable = A variable receives the text: DEF STRING[12] PAR3 at the start of the program, or the name of your own variable in the call.
help-cycle118-registers = Several numbers are in consecutive R parameters; PAR5 is the number of the first, PAR4 the number of values.
help-cycle118-rounds = One number: PAR1 is rounded to PAR2 decimal places and written as text.
help-cycle118-many = Several numbers: the R parameters are rounded to PAR2 decimal places, one after the other; PAR1 is ignored.
help-cycle118-left = The text in the variable of the call. With several numbers, their texts are in _TXT[0] to _TXT[9], and the last one is also in the variable.
help-cycle118-count = PAR4 exceeds 10: alarm 61362.
help-cycle118-length = A number with its decimal places needs more than 12 characters: the text does not fit.

help-cycle116-does = Calculates centre and radius of a circle from three or four points, for example from points measured one by one. Nothing moves.
help-cycle116-variables = Declare both variables at the start of the program: DEF REAL _DATE[13] and DEF INT _ALM.
help-cycle116-points = _DATE[0] is the number of points; _DATE[1] to _DATE[8] contain abscissa and ordinate of each point, in pairs.
help-cycle116-circle = Three points determine the circle; with four, all are used.
help-cycle116-left = Centre in _DATE[9] and _DATE[10], radius in _DATE[11], status in _DATE[12], alarm number in _ALM: both are 0 if a circle was calculated. No tool and no zero offset is corrected.
help-cycle116-line = The points are collinear or coincident: _ALM is 61316.
help-cycle116-count = _DATE[0] is neither 3 nor 4: _ALM is 61317.
help-cycle116-unseen = If the program does not evaluate _ALM after the call, it continues with a wrong circle: the alarm does not stop it.

help-cycle119-does = Calculates the position of a part in space from the setpoints and the measured positions of three points. If _COR specifies it, corrects a frame by translation and rotation. Nothing moves.
help-cycle119-variables = Declare the variables at the start of the program: DEF REAL _SETPOINT[3,3], _MEASPOINT[3,3], _RES, DEF INT _ALARM and DEF FRAME _REFRAME.
help-cycle119-points = The points were measured one by one, for example with CYCLE977 or CYCLE997; _SETPOINT and _MEASPOINT contain them in the same order, X, Y and Z of each, in the active frame.
help-cycle119-alarm = _ALARM is 0.
help-cycle119-frame = The frame between the two triangles is calculated. _RES is their difference in shape, the sum of the deviations of the three points; below 0 there is no frame.
help-cycle119-decides = With _COR=0, nothing is corrected. Otherwise a frame is corrected if _RES is below _RESLIM.
help-cycle119-left = _RES, the frame _REFRAME, and in _ALARM 0 or the alarm number. Chained to the active frame, _REFRAME moves the measured points to their setpoints.
help-cycle119-frame-moved = The frame in _COR, translation and rotation: 1 to 99 settable, 1000 last active channel basic, 1011 to 1026 channel basic frame, 2000 system frame $P_SETFR, 9999 active.
help-cycle119-again = The corrected frame applies when its G function (G54 …) is programmed again, also with _COR=9999.
help-cycle119-line = The three points are collinear, or two of them coincide: _ALARM is 61411.
help-cycle119-distorted = The triangles differ by _RESLIM or more: _ALARM is 61414, nothing is corrected.
help-cycle119-order = The points are not in the same order in both sets: the triangles do not match.
help-cycle119-mirrored = The frame contains mirroring or scaling: _ALARM is 61411.
help-cycle119-absent = The frame does not exist: _ALARM is 61321. With _COR=1000, or 9999 while G500 is active, and without a channel basic frame, _ALARM is 61412.
help-cycle119-unseen = If the program does not evaluate _ALARM after the call, it continues with an uncorrected frame: the alarm does not stop it.
