# Hilfeseiten der Messmakros der NCT-Steuerungen.

help-stylus = Der Messtaster ist in der Spindel, seine Längenkorrektur ist aktiv, und er berührt nichts.
help-oriented = Die Spindel ist orientiert (M19), und wo die Maschine den Messtaster mit M-Funktionen schaltet, ist er ein (M59, das auch orientiert). Vor dem Spindelstart mit M55 ausschalten.
help-levels-none = Es ruft kein weiteres Makro und Unterprogramme auf 2 Ebenen auf. Die Ebene des aufrufenden Programms kommt dazu: Die Grenze steht in der Beschreibung der Steuerung.
help-levels-one = Es ruft Makros auf 1 Ebene und Unterprogramme auf 2 Ebenen auf. Die Ebene des aufrufenden Programms kommt dazu: Die Grenze steht in der Beschreibung der Steuerung.
help-levels-two = Es ruft Makros auf 2 Ebenen und Unterprogramme auf 2 Ebenen auf. Die Ebene des aufrufenden Programms kommt dazu: Die Grenze steht in der Beschreibung der Steuerung.
help-guarded = Der Messtaster wurde mit G101 dorthin gefahren; eine Kollision unterwegs hätte ihn angehalten.
help-steps = Eine Antastung hat drei Schritte: schnell bis zum Signal, mit mittlerem Vorschub zurück, sehr langsam wieder vor; der letzte Schritt gilt.
help-position-lost = Das letzte G101 hat sein Ziel nicht erreicht: OUT OF POSITION.
help-result = S korrigiert eine Nullpunktverschiebung um Messwert minus Nennwert, T den Werkzeugkorrekturspeicher für das nächste Werkstück; M speichert nur die Abweichung, plus bei zu viel Material. Ohne S und T keine Korrektur.
help-limits = Eine Abweichung größer als H ergibt OUT OF TOLERANCE; größer als U ergibt sie UPPER TOL EXEEDED, und das Makro korrigiert nichts.
help-both-targets = S und T sind beide angegeben: FORMAT ERROR. Eine Abweichung korrigiert nur eines von beiden.
help-middle-tolerance = Das Nennmaß ist nicht die Mitte der Toleranz: H gilt nach beiden Seiten (20 +0.1/−0.3 wird zu 19.9 mit H0.2).
help-one-system = Teils in inch, teils metrisch kalibriert: alles im selben Maßsystem kalibrieren.

help-g101-measures-nothing = Nichts: Das Makro fährt den Messtaster nach X, Y, Z und überwacht unterwegs jedes Signal.
help-g101-before-free = Die Längenkorrektur des Messtasters ist aktiv, und er berührt nichts.
help-g101-order-straight = Gerader Weg mit F, ohne Angabe 1500 mm/min; ein Signal hält die Bewegung sofort an.
help-g101-corrects-nothing = Nichts. Nach einem Halt bleibt gespeichert, dass das Ziel verfehlt wurde: Jedes Messmakro bricht ab, bis ein G101 sein Ziel erreicht.
help-g101-wrong-obstructed = Ein Hindernis liegt im Weg: PATH OBSTRUCTED. Messtaster von Hand wegfahren und einen anderen Weg wählen.
help-g101-wrong-incremental = Bei aktivem G91 sind die Adressen Wege, keine Positionen.

help-g102-measures-offset = Versatz der Messtasterkugel zur Spindelachse in beiden Achsen der Ebene.
help-g102-before-ring = Die orientierte Spindel steht auf der Achse einer soeben ausgespindelten Bohrung über 20 mm; oder #510 enthält die M-Funktion, die sie um 180° dreht, und die Kugel ist auf 10 mm genau in der Ringmitte.
help-g102-order-walls = Vier Wände in beiden Achsen; mit einer M-Funktion in #510 noch einmal mit um 180° gedrehter Spindel.
help-g102-corrects-offset = #504 und #505, radialer Versatz in der 1. und 2. Achse der Ebene.
help-g102-wrong-moved = Die Spindel steht nicht mehr auf der Achse der Bohrung, und #510 ist 0 (kein Umschlag um 180°): Der Lagefehler der Bohrung geht in den Versatz ein.

