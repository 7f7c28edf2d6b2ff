# Ein Programm, das viele Male läuft.

runs-title = Serie von Teilen
runs-intro = Führt das offene Programm auf der verwendeten Maschine aus, Teil nach Teil. Geben Sie an, was von Teil zu Teil streut; alles andere bleibt gleich.
runs-count = Teile
runs-seed = Startwert
runs-mode = Jedes Teil
runs-production = findet die Korrekturen des vorigen Teils vor
runs-independent = beginnt neu
runs-vary = Streut: { $number }
runs-what = Was
runs-asked = Teile und was streut
runs-answered = Ergebnis der Serie
runs-of-part = von Teil { $part }
runs-of-probe = des Messtasters
runs-of-name = anderes, mit Namen
runs-name = Name in der Einrichtungsdatei, oder data. und eine Variable
runs-units = Längen in mm, Winkel in Grad, Zeiten in Sekunden.
runs-as = Verteilung
runs-normal = Normalverteilung
runs-uniform = Gleichverteilung
runs-triangular = Dreieckverteilung
runs-arcsine = Arkussinusverteilung
runs-sigma = Standardabweichung
runs-half = Halbe Breite
runs-offset = Mittelwert
runs-drift = Drift je Teil
runs-per = Gezogen
runs-part = Teil
runs-series = einmal für alle
runs-follows = Folgt Korrekturen (Variable=Faktor; …)
runs-follow = { $name } ({ $variable }), Faktor { $factor }
runs-follow-add = Einer Korrektur des Programms folgen
runs-values = Werte nacheinander: { $values }
runs-add = Streuende Größe hinzufügen
runs-preset = Nach Namen hinzufügen
runs-remove = Entfernen
runs-choose = Grenzen und Wichtungsfaktor wählen
runs-program = Programm des Beispiels
runs-example = Beispiel: Mittelwert
runs-example-hint = Tabelle des Handbuchs ausführen: dieselben Teile mit Wichtungsfaktor 3 und mit 1.
runs-run = Serie ausführen
runs-stop = Abbrechen
runs-print = Drucken
runs-close = Schließen
runs-progress = Fortschritt der Serie
runs-running = Die Serie läuft.
runs-stopped = Die Serie wurde abgebrochen.
runs-no-program = Es gibt kein Programm: Öffnen Sie eines, oder führen Sie das Beispiel aus.
runs-in-file = In der Maschineneinrichtung: { $name }
runs-nothing = { $place }: „{ $name }“ ändert sich nicht. Standardabweichung oder halbe Breite, Mittelwert oder Drift eingeben.
runs-no-number = Das ist keine Zahl: { $text }
runs-whole = { $field }: eine ganze Zahl von { $least } bis { $most } eingeben
runs-ending =
    { $runs ->
        [one] 1 Teil
       *[other] { $runs } Teile
    }, { $finished } bis zum Programmende, Startwert { $seed }
runs-first = Diagramme und Tabelle zeigen die ersten { $count } Teile; alle Kennwerte gelten für alle Teile.
runs-no-call = Es wurde nichts gemessen.
runs-call = { $cycle }, Zeile { $line }: { $feature }
runs-weight = { $named }, { $name } = { $value }
runs-part-at = Teil { $part }
runs-parts = Teile
runs-actual = Istwert
runs-set = Sollwert
runs-limit = Grenze
runs-mean = Sollwert + Mittelwert { $name }
runs-empirical = Sollwert + Erfahrungswert { $name }
runs-spread = Mittelwert { $mean }, Standardabweichung { $deviation }, von { $min } bis { $max }
runs-capability = Cp { $cp } ({ $cpLow } bis { $cpHigh }), Cpk { $cpk } ({ $cpkLow } bis { $cpkHigh }), Vertrauensbereiche 95 %
runs-correction = Korrektur bei jedem Teil: { $name }
runs-correction-sum = Korrektur bis dahin: { $name }
runs-corrected =
    { $count ->
        [one] Korrigiert bei 1 Teil
       *[other] Korrigiert bei { $count } Teilen
    }
runs-shares = Ergebnisse
runs-with = Mit Korrektur
runs-without = Dieselben Teile ohne Korrektur
runs-alarms = Alarme
runs-no-alarm = Kein Alarm.
