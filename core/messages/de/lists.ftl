# Aufrufe mit Argumenten in Klammern: was an einem Argument falsch ist und was die Argumentliste neuerer Steuerungen bedeutet.

list-text-wanted = { $param } erwartet einen Text, aber { $value } ist eine Zahl.
list-text-wanted-hint = Wert in Anführungszeichen schreiben.
list-number-wanted = { $param } erwartet eine Zahl, aber „{ $value }“ ist ein Text.
list-number-wanted-hint = Wert ohne Anführungszeichen schreiben.
list-text-unquoted = { $param }: { $value } steht ohne Anführungszeichen, und das Programm definiert keine solche Variable.
list-text-unquoted-hint = Wert in Anführungszeichen schreiben, wenn er selbst der Name ist.
list-arguments-many = Zu viele Argumente für { $name }: zulässig { $most }, im Aufruf { $count }.
list-arguments-many-hint = Kommas zählen und überzählige Argumente löschen.
list-selection = Argument { $place } in { $name } darf nicht { $value } sein.
list-selection-hint = Einen dieser Werte wählen: { $choices }.

newer-open = { $param } = { $value }: Bedeutung in der Argumentliste neuerer Steuerungen unbekannt. Der Wert bleibt unverändert, wird aber weder geprüft noch simuliert.
newer-seen = { $param } = { $value }: Programme neuerer Steuerungen haben dort eine andere Zahl; was diese bedeutet, ist nicht veröffentlicht.
newer-beyond = Von { $cycle } sind { $most } Argumente veröffentlicht. Was dahinter steht, bleibt unverändert; seine Bedeutung ist unbekannt.
newer-target = { $value } steht in Argument 2, bei neueren Steuerungen die NV-Nummer; diese Messvariante korrigiert aber keine NV.
newer-target-hint = NV: 3. Stelle von Argument 1 auf 1 setzen. Werkzeug: Argument 3 (S_KNUM1) verwenden. Sonst Argument 2 leer lassen.
newer-target-perhaps = { $value } in Argument 2 ist keine bekannte Nullpunktverschiebung. Auf älteren Steuerungen ist eine solche Zahl ein Werkzeug oder ein anderes Frame.
newer-target-perhaps-hint = NV: 1–99, 10001–10099. Werkzeug: Argument 3 (S_KNUM1). Oder Argument 2 leer lassen: Nichts wird korrigiert.
write-newer-tool = Neuere Steuerungen erwarten die Werkzeugkorrektur in Argument 3 (S_KNUM1, siehe Alarm 61328); Code unbekannt.
write-newer-zero = NV { $value } ist in der Argumentliste neuerer Steuerungen unbekannt; bekannt: 1–99, 10001–10099, 9000, 9999, 19999.
write-newer = { $param } = { $value } bedeutet in der Argumentliste neuerer Steuerungen etwas anderes, oder die Bedeutung ist unbekannt.
convert-newer = { $param } = { $value }: Die ältere Argumentliste hat keine Entsprechung für diesen Wert der neueren, oder die Bedeutung ist unbekannt.
convert-newer-hint = Aufruf so lassen oder die Messung in der Maske neu eingeben.

