# Concepts, explained for somebody who is new to measuring cycles.

concept-group-basics = Basics

concept-measuring-cycles = Measuring cycles
concept-measuring-cycles-1 = A measuring cycle is a ready subroutine that measures with a touch probe. You set its parameters, call it, and it makes all motions itself.
concept-measuring-cycles-2 = There are two kinds: workpiece measurement, where the probe moves to the part, and tool measurement, where the tool moves to the probe.
concept-measuring-cycles-3 = _MVAR selects what the cycle measures and what it corrects. Setpoint, measuring axis and limits are further parameters.
concept-measuring-cycles-4 = The results are in _OVR (setpoints, actual values, differences) and _OVI (numbers of cycle, probe and alarm). If you want, the cycle also writes them into a tool offset or a zero offset.
concept-measuring-cycles-5 = Usual mistake: a parameter of an earlier call is still set. Set every parameter of the task before each call.

concept-workpiece-measurement = Workpiece measurement
concept-workpiece-measurement-1 = The probe is in the spindle or the turret and moves to the clamped part like a tool. Its D number must be active.
concept-workpiece-measurement-2 = You measure where the part is before machining, and which size it has after machining, without unclamping it.
concept-workpiece-measurement-3 = _KNUM selects the correction target: a D number of the tool _TNUM, or a zero offset. With _KNUM=0 the cycle only measures.
concept-workpiece-measurement-4 = _TNUM is the tool that machined the surface, not the probe. The cycle corrects it so that the next part gets the right size.
concept-workpiece-measurement-5 = Usual mistake: chips or coolant on the surface. The cycle measures them too; clean the part before it measures.

concept-tool-measurement = Tool measurement
concept-tool-measurement-1 = The tool moves to a tool probe. The probe is fixed in the machine, or it is swung into the working area.
concept-tool-measurement-2 = The cycle writes the measured length or radius into the offset of the active tool. With _CHBIT[3]=0 it writes the geometry and sets the wear to 0, with _CHBIT[3]=1 it writes the wear.
concept-tool-measurement-3 = The place of the probe is stored in _TP in machine coordinates, in _TPW in workpiece coordinates. _PRNUM selects the probe.
concept-tool-measurement-4 = The new value is accepted only if the difference is above _TZL and below _TDIF. A broken tool is found in this way.
concept-tool-measurement-5 = Usual mistake: the first length in the offset is only roughly right. If the difference reaches _TDIF, the cycle corrects nothing: raise _TDIF and _TSA for a new tool.

concept-prerequisites = Prerequisites for calling
concept-prerequisites-1 = Before a cycle may run, machine, data and program must be ready. Most first failures come from one of these points.
concept-prerequisites-2 = Machine: axes as in DIN 66217, machine data adapted, reference points approached.
concept-prerequisites-3 = Data: GUD5 and GUD6 are active, for measuring in JOG also GUD7. The cycles are in the directory of the standard cycles.
concept-prerequisites-4 = Program: G40 is active, all parameters are set, and the call is not deeper than the 5th program level.
concept-prerequisites-5 = Start position: the probe reaches it on a straight line without collision.
concept-prerequisites-6 = Units: the program may use other units than the basic system if the technology data can be switched: G70 or G700 on a metric control, G71 or G710 on an inch control.
concept-prerequisites-7 = Usual mistake: tool radius compensation is still active. Program G40 before the call.

concept-skip-and-simulation = Dry run, program test, block search, simulation
concept-skip-and-simulation-1 = In some modes the control runs the program but skips the measuring cycles. Nothing is then measured and nothing is corrected.
concept-skip-and-simulation-2 = Skipped are dry run and program test, and block search unless $A_PROTO=1. Up to SW 6.2 every simulation skips the cycles too.
concept-skip-and-simulation-3 = After SW 6.2 the simulation of HMI Advanced runs the cycles; _MC_SIMSIM=0 skips them. _MC_SIMDIFF makes every simulated touch deviate by a value.
concept-skip-and-simulation-4 = Jobshop products simulate the measurement, but they write no offset, show no results, do not monitor for collision and write no log.
concept-skip-and-simulation-5 = Usual mistake: _MC_SIMDIFF is larger than the limits of the call. The simulation then stops with the alarms of the cycle.

concept-group-coordinates = Coordinate systems and planes

concept-coordinate-systems = Machine and workpiece coordinate system
concept-coordinate-systems-1 = The machine coordinate system (MCS) starts at the machine zero M. Its actual value is the position of the tool reference point F.
concept-coordinate-systems-2 = The workpiece coordinate system (WCS) starts at the workpiece zero W. Its actual value is the position of the tool tip, with a probe usually of the ball centre.
concept-coordinate-systems-3 = Workpieces are measured in the WCS, as the drawing is dimensioned. Tools are easier to measure in the MCS, because the tool probe is fixed there.
concept-coordinate-systems-4 = Each of the two systems can be set to inch or metric on its own. _TP holds the tool probe in the MCS, _TPW in the WCS.
concept-coordinate-systems-5 = Usual mistake: the probe is calibrated in the WCS, and the zero offset is changed afterwards. The stored trigger points of a tool probe in _TPW then no longer fit.

