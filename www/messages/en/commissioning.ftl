# Commissioning, step by step.
steps-path = Machine
steps-done = { $done } of { $all } done
steps-if = Do when
steps-check = Check
steps-softkeys = Softkeys and lines
steps-files = Files
steps-versions = Versions
steps-versions-title = Versions that work together
steps-connections = Connections of probes
steps-print = Print
steps-reset = Start again
