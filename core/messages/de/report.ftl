# Sätze der erzeugten Seiten in docs/; Zyklen, Alarme und Daten auf diesen Seiten haben eigene Texte.

report-alarms = Alarme und Meldungen
report-generated = Aus dem Katalog erzeugt; nicht bearbeiten.
report-known-simulated = Maske, Prüfung, Programmtext und Simulation.
report-known-stops = Maske, Prüfung und Programmtext; nicht simuliert: Der Lauf hält am Aufruf an.
report-default-machine = wie an der Maschine
report-around = Bausteine um einen Messaufruf
report-around-intro = Was ein Betrieb von Hand um eine Messung schreibt. `probewright write` fügt einen Baustein mit `--around NAME` hinzu und setzt seine Felder mit `--around NAME.FELD=WERT`; die Seite hat sie in der Maske. Sprungmarken beginnen mit PW; Sprungmarken und Variablen sind solche, die das Programm nicht verwendet.
report-jog = Messen in JOG
report-jog-intro = Die Masken des Messens in JOG: was jede misst, wo der Messtaster vor NC-Start steht, was geschrieben wird, und ihre Felder mit den Namen für ein Skript von `probewright jog`. Die Achsen sind die von G17.
report-jog-mask = Im Skript: { $mask }. Quelle: { $source }.
report-jog-results = Ergebnisse: { $names }.
report-jog-older = Bis Messzyklen SW 6.2
report-jog-older-intro = Diese Masken gibt es mit `PW-JOG` = 1 in den Maschinendaten, statt der obigen außer Werkzeug messen.
report-machine = Maschinendaten
report-machine-intro = SINUMERIK: Anwendervariablen der Datenbausteine GUD5, GUD6 und GUD7 und die Maschinendaten, von denen die Messzyklen abhängen. NCT, am Ende: Variablen und Parameter der Messmakros. Erzeugt aus den Tabellen in `core/src/control`; nicht bearbeiten.
report-own-setting = keiner: eine Einstellung von Probewright
report-unit-active = mm oder inch, aktives Maßsystem
report-unit-basic = mm oder inch, Grundsystem
report-feed-basic = mm/min oder in/min, Grundsystem
report-speed-basic = m/min oder ft/min, Grundsystem
report-alarms-raised = Alarme
report-always = immer
report-and = und
report-between = { $from } bis { $to }
report-every-variant = Alle Messvarianten
report-about = Hilfe
report-of-channel = Kanal
report-of-control = Steuerung
report-optional = optional
report-optional-when = optional bei { $condition }
report-or = oder
report-parameters = Parameter
report-raised = Auslöser: { $cycles }. Erkannt: { $found }. Quelle: { $source }.
report-required = erforderlich
report-required-when = erforderlich bei { $condition }
report-results = Ergebnisse
report-source = Quelle: { $source }.
report-standard = { $old }; { $new } ab NCK 63
report-unit-rpm = 1/min
report-variants = Messvarianten
report-when-digit = { $place }. Stelle von `{ $param }` ∈ { $numbers }
report-when-given = Angabe von `{ $param }`
report-when-not = nicht ({ $condition })
report-when-tool = Werkzeugtyp { $from } bis { $to }
report-when-variant = Messvariante ∈ { $numbers }
report-column-block = Datenbaustein
report-column-bounds = Grenzen
report-column-called = Aufruf
report-column-cure = Abhilfe
report-column-cycles = Zyklen
report-column-datum = Variable
report-column-default = Vorbesetzung
report-column-effective = wirksam
report-column-jog = JOG
report-column-meaning = Bedeutung
report-column-measures = misst
report-column-name = Name
report-column-need = nötig
report-column-number = Nummer
report-column-range = Bereich
report-column-source = Quelle
report-column-standard = Vorbesetzung
report-column-type = Typ
report-column-unit = Einheit
report-column-used = hier verwendet
report-column-when = wann


# Das Terminalprogramm selbst: was es zu falscher Bedienung sagt, und Namen dessen, was es ausgibt.

