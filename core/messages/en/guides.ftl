# Guides: what a part of Probewright is for, where it is, what to look out for. What stands in quotation marks is the
# text of a control of the page.

guide-group-results = Working with results

guide-record = Record of the measurements
guide-record-words = record, report, inspection report, table of measurements, list of results, CSV, Excel, JSON, PDF, print, customer, quality, verdict
guide-record-1 = The record lists all that a run measured, a row each: element, setpoint, actual value, limits and the share of them that is used, verdict, correction, probe with its calibration, alarms.
guide-record-2 = In the view, choose “Whole program”; the table stands under “Measurements”. “Worst first” brings the worst to the top, and a click on a row goes to its line and its step in the 3D view.
guide-record-3 = “CSV” is for a spreadsheet, “JSON” for other programs, “Print record” for paper or PDF: title block, bars and the picture with the numbered elements.
guide-record-4 = Look at the calibration beside the probe: a value measured with a foreign or old calibration is worth no more than that calibration.

guide-measured = Values of the real machine
guide-measured-words = import, read in, protocol, real values, real machine, measured values, log of the control, CSV, Excel, compare, arrows
guide-measured-1 = Lays what a machine really measured onto the calls of the program: the same table and record, and the real deviations as arrows in the 3D view.
guide-measured-2 = Open the program that the machine ran and show “Whole program”. Choose “From the machine”, then the log of the control or a table (CSV).
guide-measured-3 = Each line is matched with a call. If the figures do not say what a column holds, choose it under “Columns”.
guide-measured-4 = Lines that do not fit are listed with the reason, and none is dropped. “Back to the simulation” shows the simulated values again.

guide-certainty = How certain a measurement is
guide-certainty-words = certainty, uncertainty, expanded uncertainty, measurement uncertainty, guard band, guard bands, ISO 14253, ISO 14253-1, Monte Carlo, coverage factor, chance, probability, proven, conformity, accept
guide-certainty-1 = Tells what a measured value proves: value ± expanded uncertainty (k = 2), from the scatter of the probe, its calibration, the form error and the temperature of the part.
guide-certainty-2 = The result line has it for the call in the form. For a program choose “Certainty” above the table “Measurements”: the program runs many times, with the same random numbers each time.
guide-certainty-3 = By ISO 14253-1 a part is proven good only where the value keeps a guard band of 1.645 standard uncertainties from each limit, and proven bad only beyond the limit by as much. Between, neither is proven.
guide-certainty-4 = The chances say how likely the part is good, rework or scrap. Improve the largest contribution first.
guide-certainty-5 = It is as good as what it knows: enter the “Repeatability” of the probe under “Errors”, as a test of the probe found it. Where nothing spreads, nothing is told.

guide-series = Series of parts
guide-series-words = series, many parts, batch, lot, statistics, SPC, Cp, Cpk, capability, process capability, scrap rate, tool wear, drift, trend, histogram, mean, standard deviation
guide-series-1 = Runs the open program for one part after the other, with errors drawn at random. It shows how actual values and corrections develop, and what would be scrap without corrections.
guide-series-2 = Choose “Series” above the table “Measurements”. “Add what varies” takes sizes of the part, tool wear, the probe and any datum, each with its spread; then choose “Run series”.
guide-series-3 = With “Each part” set to “finds the corrections of the part before” you see the control loop of production, with “begins anew” the spread alone.
guide-series-4 = Cp compares the spread with the tolerance, Cpk also the distance from its middle. Heed their intervals: a few parts prove little.
guide-series-5 = The same seed draws the same parts: change one value and compare. “Example: mean value” runs the table of the manual.

guide-limits = Choosing _TZL, _TMV and _K
guide-limits-words = _TZL, _TMV, _K, zero compensation, zero offset area, mean value, empirical value, weighting factor, weight, correction limits, tolerance, oscillate, hunt
guide-limits-1 = These values decide which deviation corrects the tool, and by how much. Too tight, the correction follows chance; too wide, parts drift out of tolerance.
guide-limits-2 = Try them in “Series”: the same parts with _K=1 and _K=3. For _TZL, “Test a probe: repeat accuracy” proposes a value.

guide-screens = Measuring result screens
guide-screens-words = screen, result screen, measuring result display, acknowledge, NC start, halt, wait, M0, operator, CYCLE102, CYCLE103, _CHBIT[10], _CHBIT[11], _CHBIT[18]
guide-screens-1 = On the control a measuring cycle can show setpoints, actual values and differences on a screen. Here you see what the operator sees.
guide-screens-2 = _CHBIT[10]=1 switches the screens on. With _CHBIT[11]=1 the program waits for NC START, with _CHBIT[18]=1 the screen remains until the next measuring call. Set them in the program or under “Machine data”.
guide-screens-3 = A screen stands over the 3D view while the run is at its step. The tab “Result” lists all of them, and a click opens one.
guide-screens-4 = Tick “Halt here while playing”: playback then waits at each screen that waits on the machine, until you press “NC START”.
guide-screens-5 = In unattended production a screen that waits stops the machine at every part: set _CHBIT[11]=0 there.

