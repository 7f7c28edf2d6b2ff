# Help pages of the cycles at a tool probe.

help-tool-in-use = The tool and its D number are active; the plane and G40 are programmed. The tool lengths are in the tool data: exact for calibration, otherwise approximate.
help-tool-not-turned = No coordinate rotation is active; the sides of the probe are parallel to the axes.
help-tool-parallel = The sides of the probe are parallel to the machine axes.
help-tool-chip = A chip or coolant on the cutting edge or the probe: the probe switches too early, the result is wrong.

help-cycle971-measures-side = The position of one side of the tool probe, with a tool of known length and radius.
help-cycle971-measures-sides = The positions of all sides of the tool probe specified in _TP[k,7] (workpiece-related: _TPW[k,7]), with a tool of known length and radius.
help-cycle971-measures-tool = Length L1 (_MA = 3, 103, 203) of a milling tool or drill, or radius (_MA = 1, 2) of a milling tool.
help-cycle971-before-still = The spindle is stationary, with the cutting edge pointing at the probe; the cycle does not rotate it.
help-cycle971-before-rotating = The cycle calculates speed and feed from _CM[], or uses those in _MFS[] with _CBIT[12]=1. A rotating spindle keeps its direction, a stationary spindle uses that of _CM[5].
help-cycle971-before-clear = The tool is clear of the probe on the side to be touched: above it with _MA = 3, 103, 203, otherwise beside it.
help-cycle971-before-parallel = The tool axis is parallel to the centre line of the probe.
help-cycle971-before-over = From its position the tool can move up or down to _FA above the top of the probe, and then across to the middle of the probe.
help-cycle971-order-beside = Beside the probe: first to its middle in the other axis, then to the side, down to _TP[k,9] or _TPW[k,9] below the top, touch, back. End position: at this depth.
help-cycle971-order-on-top = On top (_MA = 3, 103, 203): over the middle, down, touch; end _FA above. Tools wider than the probe: offset towards the start by radius − _ID, abscissa (3, 103), ordinate (203); not drills.
help-cycle971-order-centre-first = With _MA = 102 or 201, two touches first determine the middle in the other axis.
help-cycle971-order-widest = For a radius, the tool moves lower by _ID, so that its largest diameter touches.
help-cycle971-order-turning = The tool touches one to three times, as specified by _CM[6] and _CM[7], or _MFS[] with _CBIT[12]=1; the last touch is used. If the spindle was stationary before, it stops again.
help-cycle971-order-all-sides = If all sides are permitted: top, both ordinate sides (giving the middle), both abscissa sides there, both ordinate sides at the abscissa middle found, top again. End _FA above it.
help-cycle971-wrong-depth = _TP[k,9] (workpiece-related: _TPW[k,9]) is 0: beside the probe, the tool goes no lower than the upper edge of the probe; when a radius is measured, alarm 61349.
help-cycle971-wrong-unclear = The tool position does not show which side to touch: alarm 61332.
help-cycle971-wrong-edge = The cutting edge does not point at the probe: the measured radius is too small, as is the length of a tool with cutting edges of different height.
help-cycle971-wrong-master = The size of the calibration tool is not exact: its error carries over to every tool measured later.
help-cycle971-wrong-no-data = Length or radius of the tool is 0: alarm 61351.
help-cycle971-wrong-direction = The spindle is stationary and _CM[5] is neither 3 nor 4: alarm 61366.

help-cycle972-measures-side = The position of one side of the tool probe, with a calibration tool of cutting edge position 3.
help-cycle972-measures-length = One length of a turning tool: L2 in the abscissa, L1 in the ordinate.
help-cycle972-order-travel = In the other axis to the middle of the probe, then to the side, touch, back. End position: _FA from this side.
help-cycle972-order-nose = The middle of the nose is at the middle of the probe; the cycle touches the side on which the tool starts.
help-cycle972-order-tip = The cutting edge touches in the direction in which it points, according to its cutting edge position.

