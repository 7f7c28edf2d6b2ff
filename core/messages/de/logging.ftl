# Das Messprotokoll: CYCLE100, 101, 105, 106, 113, 118.

cycle100-title = Protokoll ein
cycle100-help = Schaltet das Messprotokoll ein. Danach schreibt jeder Messzyklus einen Werteblock in die Datei, bis CYCLE101.
cycle100-words = Protokoll Messprotokoll protokollieren Log drucken Datei Bericht Protokollkopf einschalten ein Start starten Protokollierung Messergebnisse Messwerte Prüfprotokoll
cycle100-on = Protokoll ein, mit Protokollkopf

cycle101-title = Protokoll aus
cycle101-help = Schaltet das mit CYCLE100 eingeschaltete Messprotokoll aus. Danach lässt sich die Datei auslesen. Keine Eingaben nötig.
cycle101-words = Protokoll Messprotokoll protokollieren Log ausschalten aus stoppen Ende beenden Protokollierung
cycle101-off = Protokoll aus

cycle105-title = Ins Protokoll schreiben
cycle105-help = Schreibt den Protokollkopf oder einen Werteblock ins Protokoll, ohne Messzyklus.
cycle105-words = Protokoll Messprotokoll protokollieren Log schreiben drucken Protokollkopf Kopf Werteblock Wertezeilen Protokollinhalt Inhalt Protokollierung

cycle106-title = Protokoll verwalten
cycle106-help = Schreibt den Protokollkopf oder einen Werteblock ins Protokoll und verwaltet Dateien und Seiten. CYCLE100 ruft den Zyklus automatisch auf.
cycle106-words = Protokoll Messprotokoll Log Seite Seitenumbruch Folgedatei Folgeseite Ablaufsteuerung verwalten Protokollierung

cycle113-title = Datum oder Uhrzeit als Text
cycle113-help = Liest das Datum (jj/mm/tt) oder die Uhrzeit (hh:mm:ss) der Steuerung in eine Variable des Programms.
cycle113-words = Datum Uhrzeit Zeit Uhr Text Zeichenkette String Protokoll
cycle113-date = Datum
cycle113-time = Uhrzeit
param-113-job = Datum oder Uhrzeit
param-113-job-help = 1 liest das Datum, 2 die Uhrzeit.
result-113-text = Datum oder Uhrzeit als Text

cycle118-title = Zahl als Text
cycle118-help = Wandelt eine Realzahl, auf die gewählten Nachkommastellen gerundet, in einen Text für Meldung oder Protokoll um; auch bis zu zehn R-Parameter auf einmal.
cycle118-words = formatieren Format Realzahl Realwert Zahl Nachkommastellen Kommastellen Text Zeichenkette String Stellen gerundet runden Meldung Protokoll
cycle118-format = Text aus einer oder mehreren Zahlen
param-118-number = Zahl
param-118-number-help = Umzuwandelnde Zahl. Ohne Wirkung, wenn der Zyklus mehrere R-Parameter umwandelt.
param-118-decimals = Nachkommastellen
param-118-decimals-help = Anzahl der Nachkommastellen, auf die der Zyklus die Zahl rundet. { "_DIGIT" } ist der Wert für das Protokoll.
param-118-count = Anzahl der Zahlen
param-118-count-help = Bei mehr als 1 stehen die Zahlen in aufeinanderfolgenden R-Parametern; höchstens zehn.
param-118-register = Erster R-Parameter
param-118-register-help = 11 für R11, R12 und so weiter.
need-118-one = Der Zyklus wandelt eine einzelne Zahl in Text um.
need-118-count = Bei einer einzelnen Zahl nicht nötig.
need-118-registers = Mehrere Zahlen stehen in R-Parametern.
result-118-text = Text der Zahl, bei mehreren der letzten
result-118-field = Text einer von mehreren Zahlen

