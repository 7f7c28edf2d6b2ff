# Warnungen zum Programm als Ganzem, jede mit ihrer Abhilfe.

advice-insert = { $text } vor dem Aufruf einfügen
advice-insert-behind = { $text } nach dem Aufruf einfügen
advice-insert-around = { $before } vor und { $behind } nach dem Aufruf einfügen
advice-write = { $name }={ $value } für diesen Aufruf schreiben

advice-compensation = Werkzeugradiuskorrektur ist aktiv: { $word } in Zeile { $line }.
advice-compensation-pass = Werkzeugradiuskorrektur ist aus dem vorigen Durchlauf noch aktiv: { $word } in Zeile { $line }.
advice-compensation-hint = G40 vor dem Aufruf programmieren.
advice-compensation-open = Vor diesem Aufruf fehlt G40, und das Programm endet mit aktiver Werkzeugradiuskorrektur: Beim nächsten Lauf kann sie noch aktiv sein.
advice-plane = Vor diesem Aufruf ist keine Arbeitsebene programmiert: Die Grundstellung der Maschine bestimmt, in welchen Achsen gemessen wird.
advice-plane-hint = Ebene programmieren, zum Beispiel { $plane }.
advice-diameter = Vor diesem Aufruf ist weder DIAMON noch DIAMOF programmiert: Die Grundstellung bestimmt, ob Werte der Planachse Durchmesser sind.
advice-diameter-hint = DIAMON für Durchmesser oder DIAMOF für Radien programmieren.
advice-edge-none = Keine D-Nummer ist aktiv: Die Steuerung verrechnet die Länge des aktiven Werkzeugs nicht.
advice-edge-open = Nach dem letzten T ist kein D programmiert: Maschinendaten bestimmen, ob eine Korrektur aktiv ist.
advice-edge-hint = D-Nummer des aktiven Werkzeugs nach dem Werkzeugwechsel programmieren.
advice-tool = Das aktive Werkzeug T{ $tool } ist kein Werkstückmesstaster (Typ { $type }).
advice-tool-hint = Messtaster vor dem Aufruf einwechseln oder Typ in der Werkzeugliste korrigieren (710, an der Drehmaschine 580).
advice-tool-digit = T{ $tool } hat Typ { $type }: Die Aufrufbedingungen verlangen 1x0 oder 710, andere Handbuchstellen nennen 100 bis 199.
advice-tool-digit-hint = Messtaster einwechseln oder als Typ 710 eintragen; den jetzigen Typ kann die Steuerung ablehnen.
advice-tool-assignment = T{ $tool } hat Typ { $type }: Dieser Zyklus akzeptiert einen Messtaster für Drehmaschinen (Typ 5xy) nur bei SD 42950 = 2.
advice-tool-assignment-hint = An der Drehmaschine SD 42950 = 2 setzen; an der Fräsmaschine für den Messtaster Typ 710 eintragen.
advice-tool-position = T{ $tool }, Typ { $type }, hat Schneidenlage { $position }: Messtaster an Drehmaschinen brauchen 5 bis 8.
advice-tool-position-hint = Messtaster einwechseln oder seine Schneidenlage eintragen: 5 oder 7 steht senkrecht auf G17, 6 oder 8 auf G19.
advice-tool-plane = T{ $tool } hat Schneidenlage { $position }: Der Messtaster steht nicht senkrecht auf der Messebene dieses Zyklus.
advice-tool-plane-hint = In { $plane } messen oder Messtaster senkrecht zur aktiven Ebene verwenden: 5 und 7 für G17, 6 und 8 für G19.
advice-length = T{ $tool } hat keine Länge in der Werkzeugachse: Hier wirkt L1 in der Ordinate, L2 in der Abszisse, L3 in der Applikate.
advice-length-hint = Länge in der Werkzeugachse als L3 in einer D-Nummer für diese Ebene eintragen, falls die G18-Zuordnung nicht überall gilt.
advice-milled-diameter = DIAMON oder DIAM90 ist aktiv, aber dieser Zyklus rechnet ohne Durchmesser: Positionen in X gelten als Abstand von der Drehmitte.
advice-milled-diameter-hint = Positionen als Radien eingeben; DIAMOF vor dem Aufruf, danach wieder DIAMON oder DIAM90 programmieren.
advice-spindle = Die Spindel dreht: Zwischen M3 oder M4 und diesem Aufruf wird sie nicht angehalten.
advice-spindle-hint = Spindel mit M5 anhalten, bevor sich der Messtaster dem Werkstück nähert.
advice-open = Der Zustand bei diesem Aufruf hängt von einem anderen Programm oder vom Programmablauf ab: { $words }.
advice-open-hint = Zustand vor dem Aufruf programmieren oder sicherstellen, dass jedes aufrufende Programm ihn setzt.
advice-tool-none = Vor diesem Aufruf ist kein Werkzeug programmiert: Verwendet wird das Werkzeug in Spindel oder Revolver mit der aktiven D-Nummer.
advice-tool-none-hint = T und D vor dem Aufruf programmieren.
advice-radius = Mit DIAMOF ist der Sollwert { $value } ein Radius: Der Durchmesser ist { $diameter }.
advice-radius-hint = DIAMON vor dem Aufruf programmieren, wenn der Durchmesser aus der Zeichnung eingegeben ist.
advice-calibration = Dieses Programm kalibriert Messtaster { $number } vor diesem Aufruf nicht: Es gelten die Daten in { $data }.
advice-calibration-hint = Messtaster zuerst an dieser Maschine kalibrieren oder die Kalibrierung vor dieser Messung aufrufen.
advice-inherited = { $name }={ $value } ist in Zeile { $line } für { $cycle } geschrieben und hat dort eine andere Einheit.
advice-inherited-meaning = { $name }={ $value } ist in Zeile { $line } für { $cycle } geschrieben und bedeutet dort „{ $before }“, hier aber „{ $now }“.
advice-inherited-hint = { $name } für diesen Aufruf schreiben.
advice-frame = { $frame } wurde korrigiert, aber die Korrektur ist nicht aktiv: Das Programm läuft mit den alten Werten weiter.
advice-frame-other = { $frame } wurde korrigiert, aber das Programm läuft mit { $other } weiter und aktiviert die Korrektur nie.
advice-frame-basic = Das korrigierte Basis- oder Systemframe ist nicht aktiv: Das Programm läuft mit den alten Werten weiter.
advice-frame-hint = Korrigiertes Frame nach dem Aufruf mit { $frame } aktivieren.
advice-frame-other-hint = { $frame } nach dem Aufruf programmieren.
advice-overwritten = { $name } kann beim Aufruf einen anderen Wert haben: Auch das in Zeile { $line } aufgerufene Programm schreibt den Parameter.
advice-overwritten-hint = { $name } erst nach dem Unterprogrammaufruf schreiben.
advice-log-again = Das Protokoll { $file } wurde schon in Zeile { $line } eingeschaltet: Dieser Aufruf löscht, was seither darin steht.
advice-log-again-hint = Diesem Protokoll in { $name } einen eigenen Namen geben oder ein Protokoll für beide Messungen verwenden.
arrives = Geschrieben in Zeile { $lines }.
arrives-lines = Geschrieben in den Zeilen { $lines }.
arrives-hint = Eine Änderung hier ändert den Wert auch dort, wo ihn das Programm schreibt.
arrives-shared-hint = Andere Aufrufe verwenden den Wert ebenfalls: Eine Änderung hier wird nur für diesen Aufruf geschrieben.
arrives-many-hint = Der Wert ist in vielen Zeilen geschrieben: dort ändern.
arrives-differing = Hängt vom Programmablauf bis zu diesem Aufruf ab: { $values }.
arrives-differing-hint = Eine Änderung hier würde für alle Abläufe gelten. Den Wert dort ändern, wo er geschrieben ist; die Zeile steht in Klammern.
advice-level = Der Aufruf liegt auf Programmebene { $level }; Messzyklen sind nur auf den ersten fünf aufrufbar.
advice-level-hint = Zyklus aus einem Programm aufrufen, das näher am Hauptprogramm liegt.

