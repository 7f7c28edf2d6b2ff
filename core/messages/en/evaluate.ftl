# Decisions of a measuring cycle after measuring. Numbers in mm.
evaluate-safe-area = Difference { $difference } mm exceeds the safe area: nothing is corrected.
evaluate-safe-area-angle = Difference { $difference }° exceeds the safe area: nothing is corrected.
evaluate-difference = Difference { $difference } mm exceeds the permissible dimensional difference: nothing is corrected.
evaluate-oversize = Difference { $difference } mm is above the upper tolerance: { $follows }.
evaluate-undersize = Difference { $difference } mm is below the lower tolerance: { $follows }.
evaluate-whole = Difference { $difference } mm is within tolerance but outside the range of the mean value: { $follows }.
evaluate-mean = Difference { $difference } mm gives mean value { $mean } mm, which exceeds the zero compensation area: { $follows }.
# What follows from the four before.
evaluate-corrects-whole = the whole difference is corrected
evaluate-corrects-both = the correction is the mean of the two differences
evaluate-corrects-zero = the mean of the two differences is 0, so nothing is corrected
evaluate-corrects-mean = the correction is the mean value
evaluate-corrects-nothing = nothing is corrected, as no correction is selected
evaluate-corrects-simulated = this simulation corrects nothing
evaluate-restarts = The mean value restarts: { $name } is set to 0.
evaluate-small = Difference { $difference } mm gives mean value { $mean } mm, which is within the zero compensation area: nothing is corrected.
evaluate-kept = At most { $limit } mm (_TZL) from the stored value and therefore unchanged: { $data }.
evaluate-repeat = Measured again because the difference is too large, repetition { $count } of at most 4.
evaluate-halt = Programmed stop (M0): the operator continues with NC START.
evaluate-activated = The corrected frame is active immediately.
evaluate-not-activated = The corrected frame becomes active when the program calls it again (G54, G500 …).
evaluate-distortion = The measured triangle differs from the setpoint triangle by { $distortion } mm; the frame is corrected only below { $limit } mm.
evaluate-handed-back = The cycle raises no alarm: { $name } is set to { $alarm } and the program continues.
evaluate-tool-safe-area = Difference { $difference } mm is not below the safe area, { $limit } mm: this value is not corrected.
evaluate-tool-difference = Difference { $difference } mm is not below the permissible dimensional difference, { $limit } mm: this value is not corrected.
evaluate-tool-small = Difference { $difference } mm does not exceed the zero compensation area, { $limit } mm: this value is not corrected.
evaluate-tool-geometry = Difference { $difference } mm and the previous wear go into the geometry; the wear is set to 0.
evaluate-tool-wear = Difference { $difference } mm is corrected in the wear.
evaluate-tool-simulated = Difference { $difference } mm is not corrected: this simulation corrects nothing.
evaluate-compensation-make = The table of this probe make (_TP_CF = { $make }) is internal to the control and not in any manual: it is not applied here. Your own table in _MT_EC_R and _MT_EC_L, with _MT_COMP = 2, is applied.
evaluate-compensation = { $amount } mm from table { $table } is subtracted from the measured value.
evaluate-screen = The control shows the measuring result screen until the cycle ends.
evaluate-screen-stays = The control shows the measuring result screen until the next measuring cycle is called; the program continues.
evaluate-screen-halt = The control shows the measuring result screen. Programmed stop (M0): the operator continues with NC START.
evaluate-log-full = The log { $file } and its nine continuation files are full: nothing more is logged. The control stops and requests a new name in _PROTNAME[1].
evaluate-log-deleted = The log { $file } of this run is started again: its { $lines } lines are deleted.
evaluate-log-none = No log was started before this call: CYCLE105 prints nothing. CYCLE100 starts a log.
# What a call does with data of the machine before it measures.
check-erases = _CBIT[13]=1: this call first sets _TP[], _TPW[], _WP[], _KB[], _EV[], _MV[] and the bit itself to 0.
check-erases-hint = Set _CBIT[13] to 0 before the call, or re-enter the data after it and recalibrate.
check-converts = { $bit } does not agree with the basic system of the machine (MD 10240): this call first converts { $data } { $value ->
        [1] from inch to mm
       *[other] from mm to inch
    }.
check-converts-hint = If the data are already correct, set { $bit } to { $value } before the call.
evaluate-erased = _CBIT[13]=1: _TP[], _TPW[], _WP[], _KB[], _EV[], _MV[] and the bit itself are now 0.
evaluate-converted = { $bit } did not agree with the basic system of the machine: { $data } have been converted { $value ->
        [1] from inch to mm
       *[other] from mm to inch
    }, and the bit is now { $value }.

# A measurement in one line: what was measured.
answer-diameter = Diameter
answer-width = Width
answer-length = Length
answer-centre = Centre
answer-position = Position
answer-angle = Angle
answer-corner = Corner
answer-tool-length = Tool length
answer-radius = Radius
answer-trigger = Trigger point
answer-skew = Probe skew
answer-probe-length = Probe length
answer-value = Measured value
# What is corrected.
answer-frame = { $frame }
answer-frame-fine = { $frame }, fine
answer-tool = T{ $tool } D{ $edge }
answer-tool-offset = T{ $tool } D{ $edge } DL{ $offset }
answer-register = Register { $register }
answer-probe = Probe data
# What follows.
answer-within = Within limits
answer-within-area = Within the safe area
answer-beyond = Out of limits
answer-rework = Rework
answer-scrap = Scrap
answer-alarm = Alarm { $code }
answer-stopped = Not simulated further
answer-measured = Measured
answer-why-within = The deviation is at most { $limit }{ $unit ->
        [deg] °
        [inch]  inch
       *[mm]  mm
    }.
answer-why-area = No tolerance is set. The deviation is within the safe area of { $limit }{ $unit ->
        [deg] °
        [inch]  inch
       *[mm]  mm
    }.
answer-why-measured = No limit is set for this measurement.

screen-tool-probe = Calibrating the tool probe
screen-tool = Measuring the tool
screen-probe = Calibrating the workpiece probe
screen-workpiece = Workpiece measurement
screen-set = Setpoint
screen-actual = Actual value
screen-difference = Difference
screen-until-end = Shown until the cycle ends.
screen-until-start = Waits for NC START: acknowledge the measuring result screen.
screen-until-next = Shown until the next measuring cycle is called.
screen-waits = The program waits for NC START.
