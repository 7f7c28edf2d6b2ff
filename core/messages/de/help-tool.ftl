# Hilfeseiten der Zyklen am Werkzeugmesstaster.

help-tool-in-use = Das Werkzeug ist eingewechselt, seine D-Nummer ist aktiv; Ebene und G40 sind programmiert. Die Werkzeuglängen stehen in den Werkzeugdaten, zum Kalibrieren genau, sonst ungefähr.
help-tool-not-turned = Keine Koordinatendrehung ist aktiv; die Seiten des Messtasters liegen achsparallel.
help-tool-parallel = Die Seiten des Messtasters liegen parallel zu den Maschinenachsen.
help-tool-chip = Späne oder Kühlmittel an Schneide oder Messtaster: Der Messtaster schaltet zu früh, das Ergebnis ist falsch.

help-cycle971-measures-side = Lage einer Seite des Werkzeugmesstasters, mit einem Werkzeug, dessen Länge und Radius bekannt sind.
help-cycle971-measures-sides = Lage aller Seiten des Werkzeugmesstasters, die _TP[k,7] freigibt (werkstückbezogen: _TPW[k,7]), mit einem Werkzeug, dessen Länge und Radius bekannt sind.
help-cycle971-measures-tool = Länge L1 (_MA = 3, 103, 203) eines Fräswerkzeugs oder Bohrers oder Radius (_MA = 1, 2) eines Fräswerkzeugs.
help-cycle971-before-still = Die Spindel steht, die Schneide zeigt zum Messtaster; der Zyklus dreht die Spindel nicht.
help-cycle971-before-rotating = Drehzahl und Vorschub berechnet der Zyklus aus _CM[], mit _CBIT[12]=1 nimmt er sie aus _MFS[]. Eine drehende Spindel behält ihre Drehrichtung, für eine stehende gilt _CM[5].
help-cycle971-before-clear = Das Werkzeug steht frei auf der Seite, die es antasten soll: bei _MA = 3, 103, 203 über dem Messtaster, sonst daneben.
help-cycle971-before-parallel = Die Werkzeugachse liegt parallel zur Mittellinie des Messtasters.
help-cycle971-before-over = Der Weg ist frei: von der Startposition auf- oder abwärts bis _FA über der Messtasteroberkante und dort quer zur Messtastermitte.
help-cycle971-order-beside = Neben dem Messtaster: in der anderen Achse zur Mitte, vor die Seite, abwärts auf _TP[k,9] oder _TPW[k,9] unter die Oberkante, antasten, zurück. Der Zyklus endet auf dieser Tiefe.
help-cycle971-order-on-top = Oberseite (_MA = 3, 103, 203): über die Mitte, abwärts, antasten, Ende _FA darüber. Werkzeuge breiter als der Messtaster stehen um Radius minus _ID zur Startseite versetzt: Abszisse (3, 103), Ordinate (203); Bohrer nie.
help-cycle971-order-centre-first = Bei _MA = 102 oder 201 ermittelt der Zyklus vorher mit zwei Antastungen die Mitte in der anderen Achse.
help-cycle971-order-widest = Für einen Radius fährt das Werkzeug um _ID tiefer: Es tastet mit dem größten Durchmesser an.
help-cycle971-order-turning = Der Zyklus tastet ein- bis dreimal an, nach _CM[6] und _CM[7] oder, bei _CBIT[12]=1, nach _MFS[]; die letzte Antastung gilt. Stand die Spindel vorher, hält sie wieder an.
help-cycle971-order-all-sides = Sind alle Seiten freigegeben: Oberseite, beide Seiten der Ordinate (ergeben deren Mitte), dort beide Seiten der Abszisse, durch deren Mitte beide Seiten der Ordinate, wieder die Oberseite. Ende _FA darüber.
help-cycle971-wrong-depth = _TP[k,9] (werkstückbezogen: _TPW[k,9]) ist 0: Neben dem Messtaster fährt das Werkzeug nicht tief genug; bei der Radiusmessung Alarm 61349.
help-cycle971-wrong-unclear = Aus der Startposition des Werkzeugs geht nicht hervor, welche Seite anzutasten ist: Alarm 61332.
help-cycle971-wrong-edge = Die Schneide zeigt nicht zum Messtaster: Der Radius wird zu klein gemessen, ebenso die Länge eines Werkzeugs mit ungleich hohen Schneiden.
help-cycle971-wrong-master = Die Maße des Kalibrierwerkzeugs sind nicht genau bekannt: Der Fehler geht in jedes später gemessene Werkzeug ein.
help-cycle971-wrong-no-data = Länge oder Radius des Werkzeugs ist 0: Alarm 61351.
help-cycle971-wrong-direction = Die Spindel steht, und _CM[5] ist weder 3 noch 4: Alarm 61366.

