# Prüfung einer Maschine: was an ihren Maschinen- und Anwenderdaten falsch ist und was daraus folgt.

machine-check-nothing = Nichts in diesem Text ist ein Maschinendatum oder Anwenderdatum, das zum Messen nötig ist: eine Datei mit Maschinendaten (.TEA, INITIAL.INI), eine Definitionsdatei oder ein Serieninbetriebnahme-Archiv in Textform wählen.
machine-check-ending = Verglichene Daten: { $read }. Fehler: { $errors }. Warnungen: { $warnings }. Hinweise: { $notes }. Andere Zuweisungen in den Dateien: { $others }.
machine-check-unread = Der Wert ist nicht lesbar: { $value } So schreiben: 7, (1,0,2), SET(1,,2) oder REP(0).
machine-check-text = Hier gehört eine Zahl hin, kein Text: { $value }
machine-check-number = Hier gehört ein Text in Anführungszeichen hin: { $value }
machine-check-whole = { $value } ist keine ganze Zahl.
machine-check-no-element = { $count ->
    [one] Dieses Element gibt es nicht
   *[other] Diese { $count } Elemente, ab diesem, gibt es nicht
  }: Das Feld ist { $array }.
machine-check-no-index = { $name } ist kein Feld und hat keinen Index.
machine-check-no-field = { $other } zählt nur { $most } Datenfelder: Dieses Element gibt es nicht.
machine-check-unnamed = Diese Geometrieachse hat keinen Namen.
machine-check-unread-size = Größe oder Index des Feldes ist nicht lesbar: { $value } Ganze Zahlen schreiben: [2,10].
machine-check-many = Die Liste hat { $value } Werte für { $before } Elemente: Die letzten entfallen. Kürzen oder das Feld größer definieren.
machine-check-unlike = Die Nummer { $value } gehört zu einem anderen Datum: Die Steuerung liest den Bezeichner.
machine-check-renamed = Nach der Nummer gelesen: Im Handbuch heißt das Datum { $before }. Eine Steuerung mit diesem Bezeichner kennt { $value } nicht.
machine-check-positive = { $value } ist nicht möglich: Der Wert muss über 0 liegen. Damit wird kein Bremsweg berechnet.
machine-check-no-axis = Ohne { $data } wird kein Vorschub mit der zulässigen Auslenkung verglichen.
machine-check-axis-metric = Diese Steuerung ist in Zoll; { "MD32300" } zählt hier in m/s², { "MD32200" } in (m/min)/mm. Eine Verzögerung in inch/s² mit 0,0254 multiplizieren.
machine-check-twice = Zweimal mit verschiedenen Werten vorhanden: { $before }, dann { $value }. Der letzte gilt.
machine-check-low = { $value } ist zu klein; mindestens { $limit }.
machine-check-high = { $value } ist zu groß; höchstens { $limit }.
machine-check-not = { $value } statt { $limit }.
machine-check-between = { $value } liegt nicht zwischen 1 und { $limit }.
machine-check-bits-missing = Diese Bits müssen 1 sein: { $bits }.
machine-check-bits-set = Diese Bits müssen 0 sein: { $bits }.
machine-check-range = { $value } liegt nicht zwischen { $min } und { $max }.
machine-check-from = { $value } ist zu klein; mindestens { $min }.
machine-check-above = { $value } ist zu klein; der Wert muss über { $min } liegen.
machine-check-choice = { $value } ist nicht zulässig; zulässig: { $choices }.
machine-check-count = Das Feld { $array } ist mit { $size } Elementen definiert.
machine-check-no-array = Das Feld { $array } gibt es nicht: seine Definition ist ein Kommentar.
machine-check-fields = Jedes Element dieses Felds hat { $size } Daten; die Definition hat eine andere Anzahl.
machine-check-units = Das Grundsystem ist { "MD10240" } = { $metric }: die Zyklen rechnen die Daten beim nächsten Aufruf um.
machine-check-needs = Ohne { $other } = { $value } wirkungslos.
machine-check-erases = Der nächste Aufruf setzt alle Messtasterdaten, Erfahrungswerte und Mittelwerte auf 0.
machine-check-version = Der Softwarestand der Steuerung fehlt oder ist kleiner als 3.
machine-check-uncalibrated = Dieser Werkstückmesstaster wurde nie kalibriert. Beim ersten Kalibrieren muss { "_TSA" } größer sein als der Kugelradius.
machine-check-depth = Die Tiefe zum Messen des Radius ist 0.
machine-check-axes = Jede der drei Ziffern ist 0 bis 3: eine für jede Achse.
machine-check-size = Scheibendurchmesser oder Kantenlänge ist 0; Kalibrieren und Längenmessung brauchen den Wert.
machine-check-own-speed = Drehzahl und Vorschub des Anwenders gelten, dieser Wert ist aber 0.
machine-check-no-make = Die Korrektur der Messwerte braucht den Hersteller des Werkzeugmesstasters in { "_TP_CF" }.
machine-check-no-table = Nicht ausgefüllt: { $tables }. Eine Korrekturtabelle braucht Radien und Geschwindigkeiten in aufsteigender Folge.
machine-check-assign = Dieses Maß des Werkzeugmesstasters muss eingetragen werden.
machine-check-inputs = Automatikbetrieb und JOG verwenden verschiedene Messeingänge: { $other } = { $value }.
machine-check-probe = Es gibt nur { $most } Messtaster ({ $other }).
machine-check-most = Höchstens { $most }.
machine-check-no-lines = Keine Wertezeile des Protokolls ist ausgefüllt.
machine-check-skipped = In der Simulation überspringt die Steuerung die Messzyklen.
machine-check-ratios = { $size } Einträge für { $probes } Werkstückmesstaster: bei den übrigen werden die Triggerwerte nicht korrigiert.
machine-check-braking = Bei { $feed } wird der Messtaster bis zu { $path } mm ausgelenkt, zulässig sind { $deflection } mm; höchstens { $largest }.