terminal-error = Fehler
terminal-language = Es gibt keine Sprache { $code }, nur { $known }
terminal-cycle = Es gibt keinen Zyklus { $name }; „probewright cycles“ listet alle auf
terminal-variant = { $cycle } hat keine Messvariante { $number }
terminal-parameter = { $cycle } hat keinen Parameter { $name }
terminal-twice = { $name } ist zweimal angegeben
terminal-around = { $cycle } hat hier keinen Baustein { $name }; es gibt: { $known }
terminal-around-field = Baustein { $name } hat kein Feld { $field }
terminal-around-problem = { $name }: { $problem }
terminal-pair = Nicht in der Form NAME=WERT: { $text }
terminal-alarm = Es gibt keinen Alarm und keine Meldung { $name }
terminal-name = Kein Zyklus, keine Variable, keine Meldung und kein Alarm hat diesen Namen: { $name }
terminal-large = größer als { $most } MB
terminal-text = kein Text in UTF-8
terminal-surface = Die Maschineneinrichtung enthält keine Freiformfläche, die ersetzt werden könnte
terminal-more = Weitere Meldungen: { $count }
terminal-raised = Alarm { $alarm }
terminal-log = Ausgabe
terminal-log-left = Datei { $name }, Zeilen: { $lines }; --log ORDNER speichert sie
terminal-log-written = Datei geschrieben: { $path }, Zeilen: { $lines }
terminal-log-exists = { $path } ist schon vorhanden und wurde nicht überschrieben: Datei löschen oder anderen Ordner angeben
terminal-told-cause = Ursache
terminal-told-cure = Abhilfe
terminal-told-effect = Wirkung
terminal-told-sources = Auslöser
terminal-told-found = erkannt
terminal-told-source = Quelle

# Help pages of the terminal program and what it says about wrong arguments; names of its files stay.