help-g103-measures-radius = Wirksamer Kugelradius in beiden Richtungen beider Achsen der Ebene.
help-g103-before-ring = G102 ist ausgeführt; die Kugel ist auf Tiefe, auf 10 mm genau in der Mitte eines Kalibrierrings.
help-g103-order-centre = Vier Wände ergeben den Mittelpunkt des Rings; von dort tastet der Messtaster jede Wand noch einmal an.
help-g103-corrects-radius = #500 und #501 für Plus und Minus der 1. Achse, #502 und #503 für die 2. Achse.
help-g103-wrong-size = D ist nur ungefähr angegeben: Der halbe Fehler geht in jeden Radius ein. Genaues Maß des Rings angeben.

help-g104-measures-length = Länge des Messtasters an einer Fläche, deren Koordinate in der Werkzeugachse bekannt ist.
help-g104-before-above = Die Kugel ist über der Fläche; der Längenkorrekturspeicher enthält die Länge auf 5 mm genau.
help-g104-order-down = Der Messtaster tastet abwärts an, höchstens bis 10 mm unter die angegebene Koordinate.
help-g104-corrects-register = Längenkorrekturspeicher T: Danach zeigt die Steuerung dort, wo die Kugel antastet, die angegebene Koordinate an.
help-g104-wrong-coordinate = Die Koordinate gehört zu einer anderen Nullpunktverschiebung als der aktiven.

help-g105-measures-surface = Position einer Fläche senkrecht zu einer Achse der Ebene.
help-g105-before-side = Die Kugel ist auf der freien Seite der Fläche: auf Tiefe oder, mit der Adresse der Werkzeugachse, darüber.
help-g105-order-touch = Mit der Adresse der Werkzeugachse fährt der Messtaster im Abstand R vor die Fläche und abwärts; dann tastet er zur Nennkoordinate hin an, höchstens um Q darüber hinaus.
help-g105-corrects-radius = T, ein Radiuskorrekturspeicher, wird um die ganze Abweichung korrigiert.
help-g105-wrong-far = Die Fläche liegt weiter als Q hinter ihrer Nennkoordinate: PROBE FAIL.

help-g106-measures-surface = Höhe einer Fläche senkrecht zur Werkzeugachse.
help-g106-before-above = Die Kugel ist über dem Antastpunkt.
help-g106-order-down = Der Messtaster tastet abwärts an, höchstens bis Q unter die Nennkoordinate.
help-g106-corrects-length = T, ein Längenkorrekturspeicher, wird um die ganze Abweichung korrigiert.
help-g106-wrong-low = Die Kugel ist schon um Q oder mehr unter der Nennkoordinate: NO MOVEMENT.

help-g107-measures-corner = Schnittpunkt der beiden Wände einer Innenecke.
help-g107-before-inside = Die Kugel ist auf Tiefe innerhalb der Ecke, frei von beiden Wänden; die Wände sind parallel zu den Achsen.
help-g107-order-walls = Wand senkrecht zur 1. Achse, zurück, dann Wand senkrecht zur 2. Achse, jede höchstens bis Q hinter ihre Nennkoordinate.
help-g107-corrects-offset = Nullpunktverschiebung S, ohne S die aktive, in beiden Achsen: Die Ecke erhält ihre Nennkoordinaten.
help-g107-wrong-turned = Das Werkstück ist schräg aufgespannt: Die Ecke wird korrigiert, ihre Richtung nicht.

help-g108-measures-corner = Schnittpunkt der beiden Wände einer Außenecke.
help-g108-before-before = Die Kugel ist auf Tiefe vor der Ecke, außerhalb beider Wände. So weit, wie sie vor der Ecke ist, liegen die Antastpunkte hinter der Ecke.
help-g108-order-walls = Der Messtaster fährt an der Ecke vorbei, tastet die Wand senkrecht zur 1. Achse an und fährt zurück; dann ebenso für die 2. Achse, jeweils höchstens bis Q hinter die Nennkoordinate.
help-g108-corrects-offset = Nullpunktverschiebung S, ohne S die aktive, in beiden Achsen um die Abweichung der Ecke.
help-g108-wrong-close = Die Startposition ist zu nah an der Ecke: Der Messtaster tastet nur Rundung oder Fase an.