concept-bcs = Basic coordinate system
concept-bcs-1 = The basic coordinate system (BCS) lies between machine and workpiece coordinate system. The zero offsets build on it.
concept-bcs-2 = It differs from the MCS only while a kinematic transformation is active, for example TRANSMIT, TRACYL or the 5-axis transformation.
concept-bcs-3 = The descriptions of the cycles assume that no transformation is active. MCS and BCS are then the same.
concept-bcs-4 = Usual mistake: a transformation is still on when a tool probe is calibrated or used. Calibrate and measure in the same state.

concept-frames = Zero offset and frame
concept-frames-1 = A zero offset is the position of the workpiece zero W in the MCS. Together with rotation, mirroring and scale it is called a frame.
concept-frames-2 = Basic, system, settable (G54) and programmable frames form a chain. Only the whole chain gives the WCS in which the cycle measures.
concept-frames-3 = _KNUM selects the frame that is corrected: 1 to 4 are G54 to G57, 5 to 99 are G505 to G599, 9999 is the active frame.
concept-frames-4 = Only 9999 takes effect at once. With every other number program G54 or the like after the cycle, so that the new values apply.
concept-frames-5 = A scale factor must not be active: alarm 61310. Rotation and mirroring are possible only in some cycles.
concept-frames-6 = Usual mistake: the cycle corrects G55 while the program works in G54. The correction is there, but it has no effect.

concept-planes = Planes, abscissa, ordinate, applicate
concept-planes-1 = The plane decides which axis is which. Abscissa and ordinate are the 1st and 2nd axis of the plane, the applicate is perpendicular to it.
concept-planes-2 = G17: abscissa X, ordinate Y, applicate Z. G18: Z, X, Y. G19: Y, Z, X.
concept-planes-3 = _MA counts in this order: 1 is the abscissa, 2 the ordinate, 3 the applicate. With _MA=1 a cycle measures X in G17, but Z in G18.
concept-planes-4 = Lathes work in G18; G17 and G19 are for milling on a lathe. A diameter in X is therefore _MA=2.
concept-planes-5 = Usual mistake: the wrong plane is active. The cycle then moves another axis than you expect, and the tool length acts in another axis.

concept-tool-lengths = Tool lengths by plane and type
concept-tool-lengths-1 = A tool has up to three lengths. Plane and tool type decide in which axis each length acts.
concept-tool-lengths-2 = Mills, drills and probes (types 1xy, 2xy, 710): L1 acts in the applicate, L2 in the ordinate, L3 in the abscissa. In G17 that is Z, Y, X, in G18 Y, X, Z, in G19 X, Z, Y.
concept-tool-lengths-3 = L2 and L3 are used in special cases only, for example with an angle head.
concept-tool-lengths-4 = Turning tools (type 5xy) in G18: L1 acts in X (ordinate), L2 in Z (abscissa).
concept-tool-lengths-5 = On lathes, drills and mills usually work with SD 42950 = 2: their lengths then act as those of turning tools.
concept-tool-lengths-6 = Usual mistake: SD 42950 differs between machining and measuring. The measured length is then written into the wrong length of the tool.

concept-milling-on-lathe = Milling on a lathe
concept-milling-on-lathe-1 = A lathe with a driven tool can mill. Without a Y axis it does so through TRANSMIT on the face, or TRACYL on the circumference.
concept-milling-on-lathe-2 = The cycles support transformations in principle. How far is said in the description of each cycle.
concept-milling-on-lathe-3 = The workpiece cycles for milling also run on a lathe with a 3rd geometry axis. The probe is then type 5xy with cutting edge position 5 to 8, and SD 42950 is 2.
concept-milling-on-lathe-4 = With cutting edge position 5 or 7 the probe measures in G17, with 6 or 8 in G19.
concept-milling-on-lathe-5 = Usual mistake: G18 of turning is still active when the milling cycle is called. Program plane and D number before the call.

concept-group-probes = Probes

concept-probe-types = Probe types: multi, bidirectional, mono
concept-probe-types-1 = A touch probe changes its signal when the ball is deflected. The signal must not bounce, and it must stay as long as the ball is deflected; a pulse is not enough.
concept-probe-types-2 = A multi probe switches in all directions, a bidirectional probe in two opposite directions, a mono probe in one only.
concept-probe-types-3 = For workpiece measurement the hundreds digit of _PRNUM gives the type: 0 is multi, 1 is mono or bidirectional. _PRNUM=102 is a mono probe with the second data set, _WP[1,…].
concept-probe-types-4 = Workpiece measurement treats a bidirectional probe as a mono probe. Both take longer, because the cycle turns the spindle several times.
concept-probe-types-5 = Usual mistake: a mono probe for tight tolerances. Mono and bidirectional probes suit low accuracy only.

