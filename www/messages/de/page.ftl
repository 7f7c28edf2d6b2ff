# Texte der Seite selbst. Die Texte des Kerns stehen in core/messages/.

app-name = Probewright
panels = Bereiche
panel-tasks = Aufgaben
panel-form = Maske
panel-program = Programm
panel-view = 3D-Ansicht
panel-results = Ergebnis
panel-help = Hilfe
panel-more = Mehr
splitter-form = Breite der Maske
splitter-dock = Höhe von Programm und Ergebnis
splitter-program = Breite des Programms
splitter-help = Ziehen ändert die Größe, Doppelklick maximiert oder stellt wieder her.
sheet = Programm und Ergebnis
sheet-help = Ziehen oder Pfeiltasten: Streifen, halb oder ganz hoch.
sheet-up = Vergrößern
sheet-down = Verkleinern
sheet-peek = Streifen
sheet-half = Halb
sheet-full = Ganz
skip = Springen
skip-to = Gehe zu: { $panel }

control-sinumerik = SINUMERIK
control-nct = NCT

unit-mm = mm
unit-inch = inch
unit-deg = °
unit-mm-per-min = mm/min
unit-inch-per-min = in/min
unit-m-per-min = m/min
unit-ft-per-min = ft/min
unit-rpm = 1/min
unit-percent = %
unit-kb = KB
unit-s = s
unit-hex = hex

facts = Maschine
machine = Maschine am Programmanfang
machine-all-data = (auch Vorschübe und Daten)
machine-at-call = Beim Aufruf: { $functions }
plane-g17 = X Y
plane-g18 = Z X
plane-g19 = Y Z
fact-control = Steuerung
fact-built = { $control }, Grundsystem { $unit }
fact-unit = Maßeinheit
fact-plane = Ebene
fact-tool = Werkzeug
fact-probe = Messtaster
fact-ball = Kugel Ø { $diameter } { $unit }
fact-calibration = Kalibrierung
fact-true = passt zum Messtaster
fact-deviates = weicht vom Messtaster ab

list-pair = { $one }, { $other }
machine-data-title = Maschinendaten
machine-data-basic = Grundsystem
machine-data-basic-help = Einheit der Maschinendaten und, bei manchen G-Funktionen, der Vorschübe. Umstellen rechnet die Maschinendaten um; Zahlen in Masken und Programmen bleiben gleich.
machine-data-search = Maschinendaten suchen
machine-data-search-hint = Name oder Wörter, zum Beispiel _WP oder Vorschub
machine-data-changed = Nur geänderte Daten
machine-data-count = { $changed } von { $all } geändert
machine-data-group-changed = { $changed } geändert
machine-data-none = Nichts gefunden. Weniger Wörter eingeben oder alle Daten zeigen.
machine-data-nothing = Für diese Steuerung sind keine Maschinendaten einzustellen.
machine-data-delivered = { $value } (Vorbesetzung)
machine-data-assignments = Als Programm kopieren
definitions-title = Definitionsdateien, Wertebelegung
exported-title = Maschine prüfen
repeat-title = Messtaster testen: Wiederholgenauigkeit
user-program-title = Zeilen um Messzyklen (CYCLE198, CYCLE199)
machine-data-reset = Alles auf Vorbesetzung
machine-data-close = Fertig
machine-data-idle = In der Simulation ohne Wirkung.

link-copy = Link kopieren
theme-system = Farben: System
theme-light = Farben: hell
theme-dark = Farben: dunkel
theme-contrast = Farben: hoher Kontrast
menu = Menü
handbook-open = Handbuch
about-open = Info

tasks-title = Messaufgabe
search-open = Suchen
tasks-search = Zyklen, Parameter, Ergebnisse und Alarme suchen
tasks-search-hint = Zyklus, Alarm, Wörter
tasks-coming = Weitere Zyklen werden geladen …
tasks-absent = Die anderen Zyklen ließen sich nicht laden. Seite neu laden, um es erneut zu versuchen.
tasks-none = Nichts gefunden für „{ $search }“. Anderes Wort oder die Nummer eines Zyklus oder Alarms eingeben.

form-opened = Bearbeitet { $cycle } im Programm, Zeile { $from } bis { $to }
form-opened-line = Bearbeitet { $cycle } im Programm, Zeile { $line }
explain-more = Mehr
explain-concept = Konzept
explain-concept-hint = Konzept erklären
explain-less = Weniger

help-open = Hilfe
help-title = { $cycle } · { $name }
help-close = Schließen
help-coming = Hilfeseite wird geladen …
help-absent = Die Hilfeseite ließ sich nicht laden. Schließen und erneut öffnen, um es noch einmal zu versuchen.
help-no-variant = Die Hilfeseite hängt von der Messvariante ab: Messvariante in der Maske wählen.
help-values-title = Eingaben
help-results-title = Ergebnisse ({ $count })
help-alarms-title = Mögliche Alarme ({ $count })

form-detach = Vom Programm lösen
form-check = Prüfung
form-example = Beispiel einsetzen
screen-start = NC START
screen-halt = Beim Abspielen hier anhalten
screen-open = Messergebnisbild
around-open = Um den Aufruf
around-apply = Ins Programm übernehmen
around-back = Zurück zum Programm
around-none = Zu diesem Aufruf passt kein Baustein.
around-unsuited = Passt nicht zu diesem Aufruf.
around-absent = Auf dieser Steuerung nicht möglich:
form-snippet = Programmtext
form-comments = Werte kommentieren
form-call = Aufruf
form-copy-call = Aufruf kopieren
form-more = Mehr
form-variant-open = Alle Aufgaben
form-copy = Kopieren
form-insert = Einfügen
form-complete = Vollständig
form-incomplete = Unvollständig
form-errors = { $count ->
    [one] 1 Meldung
   *[other] { $count } Meldungen
 }

field-default = Vorbesetzung { $value }
field-otherwise = sonst { $value }
field-required = Pflichtfeld: { $reason }
field-optional = Optional: { $reason }
field-source = Quelle: { $source }.
columns-list = Spalten von { $name }
columns-remove = Spalte entfernen: { $name }
columns-choice = Spalte für { $name }
columns-add = Spalte hinzufügen
columns-note = Ergebnisse heißen hier wie in den meisten Zyklen.
columns-printed = Vorschau von { $name }
columns-marked = Außerhalb einer Grenze:
choice-none = wählen …
choice-default = Vorbesetzung
choice-other = andere Zahl
choice-label = { $name }, Auswahl
severity-error = Fehler
severity-warning = Warnung
severity-note = Hinweis

