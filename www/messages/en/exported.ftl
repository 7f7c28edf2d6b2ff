# The check of a machine by what its control exported.

exported-intro = Paste or drop what the control exports: machine data (.TEA, INITIAL.INI), definition files, the text of a series archive. Or type lines such as MD 18120 = 30. Nothing leaves this browser.
exported-text = Export of the control
exported-open = Open files
exported-remove = Remove { $name }
exported-has = This machine has
exported-jog = Measuring in JOG
exported-log = Logging
exported-tool-probe = Tool probe
exported-large = NCU 3
exported-error = Errors: { $count }
exported-warning = Warnings: { $count }
exported-note = Notes: { $count }
exported-clean = Nothing is missing in the data that were compared.
exported-channel = Channel { $channel }
exported-alarm = Alarm { $number }: { $text }
exported-limit-error = Required: { $value }
exported-limit-warning = Recommended: { $value }
exported-limit-note = Suggested: { $value }
exported-default = Default: { $value }
exported-place = { $file }, line { $line }
exported-missing = Needed, but not in this export: { $count }
exported-more = Not shown: { $count }
exported-save = Save lines to change
exported-print = Print
exported-close = Close
exported-too-large = The files are larger than { $most } MB: choose machine data and definition files only.
exported-braking = Braking path
exported-deflection = Permitted deflection of the probe, mm
exported-delay = Time from signal to braking, s (MD 10050 × MD 10070)
exported-acceleration = Lowest deceleration, m/s² (MD 32300)
exported-gain = Lowest servo gain Kv, (m/min)/mm (MD 32200)
exported-feed = Feed, mm/min
