# CYCLE972: titles, search words, variants.

cycle972-title = Tool probe in turning: calibrate, measure turning tools
cycle972-help = Measures length L1 or L2 of a turning tool with cutting edge position 1 to 8 at a tool probe whose sides lie along the axes of the machine, or calibrates one side of this probe with a tool of cutting edge position 3 whose lengths and nose radius are known. The tool in use stands on the side of the probe that it will touch, a calibration tool that measures in plus direction clear of it by its diameter too; no rotation is active. The cycle travels in the other axis until the nose stands before the centre of the probe, then in the measuring axis to _FA before the side, touches over twice the measuring path and goes back; it ends _FA before the touched side. Calibrating stores the trigger value in _TP; measuring corrects the length of the tool in use: geometry with the wear set to 0, or the wear alone with _CHBIT[3]=1. What goes wrong most often: the approximate data of the probe are missing or its sides exchanged, the start position is on the wrong side, cutting edge position or nose radius in the tool data are wrong, or the probe was calibrated under other conditions. CYCLE982 does the same and more, and is preferred by the manual.
cycle972-words = measure tool setter tool setting preset lathe turning tool probe cube calibrate calibration length L1 L2 insert nose tip cutting edge position wear geometry trigger point

cycle972-calibrate = Calibrate the tool probe
cycle972-calibrate-words = calibrate tool probe lathe turning trigger point machine _TP calibration tool side
cycle972-measure = Measure a turning tool
cycle972-measure-words = measure turning tool lathe length L1 L2 insert wear geometry machine