help-cycle982-measures-side = The position of one side of the tool probe, with a calibration tool of cutting edge position 3 whose lengths and nose radius are known.
help-cycle982-measures-one-length = One length of a turning tool, milling tool or drill: L2 with _MA=1, L1 with _MA=2; of a drill with SD 42950 = 0 always L1.
help-cycle982-measures-radius = The radius of a milling tool; the length in the axis of the radius must be known.
help-cycle982-measures-both = The radius of a milling tool and the length along the same axis.
help-cycle982-measures-all = Turning tool: both lengths, only one at cutting edge position 5 to 8. Milling tool: both lengths and radius (lengths only if the radius is entered as 0). Drill: its length.
help-cycle982-measures-upper = Lengths and radius of a milling tool at its upper cutting edge, towards the shank, as with a groove cutter.
help-cycle982-before-outside = The tool is outside the probe in both axes of the plane, on the side to be touched; the Y axis is at the middle of the probe.
help-cycle982-before-setting = For milling tools and drills SD 42950 is 2; for one length of a drill in G17 or G19 it can also be 0.
help-cycle982-before-axial = A milling tool or drill is in axial position: its axis along the abscissa, the radius in the ordinate.
help-cycle982-before-radial = A milling tool or drill is in radial position: its axis along the ordinate, the radius in the abscissa.
help-cycle982-order-calibrate = In the other axis, the middle of the nose moves to the middle of the probe, then to the side, touch, back. End position: _FA from this side.
help-cycle982-order-spindle = With a milling tool or drill, a stationary milling spindle is positioned to _STA1 first, unless _CHBIT[20]=1.
help-cycle982-order-reversal = Each point is touched twice, the second time with the spindle rotated by 180° plus _CORA: the mean value of both cutting edges is used.
help-cycle982-order-length = In the other axis to the middle of the probe, to the side, touch with the tip (a milling tool or drill across its axis with its side), back. End position: _FA from this side.
help-cycle982-order-radius = The side of the milling tool touches, in the axis of the radius.
help-cycle982-order-both = The milling tool touches the probe on the start side, moves around it and touches the opposite side. Without reversal a stationary spindle first rotates by 180°: the same edge touches.
help-cycle982-order-all = First in the abscissa, then in the ordinate, around the probe, a drill only along its axis; without reversal, a stationary spindle turns the same edge to each side. End: the start position.
help-cycle982-order-upper-behind = The tool moves around the probe on the side away from the start, touches it there for the length, and touches both sides; the abscissa is measured first. End position: the start position.
help-cycle982-order-upper-across = The tool first crosses the probe, touches it back towards the start for the length, and touches both sides; the abscissa is measured first. End position: the start position.
help-cycle982-corrects-geometry = The active tool: the value is written to the geometry and the wear is reset to 0, whatever its previous value.
help-cycle982-wrong-axis = The radius is not in the axis _MA: alarm 61325.
help-cycle982-wrong-drill-radius = The tool is a drill, whose radius the cycle does not measure: alarm 61314.
help-cycle982-wrong-fast = The milling spindle rotates fast while the tool touches: cutting edge and probe are damaged. Reduce the speed.
help-cycle982-wrong-wrong-side = The start position is on the wrong side, or between two sides of the probe: alarm 61332.
help-cycle982-wrong-nose = Nose radius or lengths of the calibration tool are wrong: their error carries over to every tool measured later.

help-tool-probe-known = For calibration, the trigger points in _TP (workpiece-related: _TPW) contain the approximate positions of the probe sides; for measuring a tool, the probe is calibrated.
help-tool-block = One touch: to _FA before the side, from there over at most twice _FA, back after the signal. If _NMSP is above 1, the touch is repeated and the mean value is used.
help-tool-reach = Tool data or probe data are wrong by more than _FA: the probe does not switch (alarm 61301), or the tool touches on its path (61302).
help-tool-trigger = The probe data: the trigger point in _TP (workpiece-related: _TPW), if it differs by more than _TZL from the stored one. Above _TSA: alarm 61303, nothing is stored.
help-tool-data = The active tool: geometry, with wear reset to 0; with _CHBIT[3]=1 only wear. No correction up to _TZL, from _TDIF message 62306 and no correction, from _TSA alarm 61303.
help-tool-in-front = The tool is already in front of the side to be touched, at most twice _FA away. Calibration needs no probe data; for measuring a tool, this side is calibrated.
help-tool-from-here = The tool touches from its position over at most twice _FA and moves back to the start position; nothing else moves.
help-tool-trigger-always = The probe data: the trigger point in _TP (workpiece-related: _TPW) is stored, whatever its previous value.
help-tool-unwatched = No limit monitors the result: if the tool touches something other than the probe, the wrong value is stored.