concept-probe-assignment = Which probe for which task
concept-probe-assignment-1 = Not every type of probe suits every machine. The task decides in how many directions the probe has to switch.
concept-probe-assignment-2 = A multi probe is possible everywhere: tools and workpieces on a lathe, workpieces on a mill.
concept-probe-assignment-3 = A bidirectional probe measures workpieces on lathes and on mills, a mono probe workpieces on mills only.
concept-probe-assignment-4 = _PRNUM must match the probe that is really there. A few variants, for example differential measurement, take a multi probe only.
concept-probe-assignment-5 = Usual mistake: _PRNUM says multi, but the probe switches in one direction only. It then touches without a signal and may be damaged.

concept-mono-probe = Mono probe
concept-mono-probe-1 = A mono probe switches in one direction only. The cycle turns the spindle so that this direction points at the surface.
concept-mono-probe-2 = The spindle must be able to position (SPOS), and the signal must get through at every angle, all 360°.
concept-mono-probe-3 = Align the probe in the spindle so that at 0° it measures in +X in G17, in +Z in G18, in +Y in G19.
concept-mono-probe-4 = If it cannot be aligned exactly, _CORA is the angle by which the cycle corrects the spindle position. It acts only with _CBIT[8]=1.
concept-mono-probe-5 = Usual mistake: _CORA is entered, but _CBIT[8] is 0. The probe then touches beside its switching direction, and the value scatters.

concept-signal-transmission = Signal transmission
concept-signal-transmission-1 = The signal of the probe travels from the spindle to a receiver at the machine column: by radio, by infrared or through a cable.
concept-signal-transmission-2 = With some types it gets through only in certain spindle positions or ranges. Ask the maker of the probe or of the machine.
concept-signal-transmission-3 = The cycles turn the spindle for mono probes, for reversal and, with _CHBIT[13]=1, with a rotated coordinate system. The signal has to get through there too.
concept-signal-transmission-4 = Usual mistake: the probe works by hand, but not inside a deep part. Without a signal the axis moves to the end of the measuring block, then comes alarm 61301.

concept-group-tools = Probes and calibration tools as tools

concept-workpiece-probe-mill = Workpiece probe on mills
concept-workpiece-probe-mill-1 = The probe is a tool with T and D number. Its type is 710 (3D probe, from SW 4) or 1xy.
concept-workpiece-probe-mill-2 = Enter length 1 (DP3) and the ball radius (DP6), the basic length (DP21) only if needed. Wear and all other values are 0.
concept-workpiece-probe-mill-3 = _CBIT[14] says where length 1 ends: 0 at the ball centre, 1 at the end of the ball. The length you enter must fit this setting.
concept-workpiece-probe-mill-4 = The exact switching behaviour is not in the tool data but in _WP. Calibration writes it there.
concept-workpiece-probe-mill-5 = Usual mistake: L1 and _CBIT[14] do not match. The length is then wrong by the ball radius: 3 mm with a ball of 6 mm.

concept-workpiece-probe-turn = Workpiece probe on lathes
concept-workpiece-probe-turn-1 = On a lathe the probe is a turning tool, type 5xy, with cutting edge position (SL) 5 to 8.
concept-workpiece-probe-turn-2 = The position says where the ball points. Both lengths go to the centre of the ball, while those of a turning tool go to its tip.
concept-workpiece-probe-turn-3 = Enter length 1, length 2 and the ball radius. Wear and all other values are 0; basic lengths only if needed.
concept-workpiece-probe-turn-4 = In the grooves for SL 7 and SL 8 the probe is calibrated with CYCLE973. The result is stored in _WP.
concept-workpiece-probe-turn-5 = Usual mistake: lengths measured to the edge of the ball, as with a turning tool. Every position is then off by the ball radius before calibration.

concept-calibration-tool-mill = Calibration tool for tool probes, mills
concept-calibration-tool-mill-1 = To calibrate a tool probe you need a tool whose size is known exactly, usually a cylindrical pin.
concept-calibration-tool-mill-2 = It is entered as type 1xy with length 1 and radius, wear and all other values 0. Measuring in JOG uses type 120.
concept-calibration-tool-mill-3 = CYCLE971 touches the probe with it and stores the trigger points in _TP or _TPW.
concept-calibration-tool-mill-4 = Usual mistake: the length of the pin is not exact. An error of 0.01 mm in its length makes every tool measured later wrong by 0.01 mm.

