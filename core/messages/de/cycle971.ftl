# CYCLE971: Titel, Suchwörter, Messvarianten, Texte der eigenen Parameter, Prüfungen und Ergebnisse.

cycle971-title = Fräsen: Werkzeugmesstaster kalibrieren, Werkzeuge messen
cycle971-help = Misst an einem Werkzeugmesstaster Länge L1 des Fräswerkzeugs oder Bohrers in der Spindel oder den Radius des Fräswerkzeugs; oder kalibriert ihn mit einem Werkzeug bekannter Maße.
cycle971-words = Werkzeug messen vermessen Werkzeugvermessung Werkzeugmessung Werkzeugvoreinstellung Voreinstellgerät Werkzeugmesstaster Werkzeugtaster Messtaster Taster Messdose Tischtaster Laser Würfel Scheibe Teller antasten kalibrieren abgleichen eichen einmessen Länge L1 Radius Durchmesser Fräser Schaftfräser Planfräser Messerkopf Bohrer Verschleiß Geometrie Bruch Werkzeugbruch Spindel drehend stehend Schneide Triggerpunkt Werkzeugkorrektur Werkzeuglänge Werkzeugradius Bruchkontrolle Bruchüberwachung T-Taster
cycle971-each-words = messen vermessen Werkzeug Werkzeugvermessung Messtaster Taster

cycle971-calibrate = Werkzeugmesstaster kalibrieren
cycle971-calibrate-workpiece = Werkzeugmesstaster kalibrieren (WKS)
cycle971-still = Werkzeug messen, Spindel steht
cycle971-rotating = Werkzeug messen, Spindel dreht
cycle971-still-workpiece = Werkzeug messen, Spindel steht (WKS)
cycle971-rotating-workpiece = Werkzeug messen, Spindel dreht (WKS)
cycle971-incremental = Werkzeugmesstaster inkrementell kalibrieren
cycle971-incremental-workpiece = Werkzeugmesstaster inkrementell kalibrieren (WKS)
cycle971-automatic = Werkzeugmesstaster automatisch kalibrieren
cycle971-automatic-workpiece = Werkzeugmesstaster automatisch kalibrieren (WKS)

ma-abscissa-centred = Abszisse (G17: X), vorher Mitte in der Ordinate
ma-ordinate-centred = Ordinate (G17: Y), vorher Mitte in der Abszisse
ma-applicate-abscissa = Applikate (G17: Z), breites Werkzeug in der Abszisse versetzt
ma-applicate-ordinate = Applikate (G17: Z), breites Werkzeug in der Ordinate versetzt
ma-radius-abscissa = Radius, in der Abszisse angetastet (G17: X)
ma-radius-ordinate = Radius, in der Ordinate angetastet (G17: Y)
ma-length = Länge, in der Messtastermitte
ma-length-abscissa = Länge, breites Werkzeug in der Abszisse versetzt (G17: X)
ma-length-ordinate = Länge, breites Werkzeug in der Ordinate versetzt (G17: Y)
param-ma-measure-tool = Länge oder Radius
param-ma-measure-tool-help = Zu messendes Maß und Messrichtung. Bei der Länge wird ein Fräswerkzeug, das breiter als der Messtaster ist, um Radius minus _ID versetzt: Die Schneide steht über der Messtastermitte.
param-id-calibrate = Versatz eines breiten Kalibrierwerkzeugs
param-id-calibrate-help = Ein Werkzeug, das breiter als der Messtaster ist, wird um den Werkzeugradius minus diesen Wert aus der Messtastermitte versetzt. Meist 0.
param-id-length = Radius bis tiefster Punkt der Schneide
param-id-length-help = Abstand vom Radius nach innen bis zum tiefsten Punkt der Schneide; ein Fräswerkzeug, das breiter als der Messtaster ist, wird um Radius minus diesen Wert versetzt. 0: außen am tiefsten.
param-id-radius = Unterkante bis größter Durchmesser
param-id-radius-help = Abstand der Werkzeugunterkante vom größten Durchmesser; um diesen Wert fährt das Werkzeug tiefer. 0, wenn der größte Durchmesser an der Unterkante liegt.
param-fa-incremental = Messweg mit Richtung
param-fa-incremental-help = Abstand von der aktuellen Position zur anzutastenden Seite; plus misst in Plus-Richtung, minus in Minus-Richtung. Verfahrweg höchstens das Doppelte. Immer in mm.

need-axis-tool-probe = Der Zyklus braucht die Messachse.
need-offset-edge = Der Zyklus positioniert damit Fräswerkzeuge; ohne Angabe gilt der Wert eines früheren Aufrufs. Gerade Schneide/Bohrer: 0 eingeben.
need-offset-wide = Gilt für ein Werkzeug, das breiter als der Messtaster ist.
need-signed-path = Das Vorzeichen bestimmt die Messrichtung.

result-actual-radius = Istwert Radius
result-difference-radius = Differenz Radius

