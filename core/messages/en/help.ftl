# Help pages: what all or most SINUMERIK cycles have in common, and the headings.

help-section-measures = What it measures
help-section-does = What it does
help-section-before = Where the probe stands before
help-section-before-tool = Where the tool stands before
help-section-before-call = What must be so before
help-section-order = What happens in order
help-section-corrects = What it corrects
help-section-leaves = What it leaves
help-section-wrong = What goes wrong
help-values = To be given: { $names }.
help-alarms = Alarms that can come: { $names }.

help-probe-loaded = The probe is in the spindle (tool type 710 or 1x0), its D number is active; G40 is programmed, no scale factor is.
help-probe-turning = On a turning machine with a third linear axis its type is 5xy and its length ends at the centre of the ball; SD42950 is 2. Cutting edge position 5 or 7 measures in G17, 6 or 8 in G19. Positions in X are radii, with DIAMON too.
help-wrong-tool = _TNUM or the D number in _KNUM is not that of the tool which cut this surface: a good tool is spoiled.
help-wrong-chip = A chip or burr on the surface falsifies the size: clean it, and set _TDIF so that such a value is not corrected.
help-wrong-conditions = The probe was calibrated with another feed, plane or spindle position, so every result is off by the same amount.
help-wrong-kept = A parameter that this call does not write still has its value from an earlier call: a limit, a zone, an angle.
help-order-block = One touch: to _FA before the set position, from there at the measuring feed over at most twice _FA, back after the signal. With _NMSP above 1 it is repeated and the mean counts.
help-ends-at-start = It ends at the start.
help-wrong-reach = The surface lies further than _FA from its set position: nothing switches, alarm 61301.
help-wrong-in-the-way = Something stands in the way: a touch while positioning is alarm 61302.
help-corrects-tool = A tool: _TNUM or _TNAME says which, _KNUM which edge and length or radius. The correction goes into the wear, with _CHBIT[6]=1 into the geometry. _KNUM=0 corrects nothing.
help-corrects-chain = Deviation beyond _TSA: alarm 61303, the program stops. Beyond _TDIF: message 62306, no correction. Beyond _TUL, _TLL or _TMV: the whole deviation. Within _TMV: the mean value weighted by _K, once it is larger than _TZL.
help-corrects-zero = A zero offset, named by _KNUM: it is moved by actual minus set value, so that the place measured gets its set coordinates; its rotation stays. The fine offset takes it where the machine has one, with _CHBIT[21]=1 the coarse one. _KNUM=0 corrects nothing.
help-corrects-zero-area = A deviation beyond _TSA is alarm 61303: the program stops, nothing is corrected.
help-corrects-when = It counts when its G function (G54 …) is programmed again; only with _KNUM=9999 it counts at once.
help-corrects-trigger = The data of the probe: a trigger value in _WP that differs from the stored one by more than _TZL is renewed. Beyond _TSA: alarm 61303, nothing is stored.
help-wrong-first = The first calibration: the stored values are 0, so _TSA has to be larger than the ball radius.
help-wrong-later = Feed, plane, spindle position or _CBIT[14] are not those of the later measurements: what is stored does not hold there.
help-calibrated = The probe is calibrated in this plane and in the directions of this measurement, at the same feed.
help-uncalibrated = The probe need not be calibrated; it switches all round, the spindle can be positioned, and _MA lies in the plane.
help-turned-over = The first point is touched with the spindle turned by 180°, then as it stood. The mean counts, so the skew cancels.
help-turned-over-stored = The skew, and the trigger value of this direction with the skew in it, are stored in _WP, too. They hold for the spindle as it stands.
help-no-spindle = The spindle cannot be positioned: alarm 61372.