concept-calibration-tool-turn = Calibration tool for tool probes, lathes
concept-calibration-tool-turn-1 = On a lathe the calibration tool is treated as a turning tool: type 5xy, cutting edge position 3.
concept-calibration-tool-turn-2 = Length 1, length 2 and radius are known exactly. Wear and all other values are 0.
concept-calibration-tool-turn-3 = Its lengths go to the circumference of the ball, not to the centre. With the workpiece probe they go to the centre.
concept-calibration-tool-turn-4 = CYCLE982 calibrates the tool probe with it and stores the trigger points in _TP or _TPW.
concept-calibration-tool-turn-5 = Usual mistake: lengths to the centre of the ball. Every trigger point, and every tool measured later, is then wrong by the ball radius.

concept-group-calibration = Calibration

concept-calibration = Calibration
concept-calibration-1 = A probe does not switch exactly where it touches. Calibration finds out where it does, on a body of known size, and the cycles take it into account.
concept-calibration-2 = For a workpiece probe it yields trigger points, skew and active ball diameter, stored in _WP; for a tool probe trigger points, stored in _TP or _TPW.
concept-calibration-3 = By default there is room for the data of 3 probes, 99 are possible. _PRNUM selects the data.
concept-calibration-4 = Calibrate and measure at the same feed and under the same conditions. The delay of the signal then cancels out.
concept-calibration-5 = Calibrate before the first use, and again after a new stylus, a collision, a new feed or a new clamping of the probe.
concept-calibration-6 = Usual mistake: at the first calibration the data in _WP are still 0. _TSA must then be larger than the ball radius, else alarm 61303 stops the cycle.

concept-calibration-bodies = Calibration bodies
concept-calibration-bodies-1 = A calibration body has a known place or size. The probe touches it, and the difference shows how the probe switches.
concept-calibration-bodies-2 = On a mill CYCLE976 uses a hole or ring gauge of known diameter, or a surface of true form with low roughness. No special gauging block is needed.
concept-calibration-bodies-3 = On a lathe CYCLE973 usually works in reference grooves fixed in the machine, or on a known surface. Place and size of the grooves are in _KB.
concept-calibration-bodies-4 = _CALNUM selects the pair of grooves; by default there are 3 sets. A tool probe is calibrated with a calibration tool instead.
concept-calibration-bodies-5 = Usual mistake: the size entered is not the true one. Half of an error in the ring diameter goes into each trigger point: 0.01 mm for an error of 0.02 mm.

concept-tool-probe-data = Tool probe data before calibration
concept-tool-probe-data-1 = In automatic mode the cycle moves to the tool probe by itself. To find it, it needs approximate trigger points in _TP or _TPW before the first calibration.
concept-tool-probe-data-2 = _TP holds the data in the MCS, _TPW in the WCS (from SW 6.3). Measure the place of the probe by hand and enter it.
concept-tool-probe-data-3 = A face that is touched in minus direction lies on the plus side of the probe. Its value must be larger than that of the opposite face.
concept-tool-probe-data-4 = On a mill also enter the edge length or the upper disc diameter in _TP[k,6], the shape (cube or disc) in _TP[k,8] and the calibration depth in _TP[k,9].
concept-tool-probe-data-5 = Usual mistake: a trigger point is still 0. The cycle then positions the tool at a wrong place; run it with low override first.

concept-positional-deviation = Positional deviation (skew)
concept-positional-deviation-1 = The ball of a probe is never exactly on the spindle axis. The distance is called positional deviation or skew.
concept-positional-deviation-2 = Calibration stores it in _WP[k,7] for the abscissa and _WP[k,8] for the ordinate: ball centre minus spindle axis. The cycles compensate for it.
concept-positional-deviation-3 = Without compensation a skew of 0.02 mm shifts a measured position by up to 0.02 mm. With a multi probe it cancels out in a width, because both sides shift alike.
concept-positional-deviation-4 = A multi probe is most accurate when the same point of the ball touches as in calibration. With _CHBIT[13]=1 the spindle follows a rotation of the plane, _CHBIT[14] sets the direction.
concept-positional-deviation-5 = Usual mistake: the probe is changed into the spindle at another angle than in calibration. Position the spindle before the call, always in the same way.

concept-group-principle = Measuring principle

concept-on-the-fly = On-the-fly measurement
concept-on-the-fly-1 = The control stores the position at the instant the probe switches, while the axis is still moving. This is called on-the-fly measurement.
concept-on-the-fly-2 = The signal is processed in the NC itself. The delay is short, so a higher measuring feed is possible for the same accuracy.
concept-on-the-fly-3 = What the axis travels while it brakes does not matter for the value. It only deflects the probe further.
concept-on-the-fly-4 = Usual mistake: judging the result by the place where the axis stops. The value that counts is in _OVR.

