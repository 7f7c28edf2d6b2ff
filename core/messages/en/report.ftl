# Sentences of the generated pages in docs/; the cycles, alarms and data on them have words of their own.

report-alarms = Alarms and messages
report-generated = Generated from the catalogue; do not edit.
report-known-simulated = Form, checks, program text and simulation.
report-known-passed = Form, checks and program text; not simulated, a run continues without it.
report-known-stops = Form, checks and program text; not simulated, a run stops at the call.
report-default-machine = as on the machine
report-machine = Machine data
report-machine-intro = SINUMERIK: user data of the blocks GUD5, GUD6 and GUD7 and the machine data that measuring cycles depend on. NCT, at the end: variables and parameters of the probing macros. Generated from the tables in `core/src/control`; do not edit.
report-own-setting = none: a setting of Probewright
report-unit-active = mm or inch, active
report-unit-basic = mm or inch, basic
report-feed-basic = mm/min or in/min, basic
report-speed-basic = m/min or ft/min, basic

# The terminal program itself: what it says about a wrong use, and names of what it prints.

terminal-error = error
terminal-language = there is no language { $code }; there are { $known }
terminal-cycle = there is no cycle { $name }; “probewright cycles” lists them
terminal-variant = { $cycle } has no variant { $number }
terminal-parameter = { $cycle } has no parameter { $name }
terminal-twice = { $name } is given twice
terminal-pair = not NAME=VALUE: { $text }
terminal-alarm = there is no alarm or message { $name }
terminal-name = no cycle, datum, finding or alarm has this name: { $name }
terminal-large = larger than { $most } MB
terminal-text = not UTF-8 text
terminal-surface = the setup has no free surface that could be replaced
terminal-more = { $count } more findings
terminal-told-cause = cause
terminal-told-cure = cure
terminal-told-effect = effect
terminal-told-sources = raised by
terminal-told-found = found
terminal-told-source = source
