# Decisions of a measuring cycle after measuring. Numbers in mm.
evaluate-safe-area = Difference { $difference } mm exceeds the safe area: nothing is corrected, the program stops.
evaluate-safe-area-angle = Difference { $difference }° exceeds the safe area: nothing is corrected, the program stops.
evaluate-difference = Difference { $difference } mm exceeds the permissible dimensional difference: nothing is corrected, the program goes on.
evaluate-oversize = Difference { $difference } mm is above the upper tolerance: the whole difference is corrected, the mean value begins again.
evaluate-undersize = Difference { $difference } mm is below the lower tolerance: the whole difference is corrected, the mean value begins again.
evaluate-whole = Difference { $difference } mm is within tolerance, but beyond the range of the mean value: the whole difference is corrected, the mean value begins again.
evaluate-mean = Difference { $difference } mm gives the mean value { $mean } mm, which exceeds the zero offset area: the mean value is corrected and begins again.
evaluate-small = Difference { $difference } mm gives the mean value { $mean } mm, which stays within the zero offset area: nothing is corrected.
evaluate-kept = No more than { $limit } mm (_TZL) from what is stored, and therefore kept: { $data }.
evaluate-repeat = Measured again after a violated limit, repetition { $count } of 4.
evaluate-halt = Programmed stop (M0): the operator continues with NC START.
evaluate-activated = The corrected frame is active at once.
evaluate-not-activated = The corrected frame becomes active when the program calls it again (G54, G500 …).
evaluate-distortion = The measured triangle differs from the set one by { $distortion } mm; below { $limit } mm the frame is corrected.
evaluate-handed-back = There is no result: { $name } becomes { $alarm }, and the program goes on.
evaluate-tool-small = Difference { $difference } mm is no more than the zero offset area, { $limit } mm: nothing is corrected.
evaluate-tool-geometry = Difference { $difference } mm is corrected: the geometry takes all of it, the wear is erased.
evaluate-tool-wear = Difference { $difference } mm is corrected in the wear.
evaluate-compensation-make = The table of this make of probe (_TP_CF = { $make }) is inside of the control and in no manual: nothing is taken off here. A table of your own in _MT_EC_R and _MT_EC_L, with _MT_COMP = 2, is.
evaluate-compensation = The table { $table } takes { $amount } mm off the measured value.
evaluate-screen = The control shows the measuring result screen until the cycle ends.
evaluate-screen-stays = The control shows the measuring result screen until the next measuring cycle is called; the program goes on.
evaluate-screen-halt = The control shows the measuring result screen. Programmed stop (M0): the operator continues with NC START.
# What a call does with data of the machine before it measures.
check-erases = _CBIT[13]=1: this call first sets _TP[], _TPW[], _WP[], _KB[], _EV[], _MV[] and the bit itself to 0.
check-erases-hint = Set _CBIT[13] to 0 before the call, or calibrate every probe again.
check-converts = { $bit } does not agree with the basic system of the machine (MD10240): this call first converts { $data } { $value ->
        [1] from inch to mm
       *[other] from mm to inch
    }.
check-converts-hint = Where the data are right as they are, set { $bit } to { $value } before the call.
evaluate-erased = _CBIT[13]=1: _TP[], _TPW[], _WP[], _KB[], _EV[], _MV[] and the bit itself are now 0.
evaluate-converted = { $bit } did not agree with the basic system of the machine: { $data } are converted { $value ->
        [1] from inch to mm
       *[other] from mm to inch
    }, and the bit is { $value } now.