newer-lost = Vor Platz { $place } fehlt ein Argument: Alles dahinter steht einen Platz zu früh.
newer-lost-between = Zwischen Platz { $place } und { $until } fehlt ein Argument: Alles dahinter steht einen Platz zu früh.
newer-lost-hint = Für das fehlende Argument ein Komma einfügen.
newer-many = An Platz { $place } steht ein Argument zu viel: Alles dahinter steht einen Platz zu spät.
newer-many-between = Zwischen Platz { $place } und { $until } steht ein Argument zu viel: Alles dahinter steht einen Platz zu spät.
newer-many-hint = Das überzählige Komma löschen.
newer-places = { $cycle } ist mit 5 Plätzen veröffentlicht, zwei davon ohne Namen. Bei { $count } Argumenten ist offen, welche davon S_PROT und S_PATH sind.
newer-lost-perhaps = { $name } = { $value } steht in keinem veröffentlichten Programm. Mit einem Argument mehr zwischen Platz { $place } und { $until } wäre der Aufruf wie in Programmen.
newer-many-perhaps = { $name } = { $value } steht in keinem veröffentlichten Programm. Mit einem Komma weniger zwischen Platz { $place } und { $until } wäre der Aufruf wie in Programmen.
newer-perhaps-hint = Argumente zählen. Ist der Aufruf so richtig, bleibt er stehen.
newer-inch = S_FA = { $value } ist das 25,4-Fache von { $meant }: Ein Messweg in mm wurde umgerechnet, als wäre er in Zoll.
newer-inch-hint = Messweg in mm eingeben.
newer-set-variant = Argument 1 auf { $value } setzen
newer-set-none = Argument 2 leeren
newer-set-path = S_FA auf { $value } setzen
newer-set-close = Klammer schließen
newer-set-lost = Leeres Argument { $place } einfügen
newer-set-many = Leeres Argument { $place } löschen
argument-list = Argumentliste von { $cycle } an neueren Steuerungen
argument-place = Argument { $place } von { $cycle }
argument-name = { $name }: { $meaning }
argument-screen = Auf dem Bildschirm: { $name }
argument-older = An älteren Steuerungen: { $name }
argument-no-older = Ältere Steuerungen haben keine Entsprechung.
argument-values = Bekannt aus Programmen, die an solchen Steuerungen laufen.
argument-alarm = Alarm { $alarm } nennt es.
argument-name-known = Nur Name und Platz sind veröffentlicht.
argument-open = Die Ziffern sind nicht veröffentlicht: Es bleibt, wie es geschrieben ist, und wird nie neu geschrieben.
argument-zero = Nullpunktverschiebung, die korrigiert wird
argument-zero-help = Leer: nur messen. 1 bis 4: G54 bis G57; 5 bis 99: G505 bis G599; plus 10000: grob. 9999 und 19999: aktives Frame. 9000 ist in Gebrauch, die Bedeutung nicht veröffentlicht.
argument-zero-fine = { $name }, fein
argument-zero-coarse = { $name }, grob
argument-zero-used = In Gebrauch, Bedeutung nicht veröffentlicht
argument-tool = Werkzeug, das korrigiert wird
argument-ball = Durchmesser der Kalibrierkugel
argument-probe = Nummer des Messtasters
argument-tool-probe = Nummer des Werkzeugmesstasters
argument-points = Abstände X1 und X2 oder Punkte P1 (X1, Y1) bis P4 (X4, Y4)
argument-points-help = Die Messvariante entscheidet; ihre Nummern sind nicht veröffentlicht.
argument-safe = Vertrauensbereich
argument-safe-help = Alarm 61303 nennt ihn; von wo er in diesem Zyklus zählt, ist nicht veröffentlicht.
argument-vectors = Grenze der berechneten Vektoren
argument-vectors-help = Rundachspositionen mit weniger als 20 Grad Abstand sind unzuverlässig (Alarm 61430, G).
argument-probing-angle = Antastwinkel
argument-probing-angle-help = Von −359 bis 359 Grad. Ältere Steuerungen haben in diesem Zyklus keinen.
argument-infeed = Zustellung auf Messhöhe
argument-infeed-help = Welches Vorzeichen nach unten führt, ist von Programm zu Programm verschieden. Ohne Zustellung steht hier 1.
argument-direction = Messrichtung
argument-direction-help = 1: plus; 2: minus.
argument-direction-open = Messrichtung
argument-direction-open-help = Ihre Zahlen sind nur für CYCLE978 und CYCLE998 veröffentlicht.
argument-carrier = Orientierbarer Werkzeugträger
argument-centre-x = Mittelpunkt, 1. Achse der Ebene
argument-centre-x-help = Wenn der Messtaster daneben startet; _AMODE ist dann 11.
argument-centre-y = Mittelpunkt, 2. Achse der Ebene
argument-centre-y-help = Wenn der Messtaster daneben startet; _AMODE ist dann 11.
argument-bits = Messoptionen
argument-bits-help = Programme lassen es leer.
argument-plane = Arbeitsebene
argument-plane-help = Programme schreiben 1.
argument-mode = Modus
argument-mode-help = Programme schreiben 1; 11, wenn S_XM und S_YM den Mittelpunkt angeben.
argument-name-only = Bedeutung nicht veröffentlicht
argument-unnamed = Für diesen Platz ist auch kein Name veröffentlicht
argument-direction-plus = Plusrichtung
argument-direction-minus = Minusrichtung
argument-probe-help = Nummer des Messtasters, 1 bis 12: Seine Daten sind Settingdaten ab SD 54600.
argument-tool-probe-help = Nummer des Werkzeugmesstasters, 1 bis 6: Seine Daten sind Settingdaten ab SD 54625.
argument-help-older = Diese Seite beschreibt den Zyklus an älteren Steuerungen. In der Argumentliste neuerer gelten andere Zahlen und Argumente: Nullpunktverschiebung (ab 10000: grob), Messtaster, Messrichtung S_MD. _CHBIT, _CBIT und die Stellen von _KNUM gehören zur älteren Steuerung. Wo keine NV korrigiert wird, misst der Aufruf nur.
write-direction = S_MD ist leer: Der ältere Aufruf sagt nicht, in welche Richtung gemessen wird.
write-direction-hint = 1 (plus) oder 2 (minus) eingeben, wie es Programme von Anwendern immer tun.
write-infeed = S_ID = { $value } behält sein Vorzeichen. Welches nach unten führt, ist an neueren Steuerungen von Programm zu Programm verschieden.
write-infeed-hint = Vor dem ersten Lauf das Vorzeichen mit einem Programm vergleichen, das an dieser Maschine läuft.
write-rotary = S_RA = { $value }: Welche Zahl an neueren Steuerungen für welche Rundachse steht, ist nicht veröffentlicht. Programme schreiben 6.
write-rotary-hint = S_RA vor dem ersten Lauf an der Steuerung prüfen.
convert-infeed = S_ID = { $value } behält sein Vorzeichen als { "_ID" }. An neueren Steuerungen sind sich Programme uneins, welches Vorzeichen nach unten führt.
convert-infeed-hint = Vor dem ersten Lauf das Vorzeichen prüfen, weit über dem Teil.
convert-rotary = S_RA = { $value } wird { "_RA" } = { $value }; welche Zahl an neueren Steuerungen für welche Rundachse steht, ist nicht veröffentlicht.
convert-rotary-hint = In { "_RA" } die Nummer der Rundachse unter den Achsen der älteren Steuerung eintragen.
generation-list = { $cycle } wird mit der Argumentliste neuerer Steuerungen aufgerufen, die Maschine ist aber von Generation { $generation }.
generation-list-hint = Aufrufe umwandeln oder PW-GENERATION in den Maschinendaten auf 3 setzen.
generation-assigned = { $cycle } wird wie an älteren Steuerungen aufgerufen, die Maschine ist aber von Generation { $generation } und erwartet Argumentlisten.
generation-assigned-hint = Aufrufe umwandeln. Laufen an dieser Maschine auch Zuweisungen, PW-GENERATION auf 0 setzen.
generation-setting-data = { $name } gibt es an neueren Steuerungen, die Maschine ist aber von Generation { $generation }.
generation-setting-data-hint = Die Anwenderdaten dieser Maschine verwenden oder PW-GENERATION in den Maschinendaten auf 2 oder 3 setzen.
generation-user-data = { $name }[] sind Anwenderdaten älterer Steuerungen, die Maschine ist aber von Generation { $generation } und hat dafür Settingdaten.
generation-user-data-hint = Die Settingdaten ab SD 54600 und SD 55630 verwenden oder PW-GENERATION in den Maschinendaten korrigieren.
argument-shown = Argument { $place } der Liste: { $name }.
argument-shown-screen = Argument { $place } der Liste: { $name }, auf dem Bildschirm { $screen }.
newer-cycle995 = Misst die Winkligkeit einer Spindel
newer-cycle996 = Misst die Kinematik der Rundachsen, eine Stellung
newer-cycle9960 = Misst die Kinematik als Ganzes
newer-cycle150 = Zeigt die Ergebnisse am Bildschirm und schreibt das Protokoll
newer-unsimulated = { $param } wird geschrieben und nicht simuliert.
newer-omitted = { $param } fehlt und ist damit 0: Was die Steuerung dann tut, ist nicht veröffentlicht; der Aufruf wird nicht simuliert.
newer-alone = { $cycle } wird nicht simuliert: Ältere Steuerungen haben keinen solchen Zyklus, und die Ziffern seiner Argumente sind nicht veröffentlicht.
newer-infeed = { "S_ID" } = { $value }: Welches Vorzeichen nach unten führt, ist nicht veröffentlicht; der Aufruf wird nicht simuliert.
newer-infeed-hint = Programme neuerer Steuerungen sind sich über das Vorzeichen uneins. An der Maschine weit über dem Teil testen.
newer-away = { "S_MD" } = { $value } führt vom Sollwert weg: Der Messtaster steht auf der anderen Seite. Was die Steuerung dann tut, ist nicht veröffentlicht; der Lauf hält hier an.
newer-away-hint = Messtaster auf der anderen Seite der Fläche positionieren oder die Messrichtung ändern.
newer-fine = { $value } korrigiert den Grobanteil, und der Feinanteil ist nicht 0. Damit hat MD 51740 Bit 5 (Grobverschiebung absolut) zu tun; wie, ist nicht veröffentlicht, daher hält der Lauf hier an.
newer-fine-hint = Feinanteil der NV vor dem Aufruf löschen oder den Feinanteil korrigieren.
newer-centre-missing = { "_AMODE" } = 11 heißt, dass der Aufruf den Mittelpunkt angibt; S_XM und S_YM sind aber leer.
newer-centre-missing-hint = Mittelpunkt in S_XM und S_YM eingeben oder { "_AMODE" } auf 1 setzen.
newer-centre-unused = S_XM und S_YM geben den Mittelpunkt an, { "_AMODE" } ist aber { $value }: Programme haben dann dort 11.
newer-centre-unused-hint = { "_AMODE" } auf 11 setzen oder S_XM und S_YM leer lassen.
newer-no-list = { $cycle } mit Zahlen als Argumenten: Die ältere Steuerung erwartet hier Variablen; die Argumentliste neuerer Steuerungen ist nicht veröffentlicht.
newer-no-list-hint = An älteren Steuerungen Variablennamen schreiben. Sonst bleibt der Aufruf unverändert und wird weder geprüft noch simuliert.
write-assigned = { $cycle } wird mit Zuweisungen geschrieben: Die Stellen von Argument 1 seiner Liste sind nicht veröffentlicht.
write-assigned-hint = Ob diese Maschine auch Zuweisungen nimmt, zeigt ein Versuch an ihr.
write-coarse = Argument 2 = { $value } heißt Feinverschiebung; hier korrigiert { "_CHBIT[21]" } = 1 die Grobverschiebung.
write-coarse-hint = { $coarse } schreiben, um die Grobverschiebung zu korrigieren.