picture-plane = Skizze der Messung, Blick auf die Arbeitsebene
picture-section = Skizze der Messung, Schnitt
picture-space = Räumliche Skizze, von der Seite und von oben

editor-find = Suchen
editor-replace-with = Ersetzen
editor-next = Nächste
editor-previous = Vorherige
editor-all = Alle
editor-match-case = Groß-/Kleinschreibung
editor-regexp = Regulärer Ausdruck
editor-by-word = Ganze Wörter
editor-replace = Ersetzen
editor-replace-all = Alle ersetzen
editor-close = Schließen
editor-current-match = Aktuelle Fundstelle
editor-on-line = in Zeile
editor-replaced = Fundstelle in Zeile $ ersetzt
editor-replaced-all = Ersetzte Fundstellen: $
editor-go-to-line = Gehe zu Zeile
editor-go = Los
editor-problems = Meldungen
editor-no-problems = Keine Meldungen
editor-deleted = Auswahl gelöscht
editor-control-character = Steuerzeichen

language = Sprache
notice-no-language = Die Texte dieser Sprache ließen sich nicht laden.

program-title = Programm
program-loading = Der Editor wird geladen …
program-editor = Teileprogramm
program-calls = Messaufrufe im Programm
program-call-count = { $count ->
    [one] 1 Aufruf
   *[other] { $count } Aufrufe
 }
program-call-line = Zeile { $line }
program-no-call = kein Messaufruf
program-file = Datei
program-copy-all = Programm kopieren
program-copy = Kopieren
program-open = Öffnen
program-save = Speichern
program-unsaved = Nicht in der Datei gespeichert
program-file-sinumerik = program.mpf
program-file-nct = program.nc

encoding = Zeichencodierung der Datei
encoding-read = Datei lesen als
encoding-save = Text speichern als
encoding-lacking = Zeile { $line }: „{ $character }“ gibt es in { $encoding } nicht. Das Programm lässt sich so nicht speichern.
encoding-save-as = Speichern als { $encoding }
encoding-show = Zeichen zeigen
encoding-utf-8 = UTF-8
encoding-utf-8-marked = UTF-8 mit BOM
encoding-utf-16le = UTF-16 LE
encoding-utf-16le-marked = UTF-16 LE mit BOM
encoding-utf-16be = UTF-16 BE
encoding-utf-16be-marked = UTF-16 BE mit BOM
encoding-gbk = GBK
encoding-gb18030 = GB 18030
encoding-big5 = Big5
encoding-shift_jis = Shift JIS
encoding-euc-kr = EUC-KR
encoding-windows-1252 = Windows-1252, westeuropäisch
encoding-windows-1250 = Windows-1250, mitteleuropäisch
encoding-windows-1251 = Windows-1251, kyrillisch
encoding-latin-1 = ISO 8859-1

activity-stop = Abbrechen
activity-halt = Pause
activity-go-on = Fortsetzen
activity-again = Erneut versuchen
activity-seconds = { $seconds } s
activity-share = { $percent } %
opening-working = Programm wird geöffnet …
opening-working-on = Programm wird geöffnet ({ $size } MB) … Bis dahin bleibt das bisherige.
laying-working = Programm wird in den Editor geladen …
laying-working-on = Programm wird in den Editor geladen ({ $size } Millionen Zeichen) …
laying-stopped = Das Programm ist noch vorhanden, aber der Editor zeigt es nicht.
reading-working = Programm wird gelesen …
reading-working-on = Programm wird gelesen ({ $size } Millionen Zeichen) … Weiterschreiben ist möglich.
reading-stopped = Das Lesen wurde abgebrochen. Die Aufrufe dieses Programms sind nicht bekannt.
reading-failed = Das Programm ließ sich nicht lesen: { $why }
running-working = Programmlauf wird simuliert …
running-working-on = Programmlauf wird simuliert ({ $size } Millionen Zeichen) …
running-halted = Der Lauf ist angehalten.
running-stopped = Der Lauf wurde abgebrochen.
running-failed = Der Programmlauf ließ sich nicht simulieren: { $why }

view-title = 3D-Ansicht
view-source = Angezeigte Bewegungen
view-form = Aufruf
view-program = Programm
view-loading = Die 3D-Ansicht wird geladen …
view-failed = 3D-Ansicht lässt sich nicht starten: { $problem }
view-canvas = 3D-Darstellung der simulierten Bewegungen
view-fit = Einpassen
view-iso = Schräg
view-top = Oben
view-front = Vorne
view-right = Rechts
view-back = Hinten
view-left = Links
view-bottom = Unten
view-cube = Ansicht von
view-section = Aufschneiden
view-central = Perspektive
view-errors = Abweichungen überhöht
view-errors-most = höchstens { $times }: sonst wäre das Werkstück nicht mehr zu erkennen
view-nominal = gestrichelt: Sollform; Beschriftung und Werte sind nicht überhöht
view-diameters = Durchmesser
view-diameters-help = Durchmesser wie auf der Zeichnung: Istmaß, darunter Sollmaß und Abweichung; am Antastpunkt die Position, die die Steuerung liest. X wie an der Steuerung angezeigt. In mm.
legend = Legende
legend-measuring = Messen
legend-positioning = Positionieren
legend-rapid = Eilgang
legend-retract = Rückzug
legend-touch = Antastpunkt mit Normale
legend-swept = vom Messtaster überstrichener Raum
legend-crash = Kollision
legend-zone = Schutzzone
legend-limit = größte noch messbare Abweichung
legend-carrier = Halter: ohne Kollisionsprüfung
legend-thinned = { $drawn } von { $points } Punkten gezeichnet, gleichmäßig ausgewählt; Zahlen und Dateien enthalten alle Punkte
timeline-first = Erster Schritt
timeline-back = Schritt zurück
timeline-play = Abspielen
timeline-pause = Pause
timeline-on = Schritt vor
timeline-last = Letzter Schritt
timeline-scrub = Schritt
timeline-speed = Geschwindigkeit
timeline-seconds = { $seconds } s
timeline-times = { $times } ×
motions-running = Die Bewegungen erscheinen hier, wenn der Lauf beendet ist.
motions-none = Keine Bewegungen.
motions-block = Bewegungen { $from } bis { $to } von { $count }; die übrigen über die Zeitleiste.
motions-line = Zeile { $line }
motion-rapid = Eilgang nach { $to }
motion-positioning = Positionieren nach { $to }, F{ $feed }
motion-measuring = Messen in Richtung { $to }, F{ $feed }
motion-retract = Rückzug nach { $to }
step-touch = Antastung bei { $at }
step-touch-stylus = Berührung des Tastschafts bei { $at }
step-crash = Kollision bei { $at }
step-crash-stylus = Kollision des Tastschafts bei { $at }
step-crash-body = Kollision des Messtastergehäuses bei { $at }
step-crash-cutter = Kollision des Werkzeugs mit dem Werkstück bei { $at }
step-orient = Spindel auf { $angle }°
step-spin = Spindel { $direction }, { $speed } 1/min
step-table = Rundachse { $axis } auf { $angle }°
step-tool = Werkzeug T{ $tool } D{ $edge }
step-set = { $name }: von { $before } auf { $after }
step-call = { $cycle } beginnt, Messvariante { $variant }
step-call-only = { $cycle } beginnt
step-return = Der Zyklus endet
step-file = Datei { $name } angelegt

