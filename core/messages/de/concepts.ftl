# Concepts, explained for somebody who is new to measuring cycles.

concept-group-basics = Grundlagen

concept-measuring-cycles = Messzyklen
concept-measuring-cycles-1 = Ein Messzyklus ist ein fertiges Unterprogramm, das mit einem Messtaster misst. Nach dem Setzen der Parameter genügt der Aufruf: Der Zyklus führt alle Bewegungen selbst aus.
concept-measuring-cycles-2 = Es gibt zwei Arten: Bei der Werkstückmessung fährt der Messtaster zum Werkstück, bei der Werkzeugmessung fährt das Werkzeug zum Messtaster.
concept-measuring-cycles-3 = _MVAR legt fest, was der Zyklus misst und was er korrigiert. Sollwert, Messachse und Grenzwerte stehen in weiteren Parametern.
concept-measuring-cycles-4 = Die Ergebnisse stehen in _OVR (Sollwerte, Istwerte, Differenzen) und _OVI (Nummern von Zyklus, Messtaster und Alarm). Auf Wunsch schreibt der Zyklus sie auch in eine Werkzeugkorrektur oder eine NV.
concept-measuring-cycles-5 = Häufiger Fehler: Ein Parameter hat noch den Wert eines früheren Aufrufs. Vor jedem Aufruf alle Parameter der Messaufgabe setzen.

concept-workpiece-measurement = Werkstückmessung
concept-workpiece-measurement-1 = Der Messtaster sitzt in der Spindel oder im Revolver und fährt wie ein Werkzeug an das gespannte Werkstück. Seine D-Nummer muss aktiv sein.
concept-workpiece-measurement-2 = Vor der Bearbeitung wird gemessen, wo das Werkstück liegt, nach der Bearbeitung, welches Maß es hat, ohne es abzuspannen.
concept-workpiece-measurement-3 = _KNUM bestimmt das Korrekturziel: eine D-Nummer des Werkzeugs _TNUM oder eine NV. Mit _KNUM=0 misst der Zyklus nur.
concept-workpiece-measurement-4 = _TNUM ist das Werkzeug, das die Fläche bearbeitet hat, nicht der Messtaster. Der Zyklus korrigiert es, damit das nächste Werkstück maßhaltig wird.
concept-workpiece-measurement-5 = Häufiger Fehler: Späne oder Kühlmittel auf der Fläche. Der Zyklus misst sie mit; das Werkstück vor dem Messen reinigen.

concept-tool-measurement = Werkzeugmessung
concept-tool-measurement-1 = Das Werkzeug fährt zu einem Werkzeugmesstaster. Er ist fest in der Maschine montiert oder schwenkt in den Arbeitsraum ein.
concept-tool-measurement-2 = Der Zyklus schreibt Länge oder Radius in die Korrektur des aktiven Werkzeugs: mit _CHBIT[3]=0 in die Geometrie, der Verschleiß wird 0, mit _CHBIT[3]=1 in den Verschleiß.
concept-tool-measurement-3 = Die Position des Werkzeugmesstasters steht in _TP im MKS, in _TPW im WKS. _PRNUM wählt den Messtaster.
concept-tool-measurement-4 = Der neue Wert gilt nur, wenn die Differenz größer als _TZL und kleiner als _TDIF ist. So fällt ein gebrochenes Werkzeug auf.
concept-tool-measurement-5 = Häufiger Fehler: Die erste Länge in der Korrektur stimmt nur grob. Erreicht die Differenz _TDIF, korrigiert der Zyklus nichts: für ein neues Werkzeug _TDIF und _TSA größer wählen.

concept-prerequisites = Voraussetzungen für den Aufruf
concept-prerequisites-1 = Vor dem Aufruf müssen Maschine, Daten und Programm vorbereitet sein. Die meisten Fehler am Anfang kommen von einem dieser Punkte.
concept-prerequisites-2 = Maschine: Achsen nach DIN 66217, Maschinendaten angepasst, Referenzpunkte angefahren.
concept-prerequisites-3 = Daten: GUD5 und GUD6 sind aktiv, für Messen in JOG auch GUD7. Die Zyklen liegen im Verzeichnis der Standardzyklen.
concept-prerequisites-4 = Programm: G40 ist aktiv, alle Parameter sind gesetzt, und der Aufruf liegt höchstens in der 5. Programmebene.
concept-prerequisites-5 = Startposition: Der Messtaster erreicht sie auf gerader Linie ohne Kollision.
concept-prerequisites-6 = Maßsystem: Bei umschaltbaren Technologiedaten darf das Programm vom Grundsystem abweichen: G70 oder G700 bei metrischer Steuerung, G71 oder G710 bei inch-Steuerung.
concept-prerequisites-7 = Häufiger Fehler: Die Werkzeugradiuskorrektur ist noch aktiv. Vor dem Aufruf G40 programmieren.

concept-skip-and-simulation = Probelauf, Programmtest, Satzsuchlauf, Simulation
concept-skip-and-simulation-1 = In manchen Betriebszuständen läuft das Programm, aber die Messzyklen werden übersprungen. Dann wird nichts gemessen und nichts korrigiert.
concept-skip-and-simulation-2 = Übersprungen wird bei Probelauf und Programmtest, bei Satzsuchlauf nur ohne $A_PROTO=1. Bis SW 6.2 überspringt auch jede Simulation die Zyklen.
concept-skip-and-simulation-3 = Nach SW 6.2 führt die Simulation von HMI Advanced die Zyklen aus, mit _MC_SIMSIM=0 werden sie übersprungen. _MC_SIMDIFF gibt den simulierten Messpunkten eine Abweichung.
concept-skip-and-simulation-4 = Jobshop-Produkte simulieren die Messung, schreiben aber keine Korrektur, zeigen keine Ergebnisse, überwachen keine Kollision und schreiben kein Protokoll.
concept-skip-and-simulation-5 = Häufiger Fehler: _MC_SIMDIFF ist größer als die Grenzwerte des Aufrufs. Die Simulation hält dann mit den Alarmen des Zyklus an.

concept-group-coordinates = Koordinatensysteme und Ebenen

concept-coordinate-systems = Maschinen- und Werkstückkoordinatensystem
concept-coordinate-systems-1 = Das Maschinenkoordinatensystem (MKS) beginnt im Maschinennullpunkt M. Sein Istwert ist die Position des Werkzeugbezugspunkts F.
concept-coordinate-systems-2 = Das Werkstückkoordinatensystem (WKS) beginnt im Werkstücknullpunkt W. Sein Istwert ist die Position der Werkzeugspitze, beim Messtaster meist der Kugelmitte.
concept-coordinate-systems-3 = Werkstücke werden im WKS gemessen, so wie die Zeichnung bemaßt ist. Werkzeuge misst man einfacher im MKS, denn dort steht der Messtaster fest.
concept-coordinate-systems-4 = Beide Systeme lassen sich unabhängig auf inch oder metrisch einstellen. _TP enthält den Werkzeugmesstaster im MKS, _TPW im WKS.
concept-coordinate-systems-5 = Häufiger Fehler: Der Werkzeugmesstaster wird im WKS kalibriert und danach die NV geändert. Die Triggerpunkte in _TPW passen dann nicht mehr.