check-path-zero = Der Messweg ist 0: Das Werkzeug würde sich nicht auf den Messtaster zubewegen.
check-path-zero-hint = _FA größer als 0 eingeben, ohne Vorzeichen.
check-path-sign = Der Messweg ist negativ, was bei dieser Messvariante unzulässig ist.
check-path-sign-hint = _FA ohne Vorzeichen eingeben; nur beim inkrementellen Kalibrieren gibt ein Vorzeichen die Richtung an.
check-path-direction-hint = In _FA den Abstand zum Messtaster eingeben, für die Minus-Richtung mit Minuszeichen.
check-tool-probe-type = { $name } enthält keinen zulässigen Werkzeugmesstastertyp.
check-tool-probe-plane = Die Scheibe in { $name } ist in dieser Ebene nicht antastbar.
check-tool-probe-type-hint = 0 für einen Würfel eintragen, 101 für eine Scheibe in XY (G17), 201 in ZX (G18) oder 301 in YZ (G19).
check-tool-probe-depth = { $name } ist 0: Das Werkzeug würde nicht tiefer als an der Messtasteroberkante antasten.
check-tool-probe-depth-hint = Abstand von der Messtasteroberkante zur Werkzeugunterkante eintragen.
check-directions-code = { $name } = { $code } ist kein zulässiger Richtungscode.
check-directions-applicate = { $name } = { $code } gibt die Minus-Richtung der Werkzeugachse nicht frei.
check-directions-hint = Hunderter (Z), Zehner (Y), Einer (X) eintragen: 0 keine, 1 minus, 2 plus, 3 beide; Werkzeugachse 1 oder 3. Vorbesetzung: 133.
check-tool-type-drill = Ein Bohrer (Typ { $type }) hat keinen messbaren Radius.
check-tool-length-zero = Die Länge L1 des aktiven Werkzeugs ist 0.
check-tool-radius-zero = Der Radius des aktiven Werkzeugs ist 0.
check-tool-zero-hint = Ungefähres Maß in den Werkzeugdaten eintragen, bei einem Kalibrierwerkzeug das genaue.
check-offset-missing = Das Werkzeug, { $tool } mm breit, ist breiter als der Messtaster, { $edge } mm: _ID bestimmt seine Position.
check-offset-missing-hint = _ID auf 0 setzen, wenn der äußerste Punkt über der Messtastermitte stehen soll.
check-offset-large = _ID ist größer als der Werkzeugradius, { $radius } mm: Das Werkzeug würde zur anderen Seite versetzt.
check-offset-large-hint = In _ID den Abstand vom Radius nach innen eingeben; höchstens der Radius ist zulässig.
check-offset-abscissa = Das Werkzeug, { $tool } mm breit, ist breiter als der Messtaster, { $edge } mm: Der Zyklus versetzt es in der Abszisse.
check-offset-abscissa-hint = _MA auf 103 oder 203 setzen, um die Achse des Versatzes festzulegen.
check-mfs-missing = { $name } ist nicht größer als 0: Drehzahl oder Vorschub einer Antastung fehlt.
check-mfs-missing-hint = Drehzahlen in _MFS[0], [2], [4], Vorschübe in _MFS[1], [3], [5] eintragen oder mit _CBIT[12]=0 berechnen lassen.
check-mfs-third = { $name } ist nicht größer als 0: Die 3. Antastung mit _MFS[4] und [5] entfällt.
check-mfs-third-hint = Auch Drehzahl und Vorschub der 2. Antastung eintragen oder _MFS[4] auf 0 setzen.
check-cm-direction = { $name } gibt keine Drehrichtung an; sie ist nötig, wenn die Spindel beim Aufruf steht.
check-cm-direction-hint = _CM[5] im Datenbaustein GUD6 auf 3 für M3 oder auf 4 für M4 setzen.
check-cm-zero = { $name } ist nicht größer als 0: Drehzahl und Vorschub der Messung sind nicht berechenbar.
check-cm-zero-hint = Grenzwerte eintragen: _CM[0] Umfangsgeschwindigkeit, [1] Drehzahl, [3] Messgenauigkeit, [4] maximaler Antastvorschub.
check-cm-factor = { $name } ist weder 0 noch mindestens 1.
check-cm-factor-hint = 0 eingeben, wenn diese Antastung entfallen soll, sonst mindestens 1: Der Vorschub wird mit diesem Faktor multipliziert.
check-cm-order = { $name } ist nicht kleiner als _CM[6], aber jede Antastung soll langsamer sein als die vorige.
check-cm-order-hint = Vorschubfaktor 2 verkleinern oder für zwei Antastungen auf 0 setzen.
check-compensation-make = Keine Messergebniskorrektur: Für _MT_COMP=1 fehlt der Messtasterhersteller in { $name }.
check-compensation-make-hint = _TP_CF auf 1 (TT130) oder 2 (TS27R) setzen oder eine eigene Korrekturtabelle mit _MT_COMP=2 verwenden.
check-compensation-inside = Die Steuerung subtrahiert Werte einer internen, nicht dokumentierten Herstellertabelle; die Simulation subtrahiert nichts.
check-compensation-inside-hint = Mit _MT_COMP=2 gilt Ihre eigene Tabelle, auch in der Simulation: _MT_EC_R beim Radius, _MT_EC_L bei der Länge.
check-compensation-table = Radien oder Umfangsgeschwindigkeiten in { $name } sind nicht aufsteigend: Die Korrektur kann falsch sein.
check-compensation-table-hint = Radien in [0,1] bis [0,4] und Geschwindigkeiten in [1,0] bis [5,0] aufsteigend eintragen oder _MT_COMP=0 setzen.

param-mfs-speed-1 = Drehzahl 1. Antastung
param-mfs-speed-1-help = In 1/min.
param-mfs-feed-1 = Vorschub 1. Antastung
param-mfs-feed-1-help = Vorschub zum Werkzeugmesstaster bei der 1. Antastung.
param-mfs-speed-2 = Drehzahl 2. Antastung
param-mfs-speed-2-help = In 1/min. 0 beendet die Messung nach der 1. Antastung.
param-mfs-feed-2 = Vorschub 2. Antastung
param-mfs-feed-2-help = Vorschub zum Werkzeugmesstaster bei der 2. Antastung.
param-mfs-speed-3 = Drehzahl 3. Antastung
param-mfs-speed-3-help = In 1/min. 0 beendet die Messung nach der 2. Antastung.
param-mfs-feed-3 = Vorschub 3. Antastung
param-mfs-feed-3-help = Vorschub zum Werkzeugmesstaster bei der 3. Antastung.