tab-outcome = Ergebnis
tab-problems = Meldungen
tab-problems-count = Meldungen ({ $count })
tab-motions = Bewegungen
tab-log = Protokoll
outcome-alarms = Alarme
outcome-results = Ergebnisse
outcome-changes = Korrekturen und Kalibrierdaten
outcome-decisions = Auswertung
outcome-screens = Messergebnisbilder ({ $count })
outcome-no-changes = Keine Korrektur.
outcome-not-simulated = Diese Version simuliert { $cycle } nicht. Maske, Prüfung und Programmtext sind verfügbar.
outcome-running = Die Ergebnisse des ganzen Programms erscheinen hier, wenn der Lauf beendet ist.
outcome-coming = Das Ergebnis wird berechnet …
outcome-absent = Der Rechenkern ließ sich nicht laden: Ohne ihn gibt es weder Prüfung noch Programmtext noch Ergebnis. Seite neu laden, um es erneut zu versuchen.
outcome-incomplete = Maske ausfüllen, um das Ergebnis zu sehen.
outcome-newer = Die Argumentliste dieser neueren Steuerung ist nicht vollständig bekannt: Der Aufruf wird nicht simuliert.
outcome-missing = Das Ergebnis erscheint hier, sobald diese Angaben stimmen: { $names }
outcome-earlier = nicht von diesem Aufruf geschrieben
outcome-assumed = Diese Werte hängen vom Programmablauf ab. Gerechnet wird mit den zuerst erreichten: { $values }
outcome-assumed-value = { $name } = { $value } (Zeile { $line })
outcome-unknown = Erst beim Programmlauf bekannt: { $names }. In der 3D-Ansicht das Programm laufen lassen oder eine Zahl eingeben.
column-name = Name
column-what = Größe
column-meaning = Bedeutung
column-value = Wert
column-unit = Einheit
column-before = alt
column-after = neu
column-difference = Änderung
problems-more = { $count ->
    [one] Eine weitere Meldung, im Programm markiert. Sie erscheint hier, sobald die aufgeführten behoben sind.
   *[other] { $count } weitere, im Programm markiert. Sie erscheinen hier, sobald die aufgeführten behoben sind.
}
problems-none = Keine Meldungen.
problem-place = Zeile { $line }, Spalte { $column }
log-save = Als Datei speichern
log-save-file = { $name } speichern
log-lines = { $count ->
    [one] { $shown } von { $count } Zeile
   *[other] { $shown } von { $count } Zeilen
 }
log-none = Nichts protokolliert.

sliders-open = Abweichungen
sliders-open-help = Simulierte Abweichungen von Werkstück und Messtaster
sliders-title = Simulierte Abweichungen
sliders-reset = Auf 0
sliders-part = Werkstückabweichungen
sliders-probe = Messtasterabweichungen
sliders-limits = Grenzen
sliders-limits-help = Größte Abweichungen von Werkstück oder Werkzeugmesstaster, bei denen diese Messung noch zu Ende läuft
slider-limits = −{ $low } bis +{ $high }
slider-figure = { $name }, Zahlenwert
error-part-size = Maß
error-part-dx = Verschiebung X
error-part-dy = Verschiebung Y
error-part-dz = Verschiebung Z
error-part-tilt = Winkel
error-part-taper = Konizität
error-part-out-of-round = Unrundheit
sliders-tool-part = Abweichungen des Werkzeugmesstasters
sliders-tool-probe = Abweichungen von Werkzeug und Signal
error-tool-probe-skew-x = Länge L1
error-tool-probe-skew-y = Länge L2
error-tool-probe-radius = Werkzeugradius
error-probe-skew-x = Lage­abweichung { $axis }
error-probe-skew-y = Lage­abweichung { $axis }
error-probe-radius = Kugelradius
error-probe-pre-travel = Schaltweg
error-probe-repeatability = Wiederholgenauigkeit

