# Anleitungen: wozu ein Teil von Probewright dient, wo er ist, worauf zu achten ist. Was in Anführungszeichen steht, ist
# der Text eines Bedienelements der Seite.

guide-group-results = Mit Ergebnissen arbeiten

guide-record = Protokoll der Messungen
guide-record-words = Protokoll, Messprotokoll, Prüfprotokoll, Bericht, Tabelle der Messungen, CSV, Excel, JSON, PDF, drucken, Kunde, Qualität, Bewertung, Erstmuster
guide-record-1 = Das Protokoll enthält alles, was ein Lauf gemessen hat, je Messung eine Zeile: Element, Sollwert, Istwert, Grenzen und ihre Ausnutzung, Bewertung, Korrektur, Messtaster mit seiner Kalibrierung, Alarme.
guide-record-2 = In der Ansicht „Programm“ wählen; die Tabelle steht unter „Messungen“. „Schlechteste zuerst“ holt die schlechtesten nach oben, ein Klick auf eine Zeile führt zu ihrer Programmzeile und zu ihrem Schritt in der 3D-Ansicht.
guide-record-3 = „CSV“ ist für eine Tabellenkalkulation, „JSON“ für andere Programme, „Protokoll drucken“ für Papier oder PDF: mit Schriftfeld, Balken und dem Bild der nummerierten Elemente.
guide-record-4 = Auf die Kalibrierung neben dem Messtaster achten: Ein Wert mit fremder oder alter Kalibrierung ist nicht mehr wert als diese.

guide-measured = Werte der realen Maschine
guide-measured-words = importieren, einlesen, Protokoll, reale Werte, reale Maschine, Messwerte, Protokoll der Steuerung, CSV, Excel, vergleichen, Pfeile
guide-measured-1 = Ordnet den Aufrufen des Programms zu, was eine Maschine wirklich gemessen hat: dieselbe Tabelle und dasselbe Protokoll, und die wirklichen Abweichungen als Pfeile in der 3D-Ansicht.
guide-measured-2 = Das Programm öffnen, das die Maschine ausgeführt hat, und „Programm“ anzeigen. „Von der Maschine“ wählen, dann das Protokoll der Steuerung oder eine Tabelle (CSV).
guide-measured-3 = Jede Zeile wird einem Aufruf zugeordnet. Sagen die Zahlen nicht, was in einer Spalte steht, diese unter „Spalten“ wählen.
guide-measured-4 = Zeilen, die nicht passen, stehen mit dem Grund in einer Liste; keine geht verloren. „Zurück zur Simulation“ zeigt wieder die simulierten Werte.

guide-certainty = Wie sicher eine Messung ist
guide-certainty-words = Sicherheit, Messunsicherheit, Unsicherheit, erweiterte Unsicherheit, erweiterte Messunsicherheit, Sicherheitsabstand, Schutzabstand, ISO 14253, ISO 14253-1, Monte Carlo, Erweiterungsfaktor, Wahrscheinlichkeit, Nachweis, Konformität
guide-certainty-1 = Sagt, was ein Messwert beweist: Wert ± erweiterte Unsicherheit (k = 2), aus der Streuung des Messtasters, seiner Kalibrierung, der Formabweichung und der Temperatur des Werkstücks.
guide-certainty-2 = Für den Aufruf in der Maske steht sie in der Ergebniszeile. Für ein Programm „Sicherheit“ über der Tabelle „Messungen“ wählen: Das Programm läuft viele Male, jedes Mal mit denselben Zufallszahlen.
guide-certainty-3 = Nach ISO 14253-1 ist ein Teil nur dann sicher gut, wenn der Wert von jeder Grenze einen Sicherheitsabstand von 1.645 Standardunsicherheiten hält, und nur dann sicher schlecht, wenn er ebenso weit jenseits liegt. Dazwischen ist weder das eine noch das andere sicher.
guide-certainty-4 = Die Wahrscheinlichkeiten sagen, ob das Teil eher gut, Nacharbeit oder Ausschuss ist. Den größten Beitrag zuerst verbessern.
guide-certainty-5 = Sie ist so gut wie das, was bekannt ist: unter „Abweichungen“ die „Wiederholgenauigkeit“ des Messtasters eintragen, wie sie sein Test ergeben hat. Wo nichts streut, steht nichts.