concept-bcs = Basiskoordinatensystem
concept-bcs-1 = Das Basiskoordinatensystem (BKS) liegt zwischen Maschinen- und Werkstückkoordinatensystem. Die Nullpunktverschiebungen bauen darauf auf.
concept-bcs-2 = Vom MKS unterscheidet es sich nur bei aktiver kinematischer Transformation, zum Beispiel TRANSMIT, TRACYL oder 5-Achs-Transformation.
concept-bcs-3 = Die Beschreibungen der Zyklen setzen voraus, dass keine Transformation aktiv ist. MKS und BKS sind dann gleich.
concept-bcs-4 = Häufiger Fehler: Beim Kalibrieren oder Messen ist noch eine Transformation aktiv. Im selben Zustand kalibrieren und messen.

concept-frames = Nullpunktverschiebung und Frame
concept-frames-1 = Eine Nullpunktverschiebung (NV) ist die Position des Werkstücknullpunkts W im MKS. Zusammen mit Drehung, Spiegelung und Maßstab heißt sie Frame.
concept-frames-2 = Basisframes, Systemframes, einstellbare (G54) und programmierbare Frames bilden eine Kette. Erst die ganze Kette ergibt das WKS, in dem der Zyklus misst.
concept-frames-3 = _KNUM wählt das zu korrigierende Frame: 1 bis 4 sind G54 bis G57, 5 bis 99 sind G505 bis G599, 9999 ist das aktive Frame.
concept-frames-4 = Nur 9999 wirkt sofort. Bei jeder anderen Nummer nach dem Zyklus G54 oder Entsprechendes programmieren, damit die neuen Werte gelten.
concept-frames-5 = Ein Maßstabsfaktor darf nicht aktiv sein: Alarm 61310. Drehung und Spiegelung sind nur in manchen Zyklen zulässig.
concept-frames-6 = Häufiger Fehler: Der Zyklus korrigiert G55, das Programm arbeitet mit G54. Die Korrektur ist eingetragen, aber ohne Wirkung.

concept-planes = Ebenen, Abszisse, Ordinate, Applikate
concept-planes-1 = Die Ebene bestimmt die Rolle der Achsen. Abszisse und Ordinate sind die 1. und 2. Achse der Ebene, die Applikate steht senkrecht darauf.
concept-planes-2 = G17: Abszisse X, Ordinate Y, Applikate Z. G18: Z, X, Y. G19: Y, Z, X.
concept-planes-3 = _MA zählt in dieser Reihenfolge: 1 Abszisse, 2 Ordinate, 3 Applikate. Mit _MA=1 misst ein Zyklus in G17 in X, in G18 in Z.
concept-planes-4 = Drehmaschinen arbeiten in G18; G17 und G19 sind für das Fräsen auf der Drehmaschine. Ein Durchmesser in X ist daher _MA=2.
concept-planes-5 = Häufiger Fehler: Die falsche Ebene ist aktiv. Dann verfährt eine andere Achse als erwartet, und auch die Werkzeuglänge wirkt in einer anderen Achse.

concept-tool-lengths = Werkzeuglängen nach Ebene und Typ
concept-tool-lengths-1 = Ein Werkzeug hat bis zu drei Längen. Ebene und Werkzeugtyp bestimmen, in welcher Achse jede Länge wirkt.
concept-tool-lengths-2 = Fräser, Bohrer und Messtaster (Typen 1xy, 2xy, 710): L1 wirkt in der Applikate, L2 in der Ordinate, L3 in der Abszisse. In G17 sind das Z, Y, X, in G18 Y, X, Z, in G19 X, Z, Y.
concept-tool-lengths-3 = L2 und L3 werden nur in Sonderfällen gebraucht, zum Beispiel bei einem Winkelkopf.
concept-tool-lengths-4 = Drehwerkzeuge (Typ 5xy) in G18: L1 wirkt in X (Ordinate), L2 in Z (Abszisse).
concept-tool-lengths-5 = An Drehmaschinen gilt für Bohrer und Fräser meist SD 42950 = 2: Ihre Längen wirken dann wie bei Drehwerkzeugen.
concept-tool-lengths-6 = Häufiger Fehler: SD 42950 ist beim Bearbeiten und beim Messen verschieden. Der Messwert landet dann in der falschen Länge des Werkzeugs.

concept-milling-on-lathe = Fräsen auf der Drehmaschine
concept-milling-on-lathe-1 = Eine Drehmaschine mit angetriebenem Werkzeug kann fräsen. Ohne Y-Achse geschieht das mit TRANSMIT auf der Stirnfläche oder mit TRACYL auf der Mantelfläche.
concept-milling-on-lathe-2 = Die Zyklen unterstützen Transformationen grundsätzlich. Wie weit, steht in der Beschreibung des jeweiligen Zyklus.
concept-milling-on-lathe-3 = Die Werkstückmesszyklen für Fräsmaschinen laufen auch auf Drehmaschinen mit 3. Geometrieachse. Der Messtaster hat dann Typ 5xy mit Schneidenlage 5 bis 8, SD 42950 ist 2.
concept-milling-on-lathe-4 = Mit Schneidenlage 5 oder 7 misst der Messtaster in G17, mit 6 oder 8 in G19.
concept-milling-on-lathe-5 = Häufiger Fehler: Beim Aufruf des Fräszyklus ist noch G18 vom Drehen aktiv. Ebene und D-Nummer vor dem Aufruf programmieren.

concept-group-probes = Messtaster

concept-probe-types = Messtastertypen: Multitaster, bidirektional, Monotaster
concept-probe-types-1 = Ein schaltender Messtaster wechselt sein Signal, wenn die Kugel ausgelenkt wird. Das Signal darf nicht prellen und muss anstehen, solange die Kugel ausgelenkt ist; ein Impuls genügt nicht.
concept-probe-types-2 = Ein Multitaster schaltet in allen Richtungen, ein bidirektionaler Messtaster in zwei entgegengesetzten, ein Monotaster nur in einer.
concept-probe-types-3 = Bei der Werkstückmessung gibt die Hunderterstelle von _PRNUM den Typ an: 0 Multitaster, 1 Monotaster oder bidirektional. _PRNUM=102 ist ein Monotaster mit dem zweiten Datenfeld, _WP[1,…].
concept-probe-types-4 = Die Werkstückmessung behandelt einen bidirektionalen Messtaster wie einen Monotaster. Beide brauchen länger, weil der Zyklus die Spindel mehrmals dreht.
concept-probe-types-5 = Häufiger Fehler: ein Monotaster für enge Toleranzen. Monotaster und bidirektionale Messtaster eignen sich nur für geringe Genauigkeit.