notice-copied = Kopiert.
notice-inserted = Eingefügt. Die Maske bearbeitet jetzt diesen Aufruf.
notice-link-long = Das Programm ist zu lang für einen Link. Als Datei speichern.
notice-link = Link kopiert. Er enthält Maske, Programm, Einrichtung und Abweichungen.
notice-no-clipboard = Kein Zugriff auf die Zwischenablage. Text markieren und von Hand kopieren.
notice-not-kept = Der Browser speichert Ihre Arbeit nicht. Programm speichern.
notice-given = In der Maschine angelegt.
notice-setup = Maschineneinrichtung geöffnet.
notice-own-setup = Standardmaschine wiederhergestellt.
notice-setup-outdated = Gespeicherte Einrichtung passt nicht zu dieser Version: nicht geladen.
notice-nothing-to-save = Noch nichts zu speichern: Die Maschineneinrichtung wird geladen.
notice-opened = Programm geöffnet.
notice-opened-empty = Geöffnet: Die Datei ist leer.
notice-written = In der Datei gespeichert.
notice-denied = Der Browser darf nicht in die Datei schreiben. Als Download gespeichert.
notice-changed = Ein anderes Programm hat die Datei geändert. Als Download gespeichert.
notice-failed = Die Datei ließ sich nicht schreiben. Als Download gespeichert.
notice-example = Beispiel in die Maske eingesetzt.
notice-no-errors = Alle Abweichungen auf 0 gesetzt.
notice-set-saved = Werte gespeichert.
notice-set-replaced = Werte gespeichert; der gleichnamige Wertesatz wurde ersetzt.
notice-set-loaded = Werte geladen.
notice-set-deleted = Werte gelöscht.
notice-kept = Das Programm bleibt, wie es ist: Der Wert wurde nicht übernommen.
notice-undone = Rückgängig gemacht.
notice-redone = Wiederhergestellt.
print-lines = { $more ->
    [one] Eine weitere Zeile ist ausgelassen. Die gespeicherte Datei enthält alle { $all }.
   *[other] { $more } weitere Zeilen sind ausgelassen. Die gespeicherte Datei enthält alle { $all }.
}
print-sheet = Einrichteblatt drucken
print-report = Bericht drucken
paper-report = Messbericht
paper-line = Zeile { $line }
paper-more = { $more ->
    [one] Ein weiterer Aufruf ist ausgelassen.
   *[other] { $more } weitere Aufrufe sind ausgelassen.
}
undo = Rückgängig
redo = Wiederherstellen
history = Verlauf
history-begin = Anfang
history-undo = Rückgängig: { $step }
history-undo-none = Nichts rückgängig zu machen
history-redo = Wiederherstellen: { $step }
history-redo-none = Nichts wiederherzustellen
step-open = { $file } öffnen
step-insert = Aufruf einfügen
step-convert = Aufruf umwandeln
step-fix = Änderung übernehmen
step-kept = { $field } = { $value } nicht übernommen
step-assign = Variable ändern
step-example = Beispiel einsetzen
step-set-load = Wertesatz laden
step-program = Zeile { $line } ändern
step-field = { $field } = { $value }
step-values = { $cycle } ändern
step-task = { $cycle } wählen
step-encoding = Zeichencodierung { $encoding }
step-errors = Abweichungen
step-machine = Maschine
step-sets = Wertesätze

refused-program-size = { $name } wurde nicht geöffnet: Die Datei hat { $size } MB, mehr als dieser Browser im Speicher halten kann. Ihr Programm ist unverändert.
refused-setup-size = { $name } wurde nicht geöffnet: Die Datei hat { $size } MB, eine Maschineneinrichtung darf höchstens { $most } MB haben. Ihre Maschineneinrichtung ist unverändert.
refused-no-program = { $name } wurde nicht geöffnet: { $why }. Ihr Programm ist unverändert.
refused-no-text = { $name } wurde nicht geöffnet: { $why }. Alles andere ist unverändert.
refused-markup = sie enthält { $kind } und kein Programm; die Programmdatei wählen
refused-no-blocks = { $name } ist geöffnet, aber keine Zeile liest sich als Satz. Vielleicht ist es kein Programm.
refused-unreadable = { $name } wurde nicht geöffnet: Der Browser kann die Datei nicht lesen. Vielleicht wurde sie inzwischen verschoben oder geändert.
refused-folder = { $name } wurde nicht geöffnet: Das ist ein Ordner ohne Dateien.
refused-setup = { $name } ist keine Maschineneinrichtung und wurde nicht geöffnet: { $why } „Einrichtung exportieren“ schreibt eine zum Vergleich. Ihre Maschineneinrichtung ist unverändert.
refused-place = Zeile { $line }, Spalte { $column }: { $text }
refused-other-control = { $name } wurde geöffnet. Es beginnt wie ein Programm für { $control }: Aufrufe für { $control } werden hier nicht gelesen.
refused-under = Unter { $control } öffnen
refused-close = Schließen

sets-open = Wertesätze …
sets-title = Wertesätze: { $cycle }
sets-name = Name
sets-save = Aktuelle Werte speichern
sets-none = Noch nichts gespeichert. Den aktuellen Werten einen Namen geben, um sie später wieder zu laden.
sets-rename = Name des Wertesatzes { $name }
sets-load = Laden
sets-load-named = { $name } laden
sets-delete = Löschen
sets-delete-named = { $name } löschen
sets-name-taken = Dieser Name ist leer oder bereits vergeben.

continuing-title = Welche Arbeit fortsetzen?
continuing-why = Probewright ist in einem weiteren Tab offen. Jeder Tab behält seine eigene Arbeit. Beim nächsten Besuch öffnet sich die zuletzt geänderte Arbeit.
continuing-copy = Kopie von { $name }, geändert { $when }
continuing-anew = Mit dem Beispiel neu anfangen

