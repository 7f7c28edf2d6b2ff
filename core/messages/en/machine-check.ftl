# The check of a machine: what is wrong with its machine and user data, and what follows from it.

machine-check-nothing = Nothing in this text is a machine datum or user datum that measuring needs: choose a file of machine data (.TEA, INITIAL.INI), a definition file or a series archive in text form.
machine-check-ending = Data compared: { $read }. Errors: { $errors }. Warnings: { $warnings }. Notes: { $notes }. Other assignments in the files: { $others }.
machine-check-unread = The value cannot be read: { $value } Write it like 7, (1,0,2), SET(1,,2) or REP(0).
machine-check-text = A number belongs here, no text: { $value }
machine-check-number = A text belongs here, in quotation marks: { $value }
machine-check-whole = { $value } is not a whole number.
machine-check-no-element = { $count ->
    [one] This element does not exist
   *[other] These { $count } elements, from this one on, do not exist
  }: the array is { $array }.
machine-check-no-index = { $name } is no array and has no index.
machine-check-no-field = This element is beyond the { $most } fields of { $other }.
machine-check-unnamed = This geometry axis has no name.
machine-check-unread-size = The size or index of the array cannot be read: { $value } Write whole numbers, like [2,10].
machine-check-many = The list has { $value } values for { $before } elements: the last ones are dropped. Shorten it, or define the array larger.
machine-check-unlike = The number { $value } is that of another datum: the control reads the identifier.
machine-check-renamed = Read by its number: the manual calls it { $before }. A control with that identifier does not know { $value }.
machine-check-positive = { $value } is not possible: the value must be above 0. No braking path is calculated with it.
machine-check-no-axis = Without { $data } no feed is held against the permitted deflection.
machine-check-axis-metric = This control is in inches; { "MD32300" } is taken in m/s², { "MD32200" } in (m/min)/mm. Multiply a deceleration in inch/s² by 0.0254.
machine-check-twice = Given twice with different values: { $before }, then { $value }. The last one counts.
machine-check-low = { $value } is too low; at least { $limit }.
machine-check-high = { $value } is too high; at most { $limit }.
machine-check-not = { $value } instead of { $limit }.
machine-check-between = { $value } is not between 1 and { $limit }.
machine-check-bits-missing = Bits that must be 1: { $bits }.
machine-check-bits-set = Bits that must be 0: { $bits }.
machine-check-range = { $value } is not between { $min } and { $max }.
machine-check-from = { $value } is too low; at least { $min }.
machine-check-above = { $value } is too low; it must be above { $min }.
machine-check-choice = { $value } is not permitted; permitted: { $choices }.
machine-check-count = The array { $array } is defined with { $size } elements.
machine-check-no-array = The array { $array } does not exist: its definition is a comment.
machine-check-fields = Each element of this array has { $size } data; the definition has a different number.
machine-check-units = The basic system is { "MD10240" } = { $metric }: the cycles convert the data at the next call.
machine-check-needs = No effect without { $other } = { $value }.
machine-check-erases = The next call sets all probe data, empirical values and mean values to 0.
machine-check-version = The software version of the control is missing, or below 3.
machine-check-uncalibrated = This workpiece probe was never calibrated. For the first calibration, { "_TSA" } must be larger than the ball radius.
machine-check-depth = The depth for radius measurement is 0.
machine-check-axes = Each of the three digits is 0 to 3: one for each axis.
machine-check-size = Disk diameter or edge length is 0; calibration and length measurement use it.
machine-check-own-speed = Speed and feed of the user apply, but this one is 0.
machine-check-no-make = The correction of measured values needs the make of the tool probe in { "_TP_CF" }.
machine-check-no-table = Not filled in: { $tables }. A correction table needs radii and speeds in ascending order.
machine-check-assign = This size of the tool probe must be entered.
machine-check-inputs = Automatic mode and JOG use different probe inputs: { $other } = { $value }.
machine-check-probe = There are only { $most } probes ({ $other }).
machine-check-most = At most { $most }.
machine-check-no-lines = No value line of the log is filled in.
machine-check-skipped = In simulation, the control skips the measuring cycles.
machine-check-ratios = { $size } entries for { $probes } workpiece probes: for the others, the trigger values are not corrected.
machine-check-braking = At { $feed }, the probe is deflected by up to { $path } mm, but it allows { $deflection } mm; at most { $largest }.