guide-series = Serie von Teilen
guide-series-words = Serie, viele Teile, Los, Charge, Statistik, SPC, Cp, Cpk, Prozessfähigkeit, Fähigkeit, Ausschussquote, Werkzeugverschleiß, Drift, Trend, Histogramm, Mittelwert, Standardabweichung
guide-series-1 = Führt das offene Programm für ein Teil nach dem anderen aus, mit zufällig gezogenen Abweichungen. Zeigt, wie sich Istwerte und Korrekturen entwickeln und was ohne Korrektur Ausschuss wäre.
guide-series-2 = „Serie“ über der Tabelle „Messungen“ wählen. „Streuende Größe hinzufügen“ nimmt Maße des Werkstücks, Werkzeugverschleiß, Messtaster und jede Variable, jede mit ihrer Streuung; dann „Serie ausführen“ wählen.
guide-series-3 = Steht „Jedes Teil“ auf „findet die Korrekturen des vorigen Teils vor“, zeigt sich der Regelkreis der Fertigung, bei „beginnt neu“ nur die Streuung.
guide-series-4 = Cp vergleicht die Streuung mit der Toleranz, Cpk auch den Abstand von ihrer Mitte. Auf die Vertrauensbereiche achten: Wenige Teile beweisen wenig.
guide-series-5 = Derselbe Startwert zieht dieselben Teile: einen Wert ändern und vergleichen. „Beispiel: Mittelwert“ führt die Tabelle des Handbuchs aus.

guide-limits = _TZL, _TMV und _K wählen
guide-limits-words = _TZL, _TMV, _K, Nullkorrektur, Mittelwert, Mittelwertbildung, Erfahrungswert, Wichtungsfaktor, Korrekturgrenzen, Toleranz, schwingen, pendeln
guide-limits-1 = Diese Werte bestimmen, welche Abweichung das Werkzeug korrigiert und wie stark. Zu eng folgt die Korrektur dem Zufall, zu weit laufen die Teile aus der Toleranz.
guide-limits-2 = In „Serie“ ausprobieren: dieselben Teile mit _K=1 und _K=3. Für _TZL schlägt „Messtaster testen: Wiederholgenauigkeit“ einen Wert vor.

guide-screens = Messergebnisbilder
guide-screens-words = Bild, Messergebnisbild, Ergebnisbild, Messergebnisanzeige, quittieren, NC-Start, anhalten, Halt, warten, M0, Bediener, CYCLE102, CYCLE103, _CHBIT[10], _CHBIT[11], _CHBIT[18]
guide-screens-1 = An der Steuerung kann ein Messzyklus Sollwerte, Istwerte und Differenzen in einem Bild zeigen. Hier erscheint, was der Bediener sieht.
guide-screens-2 = _CHBIT[10]=1 schaltet die Bilder ein. Mit _CHBIT[11]=1 wartet das Programm auf NC START, mit _CHBIT[18]=1 bleibt das Bild bis zum nächsten Messaufruf. Im Programm oder unter „Maschinendaten“ setzen.
guide-screens-3 = Ein Bild steht über der 3D-Ansicht, solange der Lauf bei seinem Schritt ist. Der Reiter „Ergebnis“ listet alle auf; ein Klick öffnet eines.
guide-screens-4 = „Beim Abspielen hier anhalten“ ankreuzen: Das Abspielen wartet dann an jedem Bild, das an der Maschine wartet, bis „NC START“ gedrückt wird.
guide-screens-5 = Bei Fertigung ohne Bediener hält ein wartendes Bild die Maschine bei jedem Teil an: dort _CHBIT[11]=0 setzen.

guide-log = Protokoll und Dateien eines Laufs
guide-log-words = Protokoll, Messprotokoll, Protokolldatei, Datei, MPF, WRITE, drucken, CYCLE100, CYCLE101, CYCLE106, _PROTNAME, Folgedatei, Fortsetzungsdatei, Überlauf, LEN_PROTOCOL_FILE
guide-log-1 = Ein Lauf hinterlässt die Dateien, die auch die Steuerung hinterlässt: das Protokoll zwischen CYCLE100 und CYCLE101, was das Programm mit WRITE schreibt, und was Makros der NCT drucken.
guide-log-2 = Der Reiter „Protokoll“ zeigt, wie jede Datei mit dem Lauf wächst, und speichert sie unter dem Namen, den sie an der Steuerung hat.
guide-log-3 = _PROTNAME[1] ist der Name ohne Endung. Hat eine Datei die Größe in MD 11420 erreicht, folgen bis zu neun weitere mit Unterstrich und Ziffer; danach hält die Steuerung an und verlangt einen neuen Namen.
guide-log-4 = In den Masken der Protokollzyklen entstehen die Spalten durch Auswählen („Spalte hinzufügen“), und die Zeilen erscheinen so, wie sie gedruckt werden. Ein Wert, der nicht in seine Spalte passt, wird gemeldet.
guide-log-5 = Datum und Uhrzeit sind die der Steuerung, nicht die dieses Rechners: „Datum und Uhrzeit, zu der ein Lauf beginnt“ in der Maschine stellt sie ein.