about-title = Über Probewright
about-what = Ein Assistent für CNC-Messzyklen: Maske ausfüllen, Programmtext erhalten, dem Messtaster beim Messen eines Werkstücks mit Abweichungen zusehen und lesen, was die Steuerung tun würde.
about-offline = Alles läuft in diesem Browser. Nach dem ersten Laden funktioniert Probewright auch ohne Netz.
about-prove-out = Eine Simulation ersetzt nicht das Einfahren an der Maschine. Jedes Programm dort mit verringertem Vorschub und der Hand am Override einfahren.
about-marks = SINUMERIK ist eine eingetragene Marke der Siemens AG.
about-independent = Probewright ist unabhängig von Siemens und von NCT; keine der beiden Firmen hat es geprüft oder freigegeben.
about-licence = Lizenz: MIT OR Apache-2.0, nach Ihrer Wahl.
about-close = Schließen
scenarios-open = Szenarien
scenarios-check = Installation prüfen
keys-title = Tasten
keys-close = Schließen
keys-page = Überall
keys-page-save = Programm speichern
keys-page-open = Programm öffnen
keys-page-undo = Letzten Schritt rückgängig machen
keys-page-redo = Wiederherstellen
keys-page-next-panel = Nächster Bereich
keys-page-previous-panel = Vorheriger Bereich
keys-page-keys = Diese Liste (außerhalb eines Textfelds)
keys-page-close = Hilfe, Menü oder Dialog schließen
keys-form = Maske
keys-form-next-field = Nächstes Feld; die Skizze zeigt, was es bedeutet
keys-form-previous-field = Vorheriges Feld
keys-form-ask = Zu einer vorgeschlagenen Änderung gehen
keys-form-refuse = Vorgeschlagene Änderung verwerfen
keys-list = Aufgaben, Suchergebnisse, Aufrufe
keys-list-next = Nächste Zeile
keys-list-previous = Vorherige Zeile
keys-list-next-page = Nächste Seite der Aufrufliste
keys-list-previous-page = Vorherige Seite der Aufrufliste
keys-list-first = Erste Zeile
keys-list-last = Letzte Zeile
keys-list-unfold = Aufgabe aufklappen
keys-list-fold = Aufgabe zuklappen
keys-list-choose = Auswählen
keys-list-leave = Suche leeren; von den Ergebnissen zurück zur Suche
keys-tabs = Ergebnisreiter
keys-tabs-next-tab = Nächster Reiter
keys-tabs-previous-tab = Vorheriger Reiter
keys-editor = Programmeditor
keys-editor-leave-editor = Editor verlassen
keys-editor-find = Suchen
keys-editor-next-problem = Nächste Meldung
keys-editor-problems = Alle Meldungen mit Abhilfe
keys-editor-tell = Argument am Cursor erklären
keys-editor-untell = Erklärung schließen
keys-splitter = Trenner zwischen Bereichen
keys-splitter-nearer = Nach links oder oben
keys-splitter-further = Nach rechts oder unten
keys-splitter-least = Minimale Größe
keys-splitter-most = Maximale Größe
keys-splitter-maximise = Maximieren oder wiederherstellen
keys-jog = Maschine in JOG
keys-jog-x-minus = X minus
keys-jog-x-plus = X plus
keys-jog-y-minus = Y minus
keys-jog-y-plus = Y plus
keys-jog-z-minus = Z minus
keys-jog-z-plus = Z plus
keys-jog-start = NC-Start
keys-view = 3D-Ansicht
keys-view-turn = Drehen
keys-view-shift = Verschieben
keys-view-zoom-in = Vergrößern
keys-view-zoom-out = Verkleinern
keys-view-fit = Einpassen
keys-view-top = Ansicht von oben
keys-view-front = Ansicht von vorn
keys-view-right = Ansicht von rechts
keys-view-oblique = Schräge Ansicht
key-ctrl = Strg
key-shift = Umschalt
key-enter = Eingabe
key-space = Leertaste
key-home = Pos 1
key-end = Ende
key-pageup = Bild auf
key-pagedown = Bild ab

newer-ready = Eine neue Version ist bereit. Ihre Arbeit bleibt beim Neuladen erhalten.
newer-reload = Neu laden
newer-later = Später

broken-title = Probewright läuft nicht mehr
broken-kept = Das ist ein Fehler in Probewright, nicht in Ihren Eingaben. Maske und Programm sind in diesem Browser gespeichert.
broken-reload = Neu laden

group-milling-workpiece = Fräsen: Werkstück
group-milling-tool = Fräsen: Werkzeug
group-milling-calibrate = Fräsen: Messtaster kalibrieren
group-milling-none = Fräsen: ohne Messtaster
group-milling-log = Fräsen: Messprotokoll
group-turning-workpiece = Drehen: Werkstück
group-turning-tool = Drehen: Werkzeug
group-turning-calibrate = Drehen: Messtaster kalibrieren
group-turning-none = Drehen: ohne Messtaster
group-turning-log = Drehen: Messprotokoll
group-any-workpiece = Werkstück
group-any-tool = Werkzeug
group-any-calibrate = Messtaster kalibrieren
group-any-none = Ohne Messtaster
group-any-log = Messprotokoll

found-measurement = Messungen ({ $count })
found-around = Bausteine um den Aufruf ({ $count })
found-parameter = Parameter ({ $count })
found-result = Ergebnisse ({ $count })
found-guide = Anleitungen ({ $count })
found-connection = Anschlüsse ({ $count })
found-concept = Konzepte ({ $count })
found-term = Begriffe ({ $count })
found-alarm = Alarme ({ $count })
found-elsewhere = Neuere Steuerungen, andere Hersteller ({ $count })
found-more = Weitere Treffer: { $count }. Ein zusätzliches Wort grenzt die Suche ein.

card-result = Ergebnis { $code }
card-alarm = Alarm { $code }
card-elsewhere = { $code }
card-cause = Ursache
card-cure = Abhilfe
card-result-cycles = Geliefert von
card-alarm-cycles = Gemeldet von
card-elsewhere-cycles = Aufrufe damit
card-parts = Argumente und Parameter
card-close = Schließen

twin-open = Dieselbe Aufgabe auf anderen Steuerungen
twin-task = { $task }: bei { $control } { $cycle }.
twin-shared = Was gleich ist
twin-differences = Was anders ist
twin-none = Für diese Werte haben andere Steuerungen keine entsprechende Aufgabe.

ways = Schreibweise
ways-findings = Zu dieser Schreibweise
way-direct = direkt
way-indirect = indirekt
way-operate = neuere Steuerungen
way-now = Schreibweise: { $way }
convert = Umwandeln:

call-state-ok = OK
call-state-note = OK
call-state-warning = Warnungen
call-state-error = Fehler
call-state-explained = erklärt, hat keine Maske
call-variant-unknown = Messvariante unbekannt

notice-converted = Umgewandelt.
notice-mended = Behoben.

tab-scan = Scan
view-scan = Scan
scan-surface = Fläche
scan-examples = Beispiele
scan-example-waves = Wellen
scan-example-dome = Kuppel
scan-example-saddle = Sattel
scan-example-step = Absatz
scan-open = STL oder Bild öffnen …
scan-begin = Scannen
scan-scanning-working = Fläche wird gescannt …
scan-taking-working = Punkte werden vorbereitet …
scan-taking-working-on = Punkte werden vorbereitet ({ $size } Millionen) …
scan-writing-working = Datei wird geschrieben …
scan-writing-working-on = Datei wird geschrieben ({ $size } Millionen Punkte) …
scan-none = Scannt die ganze Fläche mit den Werten der Maske. Statt des Beispiels ist eine Datei möglich: eine STL-Datei, unverändert übernommen, oder ein Bild, dessen helle Stellen hoch liegen.
scan-incomplete = Maske ausfüllen, um zu scannen.
scan-done = { $points } Punkte in { $lines } Zeilen.
scan-outdated = Die Maske wurde nach diesem Scan geändert.
scan-failed = Scannen nicht möglich: { $problem }
scan-file-size = { $name } hat { $size } MB; zulässig: höchstens { $most } MB.
scan-file-sort = { $name } ist weder eine STL-Datei noch ein Bild.
scan-deviations = Abstand von der wahren Fläche, mm
scan-points = Punkte
scan-greatest = größter
scan-mean = quadratischer Mittelwert
scan-shown-sent = Wie ausgegeben: unterster Kugelpunkt
scan-shown-surface = Kugel herausgerechnet: Fläche
scan-outside = außen
scan-level = auf der Fläche
scan-inside = innen
scan-save-program = NC-Programm speichern
scan-save-points = XYZ wie ausgegeben speichern
scan-save-surface = XYZ der Fläche speichern

