# Terms of the manuals and what they mean.

term-actual-set-difference = Actual/set difference
term-actual-set-difference-is = Measured value minus setpoint; in the formulas of the manuals it is D. The limits are compared with it, and the correction is calculated from it; an empirical value is already included.
term-additive-offset = Additive offset (DL)
term-additive-offset-is = Offset of a D number for one place of use of the tool, effective on top of geometry and wear; it relates to the setup offset as wear does to geometry. _KNUM selects it (7th digit: 1 or 3; with 5-digit D numbers the 9th), _DLNUM is its number; with _CHBIT[6]=0 and _CHBIT[8]=0 the cycle adds the correction to it.
term-asynchronous-subroutine = Asynchronous subroutine (ASUB)
term-asynchronous-subroutine-is = Program that an interrupt signal can start at any time, whatever the control is executing. Measuring in JOG runs as an ASUB: it needs the option “Inter-modal actions”, bit 0 of MD 11602, and interrupt number 9 (8 before PLC SW 6.1), which nothing else may use.
term-automatic-tool-offset = Automatic tool offset
term-automatic-tool-offset-is = The cycle itself writes the result into the offset of the tool _TNUM; _KNUM is the D number with the length or radius to be corrected, 0 measures only. The limits decide whether and how much is corrected; with _CHBIT[6]=0 it is the wear, with 1 the geometry.
term-basic-coordinate-system = Basic coordinate system (BCS)
term-basic-coordinate-system-is = Coordinate system between the machine and the workpiece coordinate system. It differs from the machine coordinate system only while a kinematic transformation is active, such as TRANSMIT, TRACYL or TRAORI.
term-blank-measurement = Blank measurement
term-blank-measurement-is = Workpiece measurement before machining: finds position and misalignment of the clamped blank and corrects the zero offset accordingly. The program then cuts in the right place although the blank is not clamped exactly.
term-calibrating-tool = Calibration tool
term-calibrating-tool-is = Tool of exactly known size, usually a cylindrical pin, with which the trigger points of a tool probe are found; on milling machines type 1xy (120 in JOG), on lathes type 5xy with cutting edge position 3 and lengths to the circumference of the ball. Its wear is 0; an error in its size carries over to every tool measured later.
term-calibration = Calibration
term-calibration-is = Finds where a probe switches and stores the result in its data: _WP for a workpiece probe, _TP or _TPW for a tool probe. Calibrate before the first use and after every change to the probe, at the feed, in the plane and at the spindle position of the later measurements.
term-collision-monitoring = Collision monitoring
term-collision-monitoring-is = With _CHBIT[2]=1 the cycle watches the probe signal while it positions: a touch stops the axes with alarm 61302. It then positions with _SPEED[1] and _SPEED[2], from which the axes must stop within the deflection of the probe; with _CHBIT[2]=0 nothing is watched.
term-cutting-edge-position = Cutting edge position (SL)
term-cutting-edge-position-is = Code for the direction in which the tool tip, or the ball of a workpiece probe, points. The measuring cycles measure turning tools with 1 to 8; a workpiece probe on a lathe has 5 to 8, a calibration tool 3.
term-data-blocks-for-measuring-cycles = Data blocks of the measuring cycles
term-data-blocks-for-measuring-cycles-is = Definition files with all data of the cycles: GUD5 holds the parameters of a call, the results, empirical and mean values, GUD6 the settings of the machine and the probe data, GUD7 and GUD7_MC data of measuring in JOG. The machine manufacturer loads and adapts them at start-up; their values remain stored when the control is off.
term-deceleration-path = Deceleration path, braking path (sb)
term-deceleration-path-is = Distance that the axis still travels after the probe has switched: delay until the command to brake, braking, following error. The probe must permit a deflection of this size, otherwise it is damaged; this limits the measuring feed.
term-delete-distance-to-go = Delete distance-to-go (DDTG)
term-delete-distance-to-go-is = When the probe switches, the control stops the axis and deletes the rest of the measuring block. The position stored at the signal counts, not the one where the axis comes to rest.
term-differential-measurement = Differential measurement
term-differential-measurement-is = The first point is touched twice, with the spindle rotated by 180° and in its original position; the skew cancels, so the probe need not be calibrated. Needs a multi probe and a spindle that can be positioned; CYCLE978 (thousands digit of _MVAR 1) and CYCLE998 (_MVAR=1105) have it.
term-dimension-difference-check = Dimensional difference check
term-dimension-difference-check-is = Limit above which a difference is not corrected: message 62306, and the program continues (with _CBIT[2]=1 after NC START). The cause is usually a worn or broken tool; set _TDIF above the tolerance and below _TSA.
term-empirical-value = Empirical value
term-empirical-value-is = Known, constant deviation of a measurement, kept in _EV[] and selected by _EVNUM. The cycle subtracts it from the measured value (with _CHBIT[5]=1 adds it) before it checks any limit: with automatic tool offset, single points for a zero offset, and tool measurement.
term-following-error = Following error
term-following-error-is = Distance by which a moving axis lags behind its command position: velocity divided by servo gain Kv. It lengthens the deceleration path, but does not enter the result, because the actual position is stored.
term-frame = Frame
term-frame-is = Zero offset that can also contain rotation, mirroring and scale; basic, system, settable and programmable frames act in a chain. While measuring, no scale factor may be active (alarm 61310); some cycles and variants do not permit rotation or mirroring either.
term-gauging-block = Gauging block
term-gauging-block-is = Body of known size and position on which a workpiece probe is calibrated on a lathe: usually a pair of reference grooves, one for cutting edge position 7, one for 8. Its data are in _KB[], in machine coordinates, as radius in X; _CALNUM selects the set.
term-log-of-measuring-results = Log of measuring results
term-log-of-measuring-results-is = File in the part program memory to which every measuring cycle adds its results, from CYCLE100 until CYCLE101; _PROTNAME[1] is its name. It can be read out of the control as proof of the measurements.
term-mean-value = Mean value
term-mean-value-is = Weighted running mean of the differences from part to part, which follows a trend such as wear: new = old − (old − difference)/_K. Differences up to _TMV enter it; above _TZL it becomes the tool offset and the memory is set to 0; it is kept in _MV[] only with _CHBIT[4]=1 and _EVNUM above 0.
term-measure-workpiece = Workpiece measurement
term-measure-workpiece-is = The probe is moved like a tool to the clamped workpiece and touches it. The result can correct the tool that cut the surface, or a zero offset.
term-measurement-path = Measuring path
term-measurement-path-is = Distance from the start of the measuring block to the expected position; the block ends the same distance behind it, so the probe must switch within twice _FA, otherwise alarm 61301. Always in mm, even if the control works in inches.
term-measurement-result-display = Measurement result display, result screen
term-measurement-result-display-is = Screen on which a cycle shows setpoints, actual values and differences; _CHBIT[10]=1 switches it on. With _CHBIT[11]=1 the program waits for NC START; with 0 the screen closes at the end of the cycle, or with _CHBIT[18]=1 remains until the next measuring cycle.
term-measuring-at-an-angle = Measuring at an angle
term-measuring-at-an-angle-is = CYCLE979 measures a hole, shaft, groove or web in directions that are given by an angle in the workpiece coordinate system, not by its axes. _STA1 is the angle of the first point to the abscissa, counter-clockwise positive.
term-measuring-accuracy = Measuring accuracy
term-measuring-accuracy-is = Limited by the repeat accuracy of machine and probe and by the resolution of the measuring systems; the control adds ±1 µm in on-the-fly measurement. Delays of the signal shift the result, less at a lower feed; therefore measure at the feed of the calibration.
term-measuring-axis = Measuring axis
term-measuring-axis-is = Axis in which the probe moves when it measures: 1 abscissa, 2 ordinate, 3 applicate. The plane decides which axes these are: X, Y, Z in G17, Z, X, Y in G18, Y, Z, X in G19.
term-measuring-direction = Measuring direction
term-measuring-direction-is = Direction in which the probe moves in the measuring axis: 0 plus, 1 minus. Needed where the start position does not decide it, for example when a workpiece probe is calibrated on a surface.
term-measuring-in-jog = Measuring in JOG
term-measuring-in-jog-is = Semi-automatic measuring on milling machines: select the task by softkey, fill in the mask, move the axes near the point, press NC start. It sets zero offsets and tool lengths or radii and calibrates probes; its settings are _JM_I[], _JM_B[] and the E_MESS_… data.
term-measuring-tool = Tool measurement
term-measuring-tool-is = The tool is moved to a tool probe, which is fixed or swung in, and its length or radius goes into the tool offset: with _CHBIT[3]=0 into the geometry, wear deleted, with 1 the difference into the wear. _TP[] holds the probe data in machine coordinates, _TPW[] those in workpiece coordinates.
term-measuring-variant = Measuring variant
term-measuring-variant-is = Number whose digits tell a cycle what to measure and what to correct; every cycle has variants of its own. A variant that the cycle does not have raises alarm 61307.
term-measuring-velocity = Measuring velocity, measuring feed
term-measuring-velocity-is = Feed in the measuring block. The axis must stop from it within the permitted deflection of the probe, and it should be the same for calibrating and measuring.
term-mono-probe = Mono probe
term-mono-probe-is = Probe that switches in one direction only; in _PRNUM its hundreds digit is 1. Only for workpieces on milling machines and lower accuracy: the spindle must be positionable with SPOS and turns the probe for every direction, which takes time, and the signal must come through at every angle.
term-multi-probe = Multi probe
term-multi-probe-is = Probe that switches in all directions of the three axes; in _PRNUM its hundreds digit is 0. For workpieces on milling machines and lathes and for turning tools; results are best if the same point of the ball touches as in the calibration.
term-multiple-measurement-at-one-place = Multiple measurement at the same point
term-multiple-measurement-at-one-place-is = The cycle touches each point _NMSP times and uses the arithmetic mean. This reduces random scatter, but not a constant error, and takes longer.
term-offset-angle-position = Offset angle position, offset angle
term-offset-angle-position-is = Angle in degrees by which the cycle corrects the spindle position of a mono probe, so that its switching direction points the right way; applies with _CBIT[8]=1. In CYCLE982 it corrects the spindle position after the reversal when a milling tool is measured.
term-offset-axis = Offset axis
term-offset-axis-is = Axis in which the cycle moves on between two measuring points; the hundreds digit of _MA is its number: 102 is offset axis 1, measuring axis 2. Used for example by CYCLE998, for the distance between the points of an angle, and by CYCLE971.
term-on-the-fly-measurement = On-the-fly measurement
term-on-the-fly-measurement-is = The NC processes the probe signal itself and stores the axis position at the instant of switching, while the axis is still moving. The delay is short, so a higher measuring feed gives the same accuracy.
term-oversize = Oversize
term-oversize-is = The difference is above the upper tolerance limit _TUL: message 62304; if _KNUM is not 0, the tool is corrected at once, without the mean value, and with _CBIT[2]=1 the program waits for NC START. An oversize shaft can be cut again, an oversize hole cannot.
term-paraxial-measurement = Paraxial measurement
term-paraxial-measurement-is = Measuring parallel to the axes of the workpiece coordinate system: CYCLE977 for a hole, shaft, groove, web or rectangle, CYCLE978 for a surface. If the element lies askew, the result is wrong: align the coordinate system first, or measure at an angle.
term-positional-deviation = Positional deviation (skew)
term-positional-deviation-is = Distance of the ball centre from the spindle axis, in abscissa and ordinate. The calibration determines it and the measuring cycles compensate it; the stored value applies to the spindle position of the calibration.
term-probe-ball-diameter = Probe ball diameter
term-probe-ball-diameter-is = Active diameter of the ball, as the cycles calculate with it. It includes the travel until the probe switches, so it is not the size that a micrometer shows; the calibration determines it, and CYCLE979 always needs it.
term-probe-type = Probe type
term-probe-type-is = By the directions in which it switches a probe is a multi, bidirectional or mono probe; in workpiece measurement a bidirectional probe counts as mono probe. It must be a touch-trigger probe whose signal persists, practically free of bounce, while it is deflected; a short pulse is not enough.
term-protection-zone = Protection zone
term-protection-zone-is = Zone around the setpoint centre (in CYCLE994 given by its borders). In a hole or groove it is the obstacle that the probe must not enter, around a shaft or web the free space, element included, that the probe must not leave; too little room for the ball raises alarm 61334.
term-reference-groove = Reference groove
term-reference-groove-is = Groove fixed in the machine whose exact position is known, for calibrating workpiece probes on lathes with CYCLE973. Its edges and base are in _KB[], in machine coordinates and, in X, as radius; an error in them carries over to every later measurement.
term-repeat-accuracy = Repeat accuracy
term-repeat-accuracy-is = Scatter of repeated touches of the same place: machine, probe and signal path together. Determine it on each machine, with ten or more touches; _TZL should be at least the largest random deviation.
term-safe-area = Safe area
term-safe-area-is = Outermost limit: a difference above it means that probe, setpoint or clamping is wrong, not the size; for the first calibration of a workpiece probe it must be larger than the ball radius. Alarm 61303 stops the program until NC RESET, nothing is corrected; with _CBIT[0]=1 the cycle repeats the measurement up to four times first.
term-servo-gain = Servo gain (Kv)
term-servo-gain-is = Ratio of velocity to following error of an axis, in (m/min)/mm. A high value gives a short deceleration path; the lowest value of the axes that measure counts.
term-setpoint = Setpoint
term-setpoint-is = Position or size from the drawing where the probe is expected to switch; _SETV[] holds further ones, such as the lengths of a rectangle. It is in the active system of units, inch or metric; if it is wrong, alarm 61301 or 61303 follows, or a good tool is corrected.
term-setup-offset = Setup offset (DL)
term-setup-offset-is = Offset of a D number for one place of use, entered when the machine is set up and selected like the additive offset; without bit 4 of MD 18112 there is none (alarm 61409). With _CHBIT[8]=1 the cycle adds the correction to it; with _CHBIT[8]=0 and _CHBIT[6]=1 it adds the additive offset as well and sets that to 0.
term-tolerance-bottom-limit = Lower tolerance limit
term-tolerance-bottom-limit-is = Lower limit from the drawing, with its sign, relative to the setpoint and in the active system of units. If the difference is below it, message 62305 follows, and the tool is corrected at once, without the mean value.
term-tolerance-top-limit = Upper tolerance limit
term-tolerance-top-limit-is = Upper limit from the drawing, with its sign, relative to the setpoint and in the active system of units. If _TUL and _TLL are not symmetrical, the cycle calculates with the middle of the tolerance as setpoint; differences above _TMV (usually two thirds of the tolerance) up to _TDIF are corrected at once, and the mean value is deleted.
term-tool-environment = Tool environment
term-tool-environment-is = Conditions under which a tool works (plane, assignment of lengths, settings), stored by TOOLENV under a name of up to 32 characters; from NCK SW 6.3. With _TENV a later measurement corrects the tool as it was used, even if plane or length assignment have changed since; T, D and DL number can come from it.
term-tool-name = Tool name
term-tool-name-is = With tool management, the name of the tool to be corrected instead of its number. It applies only while _TNUM is 0: a T number set by an earlier call takes precedence.
term-tool-number = Tool number (T number)
term-tool-number-is = Number of the tool that is corrected after the measurement. It must be the tool that cut the measured surface, not the probe in the spindle.
term-trigger-point = Trigger point
term-trigger-point-is = Position at which a probe switches, stored for each axis and direction. For a tool probe it is the position itself, in machine (_TP) or workpiece coordinates (_TPW); for a workpiece probe it is the distance from the true surface (_WP).
term-undersize = Undersize
term-undersize-is = The difference is below the lower tolerance limit _TLL: message 62305; if _KNUM is not 0, the tool is corrected at once, without the mean value, and with _CBIT[2]=1 the program waits for NC START. An undersize hole can be cut again, an undersize shaft cannot.
term-variable-measuring-speed = Variable measuring speed
term-variable-measuring-speed-is = Measuring feed as a parameter of the call: above 0 it applies as entered, in mm/min or inch/min of the basic system; with 0 the cycle chooses 150 mm/min for _FA=1 and 300 mm/min for a longer path.
term-weighting-factor = Weighting factor
term-weighting-factor-is = How much a single difference moves the mean value: by one _K-th of its distance from it. 1 follows every difference at once, a larger value is calmer but slower; 0 raises alarm 61318.
term-wear = Wear
term-wear-is = Part of the tool offset that is added to the geometry and takes up corrections while the geometry stays. Workpiece measurement corrects it with _CHBIT[6]=0, tool measurement with _CHBIT[3]=1; with the other value the geometry is written and the wear becomes 0.
term-zero-offset = Zero offset (ZO)
term-zero-offset-is = Position of the workpiece zero in the machine coordinate system, called with G54 to G57 or G505 to G599. With coarse and fine offset its value is the sum of the two; a correction by a cycle takes effect when the G function is programmed again, with _KNUM=9999 at once.
term-zero-offset-area = Zero compensation area (zero offset area)
term-zero-offset-area-is = Size of the random deviations: what does not exceed _TZL is not corrected, so that the offset does not follow chance; it has nothing to do with the zero offset. With automatic tool offset the mean value is compared with it and goes on, in tool measurement the difference itself.
term-zo-determination = Zero offset determination (ZO determination)
term-zo-determination-is = The cycle corrects the zero offset in _KNUM so that the element is at its setpoint. Of the limits only _TSA applies; the correction goes into the fine offset if there is one, but into the coarse offset with _CHBIT[21]=1, with _KNUM=2000 and in CYCLE961.
term-computerized-numerical-control = Computerized numerical control (CNC)
term-computerized-numerical-control-is = Numerical control in which a computer reads the program, calculates the path and controls the axes. Today it means the same as NC.
term-central-processing-unit = Central processing unit (CPU)
term-central-processing-unit-is = The part of a computer that executes its instructions. A control usually has more than one: for the NC, the PLC and the user interface.
term-german-industry-standard = German industry standard (DIN)
term-german-industry-standard-is = The measuring cycles require machine axes to DIN 66217, the standard for names and directions of axes.
term-disk-operating-system = Disk operating system (DOS)
term-disk-operating-system-is = Operating system of early PCs, controlled by typed commands. On the control it also names a text format: that of the result screens is set in the file MBDDE.INI.
term-differential-resolver-function = Differential resolver function (DRF)
term-differential-resolver-function-is = Additional offset of an axis with the handwheel while a program runs. It has nothing to do with measuring.
term-function-module-numerical-control = Function module numerical control (FM-NC)
term-function-module-numerical-control-is = Small SINUMERIK control, built as a module for the PLC SIMATIC S7-300.
term-global-user-data = Global user data (GUD)
term-global-user-data-is = Variables that every program can read and write, once for the whole control or once in each channel. Their values survive power off: a parameter that a call does not write still has the value of an earlier call.
term-input-output = Input/output (I/O)
term-input-output-is = Signals between the control and the machine. Two inputs are for touch-trigger probes; _CHBIT[0] selects that of the workpiece probe, _CHBIT[1] that of the tool probe.
term-start-up = Start-up, commissioning (IBN)
term-start-up-is = Loading cycles and definition files, setting machine data, connecting and testing the probe. IBN is short for the German word Inbetriebnahme.
term-set-up-mode = Set-up mode (JOG)
term-set-up-mode-is = Operating mode in which the operator moves the axes by direction keys or handwheel, to set up the machine.
term-local-user-data = Local user data (LUD)
term-local-user-data-is = Variables of one program or cycle that exist only while it runs; the measuring cycles calculate with them. If the memory reserved for them (MD 28020, MD 28040) is too small, the program stops at the call.
term-machine-coordinate-system = Machine coordinate system (MCS)
term-machine-coordinate-system-is = Coordinate system of the machine axes; positions count from the machine zero and do not depend on any zero offset. Reference grooves (_KB) and tool probes calibrated as machine-related (_TP) are stored in it.
term-machine-data = Machine data (MD)
term-machine-data-is = Numbered settings with which the machine manufacturer adapts the control to the machine. A change that alters the memory deletes data (alarm 4400): save a series archive first and read it back afterwards.
term-man-machine-communication = Man-machine communication (MMC)
term-man-machine-communication-is = Older name of the user interface of SINUMERIK and of its hardware, for operating, programming and simulation; later HMI. Measuring in JOG needs MMC 103 or HMI Advanced.
term-microsoft = Microsoft (MS)
term-microsoft-is = Software company; the abbreviation occurs in names such as MS-DOS.
term-numerical-control = Numerical control (NC)
term-numerical-control-is = Control of a machine by a program of numbers; also the part of the control that executes programs and moves the axes, as opposed to PLC and user interface.
term-numerical-control-kernel = Numerical control kernel (NCK)
term-numerical-control-kernel-is = Core software of the NC: prepares the program blocks, calculates the motion and controls the axes. User data with the scope NCK, such as _CBIT[], exist once for all channels.
term-numerical-control-unit = Numerical control unit (NCU)
term-numerical-control-unit-is = Hardware unit on which the NCK runs.
term-data-exchange-software = Data exchange software (PCIN)
term-data-exchange-software-is = Siemens program for a PC that exchanges programs, archives and other data with the control, usually over V.24.
term-programming-device = Programming device (PG)
term-programming-device-is = Portable Siemens computer for programming and testing the PLC.
term-programmable-logic-control = Programmable logic controller (PLC)
term-programmable-logic-control-is = Part of the control for the functions of the machine around the NC, such as tool change, coolant and clamping. It shows whether the probe signals arrive: DB10 DBX107.0 is probe 1 deflected, DBX107.1 probe 2.
term-subprogram = Subprogram (SR)
term-subprogram-is = Program that another program calls; measuring cycles are subprograms. They may be called down to the 5th program level, because they call subprograms themselves.
term-software = Software (SW)
term-software-is = With a number, the version. NCK, user interface and measuring cycles each have their own: cycles from SW 6.2 on need NCK SW 6.3 or higher.
term-tool-offset = Tool offset (TO)
term-tool-offset-is = Data of a cutting edge under its D number: tool type, cutting edge position, lengths, radius and their wear. The control calculates the path of the tool from them, so an error here is an error of the part.
term-tool-offset-active = Tool offset active (TOA)
term-tool-offset-active-is = Type of the files in which the control saves tool offsets.
term-user-interface = User interface (UI)
term-user-interface-is = Screens and keys with which the operator works at the control.
term-serial-interface = Serial interface (V.24)
term-serial-interface-is = Interface for exchanging data bit by bit with a PC, also called RS-232-C. On older controls it loads cycles and definition files and reads out log files.
term-workpiece-coordinate-system = Workpiece coordinate system (WCS)
term-workpiece-coordinate-system-is = Coordinate system of the workpiece, which the active frames place in the machine; programs and setpoints of workpiece measurement refer to it. A tool probe that is calibrated in it (_TPW) is right only with the zero offset of the calibration.
