# Help pages of the cycles at a tool probe.

help-tool-in-use = The tool is in use and its D number is active; plane and G40 are programmed. Its lengths (for a calibration exactly, otherwise roughly) stand in the tool data.
help-tool-not-turned = No rotation of the coordinate system is active; the sides of the probe lie along the axes.
help-tool-chip = A chip or coolant on edge or probe makes the tool seem longer.

help-cycle971-measures-side = Where one side of the tool probe lies, with a tool of known length and radius.
help-cycle971-measures-sides = Where all sides of the tool probe lie that _TP[k,7] names (workpiece-related: _TPW[k,7]), with a tool of known length and radius.
help-cycle971-measures-tool = Length L1 (_MA = 3, 103, 203) or radius (_MA = 1, 2) of a milling tool or drill.
help-cycle971-before-still = The spindle stands, with the edge turned towards the probe; the cycle does not turn it.
help-cycle971-before-rotating = Speed and feed stand in _CM[], with _CBIT[12]=1 in _MFS[]. A spindle that turns keeps its direction, one that stands takes that of _CM[5].
help-cycle971-before-clear = The tool stands on the side that it is to touch, clear of the probe: above it for a length, beside it for a radius.
help-cycle971-before-parallel = The tool axis is parallel to the centre line of the probe.
help-cycle971-before-over = From where the tool stands it can go up or down to _FA above the top of the probe, and there across to its middle.
help-cycle971-order-beside = Beside the probe: first to its middle in the other axis, then to the side, down by _TP[k,9] below the top, touch, back. It ends there, at depth.
help-cycle971-order-on-top = On top (_MA = 3, 103, 203): over the middle, down, touch; a tool wider than the probe stands off to the side of the start by its radius less _ID, in the abscissa (3, 103) or ordinate (203), a drill never. It ends _FA above.
help-cycle971-order-centre-first = With _MA = 102 or 201 the middle in the other axis is found by two touches before.
help-cycle971-order-widest = For a radius the tool goes lower by _ID, so that its widest place touches.
help-cycle971-order-turning = It touches one to three times, each time slower (_CM[6], _CM[7]); the last touch counts. A spindle that stood stops again.
help-cycle971-order-all-sides = The top over the nominal middle, both sides of the ordinate to find its middle, there both sides of the abscissa, both sides of the ordinate through the middle found, and the top once more. It ends _FA above that.
help-cycle971-wrong-depth = _TP[k,9] is 0: beside the probe the tool does not reach down to it, alarm 61349.
help-cycle971-wrong-unclear = Where the tool stands does not tell which side it is to touch: alarm 61332.
help-cycle971-wrong-edge = The edge is not turned to the probe: the radius comes out too small, and so does the length of a tool whose edges differ in height.
help-cycle971-wrong-master = The calibration tool is not known exactly: its error goes into every tool that is measured later.
help-cycle971-wrong-no-data = Length or radius of the tool is 0: alarm 61351.
help-cycle971-wrong-direction = _CM[5] is neither 3 nor 4: alarm 61366.

help-cycle972-measures-side = Where one side of the tool probe lies, with a calibration tool of cutting edge position 3.
help-cycle972-measures-length = One length of a turning tool: L2 in the abscissa, L1 in the ordinate.
help-cycle972-order-travel = In the other axis to the middle of the probe, then to the side, touch, back. It ends _FA before the side.
help-cycle972-order-nose = The middle of the nose stands before the middle of the probe; the side on which the tool starts is touched.
help-cycle972-order-tip = The edge touches from the side to which it points, according to its cutting edge position.