form-placed = In Zeile { $line }
field-reset = { $value } ist gelöscht: Die Eingabe galt für „{ $before }“.
field-unfit = { $value } ist gelöscht: Diese Messvariante lässt den Wert nicht zu.
field-pointed = Im Programm mit Dezimalpunkt: { $value }

asks-title = { $count ->
    [one] Das ändert eine Zeile außerhalb des Aufrufs
   *[other] Das ändert { $count } Zeilen außerhalb des Aufrufs
}
asks-more = Das ändert mehr als diesen Wert
asks-show = Änderung zeigen
asks-line = Zeile { $line }
asks-before = alt
asks-after = neu
asks-apply = Übernehmen
asks-cancel = Abbrechen
notice-applied = Übernommen.
replaced-title = Im Programm steht hier { $text }, zurzeit { $worth }.
replaced-open = Im Programm steht hier { $text }.
replaced-uses = { $name } wird in { $count ->
    [one] 1 Zeile verwendet:
   *[other] { $count } Zeilen verwendet:
}
replaced-more = und { $count } weitere
replaced-assign = { $name } auf { $value } ändern
replaced-here = Nur hier ersetzen
replaced-remove = Nur hier entfernen
replaced-keep = { $text } behalten
notice-assigned = Variable geändert.
notice-revised = Der Aufruf hat jetzt eine andere Messvariante.
of-call = { $cycle }, Zeile { $line }
of-program = Vom Programm gesetzt
outcome-more = Nicht gezeigt: { $count }. Das Protokoll hat jede Messung mit ihrer Bewertung.
results-more = { $count ->
    [one] Ein weiteres Ergebnis ist nicht aufgeführt.
   *[other] { $count } weitere Ergebnisse sind nicht aufgeführt.
}
# The line that says what a call came to.
certain-value = { $value } ± { $expanded } (k = { $coverage })
certain-share = { $share } %
certain-less = < { $share } %
certain-more = > { $share } %
certain-good = gut { $share }
certain-rework = Nacharbeit { $share }
certain-scrap = Ausschuss { $share }
certain-beyond = außerhalb der Grenzen { $share }
certain-proof-good = Sicher gut.
certain-proof-undecided = Weder gut noch schlecht ist sicher.
certain-proof-bad = Sicher schlecht.
certain-largest = Größter Beitrag: { $source }, { $share }.
certain-stopped = Endet vorzeitig: { $share }.
bar-title = Ergebnis der Messung
bar-corrects = Korrigiert
bar-corrects-what = Korrigiert { $what }
bar-nothing = nichts
bar-new = neue Werte
bar-none = Das Ergebnis erscheint hier, sobald der Aufruf simuliert werden kann.
bar-unmeasured = Dieser Aufruf misst nichts und läuft bis zum Ende.
bar-gauge = { $needles }; Grenzen { $low } bis { $high }
# The worked example, told in steps.
practice-title = Messen in JOG üben
practice-lead = Messtaster von Hand verfahren, messen und die Nullpunktverschiebung schreiben, wie in JOG an der Maschine.
practice-start = Zur Maschine
practice-rail = Üben
practice-call = In JOG üben
story-title = Beispiel ausprobieren
story-lead = Ein Werkstück liegt versetzt. Messen, Nullpunktverschiebung korrigieren, nochmals messen: fünf Schritte.
story-start = Beispiel starten
story-back = Zurück
story-next = Weiter
story-leave = Verlassen
story-count = Beispiel, Schritt { $step } von { $of }
story-part = Das Werkstück liegt um X { $x } und Y { $y } mm versetzt; die Ansicht zeigt den Versatz 100-fach überhöht. Die Nullpunktverschiebung berücksichtigt das noch nicht.
story-call = Die Maske enthält den Messaufruf. Jede Eingabe schreibt ihn neu, unter der Maske und im Programm.
story-probe = Der Messtaster tastet die Bohrung an vier Punkten an, mit dem gleichen Vorschub wie an der Maschine.
story-correct = Der Zyklus korrigiert { $corrected }: Die Nullpunktverschiebung stimmt dann mit der wirklichen Lage des Werkstücks überein.
story-again = Das Programm misst mit der korrigierten Nullpunktverschiebung noch einmal. Jetzt korrigiert es: { $left }.
notice-story-left = Das Beispiel bleibt geöffnet.
# The measurements of a whole program.
whole-title = Messungen
whole-counts = { $all ->
    [one] 1 Aufruf: { $parts }
   *[other] { $all } Aufrufe: { $parts }
 }
whole-count-within = { $count } innerhalb
whole-count-beyond = { $count } außerhalb
whole-count-measured = { $count } gemessen
whole-count-missing = { $count } ohne Wert
whole-count-alarm = { $count } mit Alarm
whole-count-stopped = { $count } nicht simuliert
whole-certain = Sicherheit
whole-certain-hint = Das Programm viele Male ausführen: wie sicher jeder Wert ist und was er beweist
whole-certain-stop = Abbrechen
whole-certain-busy = Das Programm läuft viele Male: { $share } %
whole-certain-row = Zeile { $row }: { $told }
whole-certain-told = Nachweislich gut: { $good }. Weder gut noch schlecht: { $undecided }. Nachweislich schlecht: { $bad }. Aus { $runs } Läufen.
runs-open = Serie
runs-open-hint = Dieses Programm für viele Teile ausführen, mit dem, was streut.
protocol-open = Von der Maschine
protocol-open-hint = Messprotokoll der Steuerung oder Tabelle (CSV) des wirklichen Teils lesen und die Werte den Aufrufen zuordnen.
whole-worst = Schlechteste zuerst
whole-csv = CSV
whole-csv-hint = Als CSV speichern: UTF-8, Dezimalkomma, Felder durch Semikolon getrennt
whole-error = Abbruch bei { $cycle } in Zeile { $line } ({ $feature }): { $why }
whole-error-in-file = Abbruch bei { $cycle } in { $file }, Zeile { $line } ({ $feature }): { $why }
whole-number = Nr.
whole-number-name = Nummer
whole-feature = Messelement
whole-feature-name = Messelement
whole-line = Zeile
whole-line-name = Zeile
whole-nominal = Sollwert
whole-nominal-name = Sollwert
whole-actual = Istwert
whole-actual-name = Istwert
whole-limits = Grenzen
whole-limits-name = Ausnutzung der Grenzen
whole-deviation = Abweichung
whole-deviation-name = Abweichung
whole-verdict = Bewertung
whole-verdict-name = Bewertung
whole-corrects = Korrigiert
whole-corrects-name = Korrigiert
whole-used = { $share } %
whole-between = Grenzen der Abweichung: { $low } bis { $high }
whole-probe = Taster
whole-probe-name = Messtaster und seine Kalibrierung
whole-json = JSON
whole-json-hint = Als JSON sichern, wie docs/record.schema.json es beschreibt
whole-print = Protokoll drucken
whole-print-hint = Protokoll drucken oder als PDF sichern

