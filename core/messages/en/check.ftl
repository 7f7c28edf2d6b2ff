# What is wrong with the values of a call, and the cure (-hint). Lengths in mm unless they are values as typed.

check-missing = { $param } is missing.
check-delivered = { $param } is not given; the delivered value { $value }{ $unit } counts.
check-not-a-number = “{ $value }” is not a number.
check-not-a-number-hint = Write digits with a point or a comma, for example 12.5.
check-expression = “{ $value }” is known only when the program runs; it is not checked here.
check-too-large = { $value } is beyond every machine.
check-too-large-hint = Check the number and its exponent.
check-not-whole = { $value } is not a whole number.
check-not-whole-hint = Write it without decimals.
check-text-long = The text is longer than { $most } characters.
check-text-long-hint = Shorten the name to what the control keeps.
check-text-characters = The text holds quotation marks or control characters.
check-text-characters-hint = Use the plain name.
check-range = { $param } cannot be { $value }{ $unit }.
check-range-choice-hint = Choose one of { $choices }.
check-range-both-hint = Enter a value from { $min } to { $max }{ $unit }.
check-range-from-hint = Enter { $min }{ $unit } or more.
check-range-above-hint = Enter more than { $min }{ $unit }.
check-range-below-hint = Enter { $max }{ $unit } or less.
check-unusual = { $value }{ $unit } is unusual for { $param }.
check-unusual-hint = Usual is { $min } to { $max }{ $unit }.
check-variant = { $cycle } has no measuring variant { $value }.
check-variant-pair = “{ $one }: { $first }” and “{ $other }: { $second }” do not go together: { $cycle } has no measuring variant { $value }.
check-variant-hint = Choose the variant from the list.
check-variant-near-hint = Variants close to it: { $near }. Not every combination of digits is one.

check-knum-zero = { $code } names no zero offset.
check-knum-zero-hint = 1 to 99 is G54 and following, 1000, 1011 to 1026 and 1051 to 1066 are basic frames, 2000 is the system frame, 9999 the active frame, 0 corrects nothing.
check-knum-is-tool-hint = This is the code of a tool offset. Choose the variant with tool offset, or name a frame.
check-knum-is-zero-hint = This is the code of a zero offset. Choose the variant with zero offset, or name a D number.
check-knum-digit-4 = The 4th digit of { $code } (6th with five-digit D numbers) does not exist.
check-knum-digit-5 = The 5th digit of { $code } (7th with five-digit D numbers) does not exist.
check-knum-digit-6 = The 6th digit of { $code } (8th with five-digit D numbers) does not exist.
check-knum-digit-7 = The 7th digit of { $code } (9th with five-digit D numbers) or one above it does not exist.
check-knum-edge-none = { $code } names no D number.
check-knum-edge-large = The D number in { $code } is larger than { $largest }, the largest of this control.
check-knum-seven-digits-hint = From the right: three digits D number, then 0 or 1 length, 2 radius; then 1 inverts; then 1 to 3 L1 to L3, 4 radius; then 0 to 3 kind of offset.
check-knum-nine-digits-hint = From the right: five digits D number, then 0 or 1 length, 2 radius; then 1 inverts; then 1 to 3 L1 to L3, 4 radius; then 0 to 3 kind of offset.

check-probe-number = There is no probe number { $number }.
check-probe-number-hint = Choose a number from 1 to { $fields }.
check-probe-type = The third digit of the probe number cannot be { $type }.
check-probe-type-hint = 0 is a multi probe, 1 a mono or bidirectional probe.
check-cora-off = The offset angle has no effect.
check-cora-off-hint = Set _CBIT[8]=1, or enter 0.
check-empirical-memory = There is no empirical value memory { $number }; the array holds { $size }.
check-mean-memory = There is no mean value memory { $number }; the array holds { $size }.
check-memory-hint = Choose a smaller number, or enlarge the array and { $array }.
check-mean-off = No mean value is kept from one part to the next.
check-mean-off-hint = Set _CHBIT[4]=1 if it should be kept.
check-tolerance-order = The upper tolerance { $upper } mm is below the lower one, { $lower } mm.
check-tolerance-order-hint = Exchange _TUL and _TLL, or check their signs.
check-band-difference = Half of the tolerance band, { $small } mm, is wider than _TDIF, { $large } mm: a part within tolerance would be taken for wrong.
check-zero-mean = _TZL, { $small } mm, is larger than _TMV, { $large } mm: the mean value never corrects.
check-difference-safe = _TDIF, { $small } mm, is larger than _TSA, { $large } mm: the program stops before _TDIF can act.
check-bands-hint = Keep the order _TZL, _TMV, half of the tolerance band, _TDIF, _TSA.
check-rotation = The coordinate system is turned.
check-rotation-hint = Switch the rotation off before the call: this cycle works along the axes of the machine.
check-infeed = The infeed { $infeed } mm does not lead down to the element.
check-infeed-hint = Enter a negative value if the tool axis points up.

