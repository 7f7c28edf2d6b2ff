# Der Bremsweg einer Achse.

braking-path = Der Bremsweg ist { $sum } mm: { $delay } mm bis zum Bremsbefehl, { $braking } mm während des Bremsens, { $following } mm Schleppfehler.
braking-feed = Größter Vorschub für diese Auslenkung: { $feed } mm/min.
braking-value =
    { $name ->
        [delay] Verzögerungszeit
        [acceleration] Verzögerung
        [gain] Kreisverstärkung
        [feed] Vorschub
       *[deflection] Auslenkung
    } { $value } ist nicht möglich: eine Zahl { $name ->
        [delay] ab 0
       *[other] über 0
    } eingeben.