# Die Startseite
start-place = Startseite
start-title = Was wollen Sie messen?
start-lead = Messelement auswählen, dann die Korrektur. Probewright schreibt den Aufruf und zeigt, was die Maschine tut.
start-corrects = Was wird korrigiert?
start-coming = Wird geladen …
start-open-form = Maske öffnen
start-others = Weitere Einstiege
start-program = Programm öffnen
start-drop = Programm hierherziehen
start-stays = Es bleibt auf diesem Rechner.
start-open = Öffnen
start-variants = Alle Messvarianten nach Nummer
start-recent = Zuletzt
start-counts = Aufrufe: { $calls }, Zeilen: { $lines }
start-form = { $cycle }, Maske
start-remove = { $name } aus der Liste entfernen

difference-convert = Zeile { $line }: Aufruf in „{ $way }“ umwandeln
difference-convert-all = { $count ->
    [one] Einen Aufruf in „{ $way }“ umwandeln
   *[other] { $count } Aufrufe in „{ $way }“ umwandeln
}
difference-cure = { $count ->
    [one] Eine Meldung beheben
   *[other] { $count } Meldungen beheben
}
difference-left = { $count ->
    [one] Eine Meldung dieser Art bleibt: Die vorgeschlagene Änderung allein behebt sie nicht.
   *[other] { $count } Meldungen dieser Art bleiben: Die vorgeschlagenen Änderungen allein beheben sie nicht.
}
difference-typed = { $name } auf { $value } ändern
difference-typed-several = { $count } Werte ändern
difference-summary = { $count ->
    [0] Es ändert sich nichts.
    [one] 1 Stelle im Programm ändert sich.
   *[other] { $count } Stellen im Programm ändern sich.
}
difference-values-none = Kein Wert kommt hinzu, fällt weg oder ändert sich.
difference-added = Kommt hinzu
difference-lost = Fällt weg
difference-changed = Anderer Wert
difference-findings = Zu prüfen
difference-value = { $name } = { $value }
difference-becomes = { $name } = { $before } → { $after }
difference-lines = { $count ->
    [one] Zeile { $lines }
   *[other] { $count } Aufrufe: Zeilen { $lines }
}
difference-more = { $count ->
    [one] 1 weiterer Wert
   *[other] { $count } weitere Werte
}
difference-scope = Welche Aufrufe
difference-scope-one = Dieser Aufruf
difference-scope-all = Alle { $count } Aufrufe
difference-before = Jetzt
difference-after = Danach
difference-line = Zeile
difference-list = Geänderte Zeilen
difference-gone = entfällt:
difference-came = neu:
difference-changed-from = vorher:
difference-changed-to = nachher:
difference-next = Nächste Änderung
difference-previous = Vorherige Änderung
difference-place = { $number } von { $count }
difference-further = { $count ->
    [one] Eine weitere Änderung zeigen
   *[other] { $count } weitere Änderungen zeigen
}
difference-undo = Lässt sich rückgängig machen
difference-close = Schließen
problems-cure-all = Alle { $count } dieser Art beheben …

keys-difference = Vergleich vor einer Änderung
keys-difference-apply = Übernehmen
keys-difference-cancel = Abbrechen
keys-difference-next-change = Nächste Änderung
keys-difference-previous-change = Vorherige Änderung

palette = Suchen oder ausführen
palette-hint = Befehl, Aufgabe, Zeile, Parameter …
palette-results = Suchergebnisse
palette-recent = Zuletzt benutzt
palette-command = Befehle
palette-line = Zu Zeile { $line }
palette-field = Felder dieser Maske
palette-call = Aufrufe im Programm
palette-measurement = Messaufgaben
palette-parameter = Parameter
palette-result = Ergebnisse
palette-around = Bausteine um den Aufruf
palette-guide = Anleitungen
palette-connection = Anschlüsse
palette-concept = Konzepte
palette-term = Begriffe
palette-alarm = Alarme
palette-elsewhere = Neuere Steuerungen, andere Hersteller
palette-finding = Meldungen
palette-help = Hilfeseiten
palette-datum = Anwender- und Maschinendaten
command-copy-call = Aufruf kopieren
command-copy-program = Programm kopieren
command-convert = Aufruf in „{ $way }“ umwandeln …
command-convert-all = { $count ->
    [one] Den Aufruf im Programm in „{ $way }“ umwandeln …
   *[other] Alle { $count } Aufrufe in „{ $way }“ umwandeln …
}
command-panel = Gehe zu: { $panel }
command-run-form = Diesen Aufruf simulieren
command-run-program = Ganzes Programm simulieren
command-measurements = Messungen des Programms: Protokoll, Unsicherheit, Serie, Messergebnisbilder, Werte der realen Maschine
command-print = Drucken
keys-page-palette = Suchen oder Befehl ausführen
# Sections of the form.
topic-task = Aufgabe
topic-correction = Korrektur
topic-approach = Anfahren
topic-tolerances = Toleranzen
chain-title = Grenzen auf einer Skala
chain-measured = Ist
topic-statistics = Statistik
topic-probe = Messtaster
topic-list = Argumentliste
group-more = { $count ->
    [one] 1 weiteres Feld
   *[other] { $count } weitere Felder
}
group-as-delivered = Vorbesetzung
fields-all = Alle Felder

