# Der Bremsweg einer Achse.

braking-path = Der Bremsweg ist { $sum } mm: { $delay } mm bis zum Bremsbefehl, { $braking } mm während des Bremsens, { $following } mm Schleppfehler.
braking-feed = Größter Vorschub für diese Auslenkung: { $feed } mm/min.
braking-value = { $name } = { $value } ist nicht möglich: eine positive Zahl eingeben.