concept-probe-assignment = Welcher Messtaster für welche Aufgabe
concept-probe-assignment-1 = Nicht jeder Messtastertyp passt zu jeder Maschine. Die Aufgabe bestimmt, in wie vielen Richtungen der Messtaster schalten muss.
concept-probe-assignment-2 = Ein Multitaster ist überall möglich: Werkzeuge und Werkstücke an der Drehmaschine, Werkstücke an der Fräsmaschine.
concept-probe-assignment-3 = Ein bidirektionaler Messtaster misst Werkstücke an Dreh- und Fräsmaschinen, ein Monotaster nur Werkstücke an Fräsmaschinen.
concept-probe-assignment-4 = _PRNUM muss zum tatsächlichen Messtaster passen. Einige Varianten, zum Beispiel die Differenzmessung, erfordern einen Multitaster.
concept-probe-assignment-5 = Häufiger Fehler: _PRNUM gibt einen Multitaster an, der Messtaster schaltet aber nur in einer Richtung. Er berührt dann ohne Schaltsignal und kann beschädigt werden.

concept-mono-probe = Monotaster
concept-mono-probe-1 = Ein Monotaster schaltet nur in einer Richtung. Der Zyklus dreht die Spindel so, dass diese Richtung zur Fläche zeigt.
concept-mono-probe-2 = Die Spindel muss positionierbar sein (SPOS), und das Schaltsignal muss in jeder Stellung über 360° übertragen werden.
concept-mono-probe-3 = Den Messtaster in der Spindel so ausrichten, dass er bei 0° in G17 in +X misst, in G18 in +Z, in G19 in +Y.
concept-mono-probe-4 = Lässt er sich nicht genau ausrichten, korrigiert der Zyklus die Spindelstellung um den Winkel _CORA. Das gilt nur mit _CBIT[8]=1.
concept-mono-probe-5 = Häufiger Fehler: _CORA ist eingegeben, aber _CBIT[8] ist 0. Der Messtaster tastet dann neben seiner Schaltrichtung an, und die Werte streuen.

concept-signal-transmission = Signalübertragung
concept-signal-transmission-1 = Das Schaltsignal gelangt von der Spindel zum Empfänger am Maschinenständer: über Funk, Infrarot oder Kabel.
concept-signal-transmission-2 = Bei manchen Ausführungen gelingt das nur in bestimmten Spindelstellungen oder Bereichen. Maßgebend ist der Hersteller des Messtasters oder der Maschine.
concept-signal-transmission-3 = Die Zyklen drehen die Spindel beim Monotaster, beim Umschlag und, mit _CHBIT[13]=1, mit dem gedrehten Koordinatensystem. Auch dort muss das Signal ankommen.
concept-signal-transmission-4 = Häufiger Fehler: Von Hand schaltet der Messtaster, tief im Werkstück aber nicht. Ohne Signal fährt die Achse bis ans Ende des Messsatzes, dann folgt Alarm 61301.

concept-group-tools = Messtaster und Kalibrierwerkzeuge als Werkzeuge

concept-workpiece-probe-mill = Werkstückmesstaster an Fräsmaschinen
concept-workpiece-probe-mill-1 = Der Messtaster ist ein Werkzeug mit T- und D-Nummer. Sein Typ ist 710 (3D-Taster, ab SW 4) oder 1xy.
concept-workpiece-probe-mill-2 = Länge 1 (DP3) und Kugelradius (DP6) eintragen, das Basismaß (DP21) nur bei Bedarf. Verschleiß und alle übrigen Werte sind 0.
concept-workpiece-probe-mill-3 = _CBIT[14] legt fest, worauf sich Länge 1 bezieht: 0 auf die Kugelmitte, 1 auf das Ende der Kugel. Die eingetragene Länge muss dazu passen.
concept-workpiece-probe-mill-4 = Das genaue Schaltverhalten steht nicht in den Werkzeugdaten, sondern in _WP. Das Kalibrieren schreibt es dorthin.
concept-workpiece-probe-mill-5 = Häufiger Fehler: L1 und _CBIT[14] passen nicht zusammen. Die Länge ist dann um den Kugelradius falsch: 3 mm bei einer Kugel von 6 mm.

concept-workpiece-probe-turn = Werkstückmesstaster an Drehmaschinen
concept-workpiece-probe-turn-1 = An der Drehmaschine ist der Messtaster ein Drehwerkzeug, Typ 5xy, mit Schneidenlage (SL) 5 bis 8.
concept-workpiece-probe-turn-2 = Die Schneidenlage gibt an, wohin die Kugel zeigt. Beide Längen gehen bis zur Kugelmitte, bei Drehwerkzeugen dagegen bis zur Spitze.
concept-workpiece-probe-turn-3 = Länge 1, Länge 2 und Kugelradius eintragen. Verschleiß und alle übrigen Werte sind 0; Basismaße nur bei Bedarf.
concept-workpiece-probe-turn-4 = In den Kalibriernuten für SL 7 und SL 8 wird der Messtaster mit CYCLE973 kalibriert. Das Ergebnis steht in _WP.
concept-workpiece-probe-turn-5 = Häufiger Fehler: Die Längen sind wie beim Drehwerkzeug bis zum Rand der Kugel gemessen. Vor dem Kalibrieren ist jede Position um den Kugelradius falsch.

concept-calibration-tool-mill = Kalibrierwerkzeug für Werkzeugmesstaster, Fräsmaschinen
concept-calibration-tool-mill-1 = Zum Kalibrieren eines Werkzeugmesstasters ist ein Werkzeug mit genau bekannten Maßen nötig, meist ein zylindrischer Stift.
concept-calibration-tool-mill-2 = Es ist als Typ 1xy mit Länge 1 und Radius eingetragen, Verschleiß und alle übrigen Werte 0. Messen in JOG verwendet Typ 120.
concept-calibration-tool-mill-3 = CYCLE971 tastet damit den Messtaster an und speichert die Triggerpunkte in _TP oder _TPW.
concept-calibration-tool-mill-4 = Häufiger Fehler: Die Länge des Stifts stimmt nicht genau. Ein Fehler von 0.01 mm macht jede später gemessene Werkzeuglänge um 0.01 mm falsch.