check-ball = A ball of { $ball } mm does not fit in.
check-ball-hint = Check the setpoint, or take a smaller probe.
check-path-long = The measuring path would begin in the opposite wall: the ball has only { $free } mm of way.
check-path-long-hint = Choose _FA below { $free } mm.
check-zone-wide = The protection zone { $zone } mm is not smaller than the element, { $size } mm.
check-zone-wide-hint = Choose a zone smaller than { $limit } mm, so that the ball fits beside it.
check-zone-narrow = The protection zone { $zone } mm is not larger than the element, { $size } mm.
check-zone-narrow-hint = Choose a zone larger than { $limit } mm, so that the ball fits beside the element.
check-zone-ball = Between element and protection zone there is no room for a ball of { $ball } mm.
check-zone-shortens = The protection zone shortens the measuring path to { $free } mm.
check-zone-shortens-hint = The part may deviate by no more than that; otherwise make the zone leave more room.
check-differential-mono = Differential measurement turns the spindle; a mono probe measures in one direction only.
check-differential-mono-hint = Take a multi probe, or a variant without differential measurement.
check-differential-axis = Differential measurement works only in the plane.
check-differential-axis-hint = Choose axis 1 or 2.
check-mono-spindle = A mono probe is turned before every touch, and this spindle cannot be positioned.
check-mono-spindle-hint = Take a multi probe.
check-differential-spindle = Differential measurement turns the spindle, and this spindle cannot be positioned.
check-differential-spindle-hint = Take a variant without differential measurement, with a calibrated probe.
check-knum-no-additive = This machine has no additive offsets.
check-knum-no-additive-hint = Correct length or radius instead, or have MD 18080 bit 8 set.
check-target-not-offered = { $param } = { $value } is not among the targets that the forms of this machine offer.
check-target-not-offered-hint = Choose a settable zero offset or the last basic frame, or set { $entry } to 1 in the machine data.
check-knum-no-setup = This machine has no setup offsets.
check-knum-no-setup-hint = Correct length or radius instead, or have MD 18112 bit 4 set.

check-knum-rotation = The global basic frame { $code } cannot take a rotation.
check-knum-rotation-hint = Choose a settable frame or a channel basic frame.
check-lathe-length = The probe is entered as a turning tool, and its length ends at the circumference of the ball (_CBIT[14]=1).
check-lathe-length-hint = Set _CBIT[14]=0 and let the length end at the centre of the ball.
check-mirror-datum = An axis is mirrored, and MD10610 is not 0: the measuring cycles are made for mirroring with MD10610=0 only.
check-mirror-datum-hint = Measure without mirroring, or set MD10610=0.
check-multi-probe = This measurement needs a multi probe; a mono probe switches in one direction only.
check-multi-probe-hint = Take a multi probe: { "_PRNUM" } of two digits.
check-angles-sum = Starting angle and all steps together make { $sum }°, more than 360°.
check-angles-sum-hint = Choose a smaller indexing angle, or a starting angle nearer to 0 with its sign.
check-angles-same = With this indexing angle points fall upon each other; no circle can be found.
check-angles-same-hint = Choose 120° or less for three points, 90° or less for four.
check-angles-wide = With { $points } points an indexing angle above { $useful }° is of no use.
check-angles-wide-hint = Choose { $useful }° or less.
check-ball-unknown = The ball diameter of this probe is not known; every size would be wrong by it.
check-ball-unknown-hint = Calibrate the probe in a hole with determination of the ball diameter.
check-spread-circle = The points lie so close together that the diameter is { $diameter } times and the centre { $centre } times as uncertain as one point.
check-spread-centre = The points lie so close together that the centre is { $centre } times as uncertain as one point.
check-spread-circle-hint = Spread the points over more of the circle.
check-spread-corner = The corner is { $factor } times as uncertain as one point: the points lie far from it or close together, or the edges meet at a small angle.
check-spread-corner-hint = Take points further apart and nearer to the corner.
check-spread-angle = The points lie so close together that the direction is { $factor } times as uncertain as one point after { $length } mm.
check-spread-angle-hint = Take points { $needed } mm or more apart.
check-spread-triangle = The three points lie nearly on one line: { $length } mm beside it the frame is { $factor } times as uncertain as one point.
check-spread-triangle-hint = Move one of them further from the line through the others.