help-cycle972-measures-side = Lage einer Seite des Werkzeugmesstasters, mit einem Kalibrierwerkzeug der Schneidenlage 3.
help-cycle972-measures-length = Eine Länge eines Drehwerkzeugs: L2 in der Abszisse, L1 in der Ordinate.
help-cycle972-order-travel = In der anderen Achse zur Messtastermitte, dann vor die Seite, antasten, zurück. Der Zyklus endet _FA vor der Seite.
help-cycle972-order-nose = Der Mittelpunkt des Schneidenradius steht vor der Messtastermitte; der Zyklus tastet die Seite an, auf der das Werkzeug startet.
help-cycle972-order-tip = Die Schneide tastet in der Richtung an, in die sie laut Schneidenlage zeigt.

help-cycle982-measures-side = Lage einer Seite des Werkzeugmesstasters der Drehmaschine, mit einem Kalibrierwerkzeug der Schneidenlage 3, dessen Längen und Schneidenradius bekannt sind.
help-cycle982-measures-one-length = Eine Länge eines Drehwerkzeugs, Fräswerkzeugs oder Bohrers: L2 mit _MA=1, L1 mit _MA=2; eines Bohrers bei SD 42950 = 0 immer L1.
help-cycle982-measures-radius = Radius eines Fräswerkzeugs; die Länge in der Achse des Radius muss bekannt sein.
help-cycle982-measures-both = Radius eines Fräswerkzeugs und die Länge in derselben Achse.
help-cycle982-measures-all = Drehwerkzeug: beide Längen, bei Schneidenlage 5 bis 8 nur eine. Fräswerkzeug: beide Längen und Radius (ist als Radius 0 eingetragen, nur die Längen). Bohrer: seine Länge.
help-cycle982-measures-upper = Längen und Radius eines Fräswerkzeugs an der oberen Schneide, zum Schaft hin, zum Beispiel eines Scheibenfräsers.
help-cycle982-before-outside = Das Werkzeug steht in beiden Achsen der Ebene außerhalb des Messtasters, auf der Seite, die es antasten soll; die Y-Achse steht auf der Messtastermitte.
help-cycle982-before-setting = Für Fräswerkzeuge und Bohrer ist SD 42950 gleich 2; für eine Länge eines Bohrers in G17 oder G19 auch 0.
help-cycle982-before-axial = Fräswerkzeug oder Bohrer liegt axial: Werkzeugachse in der Abszisse, Radius in der Ordinate.
help-cycle982-before-radial = Fräswerkzeug oder Bohrer liegt radial: Werkzeugachse in der Ordinate, Radius in der Abszisse.
help-cycle982-order-calibrate = In der anderen Achse mit dem Mittelpunkt des Schneidenradius zur Messtastermitte, dann vor die Seite, antasten, zurück. Der Zyklus endet _FA vor der Seite.
help-cycle982-order-spindle = Mit Fräswerkzeug oder Bohrer dreht eine stehende Frässpindel zuerst auf _STA1, außer bei _CHBIT[20]=1.
help-cycle982-order-reversal = Der Zyklus tastet jeden Punkt zweimal an, beim zweiten Mal mit um 180° plus _CORA gedrehter Spindel: Es gilt der Mittelwert beider Schneiden.
help-cycle982-order-length = In der anderen Achse zur Messtastermitte, vor die Seite, mit der Spitze antasten (Fräswerkzeug oder Bohrer quer zur Achse mit dem Umfang), zurück. Ende _FA vor der Seite.
help-cycle982-order-radius = Das Fräswerkzeug tastet mit dem Umfang an, in der Achse des Radius.
help-cycle982-order-both = Das Fräswerkzeug tastet mit dem Umfang die Seite an, auf der es startet, umfährt den Messtaster und tastet die Gegenseite an. Ohne Umschlag dreht die stehende Spindel dazu um 180°: Dieselbe Schneide tastet an.
help-cycle982-order-all = Zuerst in der Abszisse, dann in der Ordinate, um den Messtaster herum, ein Bohrer nur längs; ohne Umschlag dreht die stehende Spindel dieselbe Schneide zu jeder Seite. Ende: Startposition.
help-cycle982-order-upper-behind = Das Werkzeug umfährt den Messtaster auf der vom Start abgewandten Seite, tastet ihn dort für die Länge an und außerdem an beiden Seiten; zuerst misst der Zyklus in der Abszisse. Ende: Startposition.
help-cycle982-order-upper-across = Das Werkzeug überquert zuerst den Messtaster, tastet ihn für die Länge zurück in Richtung Start an und außerdem an beiden Seiten; zuerst misst der Zyklus in der Abszisse. Ende: Startposition.
help-cycle982-corrects-geometry = Das aktive Werkzeug: Der Zyklus trägt den Wert in die Geometrie ein und setzt den Verschleiß auf 0, unabhängig von dessen vorherigem Wert.
help-cycle982-wrong-axis = Der Radius liegt nicht in der Achse _MA: Alarm 61325.
help-cycle982-wrong-drill-radius = Das Werkzeug ist ein Bohrer; dessen Radius misst der Zyklus nicht: Alarm 61314.
help-cycle982-wrong-fast = Die Frässpindel dreht beim Antasten zu schnell: Schneide und Messtaster nehmen Schaden. Drehzahl verringern.
help-cycle982-wrong-wrong-side = Die Startposition liegt auf der falschen Seite oder zwischen zwei Seiten des Messtasters: Alarm 61332.
help-cycle982-wrong-nose = Schneidenradius oder Längen des Kalibrierwerkzeugs sind falsch: Der Fehler geht in jedes später gemessene Werkzeug ein.

