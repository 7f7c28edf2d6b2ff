# Hilfeseiten der Zyklen ohne Bewegung: Protokoll (CYCLE100, 101, 105, 106, 113, 118), Kreis und Lage (CYCLE116, 119).

help-log-data = Inhalt und Format des Protokolls stehen in Anwendervariablen der Maschine, die ihre Werte über Programme hinweg behalten: nur schreiben, was abweicht.
help-log-title = Nur eine Überschriftzeile ist geschrieben: Die zweite zeigt noch den Text eines früheren Protokolls. In _PROTVAL[1] Leerzeichen in Anführungszeichen schreiben.
help-log-column = Ein Wert ist breiter als seine Spalte: Die Steuerung verbreitert die Spalte und gibt Meldung 62309 aus; die Werte stehen nicht mehr untereinander.
help-log-line = Spaltenzahl mal Spaltenbreite ergibt mehr als 200 Zeichen: Alarm 61371.
help-log-name = _PROTNAME[1] ist der Dateiname: Buchstaben, Ziffern, Unterstriche; am Anfang zwei Buchstaben oder Buchstabe und Unterstrich. MPF wird automatisch angehängt. Verzeichnis wie beim aufrufenden Programm.
help-log-files = Die Protokolldatei. Was über die Dateigröße in MD 11420 (KB) hinausgeht, steht in bis zu neun Folgedateien, deren Namen auf Unterstrich und Ziffer enden.
help-log-full = Auch die zehnte Datei ist voll: Das Programm hält an und verlangt einen neuen Protokollnamen; mit NC START läuft es weiter.
help-log-refused = Die Datei hat keinen Namen (Alarm 61354), ein anderes Programm benutzt sie (Alarm 61356) oder ihr Verzeichnis fehlt (Alarm 61353).
help-log-header = Protokollkopf: Datum, Uhrzeit, Seitennummer, Programm _PROTNAME[0], eigene Zeilen ab _HEADLINE[0], Überschriftzeilen _PROTVAL[0] und _PROTVAL[1]. Mit _CBIT[11]=1 nur die eigenen Zeilen.
help-log-block = Werteblock: Zyklusname und _MVAR, außer bei _CBIT[6]=1; danach _PROTFORM[4] Wertezeilen. _PROTSYM[1] kennzeichnet Istwert und Differenz außerhalb von _TSA, _TDIF, _TUL oder _TLL.
help-log-chosen = _PROTVAL[2] bis _PROTVAL[5] bestimmen den Inhalt der Wertezeilen: Ergebnisse in _OVR, R-Parameter, Texte. Ein anderer Messzyklus oder eine andere Messvariante liefert andere Ergebnisse.

help-cycle100-does = Schaltet das Messprotokoll ein: Bis CYCLE101 schreibt jeder Messzyklus einen Werteblock. Keine Achse bewegt sich.
help-cycle100-values = Vor jedem Messaufruf _PROTVAL[2] bis _PROTVAL[5] auf den Inhalt seiner Wertezeilen setzen: Ein anderer Zyklus oder eine andere Messvariante liefert andere Ergebnisse.
help-cycle100-begin = Eine vorhandene Datei dieses Namens wird gelöscht und neu angelegt; dazu ruft CYCLE100 den CYCLE106 auf.
help-cycle100-each = Jeder folgende Messaufruf schreibt seinen Werteblock selbst; das Programm ruft keinen weiteren Protokollzyklus auf.
help-cycle100-lost = Das Protokoll des letzten Werkstücks wurde nicht ausgelesen: Es wird gelöscht. Für jedes Werkstück einen eigenen Dateinamen verwenden.
help-cycle100-old = Folgedateien eines früheren Protokolls bleiben, bis dieses Protokoll ihre Namen braucht: Der Inhalt gehört nicht zu diesem Werkstück.

help-cycle101-does = Schaltet das mit CYCLE100 eingeschaltete Protokoll aus. Keine Achse bewegt sich.
help-cycle101-last = Der letzte Messaufruf, der ins Protokoll gehört, ist abgearbeitet.
help-cycle101-flag = Die Kennung für das eingeschaltete Protokoll wird gelöscht; die folgenden Messzyklen schreiben nichts mehr.
help-cycle101-files = Die Protokolldateien; sie lassen sich jetzt auslesen.
help-cycle101-missing = Der Aufruf fehlt: Auch spätere Messungen stehen dann im Protokoll, und die Datei lässt sich nicht auslesen.

