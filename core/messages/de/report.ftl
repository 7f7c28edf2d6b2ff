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