guide-log = Log and files of a run
guide-log-words = log, log file, measuring log, protocol, file, MPF, WRITE, print, CYCLE100, CYCLE101, CYCLE106, _PROTNAME, continuation file, follow-up file, overflow, LEN_PROTOCOL_FILE
guide-log-1 = A run leaves the files that the control leaves: the log between CYCLE100 and CYCLE101, what the program writes with WRITE, and what NCT macros print.
guide-log-2 = The tab “Log” shows each file as it grows with the run, and saves it under the name that it has on the control.
guide-log-3 = _PROTNAME[1] is the name, without an extension. When a file has the size in MD 11420, up to nine more follow, with an underscore and a digit; then the control stops and wants a new name.
guide-log-4 = The forms of the log cycles put the columns together by choosing (“Add column”), and show the lines as they will be printed. A value that is too long for its column is reported.
guide-log-5 = Date and time are those of the control, not of this computer: “Date and time at which a run begins” in the machine sets them.

guide-group-programs = Running and extending programs

guide-run-modes = Modes of a run
guide-run-modes-words = mode, run mode, dry run, program test, block search, search run, simulation, HMI Advanced, Jobshop, ShopMill, skip, skipped, _MC_SIMSIM, _MC_SIMDIFF
guide-run-modes-1 = Shows what a program does on the control where measuring cycles are skipped or only simulated.
guide-run-modes-2 = In the view, choose “Whole program”, and under “Mode” one of “Automatic”, “Dry run”, “Program test”, “Block search” and the simulations of the control.
guide-run-modes-3 = A skipped cycle measures nothing: its results keep the values of an earlier call, and the program goes on with these. Each call says so.
guide-run-modes-4 = With “Block search”, make sure that nothing behind the target line needs a result from before it.
guide-run-modes-5 = In the simulations of the control, _MC_SIMSIM=0 skips the cycles, and _MC_SIMDIFF is added to each measured position.

guide-around = Blocks around the call
guide-around-words = around, block, rework, loop, breakage, broken tool, halt, jump, message, own alarm, semi-finish, mean, reversal, keep the result, skip, by result
guide-around-1 = Adds what a shop writes by hand about a measurement: halt, message, alarm or jump by result, rework loop, semi-finish and finish, tool breakage check, mean of several measurements, result into a variable or the log, skip if measured.
guide-around-2 = Open “Around the call” in the form, tick blocks and fill in their fields. They are inserted with the call; at a call of the program choose “Write into program”.
guide-around-3 = Blocks are read back from their lines, and can be changed and removed later.
guide-around-4 = A block that calls a program needs that program: the one for rework, for example, returns the probe to the start position.
guide-around-5 = Try every branch: give the part an error under “Errors” and run “Whole program”.

guide-user-programs = Lines before and after each measurement
guide-user-programs-words = CYCLE198, CYCLE199, user program, before the measurement, after the measurement, probe on, probe off, switch on the probe, M27, M28, cover
guide-user-programs-1 = CYCLE198 runs before each measurement, CYCLE199 after it: for what your machine always needs there, such as switching the probe on and off.
guide-user-programs-2 = “Lines around measuring cycles (CYCLE198, CYCLE199)” writes them by choosing cycles and lines: to insert, or as whole files.
guide-user-programs-3 = If a program or a file with it contains them, each call says which lines run around it.
guide-user-programs-4 = They act in every program of the machine. What belongs to one measurement stands around its call.

guide-group-proof = Proving programs and installation

guide-scenarios = Scenarios: programs that stay proven
guide-scenarios-words = scenario, test, test run, regression test, JUnit, CI, build server, folder, expected outcome, prove, proven
guide-scenarios-1 = A scenario holds a program, its machine and what must come of it: results of each call, corrections, alarms, log. Run it again after each change of the program or the machine data.
guide-scenarios-2 = Choose “Scenarios” in the menu. “Save program as scenario” makes one from what the page shows; “Run scenarios …” and “Run folder …” carry out yours.
guide-scenarios-3 = In a folder, names end in scenario.json. What differs stands first, with expected and actual value.
guide-scenarios-4 = In the terminal, a failed case gives exit status 1, and --junit writes JUnit XML, so that a server can run your programs.
guide-scenarios-5 = Save one for the good part and one for each that the program must catch: oversize, no hole, broken tool.