concept-calibration-tool-turn = Kalibrierwerkzeug für Werkzeugmesstaster, Drehmaschinen
concept-calibration-tool-turn-1 = An der Drehmaschine gilt das Kalibrierwerkzeug als Drehwerkzeug: Typ 5xy, Schneidenlage 3.
concept-calibration-tool-turn-2 = Länge 1, Länge 2 und Radius sind genau bekannt. Verschleiß und alle übrigen Werte sind 0.
concept-calibration-tool-turn-3 = Seine Längen gehen bis zum Kugelumfang, nicht bis zur Kugelmitte. Beim Werkstückmesstaster gehen sie bis zur Mitte.
concept-calibration-tool-turn-4 = CYCLE982 kalibriert damit den Werkzeugmesstaster und speichert die Triggerpunkte in _TP oder _TPW.
concept-calibration-tool-turn-5 = Häufiger Fehler: Längen bis zur Kugelmitte. Jeder Triggerpunkt und jedes später gemessene Werkzeug ist dann um den Kugelradius falsch.

concept-group-calibration = Kalibrieren

concept-calibration = Kalibrieren
concept-calibration-1 = Ein Messtaster schaltet nicht genau dort, wo er berührt. Das Kalibrieren ermittelt an einem Körper mit bekannten Maßen, wo er schaltet; die Zyklen rechnen es ein.
concept-calibration-2 = Beim Werkstückmesstaster ergibt es Triggerpunkte, Lageabweichung und wirksamen Kugeldurchmesser in _WP, beim Werkzeugmesstaster Triggerpunkte in _TP oder _TPW.
concept-calibration-3 = Im Lieferzustand ist Platz für die Daten von 3 Messtastern, 99 sind möglich. _PRNUM wählt die Daten aus.
concept-calibration-4 = Mit demselben Vorschub und unter denselben Bedingungen kalibrieren und messen. Die Verzögerung des Signals hebt sich dann auf.
concept-calibration-5 = Vor dem ersten Einsatz kalibrieren und erneut nach Taststiftwechsel, Kollision, geändertem Vorschub oder neuem Einspannen des Messtasters.
concept-calibration-6 = Häufiger Fehler: Beim ersten Kalibrieren stehen in _WP noch Nullen. _TSA muss dann größer als der Kugelradius sein, sonst hält Alarm 61303 den Zyklus an.

concept-calibration-bodies = Kalibrierkörper
concept-calibration-bodies-1 = Ein Kalibrierkörper hat eine bekannte Position oder ein bekanntes Maß. Der Messtaster tastet ihn an; die Differenz zeigt, wie er schaltet.
concept-calibration-bodies-2 = An der Fräsmaschine verwendet CYCLE976 eine Bohrung oder einen Kalibrierring mit bekanntem Durchmesser oder eine formgenaue Fläche mit geringer Rauheit. Ein besonderer Kalibrierkörper ist nicht nötig.
concept-calibration-bodies-3 = An der Drehmaschine arbeitet CYCLE973 meist in Kalibriernuten, die fest in der Maschine sind, oder an einer bekannten Fläche. Position und Maße der Nuten stehen in _KB.
concept-calibration-bodies-4 = _CALNUM wählt das Nutpaar; im Lieferzustand gibt es 3 Datensätze. Ein Werkzeugmesstaster wird dagegen mit einem Kalibrierwerkzeug kalibriert.
concept-calibration-bodies-5 = Häufiger Fehler: Das eingegebene Maß stimmt nicht. Vom Fehler im Ringdurchmesser geht die Hälfte in jeden Triggerpunkt ein: 0.01 mm bei 0.02 mm Fehler.

concept-tool-probe-data = Daten des Werkzeugmesstasters vor dem Kalibrieren
concept-tool-probe-data-1 = Im Automatikbetrieb fährt der Zyklus den Werkzeugmesstaster selbst an. Dafür braucht er schon vor dem ersten Kalibrieren ungefähre Triggerpunkte in _TP oder _TPW.
concept-tool-probe-data-2 = _TP enthält die Daten im MKS, _TPW im WKS (ab SW 6.3). Die Position des Messtasters von Hand ermitteln und eintragen.
concept-tool-probe-data-3 = Eine Fläche, die in Minus-Richtung angetastet wird, liegt auf der Plus-Seite des Messtasters. Ihr Wert muss größer sein als der der gegenüberliegenden Fläche.
concept-tool-probe-data-4 = An der Fräsmaschine außerdem eintragen: Kantenlänge oder oberer Scheibendurchmesser in _TP[k,6], Form (Würfel oder Scheibe) in _TP[k,8] und Kalibriertiefe in _TP[k,9].
concept-tool-probe-data-5 = Häufiger Fehler: Ein Triggerpunkt ist noch 0. Der Zyklus positioniert das Werkzeug dann falsch; den ersten Lauf mit kleinem Override fahren.

concept-positional-deviation = Lageabweichung
concept-positional-deviation-1 = Die Kugel eines Messtasters liegt nie genau auf der Spindelachse. Dieser Abstand heißt Lageabweichung.
concept-positional-deviation-2 = Das Kalibrieren speichert sie in _WP[k,7] für die Abszisse und _WP[k,8] für die Ordinate: Kugelmitte minus Spindelachse. Die Zyklen korrigieren sie.
concept-positional-deviation-3 = Ohne Korrektur verschiebt eine Lageabweichung von 0.02 mm eine gemessene Position um bis zu 0.02 mm. In einer Breite hebt sie sich beim Multitaster auf, weil sich beide Seiten gleich verschieben.
concept-positional-deviation-4 = Ein Multitaster misst am genauesten, wenn derselbe Punkt der Kugel antastet wie beim Kalibrieren. Mit _CHBIT[13]=1 folgt die Spindel der Drehung der Ebene, _CHBIT[14] bestimmt die Richtung.
concept-positional-deviation-5 = Häufiger Fehler: Der Messtaster steht anders in der Spindel als beim Kalibrieren. Die Spindel vor dem Aufruf immer gleich positionieren.

concept-group-principle = Messprinzip

concept-on-the-fly = Fliegendes Messen
concept-on-the-fly-1 = Die Steuerung speichert die Position in dem Augenblick, in dem der Messtaster schaltet, während die Achse noch fährt. Das heißt fliegendes Messen.
concept-on-the-fly-2 = Das Signal wird direkt in der NC verarbeitet. Die Verzögerung ist klein; bei gleicher Genauigkeit ist ein höherer Messvorschub möglich.
concept-on-the-fly-3 = Der Weg während des Bremsens ist für den Messwert ohne Bedeutung. Er lenkt nur den Messtaster weiter aus.
concept-on-the-fly-4 = Häufiger Fehler: das Ergebnis nach der Position zu beurteilen, an der die Achse steht. Es gilt der Wert in _OVR.

