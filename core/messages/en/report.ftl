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