machine-need-gud = Die Definitionsdateien GUD5, GUD6 und GUD7 lassen sich nicht aktivieren. Eine Änderung des Speichers löst Alarm 4400 aus: Serieninbetriebnahme sichern und wieder einlesen.
machine-need-reserve = Für die Messzyklen allein genug; das Handbuch empfiehlt mehr.
machine-need-functions = Die Steuerung kennt nicht alle Zyklen mit Parametern.
machine-need-lud = Die lokalen Variablen der Zyklen haben keinen Platz: das Programm hält am Aufruf an.
machine-need-system-frame = Kein Messzyklus läuft.
machine-need-basic-frame = Keine Korrektur im Basisframe: weder in JOG noch mit { "_KNUM" } = 2000.
machine-need-channel-frame = Korrekturen in einem kanalspezifischen Basisframe werden abgelehnt.
machine-need-fine = Korrekturen wirken in der Grobverschiebung; die Feinverschiebung wird eingerechnet und gelöscht.
machine-need-level = Nur richtig für einen Messtaster, der ausgelenkt 0 V liefert; sonst gilt er in Ruhelage als ausgelenkt.
machine-need-central = An einer 840D sl messen Messtaster an { "X122" } nicht.
machine-need-hmi-time = Die Anzeige der Messergebnisse wird zu spät quittiert.
machine-need-log-file = Die Protokolldatei ist früh voll: das Protokoll geht in Dateien _1 bis _9 weiter und fragt dann nach einem Namen.
machine-need-mirror = Mit Spiegelung sind Ergebnisse der Werkstückmessung falsch.
machine-need-additive = Summenkorrekturen werden abgelehnt.
machine-need-setup-offset = Einrichtekorrekturen werden abgelehnt.
machine-need-environment = Werkzeugumgebungen ({ "_TENV" }) gibt es nicht.
machine-need-jog-start = Messen in JOG startet nicht.
machine-need-geometry = Für Messen in JOG fehlt eine Geometrieachse.
machine-need-reset-length = Nach RESET und Einschalten ist die Werkzeuglänge des Messtasters oder der Basisframe nicht aktiv.
machine-need-start-length = Beim Programmstart geht die Werkzeuglängenkorrektur verloren.
machine-need-tool-change = Bei RESET und Start behält die Werkzeugverwaltung den Messtaster nicht als aktives Werkzeug.
machine-need-basic-reset = Der Basisbezug geht bei RESET verloren.
machine-need-length-type = An einer Drehmaschine mit Bohrern oder Fräsern zählen deren Längen in falschen Achsen; 2 ist für solche Maschinen.

