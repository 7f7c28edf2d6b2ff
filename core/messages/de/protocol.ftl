# Ein Protokoll einer wirklichen Maschine: warum eine Zeile oder das Ganze nicht passt, und was hilft.

protocol-ending = { $fitted ->
    [one] 1 Zeile des Protokolls passt. Zeilen, die nicht passen: { $unfit }. Aufrufe ohne Wert: { $missing }.
   *[other] { $fitted } Zeilen des Protokolls passen. Zeilen, die nicht passen: { $unfit }. Aufrufe ohne Wert: { $missing }.
}
protocol-gap = { $name } fehlt: Was darin gemessen wurde, hat keinen Wert oder steht bei einem anderen Aufruf. Alle Dateien des Protokolls auswählen.
protocol-empty = Das Protokoll ist leer: die Datei wählen, die die Maschine geschrieben hat.
protocol-large = Das Protokoll hat mehr als { $most } Zeilen: teilen, eine Datei je Teil.
protocol-no-calls = Das Programm misst nichts, wofür ein Protokoll Werte haben könnte: das Programm öffnen, das die Maschine ausgeführt hat.
protocol-no-actual = Die Spalte des Istwerts fehlt: sie nennen, oder die von Sollwert und Abweichung.
protocol-no-column = Keine Zeile hat eine Spalte „{ $name }“. Die erste Zeile lautet: { $fields }. Einen dieser Namen wählen, oder eine Nummer ab 1.
protocol-no-value = Kein Sollwert mit einem Istwert in dieser Zeile: Stehen sie da, sie wie 132.015 oder 132,015 schreiben, mit „;“ dazwischen.
protocol-no-number = In Spalte „{ $column }“ steht keine Zahl, sondern „{ $text }“: sie wie 132.015 oder 132,015 schreiben, ohne Tausenderzeichen, oder eine andere Spalte wählen.
protocol-no-call = Kein Aufruf ohne Wert hat einen Sollwert aus dieser Zeile: prüfen, ob das Programm zum Protokoll gehört, oder die Spalten wählen.
protocol-no-heading = Kein weiterer Aufruf von { $cycle } mit Messvariante { $variant }: prüfen, ob das Programm zum Protokoll gehört.
protocol-no-number-of-call = Das Programm hat keine Messung { $number }: die Spalte der Nummer prüfen.
protocol-no-line = In Zeile { $line } des Programms steht kein Aufruf ohne Wert: die Spalte der Zeile prüfen.
protocol-no-result = Der Aufruf hat kein Ergebnis { $name } ohne Wert: die Spalte des Ergebnisses prüfen.
protocol-differs = Die Abweichung { $by } ist nicht Istwert minus Sollwert, das wäre { $is }: die Spalten prüfen.
protocol-contradicted = { $actual } gilt als Istwert zum Sollwert { $set }, doch { $by } ist nicht ihre Differenz: die Zeile prüfen oder die Spalten auswählen.
protocol-ambiguous = { $actual } gilt als Istwert zum Sollwert { $set }, doch { $other } könnte es auch sein: die Zeile prüfen oder die Spalten auswählen.
protocol-marked = Die Maschine hat { $actual } als jenseits einer Grenze gekennzeichnet; nach der Toleranz dieses Programms liegt der Wert innerhalb: die Toleranz oder die Nachkommastellen des Protokolls prüfen.
protocol-blank = In Spalte „{ $column }“ steht nichts: ausfüllen oder eine andere Spalte wählen.
protocol-above = Diese Zeile steht über den Überschriften der Tabelle: sie darunter setzen oder die Spalten wählen.
protocol-wide = { $cells } Felder unter { $heads } Überschriften: Vielleicht trennt sie ein Dezimalkomma. Die Felder mit „;“ trennen, Dezimalpunkte schreiben oder Werte mit Komma in Anführungszeichen setzen.
protocol-comma = Ein Komma trennt die Zahlen und könnte das der Nachkommastellen sein: sie mit „;“ trennen, Dezimalpunkte schreiben oder sie in Anführungszeichen setzen.
protocol-quote = Ein Anführungszeichen wird geöffnet und nicht geschlossen: es am Ende des Werts schließen oder entfernen.
protocol-other-line = Messung { $number } steht in Zeile { $own } des Programms, nicht in Zeile { $line }: die Spalten der Nummer und der Zeile prüfen.
protocol-cells = { $cells } Felder unter { $heads } Überschriften: jeder Spalte eine Überschrift geben, oder einen Wert mit Trennzeichen in Anführungszeichen setzen.
protocol-mark = „{ $text }“ endet mit dem Zeichen „{ $mark }“ für Werte außerhalb einer Grenze oder mit einer eigenen Ziffer: für _PROTSYM[1] ein anderes Zeichen wählen.
protocol-again = Der Aufruf hat zum Sollwert { $set } schon einen Wert: die Zeile entfernen oder jede Messung neu nummerieren.
protocol-two-columns = Die Spalten { $first } und { $other } könnten beide „{ $name }“ sein; genommen ist Spalte { $first }: prüfen oder die Spalte mit ihrer Nummer wählen.
protocol-same-column = Die Spalte „{ $name }“ ist für zweierlei gewählt: je eine Spalte wählen.