guide-group-programs = Programme ausführen und ergänzen

guide-run-modes = Betriebsarten eines Laufs
guide-run-modes-words = Betriebsart, Probelauf, Dry Run, Programmtest, Satzsuchlauf, Satzvorlauf, Simulation, HMI Advanced, Jobshop, ShopMill, überspringen, übersprungen, _MC_SIMSIM, _MC_SIMDIFF
guide-run-modes-1 = Zeigt, was ein Programm an der Steuerung tut, wo Messzyklen übersprungen oder nur simuliert werden.
guide-run-modes-2 = In der Ansicht „Programm“ wählen und unter „Betriebsart“ eine von „Automatik“, „Probelauf“, „Programmtest“, „Satzsuchlauf“ und den Simulationen der Steuerung.
guide-run-modes-3 = Ein übersprungener Zyklus misst nichts: Seine Ergebnisse behalten die Werte eines früheren Aufrufs, und das Programm arbeitet mit diesen weiter. Jeder Aufruf sagt es.
guide-run-modes-4 = Bei „Satzsuchlauf“ darauf achten, dass nach der Zielzeile nichts ein Ergebnis von davor braucht.
guide-run-modes-5 = In den Simulationen der Steuerung überspringt _MC_SIMSIM=0 die Zyklen, und _MC_SIMDIFF wird zu jeder gemessenen Position addiert.

guide-around = Bausteine um den Aufruf
guide-around-words = um den Aufruf, Baustein, Block, Nacharbeit, Nacharbeiten, Schleife, Bruch, Werkzeugbruch, anhalten, Sprung, Meldung, eigener Alarm, Schlichten, Mittelwert, Umschlag, Ergebnis behalten, überspringen, nach Ergebnis
guide-around-1 = Ergänzt, was man um eine Messung herum von Hand schreibt: Halt, Meldung, Alarm oder Sprung nach Ergebnis, Nacharbeit in einer Schleife, Vorschlichten und Schlichten, Bruchprüfung, Mittelwert mehrerer Messungen, Ergebnis in eine Variable oder das Protokoll, Überspringen, wenn schon gemessen ist.
guide-around-2 = In der Maske „Um den Aufruf“ öffnen, Bausteine ankreuzen und ihre Felder ausfüllen. Sie werden mit dem Aufruf eingefügt; bei einem Aufruf des Programms „Ins Programm übernehmen“ wählen.
guide-around-3 = Bausteine werden an ihren Zeilen wiedererkannt und lassen sich später ändern und entfernen.
guide-around-4 = Ein Baustein, der ein Programm aufruft, braucht dieses: Das für die Nacharbeit zum Beispiel bringt den Messtaster zur Startposition zurück.
guide-around-5 = Jeden Zweig ausprobieren: dem Werkstück unter „Abweichungen“ einen Fehler geben und „Programm“ ausführen.

guide-user-programs = Zeilen vor und nach jeder Messung
guide-user-programs-words = CYCLE198, CYCLE199, Anwenderprogramm, vor der Messung, nach der Messung, Messtaster ein, Messtaster aus, Messtaster einschalten, M27, M28, Abdeckung
guide-user-programs-1 = CYCLE198 läuft vor jeder Messung, CYCLE199 danach: für alles, was die Maschine dort immer braucht, etwa den Messtaster ein- und ausschalten.
guide-user-programs-2 = „Zeilen um Messzyklen (CYCLE198, CYCLE199)“ schreibt sie nach Auswahl von Zyklen und Zeilen: zum Einfügen oder als ganze Dateien.
guide-user-programs-3 = Enthält sie ein Programm oder eine Datei dazu, sagt jeder Aufruf, welche Zeilen um ihn herum laufen.
guide-user-programs-4 = Sie wirken in jedem Programm der Maschine. Was zu einer einzelnen Messung gehört, steht um deren Aufruf.

