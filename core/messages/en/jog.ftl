# Measuring in JOG: masks, fields, results, what is refused. The words are those of the masks of the control.

jog-mask-set-edge = Set edge
jog-mask-align-edge = Align edge
jog-mask-distance = Distance of 2 edges
jog-mask-corner-right = Right-angled corner
jog-mask-corner-any = Any corner
jog-mask-pocket-rect = Rectangular pocket
jog-mask-hole-1 = 1 hole
jog-mask-spigot-rect = Rectangular spigot
jog-mask-spigot-1 = 1 circular spigot
jog-mask-holes-2 = 2 holes
jog-mask-spigots-2 = 2 circular spigots
jog-mask-holes-3 = 3 holes
jog-mask-spigots-3 = 3 circular spigots
jog-mask-holes-4 = 4 holes
jog-mask-spigots-4 = 4 circular spigots
jog-mask-align-plane = Align plane
jog-mask-cal-length = Calibrate probe, length
jog-mask-cal-radius = Calibrate probe, radius
jog-mask-tool-cal = Calibrate tool probe
jog-mask-tool-length = Measure tool, length
jog-mask-tool-radius = Measure tool, radius

jog-field-zo = Zero offset
jog-field-direction = Measuring direction
jog-field-direction-2 = Measuring direction at P2
jog-field-axis = Measuring axis
jog-field-ref-axis = Reference axis
jog-field-angle-offset = Angle offset
jog-field-spec-angle = Set angle
jog-field-corner = Corner
jog-field-pos = Position
jog-field-l = Length L
jog-field-w = Width W
jog-field-diameter = Diameter
jog-field-contact-angle = Contact angle
jog-field-dz = Infeed D{ $axis }
jog-field-x0 = { $axis }0
jog-field-y0 = { $axis }0
jog-field-x1 = { $axis }1
jog-field-y1 = { $axis }1
jog-field-z0 = { $axis }0
jog-field-d = Diameter of the ring
jog-field-set-p1 = Set P1
jog-field-cal-kind = Calibrate
jog-field-v = Offset V
jog-field-activate = Activate this zero offset?
jog-field-position-axis = Position the rotary axis?

jog-result-meas-x0 = Measured { $axis }0
jog-result-meas-y0 = Measured { $axis }0
jog-result-meas-l = Measured L
jog-result-meas-w = Measured W
jog-result-diameter = Measured diameter
jog-result-alpha = Angle α
jog-result-beta = Angle β

jog-line-inactive = { $offset } was corrected, but it is not active.
jog-line-tilted = The new WCS has a new orientation.
jog-line-turned = The workpiece is rotated about the tool axis. Take care when you move in the WCS.
jog-line-rotary = The zero offset of rotary axis { $axis } was corrected. The part is aligned once the axis has moved.
jog-line-start = Press NC start to activate.

jog-state-menu = No mask is open.
jog-state-mask = The mask { $mask } is open.
jog-state-ready = All points are stored. Press Calculate.
jog-state-busy = A measurement is running.
jog-state-activate = The activation screen waits for NC start.
jog-state-moving = The activation is running.
jog-state-alarm = An alarm is pending. Press RESET.

jog-refused = This key has no effect in this state.
jog-mode = The mode cannot be changed here. Leave the mask with << first.
jog-open = A mask is open. Leave it with << first.
jog-pending = An alarm is pending. Acknowledge it with RESET first.
jog-no-mask = No mask is open. Open one first, for example with “mask set_edge”.
jog-all-stored = All points are stored. Press Calculate, or reject a point to measure it again.
jog-missing = Points are missing: { $points }. Measure them with NC start first.
jog-at-once = This mask measures and calculates with NC start alone. Press NC start.
jog-grey = { $point } is not stored, so it cannot be rejected.
jog-nothing-to-activate = There is nothing to activate. The zero offset is active already, or nothing was corrected.
jog-no-jog = This control has no measuring in JOG. Use a setup of a SINUMERIK control.
jog-no-function = There is no mask { $name }. Available: { $known }.
jog-no-field = The mask has no field { $field } now. Available: { $known }.
jog-no-tool = There is no tool T{ $tool } with D{ $edge }. Enter it in the tools of the setup.
jog-no-datum = The control has no data item { $name }. Check the name and the index.
jog-wrong-number = { $field } is not a number: { $text }. Enter a number, for example 12.5.
jog-wrong-far = { $field } cannot be { $value }. Enter a value up to { $limit }.
jog-wrong-above = { $field } cannot be { $value }. Enter a value above 0.
jog-wrong-below = { $field } cannot be { $value }. Enter 0 or a value above 0.
jog-wrong-word = { $field } cannot be { $text }. Enter one of: { $known }.
jog-ball = The probe ball, { $value } mm, does not fit inside. Check the size in the mask.
jog-same-place = Both points lie at the same place of the reference axis. Reject one and measure it further away.
jog-in-line = The three points are collinear, or the plane is upright. Reject one and measure it elsewhere.

jog-script-command = There is no command “{ $text }”.
jog-script-command-hint = Use one of: { $known }, or enter a field as NAME = VALUE.
jog-script-alone = “{ $word }” takes no value: { $text }
jog-script-alone-hint = Write “{ $word }” alone in its line.
jog-script-move = Not a position of an axis: { $text }
jog-script-move-hint = Write axes with numbers, for example “move X10 Y-5.5”.
jog-script-point = Not a point: { $text }
jog-script-point-hint = Write P1, P2, P3 or P4.
jog-script-plc = Not a bit of the PLC: { $text }
jog-script-plc-hint = Write the point and its state, for example “plc P2 on”.
jog-script-tool = Not a tool: { $text }
jog-script-tool-hint = Write the T and D number, for example “tool T9 D1”.
jog-script-set = Not a data item with a value: { $text }
jog-script-set-hint = Write the name and the value, for example “set _JM_I[4] = 1”.
jog-script-long = The script has more than { $limit } lines.
jog-script-long-hint = Split it into several scripts.

jog-point = { $point }: { $place }
jog-offset-active = Active: { $offset }
jog-truth = The part was placed by seed { $seed }: moved by X { $x }, Y { $y }, Z { $z } mm; rotated by X { $a }, Y { $b }, Z { $c }°; oversize { $size } mm.
jog-takes = { $label } ({ $name })
jog-takes-one-of = { $label } ({ $name }): { $words }

jog-area-edge = Edge
jog-area-corner = Corner
jog-area-hole = Pocket/hole
jog-area-spigot = Spigot
jog-area-plane = Align plane
jog-area-calibrate = Calibrate probe
jog-area-tool = Measure tool

jog-word-none = Measuring only
jog-word-rotation = Coordinate rotation
jog-word-yes = Yes
jog-word-no = No
jog-word-outside = Outside
jog-word-inside = Inside
jog-word-length = Length only
jog-word-length-and-diameter = Length and diameter

jog-show-translation = Translation
jog-show-rotation = Rotation
jog-show-turned = Rotary axis
jog-show-measuring = Active while measuring

jog-crash-hint = Move the axis back in the opposite direction, then approach with a smaller increment.