concept-probe-inputs = Probe inputs
concept-probe-inputs-1 = The control has two inputs for touch probes on its I/O interface. Often one is for the workpiece probe, the other for the tool probe.
concept-probe-inputs-2 = _CHBIT[0] selects the input for workpiece measurement, _CHBIT[1] the input for tool measurement: 0 is input 1, 1 is input 2.
concept-probe-inputs-3 = To test them, deflect the probe by hand and watch the PLC status: DB10 DBX107.0 for input 1, DB10 DBX107.1 for input 2.
concept-probe-inputs-4 = If the bit is 1 at rest, the polarity in MD 13200 is wrong.
concept-probe-inputs-5 = Usual mistake: the bit is set for the other input. The probe touches, the cycle sees nothing, and alarm 61301 follows.

concept-measuring-sequence = Measuring block, step by step
concept-measuring-sequence-1 = Every touch runs in the same way. The cycle calculates a start position that lies _FA in front of the setpoint, and moves there with G0 or G1.
concept-measuring-sequence-2 = From there it moves at measuring feed _VMS, at most twice _FA: up to the setpoint and the same distance past it.
concept-measuring-sequence-3 = When the probe switches, the control stores the position, stops the axis and deletes the distance-to-go. The axis returns to the start position.
concept-measuring-sequence-4 = If the probe does not switch, the cycle tries up to five times, with _CHBIT[15]=1 once, and then outputs alarm 61301. Repetitions begin at the start position.
concept-measuring-sequence-5 = Example: with a setpoint of 50 mm, measured in plus direction, and _FA=2 the touch is expected between 48 mm and 52 mm.
concept-measuring-sequence-6 = Usual mistake: the part lies further away than _FA from its setpoint. Then the probe finds nothing, or it touches on the way to the start position.

concept-measuring-path = Measuring path _FA
concept-measuring-path-1 = _FA is the distance from the start of the measuring block to the setpoint. The block ends the same distance past it.
concept-measuring-path-2 = The default is 2: the probe searches over 4 mm in all. _FA is also the distance at which a cycle moves around the part or the tool probe.
concept-measuring-path-3 = _FA is always in mm, in inch systems too. For 0.1 inch enter 0.1 · 25.4 = 2.54.
concept-measuring-path-4 = A large _FA finds a part that lies far off, but it costs time and room. With _VMS=0 it also raises the measuring feed from 150 mm/min to 300 mm/min if it is above 1.
concept-measuring-path-5 = Usual mistake: _FA in inch. _FA=0.1 is then 0.1 mm, and the probe does not reach the part. Only CYCLE971 takes negative values.

concept-measuring-feed = Measuring feed _VMS
concept-measuring-feed-1 = _VMS is the feed at which the probe touches. It decides how far the probe is deflected, and how exact the value is.
concept-measuring-feed-2 = With _VMS=0 the cycle chooses: 150 mm/min with _FA=1, 300 mm/min with _FA above 1. In an inch basic system these are 5.9055 inch/min and 11.811 inch/min.
concept-measuring-feed-3 = A value above 0 is used as it is. The highest safe feed follows from the braking of the axis, the permitted deflection of the probe and the delay of the signal.
concept-measuring-feed-4 = With _CHBIT[17]=1 and _FA above 1 the cycle touches twice: first fast with _SPEED[3], then 2 mm back and again with _VMS.
concept-measuring-feed-5 = Usual mistake: measuring at another feed than calibrating. The trigger points then no longer fit; use one value for both.

concept-deceleration = Braking path (deceleration path)
concept-deceleration-1 = After the probe has switched, the axis moves on for a moment. The probe must be able to be deflected by this path, else it is damaged.
concept-deceleration-2 = Three parts add up: the path until the command to brake, the path while braking, and the following error.
concept-deceleration-3 = They follow from feed, IPO cycle (MD 10050 times MD 10070), acceleration (MD 32300) and servo gain (MD 32200). Take the lowest values of the axes that take part.
concept-deceleration-4 = Example with 300 mm/min, 16 ms, 1 m/s² and a servo gain of 1: 0.08 mm + 0.0125 mm + 0.3 mm = 0.3925 mm. At 6000 mm/min it is 12.6 mm.
concept-deceleration-5 = On the same axis a probe that permits 1 mm of deflection allows at most 730 mm/min. A higher feed needs more deflection or a higher servo gain.
concept-deceleration-6 = Usual mistake: only _VMS is checked. _SPEED[1], _SPEED[2] and, with _CHBIT[17]=1, _SPEED[3] are faster, and the axis has to stop from there too.

concept-accuracy = Measuring accuracy
concept-accuracy-1 = A measurement is never better than machine and probe repeat. The resolution of the measuring systems is a limit too.
concept-accuracy-2 = The control itself repeats to ±1 µm when measuring on the fly.
concept-accuracy-3 = Between contact and stored value the axis travels on. At 300 mm/min it moves 0.005 mm in 1 ms, at 150 mm/min half of that: a lower feed lessens the error.
concept-accuracy-4 = Calibration at the same feed removes the constant part. What remains is scatter; ten touches at one place show how large it is.
concept-accuracy-5 = Tools measured with a rotating spindle deviate further. _MT_COMP selects the compensation in CYCLE971: by the cycle or by your own tables.
concept-accuracy-6 = Usual mistake: limits tighter than the scatter. The cycle then corrects accidents; _TZL should be as large as the largest accidental deviation.