advice-read-back = Die Messzyklenunterstützung der Steuerung ändert diesen Aufruf beim Rückübersetzen: { $changes }.
advice-read-back-hint = Die Werte folgen aus _MZ_MASK der Maschine. Jetzt übernehmen oder, wenn die Werte im Programm richtig sind, _MZ_MASK ändern.
advice-read-back-cure = Werte aus _MZ_MASK übernehmen
advice-mask = Dieser Aufruf wurde mit anderen Maschineneinstellungen geschrieben: { $changes }.
advice-mask-hint = Sobald die Steuerung den Aufruf rückübersetzt, stehen die geänderten Werte im Programm.
advice-mask-cure = Einstellungen dieser Maschine eintragen
advice-tool-programming = Die Steuerung kann diesen Aufruf nicht in ihre Maske rückübersetzen. Seit dem Schreiben geändert: { $changes }.
advice-tool-programming-hint = Aufruf mit der Maske neu schreiben; Werkzeug und D-Nummer prüfen, sie werden jetzt anders programmiert.
nct-oriented = Die Spindel ist bei diesem Aufruf nicht orientiert: kein M19 oder M59 seit dem Programmanfang oder dem letzten M3 oder M4.
nct-oriented-hint = Spindel orientieren, bevor der Messtaster misst: Ohne Orientierung sind die Makros nicht einsetzbar.
nct-stylus-off = Der Messtaster ist bei diesem Aufruf ausgeschaltet: kein M59 seit dem Programmanfang oder dem letzten M55.
nct-stylus-off-hint = Messtaster vor dem Aufruf mit M59 einschalten.
nct-stylus-on = Die Spindel startet, während der Messtaster noch mit M59 eingeschaltet ist.
nct-stylus-on-hint = Messtaster vorher mit M55 ausschalten.
nct-stylus-left = Das Programm endet mit eingeschaltetem Messtaster.
nct-level = O9920 wird auf Unterprogrammebene { $level } aufgerufen; im Automatikbetrieb ist der Aufruf nur auf den ersten zwei erlaubt.
nct-level-hint = Den Aufruf näher ans Hauptprogramm verlegen.
user-program-runs-before = { $name } läuft vor diesem Aufruf, ab { $label } (Zeile { $line }).
user-program-runs-before-whole = { $name } läuft vor diesem Aufruf, von Anfang an (Zeile { $line }): Es hat keine Marke { $label }.
user-program-runs-behind = { $name } läuft nach diesem Aufruf, ab { $label } (Zeile { $line }).
user-program-runs-behind-whole = { $name } läuft nach diesem Aufruf, von Anfang an (Zeile { $line }): Es hat keine Marke { $label }.
user-program-cycle = Kein Messzyklus ruft die Anwenderprogramme unter dem Namen { $name } auf.
user-program-none = Mindestens einen Messzyklus auswählen.
user-program-line = Diese Zeile ist zwischen Marke und M17 nicht möglich: { $line }
user-program-variable = { $name } ist kein Variablenname.
user-program-own = Keine Siemens-Datei: Sie ersetzt die ausgelieferte. Das Handbuch druckt die Variable ihres CASE nicht ab; sie der ausgelieferten Datei entnehmen.
user-program-insert = Zum Einfügen: jede Gruppe von Zeilen zwischen die Marke des Zyklus und ihr M17.
user-program-changes = { $name } ist ein Parameter des Messzyklus: Ein in CYCLE198 geschriebener Wert lässt den Zyklus etwas anderes messen.
user-program-before-line = vor der Messung in { $cycle }
user-program-behind-line = nach der Messung in { $cycle }