help-cycle105-header = Schreibt den Protokollkopf ins Protokoll, ohne Messzyklus. Keine Achse bewegt sich.
help-cycle105-values = Schreibt einen Werteblock mit bis zu vier Zeilen ins Protokoll, ohne Messzyklus, zum Beispiel nach einer eigenen Berechnung. Keine Achse bewegt sich.
help-cycle105-open = Das Protokoll ist mit CYCLE100 eingeschaltet. Messzyklen schreiben selbst und brauchen CYCLE105 nicht.
help-cycle105-left-header = Ein weiterer Protokollkopf in der Protokolldatei.
help-cycle105-left-values = Ein weiterer Werteblock in der Protokolldatei.
help-cycle105-number = CYCLE106 nummeriert seine Aufträge anders: Dort ist 2 der Werteblock. Eine Ausgabe des Handbuchs vertauscht hier 0 und 1; einmal an der Steuerung ausprobieren.

help-cycle106-header = Schreibt den Protokollkopf ins Protokoll und verwaltet Dateien und Seiten. Keine Achse bewegt sich.
help-cycle106-values = Schreibt einen Werteblock ins Protokoll und verwaltet Dateien und Seiten. Keine Achse bewegt sich.
help-cycle106-alone = Das Programm protokolliert ohne Messzyklen; mit Messzyklen genügen CYCLE100 und die Messaufrufe.
help-cycle106-keeps = Bei Bedarf löscht der Zyklus alte Dateien dieses Namens, öffnet die nächste Datei, wenn eine voll ist, und beginnt nach _PROTFORM[0] Zeilen eine neue Seite (bei 0 keine).
help-cycle106-number = PAR1 ist weder 1 noch 2: Alarm 61360. CYCLE105 nummeriert seine Aufträge anders.

help-cycle113-date = Liest das Datum der Steuerung als Text. Keine Achse bewegt sich.
help-cycle113-time = Liest die Uhrzeit der Steuerung als Text. Keine Achse bewegt sich.
help-cycle113-variable = Eine Variable nimmt den Text auf: DEF STRING[10] PAR2 am Programmanfang oder der Name einer eigenen Variablen im Aufruf.
help-cycle113-year = Das Datum besteht aus Jahr, Monat und Tag mit je zwei Stellen, durch Schrägstriche getrennt.
help-cycle113-hour = Die Uhrzeit besteht aus Stunden, Minuten und Sekunden mit je zwei Stellen, durch Doppelpunkte getrennt.
help-cycle113-left = Der Text in der Variablen des Aufrufs, sonst nichts.
help-cycle113-short = Die Variable ist mit weniger als 10 Zeichen definiert: Der Zyklus verlangt STRING[10].

help-cycle118-does = Wandelt eine Realzahl in einen Text mit der gewählten Zahl von Nachkommastellen um; bis zu 10 Zahlen auf einmal. Keine Achse bewegt sich.
help-cycle118-variable = Eine Variable nimmt den Text auf: DEF STRING[12] PAR3 am Programmanfang oder der Name einer eigenen Variablen im Aufruf.
help-cycle118-registers = Mehrere Zahlen stehen in aufeinanderfolgenden R-Parametern; PAR5 ist die Nummer des ersten, PAR4 die Anzahl.
help-cycle118-rounds = Eine Zahl: PAR1 wird auf PAR2 Nachkommastellen gerundet und als Text geschrieben.
help-cycle118-many = Mehrere Zahlen: Die R-Parameter werden nacheinander auf PAR2 Nachkommastellen gerundet; der Zyklus ignoriert PAR1.
help-cycle118-left = Der Text in der Variablen des Aufrufs. Bei mehreren Zahlen stehen die Texte in _TXT[0] bis _TXT[9], der letzte auch in der Variablen.
help-cycle118-count = PAR4 ist größer als 10: Alarm 61362.
help-cycle118-length = Eine Zahl braucht mit ihren Nachkommastellen mehr als 12 Zeichen: Der Text passt nicht hinein.