help-cycle982-measures-side = Where one side of the lathe's tool probe lies, with a calibration tool of cutting edge position 3 whose lengths and nose radius are known.
help-cycle982-measures-one-length = One length of a turning tool, milling tool or drill: L2 with _MA=1, L1 with _MA=2.
help-cycle982-measures-radius = The radius of a milling tool; the length in the axis in which it lies has to be known.
help-cycle982-measures-both = The radius of a milling tool and the length along the same axis.
help-cycle982-measures-all = All that the tool in use has: both lengths of a turning tool (one with cutting edge position 5 to 8), both lengths and radius of a milling tool, the length of a drill.
help-cycle982-measures-upper = Lengths and radius of a milling tool at its upper edge, towards the shank, as with a groove cutter.
help-cycle982-before-outside = The tool stands outside of the probe in both axes of the plane, on the side that it is to touch; the Y axis stands over the middle of the probe.
help-cycle982-before-setting = For milling tools and drills SD42950 is 2.
help-cycle982-before-axial = A milling tool or drill lies axially: its axis along the abscissa, the radius in the ordinate.
help-cycle982-before-radial = A milling tool or drill lies radially: its axis along the ordinate, the radius in the abscissa.
help-cycle982-order-calibrate = In the other axis the middle of the nose goes to the middle of the probe, then to the side, touch, back. It ends _FA before the side.
help-cycle982-order-spindle = A milling spindle that stands is turned to _STA1 first, unless _CHBIT[20]=1.
help-cycle982-order-reversal = Each point is touched twice, the second time with the spindle turned by 180° and _CORA: the mean of both edges counts.
help-cycle982-order-length = In the other axis to the middle of the probe, then with the tip to the side, touch, back. It ends _FA before the side.
help-cycle982-order-radius = The side of the cutter touches, in the axis in which the radius lies.
help-cycle982-order-both = The side of the cutter touches the side of the probe where it starts; then it goes round the probe and touches the opposite one. Without reversal the standing spindle turns by 180° for that, so that the same edge touches.
help-cycle982-order-all = First in the abscissa, then in the ordinate, round the probe; each side of a milling tool is touched with its edge turned there. It ends at the start.
help-cycle982-order-upper-behind = It goes round the probe on the side turned away from the start, touches the length from there, then both sides. It ends at the start.
help-cycle982-order-upper-across = It crosses the probe first, touches the length back towards the start, then both sides. It ends at the start.
help-cycle982-corrects-geometry = The tool in use: the value goes into the geometry and the wear is set to 0, whatever it was before.
help-cycle982-wrong-axis = The radius does not lie in _MA: alarm 61325.
help-cycle982-wrong-drill-radius = The tool is a drill, which has no radius to measure: alarm 61314.
help-cycle982-wrong-fast = The milling spindle turns fast while the tool touches: edge and probe are damaged. Let it turn slowly.
help-cycle982-wrong-wrong-side = The start is on the wrong side, or over the probe: alarm 61332.
help-cycle982-wrong-nose = Nose radius or lengths of the calibration tool are wrong: their error goes into every tool that is measured later.

help-tool-probe-known = The sides of the probe are known roughly: the trigger values in _TP (workpiece-related: _TPW).
help-tool-block = One touch: to _FA before the side, from there over at most twice _FA, back after the signal. With _NMSP above 1 it is repeated and the mean counts.
help-tool-reach = Tool data or probe data are wrong by more than _FA: nothing switches (61301), or the tool touches on its way (61302).
help-tool-trigger = The data of the probe: the trigger value in _TP (workpiece-related: _TPW), if it differs from the stored one by more than _TZL. Beyond _TSA: alarm 61303, nothing is stored.
help-tool-data = The tool in use: geometry, with the wear set to 0; with _CHBIT[3]=1 the wear alone. A difference up to _TZL corrects nothing, from _TDIF on it is message 62306 and no correction, from _TSA on alarm 61303.
help-tool-in-front = The tool already stands before the side to be touched, no further than twice _FA; nothing need be known of the probe.
help-tool-from-here = It touches from where it stands over at most twice _FA and goes back to the start; nothing else moves.
help-tool-trigger-always = The data of the probe: the trigger value in _TP (workpiece-related: _TPW) is stored whatever it was before.
help-tool-unwatched = No limit watches the result: touching something else than the probe is stored like the probe.