concept-probe-inputs = Messtastereingänge
concept-probe-inputs-1 = Die Steuerung hat an ihrer Peripherieschnittstelle zwei Eingänge für schaltende Messtaster. Oft ist einer für den Werkstückmesstaster, der andere für den Werkzeugmesstaster.
concept-probe-inputs-2 = _CHBIT[0] wählt den Eingang für die Werkstückmessung, _CHBIT[1] den für die Werkzeugmessung: 0 ist Eingang 1, 1 ist Eingang 2.
concept-probe-inputs-3 = Zum Prüfen den Messtaster von Hand auslenken und den PLC-Status beobachten: DB10 DBX107.0 für Eingang 1, DB10 DBX107.1 für Eingang 2.
concept-probe-inputs-4 = Ist das Bit in Ruhe 1, stimmt die Polarität in MD 13200 nicht.
concept-probe-inputs-5 = Häufiger Fehler: Das Bit steht auf dem anderen Eingang. Der Messtaster berührt, der Zyklus erkennt nichts, es folgt Alarm 61301.

concept-measuring-sequence = Messsatz Schritt für Schritt
concept-measuring-sequence-1 = Jede Antastung läuft gleich ab. Der Zyklus berechnet eine Startposition, die um _FA vor dem Sollwert liegt, und fährt sie mit G0 oder G1 an.
concept-measuring-sequence-2 = Von dort fährt er mit Messvorschub _VMS höchstens zweimal _FA: bis zum Sollwert und ebenso weit darüber hinaus.
concept-measuring-sequence-3 = Schaltet der Messtaster, speichert die Steuerung die Position, hält die Achse an und löscht den Restweg. Die Achse fährt zur Startposition zurück.
concept-measuring-sequence-4 = Schaltet er nicht, versucht es der Zyklus bis zu fünfmal, mit _CHBIT[15]=1 einmal, und gibt dann Alarm 61301 aus. Wiederholungen beginnen in der Startposition.
concept-measuring-sequence-5 = Beispiel: Bei Sollwert 50 mm, Messung in Plus-Richtung und _FA=2 muss der Messtaster zwischen 48 mm und 52 mm schalten.
concept-measuring-sequence-6 = Häufiger Fehler: Das Werkstück liegt weiter als _FA neben dem Sollwert. Dann findet der Messtaster nichts oder berührt schon auf dem Weg zur Startposition.

concept-measuring-path = Messweg _FA
concept-measuring-path-1 = _FA ist der Abstand vom Start des Messsatzes bis zum Sollwert. Der Messsatz endet ebenso weit dahinter.
concept-measuring-path-2 = Voreingestellt ist 2: Der Messtaster sucht über insgesamt 4 mm. _FA ist auch der Abstand, mit dem ein Zyklus Werkstück oder Werkzeugmesstaster umfährt.
concept-measuring-path-3 = _FA ist immer in mm, auch bei Maßsystem inch. Für 0.1 inch ist 0.1 · 25.4 = 2.54 einzugeben.
concept-measuring-path-4 = Ein großes _FA findet auch ein weit verschobenes Werkstück, braucht aber Zeit und Platz. Bei _VMS=0 steigt mit _FA größer 1 auch der Messvorschub von 150 mm/min auf 300 mm/min.
concept-measuring-path-5 = Häufiger Fehler: _FA in inch. _FA=0.1 bedeutet 0.1 mm, und der Messtaster erreicht das Werkstück nicht. Nur CYCLE971 lässt negative Werte zu.

concept-measuring-feed = Messvorschub _VMS
concept-measuring-feed-1 = _VMS ist der Vorschub, mit dem der Messtaster antastet. Er bestimmt, wie weit der Messtaster ausgelenkt wird und wie genau der Wert ist.
concept-measuring-feed-2 = Bei _VMS=0 wählt der Zyklus: 150 mm/min mit _FA=1, 300 mm/min mit _FA größer 1. Im Grundsystem inch sind das 5.9055 inch/min und 11.811 inch/min.
concept-measuring-feed-3 = Ein Wert größer 0 gilt unverändert. Der höchste sichere Vorschub ergibt sich aus dem Bremsen der Achse, der zulässigen Auslenkung des Messtasters und der Verzögerung des Signals.
concept-measuring-feed-4 = Mit _CHBIT[17]=1 und _FA größer 1 tastet der Zyklus zweimal an: zuerst schnell mit _SPEED[3], dann 2 mm zurück und noch einmal mit _VMS.
concept-measuring-feed-5 = Häufiger Fehler: mit anderem Vorschub messen als kalibrieren. Die Triggerpunkte passen dann nicht mehr; für beides denselben Wert verwenden.

concept-deceleration = Bremsweg
concept-deceleration-1 = Nach dem Schalten des Messtasters fährt die Achse noch ein Stück weiter. Um diesen Weg muss sich der Messtaster auslenken lassen, sonst wird er beschädigt.
concept-deceleration-2 = Drei Anteile addieren sich: der Weg bis zum Bremsbefehl, der Weg während des Bremsens und der Schleppfehler.
concept-deceleration-3 = Sie ergeben sich aus Vorschub, IPO-Takt (MD 10050 mal MD 10070), Beschleunigung (MD 32300) und KV-Faktor (MD 32200). Es zählen die kleinsten Werte der beteiligten Achsen.
concept-deceleration-4 = Beispiel mit 300 mm/min, 16 ms, 1 m/s² und KV-Faktor 1: 0.08 mm + 0.0125 mm + 0.3 mm = 0.3925 mm. Bei 6000 mm/min sind es 12.6 mm.
concept-deceleration-5 = Mit derselben Achse erlaubt ein Messtaster mit 1 mm zulässiger Auslenkung höchstens 730 mm/min. Mehr geht nur mit größerer Auslenkung oder höherem KV-Faktor.
concept-deceleration-6 = Häufiger Fehler: Nur _VMS wird geprüft. _SPEED[1], _SPEED[2] und mit _CHBIT[17]=1 auch _SPEED[3] sind schneller, und auch daraus muss die Achse anhalten.

concept-accuracy = Messgenauigkeit
concept-accuracy-1 = Eine Messung ist nie genauer als die Wiederholgenauigkeit von Maschine und Messtaster. Auch die Auflösung der Messsysteme ist eine Grenze.
concept-accuracy-2 = Die Steuerung selbst hat beim fliegenden Messen eine Wiederholgenauigkeit von ±1 µm.
concept-accuracy-3 = Zwischen Berührung und gespeichertem Wert fährt die Achse weiter: bei 300 mm/min 0.005 mm in 1 ms, bei 150 mm/min die Hälfte. Weniger Vorschub verkleinert den Fehler.
concept-accuracy-4 = Kalibrieren mit demselben Vorschub beseitigt den konstanten Anteil. Übrig bleibt die Streuung; zehn Antastungen am selben Ort zeigen, wie groß sie ist.
concept-accuracy-5 = Bei drehender Spindel gemessene Werkzeuge weichen zusätzlich ab. _MT_COMP wählt dafür in CYCLE971 die Korrektur: zyklusintern oder über eigene Tabellen.
concept-accuracy-6 = Häufiger Fehler: Grenzwerte, die enger sind als die Streuung. Der Zyklus korrigiert dann Zufälle; _TZL sollte so groß sein wie die größte zufällige Abweichung.