help-tool-probe-known = Zum Kalibrieren geben die Triggerpunkte in _TP (werkstückbezogen: _TPW) die Lage der Messtasterseiten ungefähr an; zum Messen eines Werkzeugs ist der Messtaster kalibriert.
help-tool-block = Eine Antastung: bis _FA vor die Seite, von dort höchstens zweimal _FA weit, nach dem Schaltsignal zurück. Ist _NMSP größer als 1, wiederholt der Zyklus die Antastung; es gilt der Mittelwert.
help-tool-reach = Werkzeugdaten oder Messtasterdaten sind um mehr als _FA falsch: Der Messtaster schaltet nicht (Alarm 61301), oder das Werkzeug berührt ihn schon beim Anfahren (Alarm 61302).
help-tool-trigger = Die Messtasterdaten: der Triggerpunkt in _TP (werkstückbezogen: _TPW), wenn er um mehr als _TZL vom gespeicherten abweicht. Über _TSA: Alarm 61303, nichts wird gespeichert.
help-tool-data = Das aktive Werkzeug: Geometrie, der Verschleiß wird 0; mit _CHBIT[3]=1 nur der Verschleiß. Keine Korrektur bei einer Differenz bis _TZL oder ab _TDIF (Meldung 62306), ab _TSA Alarm 61303.
help-tool-in-front = Das Werkzeug steht schon vor der anzutastenden Seite, höchstens zweimal _FA entfernt. Kalibrieren: ohne Messtasterdaten; Werkzeug messen: diese Seite ist kalibriert.
help-tool-from-here = Das Werkzeug tastet von der Startposition aus an, höchstens zweimal _FA weit, und fährt zur Startposition zurück; keine andere Bewegung.
help-tool-trigger-always = Die Messtasterdaten: Der Triggerpunkt in _TP (werkstückbezogen: _TPW) wird immer gespeichert, unabhängig vom vorherigen Wert.
help-tool-unwatched = Kein Grenzwert überwacht das Ergebnis: Berührt das Werkzeug etwas anderes als den Messtaster, speichert der Zyklus den falschen Wert.
