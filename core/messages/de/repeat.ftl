# Wiederholtes Antasten einer Stelle: Testprogramme des Messtasters und ihre Auswertung.

repeat-control = Die Testprogramme sind für SINUMERIK-Steuerungen.
repeat-value = { $name ->
    [axis] Die Achse muss X, Y oder Z sein.
    [from] Die Startposition muss eine Zahl von -{ $most } bis { $most } sein.
    [to] Das Ende ohne Signal muss eine Zahl von -{ $most } bis { $most } und nicht die Startposition sein.
    [feed] Der Vorschub muss über 0 und darf höchstens { $most } sein.
    [input] Der Messeingang muss 1 oder 2 sein.
    [count] Die Anzahl der Antastungen muss eine ganze Zahl von { $least } bis { $most } sein.
   *[parameters] Der erste R-Parameter muss eine ganze Zahl von { $least } bis { $most } sein.
    }
repeat-few = Mindestens zwei Werte sind nötig.
repeat-many = Höchstens { $most } Werte werden ausgewertet.
repeat-not-a-number = { $value } ist keine Zahl.
repeat-no-signal = Der Messtaster hat unterwegs nicht geschaltet, deshalb gibt es keine Werte.
repeat-no-tool = Diese Maschine hat kein Werkzeug T{ $tool } D{ $edge }, also keinen Messtaster: ihn bei den Werkzeugen eintragen oder den Messtaster in die Spindel setzen.
repeat-no-probe = T{ $tool } D{ $edge } ist vom Typ { $kind }, also tastet hier kein Messtaster an: es mit Typ 710 eintragen, im Revolver mit 580, oder den Messtaster in die Spindel setzen.
repeat-behind = In dieser Richtung liegt die Messtasterkugel hinter dem Tastschaft, sodass sie nichts antasten kann. Ein Ende auf der anderen Seite des Starts wählen, etwa { $axis }{ $to }.
repeat-no-scatter = Der Messtaster dieser Maschine streut nicht: Jede Antastung ergibt denselben Wert. Seine Wiederholgenauigkeit eingeben oder Werte der realen Maschine einfügen.
repeat-diameters = Diese Werte von X sind Durchmesser: Die Wiederholgenauigkeit des Messtasters ist die Hälfte dieser Abweichung.
repeat-drift = Die Werte wandern von Antastung zu Antastung: Das ist nicht zufällig. Test mit warmer Maschine wiederholen.
repeat-narrow = Drei Standardabweichungen sind { $three }, mehr als das vorgeschlagene _TZL: Mehr Antastungen fänden größere Abweichungen.
repeat-switched = Funktionstest: Der Messtaster schaltet bei { $axis } = { $value }{ $unit }; das Programm hält bei M0, mit diesem Wert in R1
repeat-not-switched = Funktionstest: Der Messtaster schaltet nicht; das Programm hält bei M0 nach seiner Meldung
repeat-mean = { $count } Antastungen, Mittelwert { $mean }{ $unit }
repeat-deviation = Standardabweichung s = { $one }{ $unit }; 2 s = { $two }, 3 s = { $three }
repeat-range = Kleinster Wert { $smallest }, größter { $largest }, Spannweite { $range }{ $unit }
repeat-furthest = Größte Abweichung vom Mittelwert { $furthest }{ $unit }
repeat-slope = Drift { $slope }{ $unit } von Antastung zu Antastung (t = { $t })
repeat-zone = Vorschlag _TZL = { $zone }{ $unit }: die größte zufällige Abweichung, aufgerundet; { $two }{ $unit } für Durchmesser oder Breite, die aus zwei Antastungen entstehen
probe-test-function = Funktionstest: eine Antastung von Hand oder am Werkstück
probe-test-repeat = Wiederholgenauigkeit: Antastungen einer Stelle
probe-test-switched = Messtaster hat geschaltet, R1 = WKS, R2 = MKS
probe-test-failed = Messtaster hat nicht geschaltet
probe-test-done = Alle Antastungen fertig, Werte ablesen