guide-group-proof = Programme und Installation absichern

guide-scenarios = Szenarien: geprüfte Programme
guide-scenarios-words = Szenario, Test, Prüflauf, Regressionstest, JUnit, CI, Build-Server, Ordner, erwartetes Ergebnis, absichern, Nachweis
guide-scenarios-1 = Ein Szenario enthält ein Programm, seine Maschine und was dabei herauskommen muss: Ergebnisse jedes Aufrufs, Korrekturen, Alarme, Protokoll. Nach jeder Änderung am Programm oder an den Maschinendaten neu ausführen.
guide-scenarios-2 = Im Menü „Szenarien“ wählen. „Programm als Szenario speichern“ macht eines aus dem, was die Seite zeigt; „Szenarien ausführen …“ und „Ordner ausführen …“ führen eigene aus.
guide-scenarios-3 = In einem Ordner enden die Namen auf scenario.json. Was abweicht, steht zuerst, mit erwartetem und erhaltenem Wert.
guide-scenarios-4 = Im Terminal ergibt ein fehlgeschlagener Fall den Exit-Status 1, und --junit schreibt JUnit XML: So kann ein Server die Programme ausführen.
guide-scenarios-5 = Eines für das gute Teil speichern und eines für jeden Fall, den das Programm abfangen muss: Übermaß, keine Bohrung, Werkzeugbruch.

guide-installation = Installation prüfen
guide-installation-words = Selbsttest, Prüfung, Installation, Verifizierung, Validierung, Nachweis, gerechnete Beispiele, Vektoren, geschlossener Regelkreis
guide-installation-1 = Zeigt im eigenen Browser, dass Probewright rechnet, was die Handbücher drucken: Beispiele, ihre Zahlen, und geschlossene Abläufe, die kalibrieren, korrigieren und noch einmal messen.
guide-installation-2 = „Info“ wählen, dann „Installation prüfen“. Zu sehen ist, wie viele stimmen, jedes mit seiner Quelle, und die Dauer; was abweicht, steht zuerst.
guide-installation-3 = Nach jeder neuen Version ausführen. Das prüft die Rechnung, nicht die Maschine: dort jedes Programm einfahren.

guide-group-machine = Maschine und Messtaster

guide-machine-check = Maschine prüfen
guide-machine-check-words = Maschinendaten, INITIAL.INI, TEA, Serieninbetriebnahme, Archiv, Ausgabe, Datensicherung, MD, Speicher, fehlende Daten, Alarm
guide-machine-check-1 = Vergleicht, was eine Steuerung ausgegeben hat, mit dem, was die Messzyklen brauchen, und sagt, was fehlt, zu klein oder widersprüchlich ist und welcher Alarm daraus folgt.
guide-machine-check-2 = „Maschine prüfen“ wählen und Maschinendaten (.TEA, INITIAL.INI), Definitionsdateien oder den Text eines Archivs hineinziehen, oder Zeilen wie MD 18120 = 30 schreiben.
guide-machine-check-3 = Angeben, was die Maschine hat, etwa „Messen in JOG“ oder „Werkzeugmesstaster“; sonst werden Daten verlangt, die sie nicht braucht.
guide-machine-check-4 = „Zu ändernde Zeilen speichern“ schreibt nur diese Zeilen. Vor dem Einlesen die Steuerung archivieren: Daten, die den Speicher konfigurieren, löschen ihn.

guide-definitions = Definitionsdateien und Wertebelegung
guide-definitions-words = GUD, GUD5, GUD6, GUD7_MC, DEF, Definitionsdatei, Feldgröße, Wertebelegung, Speicher, zurücklesen, Anzahl der Messtaster
guide-definitions-1 = Schreibt, was die Maschine in den Definitionsdateien der Messzyklen ändert: Feldgrößen und andere Werte, das Programm, das sie zuweist, und den Speicher, den sie brauchen.
guide-definitions-2 = „Definitionsdateien, Wertebelegung“ wählen und jede Datei speichern. Sie enthalten nur zu ändernde Zeilen: in die Dateien der Steuerung übernehmen.
guide-definitions-3 = „Dateien zurücklesen“ übernimmt die Werte einer Steuerung in die Maschine hier, auch aus ihren Inbetriebnahmedateien.
guide-definitions-4 = Vor dem Aktivieren einer Definitionsdatei die Daten der Steuerung sichern; danach das Programm der Wertebelegung ausführen.