concept-group-strategy = Messstrategie

concept-deviation-kinds = Drei Arten von Abweichungen
concept-deviation-kinds-1 = Die Differenz, die ein Zyklus misst, hat mehrere Ursachen. Drei Arten werden unterschiedlich behandelt.
concept-deviation-kinds-2 = Ohne Trend: immer gleich, zum Beispiel zwischen Messtaster und Messraum. Der Erfahrungswert _EV rechnet sie heraus.
concept-deviation-kinds-3 = Mit Trend: von Werkstück zu Werkstück wachsend, zum Beispiel durch Verschleiß oder Wärme. Nur dieser Anteil soll Korrektur werden; ihm folgt der Mittelwert _MV.
concept-deviation-kinds-4 = Zufällig: jedes Mal anders, zum Beispiel durch Schmutz oder Kühlmittel. Der Wichtungsfaktor _K hält den Einfluss klein.
concept-deviation-kinds-5 = Häufiger Fehler: Mit _K=1 wird jede Differenz über _TZL voll korrigiert. Das Werkzeug folgt dann dem Zufall, und die Maße streuen mehr als vorher.

concept-mean-value = Mittelwert
concept-mean-value-1 = Der Mittelwert sammelt die Differenzen einer Serie von Werkstücken. Er folgt dem Trend und glättet das Zufällige.
concept-mean-value-2 = Nach jedem Werkstück: neuer Mittelwert = alter Mittelwert − (alter Mittelwert − Differenz)/_K. Der Speicher _MV beginnt bei 0.
concept-mean-value-3 = Beispiel mit _K=3 und _TZL=0.04: Differenzen von 0.03 mm, 0.05 mm und 0.06 mm ergeben die Mittelwerte 0.010 mm, 0.023 mm und 0.036 mm, noch ohne Korrektur. Mit _K=2 ist der dritte Mittelwert 0.046 mm und wird korrigiert.
concept-mean-value-4 = Sobald der Mittelwert _TZL überschreitet, wird er zur Korrektur und der Speicher gelöscht. Ein großes _K reagiert langsam und ruhig, ein kleines schnell und unruhig.
concept-mean-value-5 = Er wirkt nur bei Werkstückmessung mit Werkzeugkorrektur. Von Werkstück zu Werkstück bleibt er nur mit _CHBIT[4]=1 und einer Speichernummer in _EVNUM erhalten.
concept-mean-value-6 = Häufiger Fehler: Zwei Maße teilen sich eine Speichernummer. Jedem gemessenen Maß in _EVNUM eine eigene Nummer geben.

concept-empirical-value = Erfahrungswert
concept-empirical-value-1 = Ein Erfahrungswert ist eine bekannte, konstante Abweichung einer Messung. Der Zyklus verrechnet ihn vor jeder Prüfung der Grenzwerte.
concept-empirical-value-2 = Er ist nötig, wenn Messtaster und Messraum immer um denselben Betrag abweichen, zum Beispiel weil das Werkstück gespannt oder warm ist.
concept-empirical-value-3 = Die Werte stehen in _EV. _EVNUM=11 nimmt _EV[10], _EVNUM=0 keinen; mit _EVNUM=90012 gelten _EV[11] und der Mittelwert _MV[8].
concept-empirical-value-4 = Mit _CHBIT[5]=0 wird er subtrahiert, mit 1 addiert. Beispiel: Der Messtaster ergibt 20.010 mm, der Messraum 20.004 mm: mit _CHBIT[5]=0 den Wert 0.006 eingeben.
concept-empirical-value-5 = Er wirkt bei Werkstückmessung mit Werkzeugkorrektur, bei 1-Punkt-Messung mit NV-Korrektur und bei Werkzeugmessung.
concept-empirical-value-6 = Häufiger Fehler: das falsche Vorzeichen. Die Abweichung verdoppelt sich dann, statt zu verschwinden; vor der Serie an einem Werkstück prüfen.

concept-tolerance-bands = Toleranzkette
concept-tolerance-bands-1 = Die Soll-Ist-Differenz fällt in einen Bereich. Jeder Bereich hat seine Reaktion, von nichts bis zum Alarm.
concept-tolerance-bands-2 = Die Grenzwerte müssen wachsen: _TZL < _TMV < _TUL und _TLL (Beträge) < _TDIF < _TSA. Die ganze Kette gilt bei Werkstückmessung mit Werkzeugkorrektur.
concept-tolerance-bands-3 = Bis _TMV wirkt der Mittelwert: Er wird korrigiert, sobald er _TZL überschreitet. Über _TMV wird die ganze Differenz korrigiert und der Mittelwert gelöscht.
concept-tolerance-bands-4 = Außerhalb von _TUL oder _TLL hat das Werkstück Aufmaß oder Untermaß: Meldung 62304 oder 62305. Auch hier wird die ganze Differenz korrigiert.
concept-tolerance-bands-5 = Über _TDIF wird nichts korrigiert: Meldung 62306, das Werkzeug ist vielleicht verschlissen oder gebrochen. Über _TSA hält Alarm 61303 das Programm an, denn Messtaster oder Sollwert stimmt nicht.
concept-tolerance-bands-6 = Ungleiche Toleranzen werden symmetrisch gemacht: _SETVAL=10, _TUL=0, _TLL=-0.004 ergeben in _OVR[0] den Sollwert 9.998, in _OVR[8] und _OVR[12] 0.002 und -0.002.
concept-tolerance-bands-7 = Häufiger Fehler: _TLL ohne Vorzeichen. Es gilt das Vorzeichen der Zeichnung: Für 0/-0.02 ist _TUL=0 und _TLL=-0.02 einzugeben.

concept-repetition = Mehrfachmessung und Messwiederholung
concept-repetition-1 = Ein Zyklus tastet denselben Ort aus drei Gründen mehrmals an: für einen besseren Mittelwert, nach einem zweifelhaften Wert oder weil kein Schaltsignal kam.
concept-repetition-2 = _NMSP ist die Anzahl der Messungen am selben Ort; es gilt der arithmetische Mittelwert. Mit _NMSP=3 ergeben 20.001, 20.003 und 20.002 den Wert 20.002.
concept-repetition-3 = Überschreitet eine Differenz _TDIF oder _TSA, misst der Zyklus mit _CBIT[0]=1 bis zu viermal neu. Mit _CBIT[1]=1 hält er vor jeder Wiederholung an, damit die Stelle gereinigt werden kann.
concept-repetition-4 = Kommt kein Schaltsignal, versucht es der Zyklus bis zu fünfmal, mit _CHBIT[15]=1 einmal. Danach hält ihn Alarm 61301 an.
concept-repetition-5 = Häufiger Fehler: ein hohes _NMSP gegen eine schmutzige Fläche. Jede Antastung trifft denselben Span; der Mittelwert wird stabil, aber nicht richtig.