# Definitionsdateien.

definitions-none = Nichts weicht vom Lieferzustand ab.
definitions-memory = Speicher für Anwenderdaten
definitions-share = { $name }: { $bytes } Byte (im Lieferzustand { $default })
definitions-share-channel = { $name }: { $bytes } Byte je Kanal (im Lieferzustand { $default })
definitions-need = { $number } mindestens { $value } allein für die Messzyklen, { $source }
definitions-insert = In den ausgelieferten { $files } die Zeilen gleichen Namens ersetzen: Diese Zeilen sind nicht die ganze Datei.
definitions-save = Vorher die im NC aktiven Anwenderdaten sichern: Das Aktivieren einer Definitionsdatei setzt ihre Werte zurück.
definitions-activate = Einzeln in dieser Reihenfolge aktivieren: { $files }.
definitions-load = GUD7_MC.DEF mit „Load HD → NC“ laden, nicht aktivieren. Danach GUD7.DEF aktivieren: GUD7_MC.DEF wird damit aktiv.
definitions-reset = Danach NC-Reset auslösen und die Anwenderdaten zurückladen.
definitions-older = Bis zu den Messzyklen 6.02.16 gehören die Zeilen von GUD7_MC.DEF in die GUD7.DEF.
definitions-enter = Vor dem Messen in JOG die Maße jedes Werkzeugmesstasters eingeben, sonst folgt Alarm 61230: { $names }
definitions-program = { $channels ->
    [one] Danach { $name } laden und einmal in AUTOMATIK starten.
   *[other] Danach { $name } laden und in jedem messenden Kanal einmal in AUTOMATIK starten: Viele Daten sind kanalspezifisch.
  } Anschließend die Messtaster kalibrieren.
definitions-read = { $read ->
    [one] Ein Wert gelesen
   *[other] { $read } Werte gelesen
  }, { $changed } geändert, { $problems } nicht angenommen.
definitions-other-channel = { $count ->
    [one] Ein Wert wird nicht gelesen
   *[other] { $count } Werte werden nicht gelesen
  }: nur die des ersten Kanals.
definitions-not-there = { $count ->
    [one] Der Wert wird nicht gelesen
   *[other] { $count } Werte, ab diesem, werden nicht gelesen
  }: Diese Maschine hat solche Daten nicht.
definitions-sizes = Größen, die mit der Maschine gespeichert sind: { $names }.
definitions-read-newer = { $read ->
    [one] Ein Wert gelesen
   *[other] { $read } Werte gelesen
  }, { $changed } geändert, { $problems } nicht übernommen. Es sind Settingdaten: Die Maschine gehört jetzt zur Generation 3 (PW-GENERATION). Für 840D sl 2.5 und 2.6 sowie 828D bis 4.3 die 2 wählen.
definitions-settings = { $channels ->
    [one] Die Zeilen als Inbetriebnahmedatei einlesen oder die Werte in die Maschinen- und Settingdaten eintragen.
   *[other] Die Zeilen als Inbetriebnahmedatei einlesen oder die Werte in die Maschinen- und Settingdaten eintragen; die hinter CHANDATA(1) in jedem messenden Kanal.
  } Danach die Messtaster kalibrieren.
definitions-channels = Eine Steuerung hat 1 bis { $most } Kanäle.