# Programme älterer Versionen.

older-call = { $word } mit R-Parametern ist ein Messaufruf einer 840C, heute { $cycle }. Seine Parameter: { $names }.
older-call-hint = Das Programm umwandeln, danach Anwender- und Maschinendaten prüfen und den Messtaster neu kalibrieren.
older-convert = In { $cycles } umwandeln
older-open-id = { $text }: Ist das die Zustellung _ID auf Messhöhe? Für diese Variante von { $cycles } druckt das Handbuch { $other } neben demselben R-Parameter.
older-open-sza = { $text }: Ist das die Schutzzone _SZA? Für diese Variante von { $cycles } druckt das Handbuch { $other } neben demselben R-Parameter.
older-open-md = { $text }: Ist das die Messrichtung _MD? Für diese Variante von { $cycles } druckt das Handbuch { $other } neben demselben R-Parameter.
older-open-ra = { $text }: Ist das die Nummer der Rundachse _RA? Für diese Variante von { $cycles } druckt das Handbuch { $other } neben demselben R-Parameter.
older-open-rf = { $text }: Ist das der Vorschub _RF auf der Kreisbahn? Für diese Variante von { $cycles } druckt das Handbuch { $other } neben demselben R-Parameter.
older-open-hint = Das weiß die Zeichnung oder der Ersteller. Braucht die Variante beide, den anderen von Hand schreiben.
older-open-first = { $text }: Ist das der Sollwert _SETVAL von { $cycles }? { $other } setzt ihn auch, auf einen anderen Wert.
older-open-second = { $text }: Ist das der Sollwert _SETVAL von { $cycles } und nicht { $other }? Beide setzen ihn, auf verschiedene Werte.
older-setpoint-hint = Das Handbuch sagt nicht, welcher zählt. Einen wählen: Der andere wird entfernt.
older-answer = { $name } schreiben für { $text }
older-unused = { $text } verwendet diese Variante von { $cycles } nicht: Die Umwandlung lässt es weg.
older-result = { $name } wird nach einem Messaufruf gelesen: An der 840C kann darin ein Messergebnis stehen. Das Handbuch nennt keine Entsprechung.
older-result-hint = Das Ergebnis aus _OVR[] oder _OVI[] lesen; die Hilfeseite des Zyklus nennt sie.
older-unclear = { $text }: Von hier an lässt sich nicht verfolgen, welche R-Parameter zu einem Messaufruf der 840C gelangen; das Programm wird nicht umgewandelt.
older-unclear-hint = Einen R-Parameter mit fester Nummer außerhalb von Schleifen und Makros zuweisen, dann umwandeln.
older-subroutine = { $name } gehört zu den Messzyklen: { $what }
subroutine-result = zeigt das Messergebnisbild an (heute über _CHBIT[10] geschaltet).
subroutine-dialogue = fragt vor dem Messaufruf die Parameter im Dialog ab (SW 3.2 bis 4.5). Seitdem stehen die Werte im Programm; der Aufruf kann entfallen. Bis SW 4.4 brauchte er die MMC-Anbindung (an einer MMC 102 REM in Zeile 2 der comic.nsk entfernt).
subroutine-interface = intern, Schnittstelle der Messzyklen. Programme rufen es nicht auf.
subroutine-messages = gibt Meldungen aus, intern, bis SW 6.2. Ab SW 6.3 entfallen.
subroutine-alarms = gibt Alarme aus, intern, bis SW 6.2. Ab SW 6.3 entfallen.
subroutine-transfer = überträgt Daten, intern, ab SW 4.5. Programme rufen es nicht auf.
subroutine-plausibility = prüft die Parameter, intern. Programme rufen es nicht auf.
subroutine-measuring = Messfunktionen, intern. Programme rufen es nicht auf.
subroutine-milling = Messfunktionen der Werkstückmesszyklen an Fräsmaschinen, intern. Programme rufen es nicht auf.
subroutine-tool = lädt die Werkzeugkorrektur, intern; bis SW 6.2 auch die Nullpunktverschiebung. Programme rufen es nicht auf.
subroutine-zero = lädt die Nullpunktverschiebung, intern, ab SW 6.2. Programme rufen es nicht auf.
subroutine-approach = positioniert an Drehmaschinen vor, intern. Programme rufen es nicht auf.