guide-braking = Bremsweg des Messtasters
guide-braking-words = Bremsweg, Verzögerung, Überlauf, Auslenkung, Taststift, größter Vorschub, Messvorschub, _VMS, Kv, Regelverstärkung, MD32300, MD32200
guide-braking-1 = Nach dem Signal braucht die Achse einen Weg bis zum Stillstand, den der Messtaster aufnehmen muss. Berechnet diesen Weg für einen Vorschub oder den größten Vorschub für die zulässige Auslenkung.
guide-braking-2 = „Maschine prüfen“ wählen und „Bremsweg“ öffnen. Verzugszeit, Verzögerung und Kv stehen in der Ausgabe der Steuerung, oder man trägt sie ein.
guide-braking-3 = Mit diesen Daten in der Maschine ergibt ein Aufruf mit zu großem Vorschub eine Warnung mit dem größten zulässigen.
guide-braking-4 = Der Wert wird beim Signal erfasst, der Weg verfälscht ihn also nicht. Er entscheidet, ob der Taststift heil bleibt; der halbe Vorschub braucht weniger als den halben Weg.

guide-repeat = Messtaster testen: Wiederholgenauigkeit
guide-repeat-words = Wiederholgenauigkeit, Streuung, Messtastertest, Funktionstest, MEAS, Drift, Standardabweichung, Histogramm, Kalibrierung prüfen
guide-repeat-1 = Zwei Testprogramme ohne Messzyklen: Das eine zeigt, ob der Messtaster schaltet, das andere, wie weit Antastungen derselben Stelle streuen.
guide-repeat-2 = „Messtaster testen: Wiederholgenauigkeit“ wählen und Achse, Anfang, Ende und Vorschub eintragen. „Funktionstest speichern“ und „Programm Wiederholgenauigkeit speichern“ schreiben die Programme für die Maschine.
guide-repeat-3 = Was die Maschine gemessen hat, unter „Werte der realen Maschine (leer: simuliert)“ einfügen: Es erscheinen Mittelwert, Streuung, Spannweite, Drift und ein Vorschlag für _TZL.
guide-repeat-4 = Die Streuung als „Wiederholgenauigkeit“ des Messtasters eintragen: Sicherheit und Serie rechnen dann mit diesem Messtaster.
guide-repeat-5 = Driften die Werte, ist die Maschine nicht warm oder der Messtaster locker: zuerst das beheben und noch einmal testen.

guide-commissioning = Inbetriebnahme und Hochrüstung
guide-commissioning-words = Inbetriebnahme, Installation an der Maschine, einrichten, Hochrüsten, Update, HMI Advanced, HMI Embedded, PCU 50, MMC, TCU, Stecker, X121, Verdrahtung, Anschluss, Verträglichkeit, Kompatibilität, Versionen die zusammen laufen
guide-commissioning-1 = Die Schritte, mit denen Messzyklen auf eine Maschine kommen oder hochgerüstet werden, nach Bedientafel und Version, mit Softkeys, Dateien und der Kontrolle, ob jeder gelungen ist.
guide-commissioning-2 = „Inbetriebnahme und Hochrüstung“ wählen und unter „Maschine“ den Weg. Erledigtes abhaken: Die Seite merkt es sich. „Anschlüsse der Messtaster“ enthält Stecker und Signale.
guide-commissioning-3 = Wo ein Schritt Maschinendaten verlangt, sagt „Maschine prüfen“, ob sie ausreichen.

guide-background = Anleitungen, Begriffe und Konzepte
guide-background-words = Hilfe, Anleitung, Glossar, Wörterbuch, Konzept, Begriff, Bedeutung, erklären, Handbuch
guide-background-1 = Erklärt, wie man mit Probewright arbeitet und was die Handbücher der Messzyklen voraussetzen.
guide-background-2 = Strg+K drücken, „Anleitungen, Begriffe und Konzepte“ wählen und ein beliebiges Wort eingeben. „Konzept“ neben einem Feld öffnet das Konzept dazu, ein Fragezeichen in einem Dialog dessen Anleitung.
guide-background-3 = Jede Messvariante hat eine eigene Hilfeseite: „Hilfe“ neben der Maske.