machine-need-gud = The definition files GUD5, GUD6 and GUD7 cannot be activated. A change of the memory raises alarm 4400: save and read back a series archive.
machine-need-reserve = Enough for the measuring cycles alone; the manual recommends more.
machine-need-functions = The control does not know all cycles that have parameters.
machine-need-lud = The local variables of the cycles do not fit: the program stops at the call.
machine-need-system-frame = No measuring cycle runs.
machine-need-basic-frame = No correction of the basic frame: neither in JOG nor with { "_KNUM" } = 2000.
machine-need-channel-frame = Corrections of a channel basic frame are refused.
machine-need-fine = Corrections go into the coarse offset; the fine offset is included and deleted.
machine-need-level = Right only for a probe that gives 0 V when deflected; otherwise the probe counts as deflected at rest.
machine-need-central = On an 840D sl, probes at { "X122" } do not measure.
machine-need-hmi-time = The display of results is acknowledged too late.
machine-need-log-file = The log file is full early: the log continues in files _1 to _9, then asks for a name.
machine-need-mirror = With mirroring, results of workpiece measurement are wrong.
machine-need-additive = Additive offsets are refused.
machine-need-setup-offset = Setup offsets are refused.
machine-need-environment = Tool environments ({ "_TENV" }) do not exist.
machine-need-jog-start = Measuring in JOG does not start.
machine-need-geometry = A geometry axis is missing for measuring in JOG.
machine-need-reset-length = After RESET and power on, the tool length of the probe or the basic frame is not active.
machine-need-start-length = At program start, the tool length offset is lost.
machine-need-tool-change = At RESET and start, tool management does not keep the probe as the active tool.
machine-need-basic-reset = The basic reference is lost at RESET.
machine-need-length-type = On a lathe with drills or milling tools, their lengths count along the wrong axes; 2 is for these machines.

# Definition files.

definitions-none = Nothing differs from delivery.
definitions-memory = Memory of user data
definitions-share = { $name }: { $bytes } bytes (default { $default })
definitions-share-channel = { $name }: { $bytes } bytes for each channel (default { $default })
definitions-need = { $number } at least { $value } for the measuring cycles alone, { $source }
definitions-insert = Replace the lines of the same names in the original { $files }: these lines are not the whole file.
definitions-save = First save the user data that are active in the NC: activating a definition file resets their values.
definitions-activate = Activate one at a time, in this order: { $files }.
definitions-load = Load GUD7_MC.DEF with “Load HD → NC” and do not activate it. Then activate GUD7.DEF, which takes GUD7_MC.DEF with it.
definitions-reset = Then trigger an NC reset and read the user data back in.
definitions-older = Up to measuring cycles 6.02.16 the lines of GUD7_MC.DEF belong to GUD7.DEF.
definitions-enter = Before measuring in JOG, enter the sizes of each tool probe; otherwise alarm 61230 follows: { $names }
definitions-program = { $channels ->
    [one] Then load { $name } and run it once in AUTOMATIC.
   *[other] Then load { $name } and run it once in AUTOMATIC in each channel that measures: many of the data belong to the channel.
  } Calibrate the probes afterwards.
definitions-read = { $read ->
    [one] One value read
   *[other] { $read } values read
  }, { $changed } changed, { $problems } not accepted.
definitions-other-channel = { $count ->
    [one] One value is not read
   *[other] { $count } values are not read
  }: only those of the first channel are.
definitions-not-there = { $count ->
    [one] The value is not read
   *[other] { $count } values, from this one on, are not read
  }: this machine does not have such data.
definitions-sizes = Sizes kept with the machine: { $names }.
definitions-read-newer = { $read ->
    [one] One value read
   *[other] { $read } values read
  }, { $changed } changed, { $problems } not accepted. They are setting data: the machine is now of generation 3 (PW-GENERATION). For 840D sl 2.5 and 2.6 and 828D up to 4.3, choose 2.
definitions-settings = { $channels ->
    [one] Read the lines in as a start-up file, or enter the values in the machine and setting data.
   *[other] Read the lines in as a start-up file, or enter the values in the machine and setting data; those behind CHANDATA(1) in each channel that measures.
  } Calibrate the probes afterwards.
definitions-channels = A control has 1 to { $most } channels.