concept-group-strategy = Measuring strategy

concept-deviation-kinds = Three kinds of deviation
concept-deviation-kinds-1 = The difference that a cycle measures has several causes. Three kinds are treated differently.
concept-deviation-kinds-2 = Without trend: always the same, for example between the probe and the inspection room. The empirical value _EV takes it out.
concept-deviation-kinds-3 = With trend: growing from part to part, for example by wear or heat. Only this part should become a tool offset; the mean value _MV follows it.
concept-deviation-kinds-4 = Accidental: different each time, for example by dirt or coolant. The weighting factor _K keeps its influence small.
concept-deviation-kinds-5 = Usual mistake: _K=1 corrects every difference above _TZL in full. The tool then follows the accidents, and the sizes scatter more than before.

concept-mean-value = Mean value
concept-mean-value-1 = The mean value collects the differences of a series of parts. It follows a trend and smooths what is accidental.
concept-mean-value-2 = After each part: new mean = old mean − (old mean − difference)/_K. The memory _MV starts at 0.
concept-mean-value-3 = Example with _K=3 and _TZL=0.04: differences of 0.03 mm, 0.05 mm and 0.06 mm give means of 0.010 mm, 0.023 mm and 0.036 mm, so nothing is corrected yet. With _K=2 the third mean is 0.046 mm and is corrected.
concept-mean-value-4 = As soon as the mean exceeds _TZL, it becomes the tool offset, and the memory is cleared. A large _K is slow and calm, a small one quick and nervous.
concept-mean-value-5 = It acts only in workpiece measurement with tool offset. It lasts from part to part only with _CHBIT[4]=1 and a memory number in _EVNUM.
concept-mean-value-6 = Usual mistake: two features share one memory number. Give each measured size a number of its own in _EVNUM.

concept-empirical-value = Empirical value
concept-empirical-value-1 = An empirical value is a known, constant deviation of one measurement. The cycle takes it out before it checks any limit.
concept-empirical-value-2 = You need it when the probe and the inspection room always differ by the same amount, for example because the part is clamped or warm.
concept-empirical-value-3 = The values are in _EV. _EVNUM=11 takes _EV[10], _EVNUM=0 none; with _EVNUM=90012 it is _EV[11] and the mean value _MV[8].
concept-empirical-value-4 = With _CHBIT[5]=0 it is subtracted, with 1 added. Example: the probe says 20.010 mm, the inspection room 20.004 mm: enter 0.006 with _CHBIT[5]=0.
concept-empirical-value-5 = It acts in workpiece measurement with tool offset, in the measurement of a single point with zero offset, and in tool measurement.
concept-empirical-value-6 = Usual mistake: the wrong sign. The deviation then doubles instead of disappearing; check with one part before the series.

concept-tolerance-bands = Tolerance chain
concept-tolerance-bands-1 = The difference between actual value and setpoint falls into a band. Each band has its own reaction, from nothing to an alarm.
concept-tolerance-bands-2 = The limits must grow: _TZL < _TMV < _TUL and _TLL (amounts) < _TDIF < _TSA. The whole chain acts in workpiece measurement with tool offset.
concept-tolerance-bands-3 = Up to _TMV the mean value works: it is corrected once it exceeds _TZL. Above _TMV the whole difference is corrected, and the mean is cleared.
concept-tolerance-bands-4 = Beyond _TUL or _TLL the part is oversize or undersize: message 62304 or 62305. The whole difference is corrected here too.
concept-tolerance-bands-5 = Above _TDIF nothing is corrected: message 62306, the tool may be worn or broken. Above _TSA alarm 61303 stops the program, because probe or setpoint is wrong.
concept-tolerance-bands-6 = Unequal tolerances are made symmetrical: _SETVAL=10, _TUL=0, _TLL=-0.004 give a setpoint of 9.998 in _OVR[0] with 0.002 and -0.002 in _OVR[8] and _OVR[12].
concept-tolerance-bands-7 = Usual mistake: _TLL without its sign. It is signed as on the drawing: for 0/-0.02 enter _TUL=0 and _TLL=-0.02.

concept-repetition = Multiple measurement and repetition
concept-repetition-1 = A cycle can touch a place more than once for three reasons: for a better mean, after a doubtful value, or because no signal came.
concept-repetition-2 = _NMSP is the number of touches at one place; the arithmetic mean counts. With _NMSP=3 the values 20.001, 20.003 and 20.002 give 20.002.
concept-repetition-3 = If a difference exceeds _TDIF or _TSA, the cycle measures again up to four times with _CBIT[0]=1. With _CBIT[1]=1 it stops before each repetition, so that you can clean the place.
concept-repetition-4 = If no signal comes, the cycle tries up to five times, with _CHBIT[15]=1 once. Then alarm 61301 stops it.
concept-repetition-5 = Usual mistake: a high _NMSP against a dirty surface. Every touch meets the same chip; the mean becomes steady, but not right.