profile-own = Standardmaschine
profile-new = Maschine 1
profile-list = Maschinenprofile
profile-edit = Maschine bearbeiten …
profile-name = Name
profile-create = Neue Maschine …
profile-copy = Duplizieren
profile-delete = Löschen
profile-export = Einrichtung exportieren
profile-import = Einrichtung importieren …
notice-profile-new = Neues Maschinenprofil.
notice-profile-deleted = Maschinenprofil gelöscht.
step-profile-delete = Maschinenprofil löschen
step-profile-name = Maschine umbenennen: { $name }
step-equip-set = { $row }: { $cell }
step-equip-use = { $row } aktivieren
step-equip-move = { $row } verschieben
step-equip-copy = { $row } duplizieren
step-equip-remove = { $row } löschen
step-equip-add-tools = Werkzeug anlegen
step-equip-add-offsets = NV anlegen
step-equip-add-part = { $shape } hinzufügen
step-equip-measured = Hinzufügen, was der Aufruf misst
equipment-title = Maschine
equipment-of = Maschine: { $name }
equipment-tab-machine = Maschine
equipment-tab-tools = Werkzeuge
equipment-tab-offsets = NV
equipment-tab-probe = Messtaster
equipment-tab-toolprobes = Werkzeugmesstaster
equipment-tab-part = Werkstück
equipment-offset = NV
equipment-actions = Aktionen
equipment-use = Aktiv
equipment-copy = Duplizieren
equipment-remove = Löschen
equipment-earlier = Nach oben
equipment-later = Nach unten
equipment-add-tools = Werkzeug anlegen
equipment-add-offsets = NV anlegen
equipment-add-part = Hinzufügen
equipment-measured = Hinzufügen, was der Aufruf misst
equipment-shape = Element
equipment-empty = Noch keine Werkzeuge. Das erste anlegen.
equipment-no-toolprobes = Noch kein Werkzeugmesstaster.
equipment-no-part = Noch kein Werkstück. Ein Element hinzufügen oder das, was der Aufruf misst.

beside-title = Dateien zum Programm
beside-add = Dateien hinzufügen
beside-add-help = Dateien hinzufügen: Unterprogramme und Definitionsdateien (.DEF), die zum Programm gehören
beside-shown = { $name } wird angezeigt
beside-show = { $name } anzeigen
beside-remove = { $name } entfernen
beside-define = Zur Maschine …
beside-line = { $file }, Zeile { $line }
beside-place = { $file }: { $place }
notice-beside = Dateien hinzugefügt.
notice-beside-removed = Datei entfernt.
notice-defined = Definitionen in die Maschine übernommen.
step-beside = Dateien zum Programm
step-given = Programmparameter
step-define = { $file } in die Maschine übernehmen
step-machine-value = { $name }
define-title = { $name } in „{ $machine }“ übernehmen?
define-what = { $count ->
    [one] Die Maschine erhält diese Definition. Sie gilt dann für jedes Programm.
   *[other] Die Maschine erhält diese { $count } Definitionen. Sie gelten dann für jedes Programm.
 }
define-nothing = Die Maschine hat diese Definitionen schon, oder die Datei enthält keine.
define-apply = In die Maschine übernehmen
define-cancel = Abbrechen
given-title = Programmlauf
given-program = Programm
given-program-first = Erstes Programm des Textes
given-strict = Anhalten, wenn etwas fehlt
given-mode = Betriebsart
given-mode-automatic = Automatik
given-mode-dry-run = Probelauf
given-mode-program-test = Programmtest
given-mode-block-search = Satzsuchlauf
given-mode-simulation = Simulation in HMI Advanced
given-mode-jobshop = Simulation in Jobshop
given-target = Satzsuchlauf bis Zeile
given-mode-dry-run-told = Messzyklen werden übersprungen; Ergebnisse behalten die Werte früherer Aufrufe. Vorschübe unter 5000 mm/min werden zu 5000 mm/min.
given-mode-program-test-told = Messzyklen werden übersprungen; Ergebnisse behalten die Werte früherer Aufrufe. An der Maschine bewegt sich keine Achse.
given-mode-block-search-told = Messzyklen vor dieser Zeile werden übersprungen; Ergebnisse behalten die Werte früherer Aufrufe.
given-mode-simulation-told = Messzyklen werden ausgeführt, außer _MC_SIMSIM ist 0. _MC_SIMDIFF kommt zu jeder gemessenen Position hinzu.
given-mode-jobshop-told = Messzyklen werden ausgeführt, außer _MC_SIMSIM ist 0, korrigieren aber nichts, zeigen kein Ergebnis und protokollieren nicht. _MC_SIMDIFF kommt zu jeder gemessenen Position hinzu.
given-assumed = { $count ->
    [one] Ein Wert der Maschine wurde angenommen: { $values }.
   *[other] { $count } Werte der Maschine wurden angenommen: { $values }.
 }
given-enter-values = Werte eingeben
given-enter-value = Wert eingeben
given-missing = Nicht vorhanden: { $names }.
given-open-files = Dateien öffnen
given-open = { $names } öffnen
machine-values-title = Werte der Maschine
machine-values-help = Programme lesen diese Werte, aber nur die Maschine kennt sie. Ein eingegebener Wert gilt für jeden Lauf; bei leerem Feld gilt wieder der angenommene Wert.
machine-values-state = Herkunft
machine-values-typed = eingegeben
machine-values-assumed = angenommen
machine-values-where = Gelesen in

# Guides, concepts and terms of the manuals.
terms-title = Anleitungen, Begriffe und Konzepte
terms-open = Anleitungen, Begriffe
terms-search = Anleitungen, Begriffe und Konzepte suchen
terms-search-hint = Triggerpunkt, Mittelwert, Cpk
terms-drag = Ziehen oder eingeben: { $what }
terms-no-number = Eine Zahl eingeben.
terms-range = { $from } bis { $to }{ $unit } eingeben.
terms-whole = Eine ganze Zahl von { $from } bis { $to } eingeben.
terms-limits = { $from } … { $to }
terms-shown = { $what }: { $value }.
terms-print = Seite drucken
terms-terminal = Im Terminal
guide-go = Dorthin
guide-open = Anleitung
terms-list = Begriffe
terms-none = Weder Anleitung noch Begriff oder Konzept enthält diese Wörter.

steps-title = Inbetriebnahme und Hochrüstung