terminal-usage = Aufruf
terminal-any-options = [OPTIONEN]
terminal-commands = Befehle
terminal-arguments = Argumente
terminal-options = Optionen
terminal-probewright-about = Programmierhilfe für CNC-Messzyklen
terminal-cycles-about = Messzyklen und Messmakros auflisten
terminal-explain-about = Zyklus, Maske des Messens in JOG, Alarm, Meldung, Parameter, Ergebnis oder Variable der Maschine erklären, zum Beispiel CYCLE977, set_edge, 61303, PW135 oder _SZA
terminal-alarms-about = Bedeutung und Abhilfe eines Alarms anzeigen; ohne Nummer alle Alarme auflisten
terminal-check-about = Teileprogramme prüfen; Rückgabewert 1 bei einem Fehler, 2 bei einer nicht lesbaren Datei
terminal-write-about = Programmtext eines Aufrufs auf die Standardausgabe schreiben
terminal-read-about = Messaufrufe eines Teileprogramms auflisten
terminal-run-about = Teileprogramm simulieren; Rückgabewert 1 bei einem Fehler oder wenn es nicht bis zum Ende läuft
terminal-test-about = Szenarien ausführen: Programme mit ihrer Maschine und dem erwarteten Ergebnis; Exit-Status 1, wenn ein Fall scheitert
terminal-jog-about = Eine Sitzung Messen in JOG aus einem Skript ausführen; Rückgabewert 1, wenn eine Zeile abgelehnt oder ein Alarm ausgelöst wird
terminal-help-about = Hilfe zu einem Befehl anzeigen
terminal-lang-text = Sprache der Ausgabe, zum Beispiel de; Vorbesetzung: Sprache der Umgebung, sonst Englisch
terminal-json-text = Ausgabe als JSON
terminal-cycles-json-text = Ausgabe als JSON, mit Messvarianten, Parametern und Ergebnissen
terminal-check-json-text = Ausgabe als JSON: Meldungen zu jeder Datei
terminal-name-text = Name oder Nummer
terminal-variant-text = Messvariante des Zyklus, zum Beispiel 101: zeigt ihre Hilfeseite
terminal-number-text = Nummer, zum Beispiel 61303, oder Meldung einer NCT-Steuerung, zum Beispiel „PROBE FAIL“
terminal-files-text = Teileprogramme
terminal-file-text = Teileprogramm
terminal-control-text = Steuerung: sinumerik (840D, 840Di, 810D) oder nct; ohne Angabe am Programm erkannt
terminal-setup-text = Datei mit der Maschineneinrichtung, siehe docs/setup.schema.json; ohne Angabe wird eine Maschine angenommen und gemeldet, die zum Programm passt
terminal-with-text = Definitionsdateien (.DEF) und Unterprogramme, die zum Programm gehören, oder ein Ordner damit
terminal-program-text = Programm des Textes, das läuft, mit seinem Namen; ohne Angabe das erste
terminal-arg-text = Wert für einen Parameter des Programms selbst, zum Beispiel DEPTH=5
terminal-screens-text = Messergebnisbild jedes Aufrufs ausgeben, der eines zeigt (_CHBIT[10])
terminal-strict-text = Anhalten, wenn ein Unterprogramm oder ein Wert der Maschine fehlt
terminal-max-blocks-text = Abbruch nach so vielen Sätzen; lange Sätze, Felder und Bewegungen in Schleifen zählen mehrfach
terminal-assumed-values = Angenommene Werte der Maschine: { $values }. In Klammern die Zeilennummern.
terminal-progress = { $share } %, { $blocks } Sätze
terminal-test-passed = ok
terminal-test-failed = FEHLER
terminal-test-held = Bestanden: { $good } von { $count }
terminal-test-none = in diesem Ordner liegen weder scenario.json noch Dateien mit der Endung .scenario.json
terminal-check-setup-text = Datei mit der Maschineneinrichtung, mit Werkzeugen und Daten; ohne Angabe die Standardmaschine
terminal-cycle-text = Name des Zyklus, zum Beispiel CYCLE977
terminal-values-text = Werte, zum Beispiel _SETVAL=132
terminal-comments-text = Zu jedem Parameter eine Kommentarzeile schreiben
terminal-around-text = Baustein um den Aufruf: NAME, seine Felder als NAME.FELD=WERT; mehrfach möglich (siehe docs/de/around.md)
terminal-style-text = Schreibweise: direct (Zuweisungen, dann der Aufruf; Vorbesetzung), indirect (CYCLE_PARA und Parametrieraufruf), operate (Argumentliste neuerer Steuerungen)
terminal-print-text = Datei für den Ausdruck: was die Adressen V und W der NCT-Makros drucken
terminal-log-text = Ordner für Messprotokolle und für Dateien, die das Programm schreibt; vorhandene Dateien werden nicht überschrieben
terminal-record-text = Datei für das Protokoll aller Messungen: Tabelle (.csv) oder Dokument (.json, siehe docs/record.schema.json)
terminal-record-ending = das Protokoll wird als .csv oder .json geschrieben: eine dieser Endungen wählen
terminal-measured-text = Protokoll einer wirklichen Maschine: Messprotokoll der Steuerung oder Tabelle; die Werte werden den Aufrufen des Programms zugeordnet, und --record schreibt das Protokoll aus ihnen
terminal-columns-text = Spalten dieser Tabelle, zum Beispiel actual=Istmaß nominal=3; Namen: number, line, result, nominal, actual, deviation
terminal-column = keine Spalte eines Protokolls: { $text }; zum Beispiel actual=3
terminal-surface-text = Fläche statt der in der Maschineneinrichtung, in derselben Größe: PNG-Bild (Weiß ist am höchsten), dome, waves, saddle oder step; eine STL-Datei behält ihre Größe
terminal-scan-nc-text = Datei für die Ausgabe des Digitalisierens: das NC-Programm
terminal-scan-xyz-text = Datei für die Punkte, als Zeilen X Y Z in mm
terminal-scan-surface-text = Datei für die Punkte der Fläche, als Zeilen X Y Z in mm: ohne den Kugelradius
terminal-script-text = Skript: eine Zeile je Taste, Wert oder Bewegung, zum Beispiel „mask set_edge“, „zo = G54“, „move X-20 Y10“, „start“
terminal-jog-setup-text = Datei mit der Maschineneinrichtung, mit Messtaster, Werkstück und NV, siehe docs/setup.schema.json
terminal-random-text = Werkstück zufällig legen: verschoben, gedreht, in anderer Größe; dieselbe Zahl ergibt dasselbe Werkstück
terminal-what-if-text = Auch sagen, was die nächste Taste, NC-Start oder Berechnen, am Ende des Skripts täte
terminal-masks-text = Masken mit ihren Feldern auflisten, und was diese annehmen
terminal-scenarios-text = Szenariodateien oder Ordner: aus diesen jede scenario.json und jede Datei mit der Endung .scenario.json
terminal-junit-text = Datei für das Ergebnis als JUnit-XML
terminal-as-program-text = Den automatischen Zyklus ausgeben, der dasselbe macht wie die offene Maske, und was anders ist
terminal-help-text = Hilfe anzeigen
terminal-version-text = Version anzeigen
terminal-value-command = BEFEHL
terminal-value-lang = SPRACHE
terminal-value-folder = ORDNER
terminal-value-name = NAME
terminal-value-columns = SPALTEN
terminal-value-variant = MESSVARIANTE
terminal-value-number = NUMMER
terminal-value-files = DATEIEN
terminal-value-file = DATEI
terminal-value-control = STEUERUNG
terminal-value-setup = DATEI
terminal-value-cycle = ZYKLUS
terminal-value-values = WERTE
terminal-value-around = NAME[.FELD=WERT]
terminal-value-style = SCHREIBWEISE
terminal-value-scenarios = SZENARIEN
terminal-value-script = SKRIPT
terminal-value-random = ZAHL
terminal-wrong-argument = Es gibt kein Argument { $name }
terminal-wrong-command = Es gibt keinen Befehl { $name }
terminal-wrong-none = Ein Befehl fehlt
terminal-wrong-value = { $name }: „{ $value }“ ist unzulässig; zulässig: { $known }
terminal-wrong-empty = Ein Wert fehlt: { $name }
terminal-wrong-number = „{ $value }“ ist keine Zahl: { $name }
terminal-wrong-missing = Es fehlt: { $name }
terminal-wrong-conflict = { $name } und { $other } schließen einander aus
terminal-wrong-similar = Ähnlich: { $known }
terminal-wrong-more = Hilfe: --help