concept-differential = Differential measurement
concept-differential-1 = The cycle touches the first point twice, once with the spindle turned by 180°. In the mean of both values the skew of the probe cancels out.
concept-differential-2 = In this way a probe can be used that has not been calibrated before.
concept-differential-3 = It needs a multi probe and a spindle that can be positioned with SPOS. A mono or bidirectional probe must always be calibrated.
concept-differential-4 = CYCLE978 measures differentially with a 1 in the thousands digit of _MVAR, CYCLE998 with _MVAR=1105.
concept-differential-5 = Usual mistake: the tool data of the probe are ignored. Length and ball radius still count, so enter them correctly.

concept-protection-zone = Protection zone
concept-protection-zone-1 = A protection zone keeps the probe away from an obstacle. Examples are a pin in the middle of a hole or a clamp beside a shaft.
concept-protection-zone-2 = In CYCLE977 a 1 in the thousands digit of _MVAR switches it on. _SZA is its size, for a rectangle _SZA in the abscissa and _SZO in the ordinate.
concept-protection-zone-3 = Inside, the probe lifts and crosses the zone from above. Outside, the zone is the free space that the probe must not leave, element included.
concept-protection-zone-4 = In CYCLE994 _SZA and _SZO are the borders from the workpiece zero, and the probe moves around them. Add the ball radius.
concept-protection-zone-5 = Usual mistake: the zone is as large as the element. Then no room is left for the ball, and alarm 61334 comes.

concept-collision-monitoring = Collision monitoring
concept-collision-monitoring-1 = Between the touches a cycle moves to intermediate positions. With _CHBIT[2]=1 it watches the signal of the probe on the way.
concept-collision-monitoring-2 = If the probe touches something there, the axes stop and alarm 61302 is output. Probe and part are usually saved.
concept-collision-monitoring-3 = The monitored moves run at _SPEED[1] in the plane and _SPEED[2] in the infeed axis, 1000 mm/min by default. Without monitoring _SPEED[0] applies, in percent of rapid traverse.
concept-collision-monitoring-4 = At 1000 mm/min an axis with 1 m/s², 16 ms and a servo gain of 1 needs 1.4 mm to stop. The probe must be able to be deflected that far.
concept-collision-monitoring-5 = Usual mistake: trusting it in your own blocks. It acts inside the cycle only; the way to the start position is yours.

concept-group-data = Parameters and data

concept-data-concept = Parameters and data
concept-data-concept-1 = The cycles take their input from variables and return their results in variables. These are global user data (GUD), stored in GUD5, GUD6 and, for JOG, GUD7.
concept-data-concept-2 = Mandatory parameters such as _SETVAL, _MA and _KNUM describe the task: set them before each call. Auxiliary parameters such as _VMS, _FA and _TSA are usually set once.
concept-data-concept-3 = Values come from the program, from the screen forms, or by hand in the operating area Parameters. Results are in _OVR and _OVI.
concept-data-concept-4 = GUDs are battery-backed and keep their values over power off. Local data (LUD) exist only while the cycle runs.
concept-data-concept-5 = Usual mistake: a value that another program left behind, for example _KNUM or _NMSP. What is not set keeps its last value.

concept-bits = Central bits and channel bits
concept-bits-1 = Bits are switches: they turn features of the cycles on and off. The machine manufacturer usually sets them once.
concept-bits-2 = _CBIT[] exists once in the NCK and applies to all channels. _CHBIT[] exists in each channel and applies there only.
concept-bits-3 = Examples: _CBIT[0]=1 repeats a doubtful measurement. _CHBIT[2]=1 switches collision monitoring on.
concept-bits-4 = A program may change them, and they keep the new state over power off. Set them back at the end of the program.
concept-bits-5 = Usual mistake: a _CBIT[] changed for one channel. Every other channel measures differently from that moment.

concept-units = Units of the parameters
concept-units-1 = A control has a basic system of units, and a program can switch to the other one. Not all parameters follow the switch.
concept-units-2 = In the active system of units: _SETVAL, _SETV, _ID, _CPA, _CPO, _SZA, _SZO, _TUL and _TLL. These come from the drawing.
concept-units-3 = In the basic system: all other parameters with a dimension, for example _TSA, _TDIF, _TZL and _VMS. _FA is always in mm.
concept-units-4 = Example: a metric control with G70 active. _SETVAL=1 is 1 inch, _TSA=1 is 1 mm, _FA=1 is 1 mm.
concept-units-5 = Usual mistake: all values in inch. _TSA=0.04 on a metric control is then only 0.04 mm, and alarm 61303 comes for a good part.

concept-group-modes = Operating modes

