# Commissioning, step by step.
steps-path = Maschine
steps-done = { $done } von { $all } erledigt
steps-if = Wann
steps-check = Prüfung
steps-softkeys = Softkeys und Zeilen
steps-files = Dateien
steps-versions = Versionen
steps-versions-title = Versionen, die zusammenarbeiten
steps-connections = Anschlüsse der Messtaster
steps-print = Drucken
steps-reset = Neu beginnen