help-g109-measures-pocket = Breite und Mitte einer Tasche in einer Achse der Ebene.
help-g109-measures-web = Breite und Mitte eines Stegs in einer Achse der Ebene.
help-g109-before-inside = Die Kugel ist auf Tiefe in der Nennmitte der Tasche.
help-g109-before-above = Die Kugel ist über der Nennmitte des Stegs.
help-g109-order-outwards = Der Messtaster tastet eine Wand nach außen an, dann die gegenüberliegende, jede höchstens bis Q hinter ihre Nennposition.
help-g109-order-inwards = Auf jeder Seite fährt der Messtaster im Abstand R neben die Wand und abwärts und tastet nach innen an, höchstens bis Q hinter die Nennposition.
help-g109-corrects-half = S wird um den Versatz der Mitte korrigiert; T, ein Radius, um die halbe Abweichung der Breite.
help-g109-wrong-width = Die Breite fehlt oder ist 0: FORMAT ERROR.
help-g109-wrong-room = Das korrigierte Werkzeug würde nicht mehr in die Tasche passen: TOOL DIA OFFS TOO LARGE.

help-g110-measures-bore = Mittelpunkt und Durchmesser einer Bohrung.
help-g110-measures-boss = Durchmesser und Mittelpunkt eines Zapfens.
help-g110-before-inside = Die Kugel ist auf Tiefe im Nennmittelpunkt der Bohrung.
help-g110-before-above = Die Kugel ist über dem Nennmittelpunkt des Zapfens.
help-g110-order-outwards = Der Messtaster tastet beide Wände in der 1. Achse an, dann beide in der 2. Achse, nach außen, jede höchstens bis Q hinter ihre Nennposition.
help-g110-order-inwards = Beide Wände in der 1. Achse, dann beide in der 2. Achse: Der Messtaster fährt jedes Mal im Abstand R neben die Wand und abwärts und tastet nach innen an, höchstens bis Q hinter die Nennposition.
help-g110-corrects-half = S wird in beiden Achsen um den Versatz des Mittelpunkts korrigiert; T, ein Radius, um die halbe Abweichung des Durchmessers.
help-g110-wrong-room = Das korrigierte Werkzeug würde nicht mehr in die Bohrung passen: TOOL DIA OFFS TOO LARGE.

help-p9920-measures-probe = Position und Durchmesser der Scheibe des Werkzeugmesstasters.
help-p9920-measures-length = Länge eines Werkzeugs.
help-p9920-measures-both = Länge und Durchmesser eines Werkzeugs.
help-p9920-before-reference = Der Referenzpunkt ist angefahren, und die Achse des Werkzeugmesstasters ist parallel zu Z.
help-p9920-before-centre = Das Referenzwerkzeug mit genau bekanntem Durchmesser ist über dem Mittelpunkt der Scheibe.
help-p9920-before-above = Das Werkzeug ist in Z über dem Werkzeugmesstaster, und dieser ist kalibriert.
help-p9920-order-rim = In +X, −X, +Y und −Y: vom Mittelpunkt um die halbe Summe beider Durchmesser plus E nach außen, um Z abwärts, zum Scheibenrand, wieder hoch.
help-p9920-order-face = Dann über dem Mittelpunkt abwärts auf die Scheibe und hoch zur Startposition.
help-p9920-order-length = In +X bis D/2 vom Mittelpunkt, dann höchstens um Z abwärts bis zur Antastung.
help-p9920-order-diameter = Nach der Antastung um K hoch, in +X bis zur halben Summe beider Durchmesser plus E vom Mittelpunkt, abwärts bis K unter die Antasthöhe, zum Scheibenrand.
help-p9920-corrects-probe = #506, #507 und #508 erhalten die Position der Scheibe, #509 ihren Durchmesser, #513 die Länge des Referenzwerkzeugs.
help-p9920-corrects-length = Länge im Speicher T, wie G43 sie verrechnet.
help-p9920-corrects-radius = Radius im Speicher T.
help-p9920-wrong-length = Nach dem Makro ist G49 aktiv, Vorschub und Drehzahl können geändert sein: vor Bewegungen in Z wieder eine Länge aktivieren.
help-p9920-wrong-turning = Ein Werkzeug, das sich drehend absenkt (M3, M4), kann die Scheibe abreißen.
help-p9920-wrong-lift = Mit einem Abhebeweg unter 2 mm kann das Werkzeug den Scheibenrand verfehlen.
help-p9920-wrong-disk = Der Scheibendurchmesser weicht um mehr als 2 mm von den 40 mm in #509 ab: Bis zum Kalibrieren rechnet das Makro mit einem falschen Durchmesser.
