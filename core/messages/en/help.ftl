# Help pages: what all or most SINUMERIK cycles have in common, and the headings.

help-section-measures = What it measures
help-section-does = What it does
help-section-before = Start position of the probe
help-section-before-tool = Start position of the tool
help-section-before-call = Conditions before the call
help-section-order = Sequence
help-section-corrects = What it corrects
help-section-leaves = What it returns
help-section-wrong = What can go wrong
help-values = Inputs: { $names }.
help-alarms = Possible alarms: { $names }.

help-probe-loaded = The probe is in the spindle (tool type 710 or 1x0) and its D number is active; G40 is programmed, no scale factor is active.
help-probe-turning = On a turning machine with a third linear axis: type 5xy, length to the ball centre, SD 42950 is 2. Cutting edge position 5 or 7 measures in G17, 6 or 8 in G19. X as radius, also with DIAMON.
help-wrong-tool = _TNUM, or the D number in _KNUM, is not that of the tool that cut this surface: a good tool gets a wrong offset.
help-wrong-chip = A chip or burr on the surface falsifies the size: clean the surface, and set _TDIF so that such a value is not corrected.
help-wrong-conditions = The probe was calibrated at another feed or spindle position: the results have a constant error. In another plane: the same error, or an alarm with _CBIT[16]=1.
help-wrong-kept = A parameter not written by this call still has the value of an earlier call: a limit, a protection zone or an angle.
help-order-block = One touch: to _FA before the setpoint position, then at the measuring feed for at most twice _FA, back after the signal. With _NMSP above 1 the touch is repeated and the mean value applies.
help-ends-at-start = End position: the start position.
help-wrong-reach = The surface is more than _FA behind its setpoint position: the probe does not switch, alarm 61301.
help-wrong-in-the-way = There is an obstacle in the path: with _CHBIT[2]=1, a touch during positioning raises alarm 61302.
help-corrects-tool = A tool (_TNUM, _TNAME or _TENV): its wear, with _CHBIT[6]=1 its geometry. _KNUM selects edge, length or radius, or a setup or additive offset instead. _KNUM=0 corrects nothing.
help-corrects-chain = Above _TSA: alarm 61303, program stop. Above _TDIF: message 62306, no correction. Outside _TUL, _TLL or _TMV: whole deviation. Within _TMV: mean value weighted by _K, if above _TZL.
help-corrects-zero = The zero offset in _KNUM, by actual value minus setpoint; its rotation is unchanged. Target: fine offset if available, with _CHBIT[21]=1 or _KNUM=2000 coarse offset. _KNUM=0: no correction.
help-corrects-zero-area = Deviation above _TSA: alarm 61303, the program stops, no correction.
help-corrects-when = The correction applies when the G function (G54 …) is programmed again; only with _KNUM=9999 does it apply immediately.
help-corrects-trigger = The probe data: if a trigger point differs by more than _TZL from the value in _WP, the cycle stores it. Above _TSA: alarm 61303, nothing is stored.
help-wrong-first = First calibration: the stored values are 0, so _TSA must be larger than the ball radius.
help-wrong-later = Feed, plane, spindle position or, in milling cycles, _CBIT[14] differ in later measurements: the stored values do not apply there.
help-calibrated = The probe is calibrated in this plane and in the directions of this measurement, at the same feed.
help-uncalibrated = The probe need not be calibrated; it switches in all directions, the spindle can be positioned, and the measuring axis is in the plane.
help-turned-over = The first point is touched with the spindle rotated by 180°, then in the original spindle position. The mean value is used, so the skew cancels.
help-turned-over-stored = The cycle also stores in _WP the skew, and the trigger point of this direction including the skew. They apply to this spindle position only.
help-no-spindle = The spindle cannot be positioned: alarm 61372.

# Where a form is on the control.
where-title = Where is this on my control?
where-from = This form is there from measuring cycles SW { $version }.
where-editor = Program editor: { $softkeys } (measuring cycles from SW 6.2).
where-older = Program editor: { $softkeys } (measuring cycles up to SW 5.4). The support writes { $call }().
where-older-call = Program editor, measuring cycles up to SW 5.4: the support writes { $call }(). The manual does not print its softkeys.
where-jog-newer = In JOG, measuring cycles from SW 6.3: { $softkeys }.
where-jog-older = In JOG, measuring cycles up to SW 6.2: { $softkeys }.
where-jog-both = In JOG: { $softkeys }.
where-jog-needs = If the softkeys are missing: they need HMI Advanced (PCU 50) or MMC 103, the option “Inter-modal actions” and, in MA_JOG.COM, their lines without semicolons.
where-jog-files = Files of softkeys and masks from SW 6.3: COM_FILE.COM, and MC_CST0.ARC or MC_CST1.ARC.
where-jog-files-older = Files of softkeys and masks up to SW 6.2: MA_JOG.COM, JOG_MEAS.COM and BMP_FILE.ARC.
where-jog-settings = The mask has no settings screen. What it proposes and how it moves is in user data: _JM_I[] and _JM_B[] in GUD6, E_MESS_… in GUD7.
where-jog-settings-tool = The mask has no settings screen. The tool probe and how it is approached are in E_MESS_MT_… (GUD7), where the result goes in _JM_B[0] (GUD6).
where-settings = Start-up > Measuring cycles > Automatic measuring sets what the masks offer (_MZ_MASK). If the softkeys are missing, see the steps of commissioning.
where-files = Files of the masks on HMI Advanced: MCSUPP.COM, AEDITOR.COM, STARTUP.COM.
where-files-older = Files up to SW 5.4: MCSUPP_1.COM and MCSUPP_2.COM with COV.COM (softkeys), SC.COM (masks) and the auxiliary cycles.
where-none-replaced = From SW 6.2 there is no mask. Use the mask for tool measurement on lathes, or write the call.
where-none-log = There is no mask. Write the call into the program; the log itself is set in its user data.
where-none-helper = There is no mask. Write the call into the program.
where-none-block = There is no mask. Write the block into the program, or enter it in MDI.