concept-differential = Differenzmessung
concept-differential-1 = Der Zyklus tastet den ersten Punkt zweimal an, einmal mit um 180° gedrehter Spindel. Im Mittel beider Werte ist die Lageabweichung des Messtasters aufgehoben.
concept-differential-2 = So lässt sich auch ein nicht kalibrierter Messtaster verwenden.
concept-differential-3 = Nötig sind ein Multitaster und eine mit SPOS positionierbare Spindel. Monotaster und bidirektionale Messtaster müssen immer kalibriert sein.
concept-differential-4 = CYCLE978 misst mit einer 1 in der Tausenderstelle von _MVAR als Differenzmessung, CYCLE998 mit _MVAR=1105.
concept-differential-5 = Häufiger Fehler: Die Werkzeugdaten des Messtasters werden vernachlässigt. Länge und Kugelradius gehen weiterhin ein und müssen stimmen.

concept-protection-zone = Schutzzone
concept-protection-zone-1 = Eine Schutzzone hält den Messtaster von einem Hindernis fern. Beispiele sind ein Zapfen in der Mitte einer Bohrung oder ein Spanneisen neben einer Welle.
concept-protection-zone-2 = In CYCLE977 schaltet eine 1 in der Tausenderstelle von _MVAR sie ein. _SZA ist ihr Maß; beim Rechteck gilt _SZA in der Abszisse und _SZO in der Ordinate.
concept-protection-zone-3 = Bei Innenmessung hebt der Messtaster ab und fährt über die Zone. Bei Außenmessung ist die Zone der freie Raum samt Messelement, den er nicht verlassen darf.
concept-protection-zone-4 = In CYCLE994 sind _SZA und _SZO die Grenzen ab Werkstücknullpunkt, der Messtaster umfährt sie. Der Kugelradius ist einzurechnen.
concept-protection-zone-5 = Häufiger Fehler: Die Zone ist so groß wie das Messelement. Dann bleibt kein Platz für die Kugel, und es folgt Alarm 61334.

concept-collision-monitoring = Kollisionsüberwachung
concept-collision-monitoring-1 = Zwischen den Antastungen fährt ein Zyklus Zwischenpositionen an. Mit _CHBIT[2]=1 überwacht er dabei das Schaltsignal.
concept-collision-monitoring-2 = Berührt der Messtaster dort etwas, halten die Achsen an und Alarm 61302 erscheint. Meist bleiben Messtaster und Werkstück unbeschädigt.
concept-collision-monitoring-3 = Überwachte Wege fahren in der Ebene mit _SPEED[1], in der Zustellachse mit _SPEED[2], im Lieferzustand 1000 mm/min. Ohne Überwachung gilt _SPEED[0] in Prozent des Eilgangs.
concept-collision-monitoring-4 = Bei 1000 mm/min braucht eine Achse mit 1 m/s², 16 ms und KV-Faktor 1 zum Anhalten 1.4 mm. So weit muss sich der Messtaster auslenken lassen.
concept-collision-monitoring-5 = Häufiger Fehler: sich in eigenen Sätzen darauf zu verlassen. Sie wirkt nur im Zyklus, nicht auf dem Weg zur Startposition vor dem Aufruf.

concept-group-data = Parameter und Daten

concept-data-concept = Parameter und Daten
concept-data-concept-1 = Die Zyklen lesen ihre Vorgaben aus Variablen und geben Ergebnisse in Variablen zurück. Das sind globale Anwenderdaten (GUD) in GUD5, GUD6 und für JOG in GUD7.
concept-data-concept-2 = Pflichtparameter wie _SETVAL, _MA und _KNUM beschreiben die Aufgabe: vor jedem Aufruf setzen. Zusatzparameter wie _VMS, _FA und _TSA setzt man meist einmal.
concept-data-concept-3 = Werte kommen aus dem Programm, aus den Eingabemasken oder von Hand im Bedienbereich Parameter. Ergebnisse stehen in _OVR und _OVI.
concept-data-concept-4 = GUDs sind gepuffert und behalten ihre Werte über Netz-Aus. Lokale Daten (LUD) gibt es nur, solange der Zyklus läuft.
concept-data-concept-5 = Häufiger Fehler: ein Wert, den ein anderes Programm hinterlassen hat, zum Beispiel _KNUM oder _NMSP. Nicht gesetzte Parameter behalten den letzten Wert.

concept-bits = Zentrale und kanalspezifische Bits
concept-bits-1 = Bits sind Schalter: Sie schalten Funktionen der Zyklen ein und aus. Meist stellt sie der Maschinenhersteller einmal ein.
concept-bits-2 = _CBIT[] gibt es einmal im NCK, die Bits gelten für alle Kanäle. _CHBIT[] gibt es in jedem Kanal, die Bits gelten nur dort.
concept-bits-3 = Beispiele: _CBIT[0]=1 wiederholt eine zweifelhafte Messung. _CHBIT[2]=1 schaltet die Kollisionsüberwachung ein.
concept-bits-4 = Ein Programm darf sie ändern; sie behalten den neuen Zustand über Netz-Aus. Am Programmende zurücksetzen.
concept-bits-5 = Häufiger Fehler: ein _CBIT[] für einen Kanal ändern. Ab diesem Moment messen auch alle anderen Kanäle anders.

concept-units = Maßsystem der Parameter
concept-units-1 = Eine Steuerung hat ein Grundsystem, ein Programm kann auf das andere Maßsystem umschalten. Nicht alle Parameter folgen der Umschaltung.
concept-units-2 = Im aktiven Maßsystem: _SETVAL, _SETV, _ID, _CPA, _CPO, _SZA, _SZO, _TUL und _TLL. Es sind die Werte aus der Zeichnung.
concept-units-3 = Im Grundsystem: alle anderen Parameter mit Maßeinheit, zum Beispiel _TSA, _TDIF, _TZL und _VMS. _FA ist immer in mm.
concept-units-4 = Beispiel: eine metrische Steuerung mit aktivem G70. _SETVAL=1 ist 1 inch, _TSA=1 ist 1 mm, _FA=1 ist 1 mm.
concept-units-5 = Häufiger Fehler: alle Werte in inch. Bei metrischer Steuerung ist _TSA=0.04 dann nur 0.04 mm, und Alarm 61303 kommt bei einem guten Werkstück.

concept-group-modes = Betriebsarten