concept-measuring-jog = Measuring in JOG
concept-measuring-jog-1 = Measuring in JOG is semi-automatic and made for mills. You choose a task by softkey, fill in a screen form and press NC start.
concept-measuring-jog-2 = It sets up workpieces (edge, corner, pocket, hole, spigot, plane), calibrates probes and measures tools.
concept-measuring-jog-3 = You move the probe near the point with keys or handwheel. NC start then touches at E_MESS_FM over at most twice E_MESS_D_M, and the probe returns.
concept-measuring-jog-4 = The result goes into a zero offset or a tool offset. The settings are in _JM_I (numbers), _JM_B (switches) and the E_MESS data.
concept-measuring-jog-5 = Usual mistake: the probe is too far away, or the direction in the form points away from the part. Alarm 61301: press RESET, move closer, start again.

concept-group-tasks = Measuring tasks

concept-overview-milling = Tasks on mills
concept-overview-milling-1 = Calibrate first: CYCLE976 calibrates the workpiece probe, CYCLE971 the tool probe. CYCLE971 also measures length and radius of tools.
concept-overview-milling-2 = CYCLE978 measures one point of a surface. CYCLE977 measures hole, shaft, groove, web and rectangle parallel to the axes.
concept-overview-milling-3 = CYCLE979 measures hole, shaft, groove and web at an angle, circles from three or four points.
concept-overview-milling-4 = CYCLE998 measures the angle of a surface, in space too. CYCLE961 finds a corner, CYCLE997 one sphere or three.
concept-overview-milling-5 = CYCLE977, CYCLE978 and CYCLE979 correct a tool or a zero offset, the last three a zero offset only.
concept-overview-milling-6 = Usual mistake: CYCLE977 for a groove that is not parallel to an axis. The result is wider than the groove; use CYCLE979 or align the part first.

concept-overview-turning = Tasks on lathes
concept-overview-turning-1 = Calibrate first: CYCLE973 calibrates the workpiece probe in a reference groove or on a surface, CYCLE982 the tool probe.
concept-overview-turning-2 = CYCLE982 measures turning tools, drills and mills on the tool probe. CYCLE972 calibrates and measures turning tools only.
concept-overview-turning-3 = CYCLE974 measures one point: a diameter from one side, a face or a length. With reversal the spindle turns the part by 180°, and run-out cancels.
concept-overview-turning-4 = CYCLE994 measures a diameter at two opposite points. It goes around the part or through the bore to the other side.
concept-overview-turning-5 = Usual mistake: radius and diameter mixed up. With DIAMON the setpoint in X is a diameter, but _FA and the correction of a length are not.

# Live pictures: what is dragged, and what it comes to.
concept-drag-difference = Difference
concept-drag-feed = Measuring feed
concept-drag-offset = Zero offset G54 in X
concept-drag-plane = Plane (17, 18 or 19)
concept-told-systems = F from M (MCS): { $machine }. Ball centre from W (WCS): { $workpiece }. The zero offset moves W and the part: in the WCS the probe stays at the same value.
concept-told-lengths = { $plane }, types 1xy, 2xy, 710: L1 in { $first }, L2 in { $second }, L3 in { $third }. Beside it a turning tool (5xy) in G18: L1 in { $turning }, L2 in { $along }. F is the tool reference point.
concept-told-mean = { $count ->
        [0] With this weighting factor none of the ten parts leads to a correction.
        [one] One of the ten parts leads to a correction. The mean value then restarts at 0.
       *[other] { $count } of the ten parts lead to a correction. After each, the mean value restarts at 0.
    }
concept-told-latched = The stored value stays where the probe switched. The axis stops { $path } mm further on, and nobody reads that place.
concept-told-travel = In 1 ms the axis moves { $path } mm. The control itself repeats to ±0.001 mm (the band).
concept-told-units = Metric control, G70 active: _SETVAL={ $inches } is { $length } mm, _TSA=1 and _FA=1 are 1 mm each.
concept-told-empirical = The measured difference { $measured } mm counts as { $counts } mm.
concept-told-mono = { $beside ->
        [0] The probe touches in its switching direction.
       *[other] The probe touches { $beside }° beside its switching direction.
    }
concept-told-repeated = { $count ->
        [1] One touch, { $mean } µm beside the place, where the probe scatters by { $scatter } µm.
       *[other] The mean of { $count } touches is { $mean } µm beside the place. It scatters by { $scatter } µm, a single touch by { $single } µm.
    }

# Why a concept has no picture.
concept-still-conditions = No picture: these are conditions, and nothing moves.
concept-still-skipped = No picture: where a cycle is skipped, nothing moves.
concept-still-same = No picture: without a transformation it is the machine coordinate system.
concept-still-transformation = No picture: no part shows a transformation.
concept-still-table = No picture: this depends on the machine, not on a position.
concept-still-electrical = No picture: this is electrical, and nothing moves.
concept-still-memory = No picture: this is memory of the control.
