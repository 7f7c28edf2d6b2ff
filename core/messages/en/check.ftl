# What is wrong with the values of a call, and the cure (-hint). Lengths in mm unless they are values as typed.

check-missing = { $param } is missing.
check-delivered = { $param } is not set: the default { $value }{ $unit } applies.
check-not-a-number = “{ $value }” is not a number.
check-not-a-number-hint = Enter a number with a decimal point or comma, for example 12.5.
check-expression = “{ $value }” is known only when the program runs, so it is not checked.
check-no-value = { $name } has no value here, so the call is not simulated.
check-no-value-hint = Assign { $name } before the call, or set it in the setup.
check-too-large = { $value } is out of range for any machine.
check-too-large-hint = Check the number and its exponent.
check-not-whole = { $value } is not a whole number.
check-not-whole-hint = Enter the value without decimals.
check-text-long = The text is longer than { $most } characters.
check-text-long-hint = Shorten the text to this length.
check-text-characters = The text contains quotation marks or control characters.
check-text-characters-hint = Enter the text without quotation marks and control characters.
check-range = { $param } cannot be { $value }{ $unit }.
check-range-choice-hint = Permitted: { $choices }.
check-range-both-hint = Enter a value from { $min } to { $max }{ $unit }.
check-range-from-hint = Enter at least { $min }{ $unit }.
check-range-above-hint = Enter a value above { $min }{ $unit }.
check-range-below-hint = Enter a value below { $max }{ $unit }.
check-unusual = { $value }{ $unit } is unusual for { $param }.
check-unusual-hint = Usual range: { $min } to { $max }{ $unit }.
check-variant = { $cycle } has no measuring variant { $value }.
check-variant-pair = “{ $one }: { $first }” and “{ $other }: { $second }” cannot be combined: { $cycle } has no measuring variant { $value }.
check-variant-hint = Choose the variant from the list.
check-variant-near-hint = Closest variants: { $near }. Not every combination of digits is a variant.

check-knum-zero = { $code } is not the code of a zero offset.
check-knum-zero-hint = Permitted: 0 (none), 1 to 99 (G54 …), 1000, 1011 to 1026, 1051 to 1066 (basic), 2000 (system), 9999 (active).
check-knum-no-system = This machine has no system frame $P_SETFR, which { $code } specifies.
check-knum-no-system-hint = Choose another frame, or set bit 0 of MD 28082.
check-knum-is-tool-hint = This is the code of a tool offset. Enter the code of a frame, or choose a variant with tool offset, if any.
check-knum-is-zero-hint = This is the code of a zero offset. Enter a permitted D number, or choose a variant with zero offset, if any.
check-knum-digit-4 = The 4th digit from the right of { $code } (6th with five-digit D numbers) is not permitted.
check-knum-digit-5 = The 5th digit from the right of { $code } (7th with five-digit D numbers) is not permitted.
check-knum-digit-6 = The 6th digit from the right of { $code } (8th with five-digit D numbers) is not permitted.
check-knum-digit-7 = The 7th digit from the right of { $code } (9th with five-digit D numbers) or a higher one is not permitted.
check-knum-edge-none = { $code } contains no D number.
check-knum-edge-large = The D number in { $code } exceeds { $largest }, the maximum of this control.
check-knum-seven-digits-hint = From the right: 3 digits D. 0, 1: length, 2: radius. 1: inverted. 1 to 3: L1 to L3, 4: radius. 0 to 3: type.
check-knum-nine-digits-hint = From the right: 5 digits D. 0, 1: length, 2: radius. 1: inverted. 1 to 3: L1 to L3, 4: radius. 0 to 3: type.

check-probe-number = Probe number { $number } does not exist.
check-probe-number-hint = Enter a number from 1 to { $fields }.
check-probe-type = The 3rd digit from the right of the probe number cannot be { $type }.
check-probe-type-hint = Enter 0 for a multi probe, or 1 for a mono or bidirectional probe.
check-cora-off = The offset angle has no effect: _CBIT[8] is 0.
check-cora-off-hint = Set _CBIT[8]=1, or enter 0 for the offset angle.
check-empirical-memory = Empirical value memory { $number } does not exist: the size of the array is { $size }.
check-mean-memory = Mean value memory { $number } does not exist: the size of the array is { $size }.
check-memory-hint = Enter a smaller number, or enlarge the array and increase { $array }.
check-mean-off = No mean value is stored from part to part: _CHBIT[4] is 0.
check-mean-off-hint = Set _CHBIT[4]=1 to store the mean value.
check-tolerance-order = The upper tolerance, { $upper } mm, is below the lower tolerance, { $lower } mm.
check-tolerance-order-hint = Swap _TUL and _TLL, or correct their signs.
check-band-difference = Half of the tolerance band, { $small } mm, is larger than _TDIF, { $large } mm: no correction for some good parts.
check-zero-mean = _TZL, { $small } mm, is larger than _TMV, { $large } mm: the cycle never corrects by the mean value.
check-difference-safe = _TDIF, { $small } mm, is larger than _TSA, { $large } mm: the program stops before _TDIF takes effect.
check-bands-hint = Keep this order, smallest first: _TZL, _TMV, half of the tolerance band, _TDIF, _TSA.
check-rotation = A coordinate rotation is active.
check-rotation-hint = Deselect the rotation before the call: this cycle measures parallel to the machine axes.
check-infeed = The infeed, { $infeed } mm, does not move the probe down to the element.
check-infeed-hint = Enter a negative value; if the probe body is on the minus side of the applicate, a positive one.