help-cycle116-does = Berechnet Mittelpunkt und Radius eines Kreises aus drei oder vier Punkten, zum Beispiel aus einzeln gemessenen Punkten. Keine Achse bewegt sich.
help-cycle116-variables = Beide Variablen sind am Programmanfang definiert: DEF REAL _DATE[13] und DEF INT _ALM.
help-cycle116-points = _DATE[0] ist die Anzahl der Punkte; Abszisse und Ordinate jedes Punkts stehen paarweise in _DATE[1] bis _DATE[8].
help-cycle116-circle = Drei Punkte bestimmen den Kreis; bei vier Punkten gehen alle in die Rechnung ein.
help-cycle116-left = Mittelpunkt in _DATE[9] und _DATE[10], Radius in _DATE[11], Status in _DATE[12], Alarmnummer in _ALM; Status und _ALM sind 0, wenn ein Kreis berechnet ist. Werkzeug und NV bleiben unverändert.
help-cycle116-line = Die Punkte liegen auf einer Geraden oder aufeinander: _ALM ist 61316.
help-cycle116-count = _DATE[0] ist weder 3 noch 4: _ALM ist 61317.
help-cycle116-unseen = Wertet das Programm _ALM nach dem Aufruf nicht aus, läuft es mit einem falschen Kreis weiter: Der Alarm hält es nicht an.

help-cycle119-does = Berechnet die Lage eines Werkstücks im Raum aus Soll- und Messpositionen dreier Punkte. Je nach _COR korrigiert der Zyklus ein Frame um Verschiebung und Drehung. Keine Achse bewegt sich.
help-cycle119-variables = Die Variablen sind am Programmanfang definiert: DEF REAL _SETPOINT[3,3], _MEASPOINT[3,3], _RES, DEF INT _ALARM und DEF FRAME _REFRAME.
help-cycle119-points = Die Punkte sind einzeln gemessen, zum Beispiel mit CYCLE977 oder CYCLE997; _SETPOINT und _MEASPOINT enthalten sie in gleicher Reihenfolge, je X, Y und Z, im aktiven Frame.
help-cycle119-alarm = _ALARM ist 0.
help-cycle119-frame = Der Zyklus berechnet das Frame zwischen beiden Dreiecken. _RES ist ihr Formunterschied, die Summe der Abweichungen der drei Punkte; unter 0 gibt es kein Frame.
help-cycle119-decides = Bei _COR=0 korrigiert der Zyklus nichts. Sonst korrigiert er ein Frame, wenn _RES kleiner als _RESLIM ist.
help-cycle119-left = _RES, in _REFRAME ein Frame, in _ALARM 0 oder eine Alarmnummer. Mit dem aktiven Frame verkettet, bringt _REFRAME die gemessenen Punkte auf ihre Sollpositionen.
help-cycle119-frame-moved = Das Frame nach _COR, Verschiebung und Drehung: 1 bis 99 einstellbares Frame, 1000 letztes aktives Kanal-Basisframe, 1011 bis 1026 Kanal-Basisframe, 2000 Systemframe $P_SETFR, 9999 aktives Frame.
help-cycle119-again = Das korrigierte Frame wirkt, wenn seine G-Funktion (G54 …) erneut programmiert wird, auch bei _COR=9999.
help-cycle119-line = Die drei Punkte liegen auf einer Geraden, oder zwei von ihnen fallen zusammen: _ALARM ist 61411.
help-cycle119-distorted = Die Dreiecke weichen um _RESLIM oder mehr voneinander ab: _ALARM ist 61414, nichts wird korrigiert.
help-cycle119-order = Soll- und Messpunkte stehen in verschiedener Reihenfolge: Die Dreiecke passen nicht aufeinander.
help-cycle119-mirrored = Das Frame spiegelt oder skaliert: _ALARM ist 61411.
help-cycle119-absent = Das Frame ist nicht vorhanden: _ALARM ist 61321. Fehlt bei _COR=1000, oder bei 9999 mit aktivem G500, ein Kanal-Basisframe, ist _ALARM 61412.
help-cycle119-unseen = Wertet das Programm _ALARM nach dem Aufruf nicht aus, läuft es mit unkorrigiertem Frame weiter: Der Alarm hält es nicht an.