guide-installation = Check this installation
guide-installation-words = self-test, self test, check, installation, verify, validation, proof, worked examples, vectors, closed loop
guide-installation-1 = Proves in your own browser that Probewright calculates what the manuals print: worked examples, their figures, and closed loops that calibrate, correct and measure again.
guide-installation-2 = Choose “About”, then “Check this installation”. You see how many hold, each with its source, and the time it took; what differs stands first.
guide-installation-3 = Do this after each new version. It proves the calculation, not your machine: prove out every program there.

guide-group-machine = Machine and probe

guide-machine-check = Check a machine
guide-machine-check-words = machine data, INITIAL.INI, TEA, series archive, archive, export, backup, MD, memory, missing data, alarm
guide-machine-check-1 = Holds what a control exported against what the measuring cycles need, and tells what is missing, too low or contradictory, and which alarm follows from it.
guide-machine-check-2 = Choose “Check a machine”, and drop machine data (.TEA, INITIAL.INI), definition files or the text of an archive, or type lines such as MD 18120 = 30.
guide-machine-check-3 = Say what the machine has, such as “Measuring in JOG” or “Tool probe”; otherwise data are demanded that it does not need.
guide-machine-check-4 = “Save lines to change” writes these lines only. Archive the control before you read them in: data that configure the memory erase it.

guide-definitions = Definition files and value assignments
guide-definitions-words = GUD, GUD5, GUD6, GUD7_MC, DEF, definition file, array size, value assignment, memory, read back, number of probes
guide-definitions-1 = Writes what your machine changes in the definition files of the measuring cycles: array sizes and other values, the program that assigns them, and the memory that they need.
guide-definitions-2 = Choose “Definition files, value assignments” and save each file. They contain only lines to change: put them into the files of the control.
guide-definitions-3 = “Read files back” takes the values of a control into the machine here, also from its start-up files.
guide-definitions-4 = Back up the data of the control before you activate a definition file; then run the program of value assignments.

guide-braking = Braking path of the probe
guide-braking-words = braking path, braking distance, deceleration, overtravel, deflection, stylus, largest feed, measuring feed, _VMS, Kv, servo gain, MD32300, MD32200
guide-braking-1 = After the signal the axis needs a path to stop, and the probe has to take it. Calculates this path for a feed, or the largest feed for the deflection that the probe allows.
guide-braking-2 = Choose “Check a machine” and open “Braking path”. Delay, deceleration and servo gain come from the export of the control, or you type them.
guide-braking-3 = With these data in the machine, a call whose feed is too high is a warning with the largest feed.
guide-braking-4 = The value is taken at the signal, so the path does not falsify it. It decides whether the stylus survives; half the feed takes less than half the path.

guide-repeat = Test a probe: repeat accuracy
guide-repeat-words = repeatability, repeat accuracy, scatter, probe test, function test, MEAS, drift, standard deviation, histogram, calibration check
guide-repeat-1 = Two test programs without measuring cycles: one shows whether the probe switches, the other how far touches of one place spread.
guide-repeat-2 = Choose “Test a probe: repeat accuracy” and enter axis, start, end and feed. “Save function test” and “Save repeat program” write the programs for the machine.
guide-repeat-3 = Paste what the machine measured under “Values of the real machine (empty: simulated)”: you get mean, deviation, range, drift and a proposed _TZL.
guide-repeat-4 = Enter the deviation as “Repeatability” of the probe: certainty and series then calculate with your probe.
guide-repeat-5 = If the values drift, the machine is not warm or the probe is loose: remedy that first, and test again.

guide-commissioning = Commissioning and upgrade
guide-commissioning-words = commissioning, installation on the machine, install, upgrade, HMI Advanced, HMI Embedded, PCU 50, MMC, TCU, plug, X121, wiring, connection, compatibility, versions that work together
guide-commissioning-1 = The steps by which measuring cycles come to a machine or are upgraded, by operator panel and version, with softkeys, files and how to see that each is right.
guide-commissioning-2 = Choose “Commissioning and upgrade” and the way under “Machine”. Tick what is done: the page keeps it. “Connections of probes” has plugs and signals.
guide-commissioning-3 = Where a step asks for machine data, “Check a machine” says whether they are sufficient.

guide-background = Guides, concepts and terms
guide-background-words = help, guide, glossary, dictionary, concept, term, meaning, explain, manual
guide-background-1 = Explains how to work with Probewright, and what the manuals of measuring cycles take for granted.
guide-background-2 = Press Ctrl+K, choose “Guides, concepts and terms” and type any word. “Concept” beside a field opens the concept that it needs, and a question mark in a dialog its guide.
guide-background-3 = Each measuring variant has a help page of its own: “Help” beside the form.