concept-measuring-jog = Messen in JOG
concept-measuring-jog-1 = Messen in JOG ist halbautomatisch und für Fräsmaschinen bestimmt. Die Aufgabe per Softkey wählen, die Maske ausfüllen, NC-Start drücken.
concept-measuring-jog-2 = Damit werden Werkstücke eingerichtet (Kante, Ecke, Tasche, Bohrung, Zapfen, Ebene), Messtaster abgeglichen und Werkzeuge gemessen.
concept-measuring-jog-3 = Den Messtaster mit Tasten oder Handrad in die Nähe des Messpunkts fahren. NC-Start tastet mit E_MESS_FM über höchstens zweimal E_MESS_D_M an, dann fährt der Messtaster zurück.
concept-measuring-jog-4 = Das Ergebnis geht in eine NV oder eine Werkzeugkorrektur. Die Einstellungen stehen in _JM_I (Nummern), _JM_B (Schalter) und den E_MESS-Daten.
concept-measuring-jog-5 = Häufiger Fehler: Der Messtaster steht zu weit weg, oder die Richtung in der Maske zeigt vom Werkstück weg. Alarm 61301: RESET drücken, näher heranfahren, neu starten.

concept-group-tasks = Messaufgaben

concept-overview-milling = Messaufgaben an Fräsmaschinen
concept-overview-milling-1 = Zuerst kalibrieren: CYCLE976 kalibriert den Werkstückmesstaster, CYCLE971 den Werkzeugmesstaster. CYCLE971 misst auch Länge und Radius von Werkzeugen.
concept-overview-milling-2 = CYCLE978 misst einen Punkt einer Fläche. CYCLE977 misst Bohrung, Welle, Nut, Steg und Rechteck achsparallel.
concept-overview-milling-3 = CYCLE979 misst Bohrung, Welle, Nut und Steg unter einem Winkel, Kreise aus drei oder vier Punkten.
concept-overview-milling-4 = CYCLE998 misst den Winkel einer Fläche, auch im Raum. CYCLE961 ermittelt eine Ecke, CYCLE997 eine oder drei Kugeln.
concept-overview-milling-5 = CYCLE977, CYCLE978 und CYCLE979 korrigieren ein Werkzeug oder eine NV, die drei letzten nur eine NV.
concept-overview-milling-6 = Häufiger Fehler: CYCLE977 für eine Nut, die nicht achsparallel liegt. Die Breite wird zu groß; CYCLE979 verwenden oder das Werkstück vorher ausrichten.

concept-overview-turning = Messaufgaben an Drehmaschinen
concept-overview-turning-1 = Zuerst kalibrieren: CYCLE973 kalibriert den Werkstückmesstaster in einer Kalibriernut oder an einer Fläche, CYCLE982 den Werkzeugmesstaster.
concept-overview-turning-2 = CYCLE982 misst Drehwerkzeuge, Bohrer und Fräser am Werkzeugmesstaster. CYCLE972 kalibriert ebenfalls, misst aber nur Drehwerkzeuge.
concept-overview-turning-3 = CYCLE974 misst einen Punkt: einen Durchmesser von einer Seite, eine Stirnfläche oder eine Länge. Mit Umschlag dreht die Spindel das Werkstück um 180°, die Rundlaufabweichung hebt sich auf.
concept-overview-turning-4 = CYCLE994 misst einen Durchmesser an zwei gegenüberliegenden Punkten. Er fährt außen um das Werkstück oder durch die Bohrung zur anderen Seite.
concept-overview-turning-5 = Häufiger Fehler: Radius und Durchmesser verwechselt. Mit DIAMON ist der Sollwert in X ein Durchmesser, _FA und die Korrektur einer Länge dagegen nicht.

# Bilder zum Ziehen: was gezogen wird und was herauskommt.
concept-drag-difference = Differenz
concept-drag-feed = Messvorschub
concept-drag-offset = Nullpunktverschiebung G54 in X
concept-drag-plane = Ebene (17, 18 oder 19)
concept-told-systems = F ab M (MKS): { $machine }. Kugelmitte ab W (WKS): { $workpiece }. Die Nullpunktverschiebung bewegt W und das Werkstück: Im WKS bleibt der Wert des Messtasters gleich.
concept-told-lengths = { $plane }, Typen 1xy, 2xy, 710: L1 in { $first }, L2 in { $second }, L3 in { $third }. Daneben ein Drehwerkzeug (5xy) in G18: L1 in { $turning }, L2 in { $along }. F ist der Werkzeugbezugspunkt.
concept-told-mean = { $count ->
        [0] Mit diesem Wichtungsfaktor führt keines der zehn Teile zu einer Korrektur.
        [one] Eines der zehn Teile führt zu einer Korrektur. Danach beginnt der Mittelwert wieder bei 0.
       *[other] { $count } der zehn Teile führen zu einer Korrektur. Danach beginnt der Mittelwert jeweils wieder bei 0.
    }
concept-told-latched = Der gespeicherte Wert bleibt, wo der Messtaster geschaltet hat. Die Achse hält { $path } mm dahinter; diese Stelle liest niemand.
concept-told-travel = In 1 ms fährt die Achse { $path } mm. Die Steuerung selbst wiederholt auf ±0,001 mm (das Band).
concept-told-units = Metrische Steuerung, G70 aktiv: _SETVAL={ $inches } sind { $length } mm, _TSA=1 und _FA=1 je 1 mm.
concept-told-empirical = Die gemessene Differenz { $measured } mm zählt als { $counts } mm.
concept-told-mono = { $beside ->
        [0] Der Messtaster tastet in seiner Schaltrichtung an.
       *[other] Der Messtaster tastet { $beside }° neben seiner Schaltrichtung an.
    }
concept-told-repeated = { $count ->
        [1] Eine Antastung, { $mean } µm neben der Stelle; der Messtaster streut um { $scatter } µm.
       *[other] Der Mittelwert aus { $count } Antastungen liegt { $mean } µm neben der Stelle. Er streut um { $scatter } µm, eine einzelne um { $single } µm.
    }

# Warum ein Konzept kein Bild hat.
concept-still-conditions = Kein Bild: Das sind Bedingungen, nichts bewegt sich.
concept-still-skipped = Kein Bild: Wo ein Zyklus übersprungen wird, bewegt sich nichts.
concept-still-same = Kein Bild: Ohne Transformation ist es das Maschinenkoordinatensystem.
concept-still-transformation = Kein Bild: Eine Transformation ist an keinem Werkstück zu sehen.
concept-still-table = Kein Bild: Das hängt von der Maschine ab, nicht von einer Position.
concept-still-electrical = Kein Bild: Das ist elektrisch, nichts bewegt sich.
concept-still-memory = Kein Bild: Das ist Speicher der Steuerung.
