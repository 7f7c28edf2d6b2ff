# Terms of the manuals and what they mean.

term-actual-set-difference = Soll-Ist-Differenz
term-actual-set-difference-is = Istwert minus Sollwert; in den Formeln der Handbücher D. Mit ihr vergleicht der Zyklus die Grenzwerte, aus ihr berechnet er die Korrektur; ein Erfahrungswert ist bereits eingerechnet.
term-additive-offset = Summenkorrektur (DL)
term-additive-offset-is = Korrektur einer D-Nummer für einen Einsatzort des Werkzeugs, zusätzlich zu Geometrie und Verschleiß; sie verhält sich zur Einrichtekorrektur wie der Verschleiß zur Geometrie. _KNUM wählt sie (7. Stelle: 1 oder 3, bei 5-stelligen D-Nummern 9. Stelle), _DLNUM ist ihre Nummer; mit _CHBIT[6]=0 und _CHBIT[8]=0 addiert der Zyklus die Korrektur dazu.
term-asynchronous-subroutine = Asynchrones Unterprogramm (ASUP)
term-asynchronous-subroutine-is = Programm, das ein Interruptsignal jederzeit starten kann, unabhängig vom laufenden Programm. Messen in JOG läuft als ASUP: Nötig sind die Option „Betriebsartübergreifende Aktionen“, Bit 0 in MD 11602 und die Interruptnummer 9 (vor PLC SW 6.1: 8), die sonst niemand verwenden darf.
term-automatic-tool-offset = Automatische Werkzeugkorrektur
term-automatic-tool-offset-is = Der Zyklus schreibt das Ergebnis selbst in die Korrektur des Werkzeugs _TNUM; _KNUM enthält die D-Nummer und die zu korrigierende Länge oder den Radius, bei 0 wird nur gemessen. Die Grenzwerte entscheiden, ob und wie viel korrigiert wird; mit _CHBIT[6]=0 der Verschleiß, mit 1 die Geometrie.
term-basic-coordinate-system = Basiskoordinatensystem (BKS)
term-basic-coordinate-system-is = Koordinatensystem zwischen Maschinen- und Werkstückkoordinatensystem. Es unterscheidet sich vom Maschinenkoordinatensystem nur bei aktiver kinematischer Transformation, zum Beispiel TRANSMIT, TRACYL oder TRAORI.
term-blank-measurement = Rohteilmessung
term-blank-measurement-is = Werkstückmessung vor der Bearbeitung: ermittelt Position und Schräglage des gespannten Rohteils und korrigiert danach die Nullpunktverschiebung. So bearbeitet das Programm an der richtigen Stelle, auch wenn das Rohteil nicht genau aufgespannt ist.
term-calibrating-tool = Kalibrierwerkzeug
term-calibrating-tool-is = Werkzeug mit genau bekannten Maßen, meist ein zylindrischer Stift, mit dem die Triggerpunkte eines Werkzeugmesstasters ermittelt werden; an Fräsmaschinen Typ 1xy (in JOG 120), an Drehmaschinen Typ 5xy mit Schneidenlage 3 und Längen bis zum Kugelumfang. Sein Verschleiß ist 0; ein Maßfehler geht in jedes später gemessene Werkzeug ein.
term-calibration = Kalibrierung
term-calibration-is = Ermittelt, wo ein Messtaster schaltet, und speichert das in seinen Daten: _WP beim Werkstückmesstaster, _TP oder _TPW beim Werkzeugmesstaster. Vor dem ersten Einsatz und nach jeder Änderung am Messtaster kalibrieren: mit Vorschub, Ebene und Spindelstellung der späteren Messungen.
term-collision-monitoring = Kollisionsüberwachung
term-collision-monitoring-is = Mit _CHBIT[2]=1 überwacht der Zyklus beim Positionieren das Schaltsignal: Eine Berührung hält die Achsen mit Alarm 61302 an. Er positioniert dann mit _SPEED[1] und _SPEED[2]; daraus müssen die Achsen innerhalb der Auslenkung des Messtasters anhalten; mit _CHBIT[2]=0 wird nichts überwacht.
term-cutting-edge-position = Schneidenlage (SL)
term-cutting-edge-position-is = Kennzahl für die Richtung, in die die Werkzeugspitze oder die Kugel eines Werkstückmesstasters zeigt. Die Messzyklen messen Drehwerkzeuge mit 1 bis 8; ein Werkstückmesstaster an Drehmaschinen hat 5 bis 8, ein Kalibrierwerkzeug 3.
term-data-blocks-for-measuring-cycles = Datenbausteine der Messzyklen
term-data-blocks-for-measuring-cycles-is = Definitionsdateien mit allen Daten der Zyklen: GUD5 mit Aufrufparametern, Ergebnissen, Erfahrungs- und Mittelwerten, GUD6 mit den Einstellungen der Maschine und den Messtasterdaten, GUD7 und GUD7_MC mit Daten für Messen in JOG. Der Maschinenhersteller lädt sie bei der Inbetriebnahme und passt sie an; die Werte bleiben auch ohne Spannung gespeichert.
term-deceleration-path = Bremsweg (sb)
term-deceleration-path-is = Weg, den die Achse nach dem Schalten des Messtasters noch zurücklegt: Verzögerung bis zum Bremsbefehl, Bremsen, Schleppfehler. Um so viel muss sich der Messtaster auslenken lassen, sonst wird er beschädigt; das begrenzt den Messvorschub.
term-delete-distance-to-go = Restweglöschen
term-delete-distance-to-go-is = Schaltet der Messtaster, hält die Steuerung die Achse an und löscht den Rest des Messsatzes. Es zählt die beim Schaltsignal gespeicherte Position, nicht die, an der die Achse zum Stehen kommt.
term-differential-measurement = Differenzmessung
term-differential-measurement-is = Den ersten Punkt tastet der Zyklus zweimal an, mit um 180° gedrehter Spindel und in der ursprünglichen Stellung; die Lageabweichung hebt sich auf, der Messtaster muss nicht kalibriert sein. Nötig sind ein Multitaster und eine positionierbare Spindel; möglich in CYCLE978 (Tausenderstelle von _MVAR gleich 1) und CYCLE998 (_MVAR=1105).
term-dimension-difference-check = Maßdifferenzkontrolle
term-dimension-difference-check-is = Grenzwert, über dem der Zyklus eine Differenz nicht korrigiert: Meldung 62306, das Programm läuft weiter (mit _CBIT[2]=1 nach NC START). Ursache ist meist ein verschlissenes oder gebrochenes Werkzeug; _TDIF größer als die Toleranz und kleiner als _TSA wählen.
term-empirical-value = Erfahrungswert
term-empirical-value-is = Bekannte, konstante Abweichung einer Messung, in _EV[] gespeichert und mit _EVNUM gewählt. Der Zyklus subtrahiert sie vom Messwert (mit _CHBIT[5]=1 addiert er sie), bevor er Grenzwerte prüft: bei automatischer Werkzeugkorrektur, 1-Punkt-Messung für eine NV und Werkzeugmessung.
term-following-error = Schleppfehler
term-following-error-is = Weg, um den eine fahrende Achse ihrer Sollposition nacheilt: Geschwindigkeit geteilt durch KV-Faktor. Er verlängert den Bremsweg, geht aber nicht ins Ergebnis ein, da die Istposition gespeichert wird.
term-frame = Frame
term-frame-is = Nullpunktverschiebung, die auch Drehung, Spiegelung und Maßstab enthalten kann; Basisframes, Systemframes, einstellbare und programmierbare Frames wirken als Kette. Beim Messen darf kein Maßstabsfaktor aktiv sein (Alarm 61310), in manchen Zyklen und Messvarianten auch keine Drehung oder Spiegelung.
term-gauging-block = Kalibrierkörper
term-gauging-block-is = Körper mit bekannten Maßen und bekannter Position, an dem ein Werkstückmesstaster an Drehmaschinen kalibriert wird: meist ein Paar Kalibriernuten, eine für Schneidenlage 7, eine für 8. Seine Daten stehen in _KB[], im MKS, in X als Radius; _CALNUM wählt den Datensatz.
term-log-of-measuring-results = Protokoll der Messergebnisse
term-log-of-measuring-results-is = Datei im Teileprogrammspeicher, in die von CYCLE100 bis CYCLE101 jeder Messzyklus seine Ergebnisse schreibt; ihr Name steht in _PROTNAME[1]. Als Nachweis der Messungen lässt sie sich aus der Steuerung auslesen.
term-mean-value = Mittelwert
term-mean-value-is = Gewichteter, laufender Mittelwert der Differenzen von Werkstück zu Werkstück; er folgt einem Trend wie dem Verschleiß: neu = alt − (alt − Differenz)/_K. Differenzen bis _TMV gehen ein; über _TZL wird er zur Werkzeugkorrektur und der Speicher 0; in _MV[] bleibt er nur mit _CHBIT[4]=1 und _EVNUM größer 0.
term-measure-workpiece = Werkstückmessung
term-measure-workpiece-is = Der Messtaster wird wie ein Werkzeug an das gespannte Werkstück gefahren und tastet es an. Das Ergebnis kann das Werkzeug korrigieren, das die Fläche bearbeitet hat, oder eine Nullpunktverschiebung.
term-measurement-path = Messweg
term-measurement-path-is = Abstand vom Start des Messsatzes zur erwarteten Position; der Messsatz endet ebenso weit dahinter, der Messtaster muss also innerhalb von zweimal _FA schalten, sonst Alarm 61301. Immer in mm, auch wenn die Steuerung in inch arbeitet.
term-measurement-result-display = Messergebnisbild
term-measurement-result-display-is = Bild, in dem ein Zyklus Sollwerte, Istwerte und Differenzen anzeigt; _CHBIT[10]=1 schaltet es ein. Mit _CHBIT[11]=1 wartet das Programm auf NC START; mit 0 schließt das Bild am Zyklusende oder bleibt mit _CHBIT[18]=1 bis zum nächsten Messzyklus stehen.
term-measuring-at-an-angle = Messen unter einem Winkel
term-measuring-at-an-angle-is = CYCLE979 misst Bohrung, Welle, Nut oder Steg in Richtungen, die ein Winkel im WKS bestimmt, nicht dessen Achsen. _STA1 ist der Winkel des ersten Punkts zur Abszisse, gegen den Uhrzeigersinn positiv.
term-measuring-accuracy = Messgenauigkeit
term-measuring-accuracy-is = Begrenzt durch die Wiederholgenauigkeit von Maschine und Messtaster und die Auflösung der Messsysteme; die Steuerung trägt beim fliegenden Messen ±1 µm bei. Signalverzögerungen verschieben das Ergebnis, bei kleinem Vorschub weniger; deshalb mit dem Vorschub der Kalibrierung messen.
term-measuring-axis = Messachse
term-measuring-axis-is = Achse, in der der Messtaster beim Messen verfährt: 1 Abszisse, 2 Ordinate, 3 Applikate. Welche Achsen das sind, bestimmt die Ebene: X, Y, Z bei G17, Z, X, Y bei G18, Y, Z, X bei G19.
term-measuring-direction = Messrichtung
term-measuring-direction-is = Richtung, in der der Messtaster in der Messachse verfährt: 0 plus, 1 minus. Nötig, wo die Startposition sie nicht bestimmt, zum Beispiel beim Kalibrieren eines Werkstückmesstasters an einer Fläche.
term-measuring-in-jog = Messen in JOG
term-measuring-in-jog-is = Halbautomatisches Messen an Fräsmaschinen: Aufgabe per Softkey wählen, Maske ausfüllen, Achsen nahe an den Punkt fahren, NC-Start drücken. Damit lassen sich NV, Werkzeuglängen und Werkzeugradien setzen und Messtaster kalibrieren; die Einstellungen stehen in _JM_I[], _JM_B[] und den E_MESS_…-Daten.
term-measuring-tool = Werkzeugmessung
term-measuring-tool-is = Das Werkzeug fährt an einen festen oder eingeschwenkten Werkzeugmesstaster; Länge oder Radius geht in die Werkzeugkorrektur: mit _CHBIT[3]=0 in die Geometrie, der Verschleiß wird gelöscht, mit 1 die Differenz in den Verschleiß. _TP[] enthält die Messtasterdaten im MKS, _TPW[] die im WKS.
term-measuring-variant = Messvariante
term-measuring-variant-is = Zahl, deren Stellen dem Zyklus sagen, was er misst und was er korrigiert; jeder Zyklus hat eigene Messvarianten. Eine Messvariante, die der Zyklus nicht hat, löst Alarm 61307 aus.
term-measuring-velocity = Messgeschwindigkeit, Messvorschub
term-measuring-velocity-is = Vorschub im Messsatz. Die Achse muss daraus innerhalb der zulässigen Auslenkung des Messtasters anhalten; beim Kalibrieren und Messen denselben Vorschub verwenden.
term-mono-probe = Monotaster
term-mono-probe-is = Messtaster, der nur in einer Richtung schaltet; in _PRNUM ist die Hunderterstelle 1. Nur für Werkstücke an Fräsmaschinen und geringere Genauigkeit: Die Spindel muss mit SPOS positionierbar sein und dreht den Messtaster für jede Richtung, was Zeit kostet; das Signal muss in jeder Winkelstellung ankommen.
term-multi-probe = Multitaster
term-multi-probe-is = Messtaster, der in allen Richtungen der drei Achsen schaltet; in _PRNUM ist die Hunderterstelle 0. Für Werkstücke an Fräs- und Drehmaschinen und für Drehwerkzeuge; am genauesten misst er, wenn derselbe Punkt der Kugel antastet wie beim Kalibrieren.
term-multiple-measurement-at-one-place = Mehrfachmessung am selben Ort
term-multiple-measurement-at-one-place-is = Der Zyklus tastet jeden Punkt _NMSP-mal an; es gilt der arithmetische Mittelwert. Das verringert die zufällige Streuung, nicht aber einen konstanten Fehler, und dauert länger.
term-offset-angle-position = Korrekturwinkel (Korrekturwinkellage)
term-offset-angle-position-is = Winkel in Grad, um den der Zyklus die Spindelstellung eines Monotasters korrigiert, damit dessen Schaltrichtung stimmt; gilt mit _CBIT[8]=1. In CYCLE982 korrigiert er beim Messen eines Fräswerkzeugs die Spindelstellung nach dem Umschlag.
term-offset-axis = Versatzachse
term-offset-axis-is = Achse, in der der Zyklus zwischen zwei Messpunkten weiterfährt; ihre Nummer ist die Hunderterstelle von _MA: 102 ist Versatzachse 1, Messachse 2. Zum Beispiel in CYCLE998, für den Abstand der Punkte eines Winkels, und in CYCLE971.
term-on-the-fly-measurement = Fliegendes Messen
term-on-the-fly-measurement-is = Die NC verarbeitet das Schaltsignal selbst und speichert die Achsposition im Augenblick des Schaltens, während die Achse noch fährt. Die Verzögerung ist klein, deshalb ist bei gleicher Genauigkeit ein höherer Messvorschub möglich.
term-oversize = Aufmaß
term-oversize-is = Die Differenz liegt über der Toleranzobergrenze _TUL: Meldung 62304; ist _KNUM nicht 0, korrigiert der Zyklus sofort, ohne Mittelwert, und mit _CBIT[2]=1 wartet das Programm auf NC START. Eine Welle mit Aufmaß ist nacharbeitbar, eine Bohrung nicht.
term-paraxial-measurement = Achsparalleles Messen
term-paraxial-measurement-is = Messen parallel zu den Achsen des Werkstückkoordinatensystems: CYCLE977 für Bohrung, Welle, Nut, Steg oder Rechteck, CYCLE978 für eine Fläche. Liegt das Messelement schräg, ist das Ergebnis falsch: zuerst das Koordinatensystem ausrichten oder unter einem Winkel messen.
term-positional-deviation = Lageabweichung
term-positional-deviation-is = Abstand der Kugelmitte von der Spindelachse, in Abszisse und Ordinate. Die Kalibrierung ermittelt sie, die Messzyklen rechnen sie ein; der gespeicherte Wert gilt für die Spindelstellung beim Kalibrieren.
term-probe-ball-diameter = Kugeldurchmesser des Messtasters
term-probe-ball-diameter-is = Wirksamer Durchmesser der Messtasterkugel, mit dem die Zyklen rechnen. Er enthält den Weg bis zum Schalten und ist deshalb nicht das Maß der Bügelmessschraube; die Kalibrierung ermittelt ihn, CYCLE979 braucht ihn immer.
term-probe-type = Messtastertyp
term-probe-type-is = Nach den Schaltrichtungen gibt es Multitaster, bidirektionale Messtaster und Monotaster; bei der Werkstückmessung gilt der bidirektionale als Monotaster. Nötig ist ein schaltender Messtaster, dessen Signal praktisch prellfrei ansteht, solange er ausgelenkt ist; ein kurzer Impuls genügt nicht.
term-protection-zone = Schutzzone
term-protection-zone-is = Zone um den Sollmittelpunkt (in CYCLE994 durch ihre Grenzen angegeben). In Bohrung oder Nut ist sie das Hindernis, in das der Messtaster nicht fahren darf, um Welle oder Steg der freie Raum samt Messelement, den er nicht verlassen darf; zu wenig Platz für die Kugel löst Alarm 61334 aus.
term-reference-groove = Kalibriernut
term-reference-groove-is = Fest in der Maschine angebrachte Nut mit genau bekannter Position, zum Kalibrieren von Werkstückmesstastern an Drehmaschinen mit CYCLE973. Kanten und Boden stehen in _KB[], im MKS, in X als Radius; ein Fehler darin geht in jede spätere Messung ein.
term-repeat-accuracy = Wiederholgenauigkeit
term-repeat-accuracy-is = Streuung bei wiederholtem Antasten derselben Stelle: Maschine, Messtaster und Signalübertragung zusammen. An jeder Maschine mit zehn oder mehr Antastungen ermitteln; _TZL soll mindestens so groß sein wie die größte zufällige Abweichung.
term-safe-area = Vertrauensbereich
term-safe-area-is = Äußerster Grenzwert: Eine Differenz darüber heißt, dass Messtaster, Sollwert oder Aufspannung nicht stimmt, nicht das Maß; beim ersten Kalibrieren eines Werkstückmesstasters muss er größer als der Kugelradius sein. Alarm 61303 hält das Programm bis NC RESET an, nichts wird korrigiert; mit _CBIT[0]=1 wiederholt der Zyklus die Messung vorher bis zu viermal.
term-servo-gain = KV-Faktor (Kv)
term-servo-gain-is = Verhältnis von Geschwindigkeit zu Schleppfehler einer Achse, in (m/min)/mm. Ein großer Wert ergibt einen kurzen Bremsweg; es zählt der kleinste Wert der messenden Achsen.
term-setpoint = Sollwert
term-setpoint-is = Position oder Maß aus der Zeichnung, bei dem der Messtaster schalten soll; _SETV[] enthält weitere, zum Beispiel die Längen eines Rechtecks. Er gilt im aktiven Maßsystem, inch oder metrisch; ist er falsch, folgt Alarm 61301 oder 61303, oder ein gutes Werkzeug wird korrigiert.
term-setup-offset = Einrichtekorrektur (DL)
term-setup-offset-is = Korrektur einer D-Nummer für einen Einsatzort, beim Einrichten eingegeben und gewählt wie die Summenkorrektur; ohne Bit 4 in MD 18112 gibt es sie nicht (Alarm 61409). Mit _CHBIT[8]=1 addiert der Zyklus die Korrektur dazu; mit _CHBIT[8]=0 und _CHBIT[6]=1 addiert er auch die Summenkorrektur und setzt diese auf 0.
term-tolerance-bottom-limit = Toleranzuntergrenze
term-tolerance-bottom-limit-is = Untere Toleranz der Zeichnung, mit Vorzeichen, bezogen auf den Sollwert und im aktiven Maßsystem. Liegt die Differenz darunter, folgt Meldung 62305, und der Zyklus korrigiert das Werkzeug sofort, ohne Mittelwert.
term-tolerance-top-limit = Toleranzobergrenze
term-tolerance-top-limit-is = Obere Toleranz der Zeichnung, mit Vorzeichen, bezogen auf den Sollwert und im aktiven Maßsystem. Sind _TUL und _TLL nicht symmetrisch, rechnet der Zyklus mit der Toleranzmitte als Sollwert; Differenzen über _TMV (meist zwei Drittel der Toleranz) bis _TDIF korrigiert er sofort und löscht den Mittelwert.
term-tool-environment = Werkzeugumgebung
term-tool-environment-is = Bedingungen, unter denen ein Werkzeug arbeitet (Ebene, Längenzuordnung, Einstellungen), mit TOOLENV unter einem Namen mit bis zu 32 Zeichen gespeichert; ab NCK SW 6.3. Mit _TENV korrigiert eine spätere Messung das Werkzeug so, wie es eingesetzt war, auch wenn Ebene oder Längenzuordnung inzwischen anders sind; T-, D- und DL-Nummer können daraus stammen.
term-tool-name = Werkzeugname
term-tool-name-is = Bei Werkzeugverwaltung der Name des zu korrigierenden Werkzeugs statt der Nummer. Er gilt nur, wenn _TNUM 0 ist: Eine T-Nummer aus einem früheren Aufruf hat Vorrang.
term-tool-number = Werkzeugnummer (T-Nummer)
term-tool-number-is = Nummer des Werkzeugs, das nach der Messung korrigiert wird. Es muss das Werkzeug sein, das die gemessene Fläche bearbeitet hat, nicht der Messtaster in der Spindel.
term-trigger-point = Triggerpunkt
term-trigger-point-is = Position, bei der ein Messtaster schaltet, für jede Achse und Richtung gespeichert. Beim Werkzeugmesstaster ist es die Position selbst, im MKS (_TP) oder WKS (_TPW), beim Werkstückmesstaster der Abstand zur wahren Position der Fläche (_WP).
term-undersize = Untermaß
term-undersize-is = Die Differenz liegt unter der Toleranzuntergrenze _TLL: Meldung 62305; ist _KNUM nicht 0, korrigiert der Zyklus sofort, ohne Mittelwert, und mit _CBIT[2]=1 wartet das Programm auf NC START. Eine Bohrung mit Untermaß ist nacharbeitbar, eine Welle nicht.
term-variable-measuring-speed = Variable Messgeschwindigkeit
term-variable-measuring-speed-is = Messvorschub als Parameter des Aufrufs: Größer als 0 gilt er wie eingegeben, in mm/min oder inch/min des Grundsystems; bei 0 wählt der Zyklus 150 mm/min für _FA=1 und 300 mm/min für einen längeren Messweg.
term-weighting-factor = Wichtungsfaktor
term-weighting-factor-is = Wie stark eine einzelne Differenz den Mittelwert verschiebt: um den _K-ten Teil ihres Abstands zu ihm. 1 folgt jeder Differenz sofort, ein größerer Wert ist ruhiger, aber langsamer; 0 löst Alarm 61318 aus.
term-wear = Verschleiß
term-wear-is = Teil der Werkzeugkorrektur, der zur Geometrie addiert wird und Korrekturen aufnimmt, während die Geometrie bleibt. Die Werkstückmessung korrigiert ihn mit _CHBIT[6]=0, die Werkzeugmessung mit _CHBIT[3]=1; beim anderen Wert wird die Geometrie geschrieben, der Verschleiß wird 0.
term-zero-offset = Nullpunktverschiebung (NV)
term-zero-offset-is = Position des Werkstücknullpunkts im Maschinenkoordinatensystem, aufgerufen mit G54 bis G57 oder G505 bis G599. Bei Grob- und Feinverschiebung gilt die Summe beider; die Korrektur eines Zyklus wirkt, sobald die G-Funktion wieder programmiert wird, mit _KNUM=9999 sofort.
term-zero-offset-area = Nullkorrektur (Nullkorrekturbereich)
term-zero-offset-area-is = Größe der zufälligen Abweichungen: Was _TZL nicht überschreitet, korrigiert der Zyklus nicht, damit die Korrektur nicht dem Zufall folgt; mit der Nullpunktverschiebung hat sie nichts zu tun. Bei automatischer Werkzeugkorrektur vergleicht er den Mittelwert damit und führt ihn weiter, bei der Werkzeugmessung die Differenz selbst.
term-zo-determination = NV-Ermittlung
term-zo-determination-is = Der Zyklus korrigiert die NV aus _KNUM so, dass das Messelement auf seinem Sollwert liegt. Von den Grenzwerten gilt nur _TSA; die Korrektur geht in die Feinverschiebung, falls vorhanden, jedoch mit _CHBIT[21]=1, mit _KNUM=2000 und in CYCLE961 in die Grobverschiebung.
term-computerized-numerical-control = Rechnergestützte numerische Steuerung (CNC)
term-computerized-numerical-control-is = Numerische Steuerung, in der ein Rechner das Programm liest, die Bahn berechnet und die Achsen steuert. Heute gleichbedeutend mit NC.
term-central-processing-unit = Zentraleinheit (CPU)
term-central-processing-unit-is = Teil eines Rechners, der die Befehle ausführt. Eine Steuerung hat meist mehrere: für NC, PLC und Bedienoberfläche.
term-german-industry-standard = Deutsche Industrienorm (DIN)
term-german-industry-standard-is = Die Messzyklen setzen Maschinenachsen nach DIN 66217 voraus, der Norm für Bezeichnung und Richtung der Achsen.
term-disk-operating-system = Disk Operating System (DOS)
term-disk-operating-system-is = Betriebssystem früher PCs, mit eingetippten Befehlen bedient. An der Steuerung auch Name eines Textformats: Das der Messergebnisbilder steht in der Datei MBDDE.INI.
term-differential-resolver-function = Differential-Drehmelder-Funktion (DRF)
term-differential-resolver-function-is = Zusätzliche Verschiebung einer Achse mit dem Handrad, während ein Programm läuft. Mit dem Messen hat sie nichts zu tun.
term-function-module-numerical-control = Funktionsmodul numerische Steuerung (FM-NC)
term-function-module-numerical-control-is = Kleine SINUMERIK-Steuerung, gebaut als Baugruppe für die PLC SIMATIC S7-300.
term-global-user-data = Globale Anwendervariablen (GUD)
term-global-user-data-is = Variablen, die jedes Programm lesen und schreiben kann, einmal für die ganze Steuerung oder einmal in jedem Kanal. Ihre Werte bleiben auch ohne Spannung erhalten: Ein Parameter, den ein Aufruf nicht schreibt, hat noch den Wert eines früheren Aufrufs.
term-input-output = Eingang/Ausgang (E/A)
term-input-output-is = Signale zwischen Steuerung und Maschine. Zwei Eingänge sind für schaltende Messtaster; _CHBIT[0] wählt den des Werkstückmesstasters, _CHBIT[1] den des Werkzeugmesstasters.
term-start-up = Inbetriebnahme (IBN)
term-start-up-is = Zyklen und Definitionsdateien laden, Maschinendaten einstellen, Messtaster anschließen und prüfen.
term-set-up-mode = Einrichtebetrieb (JOG)
term-set-up-mode-is = Betriebsart, in der der Bediener die Achsen mit Richtungstasten oder Handrad verfährt, um die Maschine einzurichten.
term-local-user-data = Lokale Anwendervariablen (LUD)
term-local-user-data-is = Variablen eines Programms oder Zyklus, die es nur gibt, solange es läuft; die Messzyklen rechnen damit. Reicht der dafür reservierte Speicher (MD 28020, MD 28040) nicht, hält das Programm am Aufruf an.
term-machine-coordinate-system = Maschinenkoordinatensystem (MKS)
term-machine-coordinate-system-is = Koordinatensystem der Maschinenachsen; die Positionen zählen vom Maschinennullpunkt aus und hängen von keiner Nullpunktverschiebung ab. Kalibriernuten (_KB) und maschinenbezogen kalibrierte Werkzeugmesstaster (_TP) sind darin gespeichert.
term-machine-data = Maschinendaten (MD)
term-machine-data-is = Nummerierte Einstellungen, mit denen der Maschinenhersteller die Steuerung an die Maschine anpasst. Eine Änderung der Speicheraufteilung löscht Daten (Alarm 4400): vorher Serieninbetriebnahme sichern und danach wieder einlesen.
term-man-machine-communication = Man-Machine-Communication (MMC)
term-man-machine-communication-is = Älterer Name der Bedienoberfläche von SINUMERIK und ihrer Hardware, für Bedienung, Programmierung und Simulation; später HMI. Messen in JOG braucht MMC 103 oder HMI Advanced.
term-microsoft = Microsoft (MS)
term-microsoft-is = Softwarehersteller; die Abkürzung steht in Namen wie MS-DOS.
term-numerical-control = Numerische Steuerung (NC)
term-numerical-control-is = Steuerung einer Maschine durch ein Programm aus Zahlen; auch der Teil der Steuerung, der Programme abarbeitet und Achsen verfährt, im Unterschied zu PLC und Bedienoberfläche.
term-numerical-control-kernel = NC-Kern (NCK)
term-numerical-control-kernel-is = Kernsoftware der NC: bereitet die Programmsätze auf, berechnet die Bewegung und steuert die Achsen. Anwenderdaten mit dem Geltungsbereich NCK, zum Beispiel _CBIT[], gibt es einmal für alle Kanäle.
term-numerical-control-unit = Numerische Steuereinheit (NCU)
term-numerical-control-unit-is = Hardwareeinheit, auf der der NCK läuft.
term-data-exchange-software = Datenübertragungssoftware (PCIN)
term-data-exchange-software-is = Siemens-Programm für den PC, das Programme, Archive und andere Daten mit der Steuerung austauscht, meist über V.24.
term-programming-device = Programmiergerät (PG)
term-programming-device-is = Tragbarer Siemens-Rechner zum Programmieren und Testen der PLC.
term-programmable-logic-control = Speicherprogrammierbare Steuerung (PLC)
term-programmable-logic-control-is = Teil der Steuerung für die Funktionen der Maschine rund um die NC, zum Beispiel Werkzeugwechsel, Kühlmittel und Spannen. An ihr lässt sich sehen, ob die Schaltsignale ankommen: DB10 DBX107.0 heißt Messtaster 1 ausgelenkt, DBX107.1 Messtaster 2.
term-subprogram = Unterprogramm (UP)
term-subprogram-is = Programm, das ein anderes Programm aufruft; Messzyklen sind Unterprogramme. Ihr Aufruf ist bis zur 5. Programmebene zulässig, weil sie selbst Unterprogramme aufrufen.
term-software = Software (SW)
term-software-is = Mit Nummer der Softwarestand. NCK, Bedienoberfläche und Messzyklen haben je einen eigenen: Zyklen ab SW 6.2 brauchen NCK SW 6.3 oder höher.
term-tool-offset = Werkzeugkorrektur (WZK)
term-tool-offset-is = Daten einer Schneide unter ihrer D-Nummer: Werkzeugtyp, Schneidenlage, Längen, Radius und deren Verschleiß. Damit berechnet die Steuerung den Weg des Werkzeugs; ein Fehler hier ist ein Fehler am Werkstück.
term-tool-offset-active = Tool Offset Active (TOA)
term-tool-offset-active-is = Typ der Dateien, in denen die Steuerung Werkzeugkorrekturen sichert.
term-user-interface = Bedienoberfläche (BOF)
term-user-interface-is = Bilder und Tasten, mit denen der Bediener an der Steuerung arbeitet.
term-serial-interface = Serielle Schnittstelle (V.24)
term-serial-interface-is = Schnittstelle, die Daten Bit für Bit mit einem PC austauscht, auch RS-232-C. An älteren Steuerungen lassen sich damit Zyklen und Definitionsdateien laden und Protokolldateien auslesen.
term-workpiece-coordinate-system = Werkstückkoordinatensystem (WKS)
term-workpiece-coordinate-system-is = Koordinatensystem des Werkstücks, das die aktiven Frames in die Maschine legen; Programme und Sollwerte der Werkstückmessung beziehen sich darauf. Ein darin kalibrierter Werkzeugmesstaster (_TPW) stimmt nur mit der Nullpunktverschiebung der Kalibrierung.