log-job-header = Protokollkopf
log-job-values = Werteblock
param-log-job = Auftrag
param-log-job-help = Protokollkopf oder Werteblock schreiben.
param-log-file = Protokolldatei
param-log-file-help = Name ohne Endung: Buchstaben, Ziffern, Unterstriche; am Anfang zwei Buchstaben oder Buchstabe und Unterstrich. Eine Datei dieses Namens wird überschrieben.
param-log-program = Messprogramm
param-log-program-help = Programmname im Protokollkopf.
param-log-headline = Anwenderdefinierte Kopfzeile
param-log-headline-help = Beliebiger Text, auch zusammengesetzt: { "\"Part number: \"<<PARTNUM" }. Mit { "_CBIT[11]" }=1 bilden diese Zeilen den ganzen Protokollkopf.
param-log-page = Zeilen pro Seite
param-log-page-help = Nach so vielen Zeilen, Kopf eingerechnet, beginnt eine neue Seite mit Protokollkopf. 0: Protokollkopf nur am Anfang.
param-log-line = Zeichen pro Zeile
param-log-line-help = Höchstens 200. Braucht eine Zeile mehr Zeichen als angegeben, erscheint eine Meldung.
param-log-first-page = Nummer der ersten Seite
param-log-first-page-help = Nummer, mit der die Seitenzählung im Protokollkopf beginnt.
param-log-head-lines = Anzahl anwenderdefinierter Kopfzeilen
param-log-head-lines-help = Anzahl der Zeilen { "_HEADLINE[]" }, die ausgegeben werden.
param-log-value-lines = Anzahl der Wertezeilen
param-log-value-lines-help = Anzahl der Zeilen pro Messung, höchstens vier.
param-log-column = Zeichen pro Spalte
param-log-column-help = 0: Jede Spalte ist so breit wie ihr Feld in der ersten Überschriftzeile.
param-log-separator = Trennzeichen
param-log-separator-help = Zeichen zwischen zwei Werten im Protokoll. In den Zeilen, die den Inhalt festlegen, trennt immer ein Komma.
param-log-mark = Kennzeichen für Toleranzüberschreitung
param-log-mark-help = Steht hinter Istwert und Differenz, wenn sie außerhalb von { "_TSA" }, { "_TDIF" }, { "_TUL" } oder { "_TLL" } liegen.
param-log-title = Überschriftzeile
param-log-title-help = Spaltennamen, durch Kommas getrennt. Genügt eine Zeile, in die zweite Leerzeichen in Anführungszeichen eingeben, sonst erscheint dort ein alter Text.
param-log-values = Wertezeile
param-log-values-help = Spalten, durch Kommas getrennt: { "_OVR[4]" } und andere Ergebnisse, R27 und andere R-Parameter, { "_TXT[0]" }, { "_AXIS" } (Achse von { "_MA" }), { "_AXIS1" } bis { "_AXIS3" } (Ebene), { "_TIME" }. Anderer Text bleibt unverändert.
param-log-digits = Nachkommastellen
param-log-digits-help = Stellen nach dem Dezimalpunkt für alle Werte.
need-log-file = Das Protokoll braucht eine Datei.
need-log-header = Gehört zum Protokollkopf; ohne Eingabe gilt der Wert in GUD6.
need-log-values = Gehört zu den Werten; ohne Eingabe gilt der Wert in GUD6.
need-log-titles = Gehört zum Protokollkopf; bestimmt die Spaltenbreiten, wenn „Zeichen pro Spalte“ 0 ist.
need-log-format = Gehört zum Format; ohne Eingabe gilt der Wert in GUD6.

check-log-file = Dieser Name ist für eine Protokolldatei unzulässig.
check-log-file-hint = Nur Buchstaben, Ziffern und Unterstriche verwenden; mit zwei Buchstaben oder Buchstabe und Unterstrich beginnen. Endung weglassen.
check-log-line = Eine Protokollzeile hat höchstens { $most } Zeichen: Die Steuerung begrenzt den Wert darauf.
check-log-line-hint = Für „Zeichen pro Zeile“ höchstens { $most } eingeben.
check-log-empty = Es gibt nichts zu protokollieren: Überschriftzeilen und Wertezeilen sind leer.
check-log-empty-hint = Spaltennamen oder in einer Wertezeile den Inhalt eingeben, zum Beispiel { "_OVR[0],_OVR[4],_OVR[16]" }.
check-log-width = Die erste Überschriftzeile, aus der die Spaltenbreiten folgen, ist leer: Alle Spalten werden 12 Zeichen breit.
check-log-width-hint = Erste Überschriftzeile oder Spaltenbreite eingeben.
check-log-unknown = { $word } ist nicht protokollierbar.
check-log-unknown-hint = Protokollierbar: { "_OVR[0]" } bis { "_OVR[31]" }, R-Parameter, { "_TXT[0]" } bis { "_TXT[99]" }, { "_AXIS" }, { "_AXIS1" } bis { "_AXIS3" }, { "_TIME" }.
check-log-narrow = Spalte { $column } ist { $width } Zeichen breit, ihr Text braucht { $needed }.
check-log-narrow-hint = Spalte verbreitern oder Text kürzen; sonst verbreitert die Steuerung die Spalte und gibt eine Meldung aus.
check-log-long = Die Zeile hat { $total } Zeichen; im Protokoll sind höchstens { $most } zulässig.
check-log-long-hint = Spaltenbreite verringern oder weniger Werte pro Zeile protokollieren.
check-log-longer = Die Zeile hat { $total } Zeichen, zulässig sind aber nur { $most }.
check-log-longer-hint = Wert „Zeichen pro Zeile“ erhöhen oder Spaltenbreite verringern.

log-column-time = Uhrzeit
log-column-axis = Messachse, { "_MA" }
log-column-axis-place = { $place ->
    [1] Abszisse
    [2] Ordinate
   *[other] Applikate
 }, Achsname
log-column-text = Text { $text }
log-column-number = R-Parameter { $text }
log-column-comment = Text „{ $text }“
log-column-unknown = { $text }: nicht protokollierbar
log-column-free = Freier Text
