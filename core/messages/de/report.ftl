# Sätze der erzeugten Seiten in docs/; Zyklen, Alarme und Daten auf diesen Seiten haben eigene Texte.

report-alarms = Alarme und Meldungen
report-generated = Aus dem Katalog erzeugt; nicht bearbeiten.
report-known-simulated = Maske, Prüfung, Programmtext und Simulation.
report-known-passed = Maske, Prüfung und Programmtext; nicht simuliert: Der Lauf geht ohne diesen Aufruf weiter.
report-known-stops = Maske, Prüfung und Programmtext; nicht simuliert: Der Lauf hält am Aufruf an.
report-default-machine = wie an der Maschine
report-machine = Daten der Maschine
report-machine-intro = SINUMERIK: Anwendervariablen der Bausteine GUD5, GUD6 und GUD7 und die Maschinendaten, von denen die Messzyklen abhängen. NCT, am Ende: Variablen und Parameter der Messmakros. Erzeugt aus den Tabellen in `core/src/control`; nicht bearbeiten.
report-own-setting = keiner: eine Einstellung von Probewright
report-unit-active = mm oder inch, aktives Maßsystem
report-unit-basic = mm oder inch, Grundsystem
report-feed-basic = mm/min oder inch/min, Grundsystem
report-speed-basic = m/min oder ft/min, Grundsystem

# Das Terminalprogramm selbst: was es zu falscher Bedienung sagt, und Namen dessen, was es ausgibt.

terminal-error = Fehler
terminal-language = Es gibt keine Sprache { $code }, nur { $known }
terminal-cycle = Es gibt keinen Zyklus { $name }; „probewright cycles“ listet alle auf
terminal-variant = { $cycle } hat keine Variante { $number }
terminal-parameter = { $cycle } hat keinen Parameter { $name }
terminal-twice = { $name } ist zweimal angegeben
terminal-pair = Nicht in der Form NAME=WERT: { $text }
terminal-alarm = Es gibt keinen Alarm und keine Meldung { $name }
terminal-name = Kein Zyklus, kein Datum, keine Meldung und kein Alarm hat diesen Namen: { $name }
terminal-large = größer als { $most } MB
terminal-text = kein Text in UTF-8
terminal-surface = Das Setup enthält keine Freiformfläche, die ersetzt werden könnte
terminal-more = { $count } weitere Meldungen
terminal-told-cause = Ursache
terminal-told-cure = Abhilfe
terminal-told-effect = Wirkung
terminal-told-sources = Quelle
terminal-told-found = erkannt
terminal-told-source = Fundstelle
