# CYCLE972: titles, search words, variants.

cycle972-title = Turning: calibrate tool probe, measure tools
cycle972-help = Measures L1 or L2 of a turning tool (cutting edge position 1 to 8) at a tool probe parallel to the axes, or calibrates a side with a known tool of position 3. Prefer CYCLE982.
cycle972-words = measure tool setter tool setting preset lathe turning tool probe cube calibrate calibration length L1 L2 insert nose tip cutting edge position wear geometry trigger point

cycle972-calibrate = Calibrate the tool probe
cycle972-calibrate-words = lathe turning trigger point machine _TP calibration side
cycle972-measure = Measure a turning tool
cycle972-measure-words = lathe length L1 L2 insert wear geometry machine