check-ball = The probe ball, { $ball } mm, does not fit inside.
check-ball-hint = Correct the size entered, or use a probe with a smaller ball.
check-path-long = The measuring path would start inside the opposite wall: the ball has only { $free } mm of travel.
check-path-long-hint = Reduce _FA below { $free } mm.
check-zone-wide = The protection zone, { $zone } mm, is not smaller than the element, { $size } mm.
check-zone-wide-hint = Reduce the protection zone below { $limit } mm, so that the ball fits beside it.
check-zone-none-hint = No protection zone fits inside: use a variant without protection zone, or a smaller ball.
check-zone-narrow = The protection zone, { $zone } mm, is not larger than the element, { $size } mm.
check-zone-narrow-hint = Increase the protection zone above { $limit } mm, so that the ball fits beside the element.
check-zone-ball = The probe ball, { $ball } mm, does not fit between element and protection zone.
check-zone-shortens = The protection zone shortens the measuring path to { $free } mm.
check-zone-shortens-hint = Change the protection zone to allow more travel, or accept this as the maximum deviation of the part.
check-differential-mono = Differential measurement rotates the spindle, but a mono probe measures in one direction only.
check-differential-mono-hint = Use a multi probe, or a variant without differential measurement.
check-differential-axis = Differential measurement is possible only in the plane.
check-differential-axis-hint = Set the measuring axis to 1 or 2.
check-mono-spindle = The cycle rotates a mono probe before every touch, but this spindle cannot be positioned.
check-mono-spindle-hint = Use a multi probe.
check-differential-spindle = Differential measurement rotates the spindle, but this spindle cannot be positioned.
check-differential-spindle-hint = Use a variant without differential measurement, and a calibrated probe.
check-knum-no-additive = This machine has no additive offsets.
check-knum-no-additive-hint = Correct length or radius instead, or set bit 8 of MD 18080.
check-target-not-offered = { $param } = { $value } is not among the targets offered by the forms of this machine.
check-target-not-offered-hint = Choose a settable zero offset or the last basic frame, for tools a D number; or set { $entry } in GUD6 to 1.
check-knum-no-setup = This machine has no setup offsets.
check-knum-no-setup-hint = Correct length or radius instead, or set bit 4 of MD 18112.

check-knum-rotation = The global basic frame { $code } cannot store a rotation.
check-knum-rotation-hint = Choose a settable frame or a channel basic frame.
check-lathe-length = The length of a probe of type 5xy ends at the ball centre, but _CBIT[14]=1 means the ball circumference.
check-lathe-length-hint = Set _CBIT[14]=0 and enter the length to the centre of the ball.
check-mirror-datum = An axis is mirrored and MD 10610 is not 0: measuring cycles support mirroring only with MD 10610=0.
check-mirror-datum-hint = Measure without mirroring, or set MD 10610=0.
check-multi-probe = This measurement needs a multi probe: a mono probe switches in one direction only.
check-multi-probe-hint = Use a multi probe: { "_PRNUM" } with two digits.
check-angles-sum = Starting angle plus all indexing angles, without their signs, is { $sum }°, more than 360°.
check-angles-sum-hint = Reduce the indexing angle, or enter a starting angle nearer to 0, with its sign.
check-angles-same = With this indexing angle, points coincide: no circle can be calculated.
check-angles-same-hint = Enter 120° or less for three points, 90° or less for four, but not 0.
check-angles-wide = With { $points } points, an indexing angle above { $useful }° is not useful.
check-angles-wide-hint = Enter { $useful }° or less.
check-ball-unknown = The ball diameter of this probe is not known, so every measured size would be off by it.
check-ball-unknown-hint = Calibrate the probe in a hole and determine the ball diameter.
check-spread-circle = Points too close together: the diameter is { $diameter } times and the centre { $centre } times as uncertain as one point.
check-spread-centre = The points are so close together that the centre is { $centre } times as uncertain as one point.
check-spread-circle-hint = Spread the points over a larger part of the circle.
check-spread-corner = The corner is { $factor } times as uncertain as one point: points far away or close together, or a small angle.
check-spread-corner-hint = Move the points further apart and nearer to the corner.
check-spread-angle = Points too close together: { $length } mm away, the direction is { $factor } times as uncertain as one point.
check-spread-angle-hint = Place the points at least { $needed } mm apart.
check-spread-triangle = The points are almost collinear: { $length } mm from the line, the frame is { $factor } times as uncertain as one point.
check-spread-triangle-hint = Move one point further from the line through the other two.
check-braking = With { $name } = { $feed }{ $unit } the axis moves { $path } mm after the signal; the probe takes { $deflection } mm.
check-braking-hint = Set { $name } to { $largest }{ $unit } at most.
