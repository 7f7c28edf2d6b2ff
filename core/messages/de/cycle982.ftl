# CYCLE982: Titel, Suchwörter, Messvarianten, Texte der eigenen Parameter, Prüfungen.

cycle982-title = Drehen: Werkzeugmesstaster kalibrieren, Drehwerkzeuge, Fräswerkzeuge und Bohrer messen
cycle982-help = Misst L1 und L2 von Drehwerkzeug, Fräser oder Bohrer, beim Fräser auch den Radius, an einem achsparallelen Werkzeugmesstaster oder kalibriert eine Seite mit bekanntem Werkzeug der Schneidenlage 3.
cycle982-words = Werkzeug messen vermessen Werkzeugvermessung Werkzeugmessung Werkzeugvoreinstellung Voreinstellgerät Drehmaschine Drehen Drehfräsen angetriebenes Werkzeug Werkzeugmesstaster Werkzeugtaster Messtaster Taster Messdose Würfel antasten kalibrieren abgleichen eichen einmessen Länge L1 L2 Radius Durchmesser Wendeschneidplatte Platte Schneide Schneidenradius Spitze Schneidenlage Drehmeißel Drehstahl Stahl Bohrer Fräser Schaftfräser Nutfräser Scheibenfräser T-Nutenfräser Umschlag inkrementell automatisch Verschleiß Geometrie Triggerpunkt Werkzeugkorrektur Werkzeuglänge Messarm Bruchkontrolle
cycle982-each-words = Drehmaschine Drehen messen vermessen Werkzeug Werkzeugvermessung

cycle982-calibrate = Werkzeugmesstaster kalibrieren
cycle982-calibrate-workpiece = Werkzeugmesstaster kalibrieren (WKS)
cycle982-incremental-calibrate = Werkzeugmesstaster inkrementell kalibrieren
cycle982-incremental-calibrate-workpiece = Werkzeugmesstaster inkrementell kalibrieren (WKS)
cycle982-measure = Messen: Länge L1 oder L2; Drehwerkzeug, Fräswerkzeug oder Bohrer axial
cycle982-measure-reversal = Messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer axial, mit Umschlag
cycle982-measure-radius = Messen: Radius; Fräswerkzeug axial
cycle982-measure-radius-reversal = Messen: Radius; Fräswerkzeug axial, mit Umschlag
cycle982-measure-both = Messen: Länge und Radius; Fräswerkzeug axial
cycle982-measure-both-reversal = Messen: Länge und Radius; Fräswerkzeug axial, mit Umschlag
cycle982-measure-radial = Messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial
cycle982-measure-radial-reversal = Messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial, mit Umschlag
cycle982-measure-radius-radial = Messen: Radius; Fräswerkzeug radial
cycle982-measure-radius-radial-reversal = Messen: Radius; Fräswerkzeug radial, mit Umschlag
cycle982-measure-both-radial = Messen: Länge und Radius; Fräswerkzeug radial
cycle982-measure-both-radial-reversal = Messen: Länge und Radius; Fräswerkzeug radial, mit Umschlag
cycle982-measure-workpiece = Messen: Länge L1 oder L2; Drehwerkzeug, Fräswerkzeug oder Bohrer axial (WKS)
cycle982-measure-reversal-workpiece = Messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer axial, mit Umschlag (WKS)
cycle982-measure-radius-workpiece = Messen: Radius; Fräswerkzeug axial (WKS)
cycle982-measure-radius-reversal-workpiece = Messen: Radius; Fräswerkzeug axial, mit Umschlag (WKS)
cycle982-measure-both-workpiece = Messen: Länge und Radius; Fräswerkzeug axial (WKS)
cycle982-measure-both-reversal-workpiece = Messen: Länge und Radius; Fräswerkzeug axial, mit Umschlag (WKS)
cycle982-measure-radial-workpiece = Messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial (WKS)
cycle982-measure-radial-reversal-workpiece = Messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial, mit Umschlag (WKS)
cycle982-measure-radius-radial-workpiece = Messen: Radius; Fräswerkzeug radial (WKS)
cycle982-measure-radius-radial-reversal-workpiece = Messen: Radius; Fräswerkzeug radial, mit Umschlag (WKS)
cycle982-measure-both-radial-workpiece = Messen: Länge und Radius; Fräswerkzeug radial (WKS)
cycle982-measure-both-radial-reversal-workpiece = Messen: Länge und Radius; Fräswerkzeug radial, mit Umschlag (WKS)
cycle982-automatic = Automatisch messen: beide Längen, Radius; Drehwerkzeug, Fräswerkzeug oder Bohrer axial
cycle982-automatic-reversal = Automatisch messen: beide Längen, Radius; Fräswerkzeug oder Bohrer axial, mit Umschlag
cycle982-automatic-upper = Automatisch messen: obere Schneide; Fräswerkzeug axial
cycle982-automatic-upper-reversal = Automatisch messen: obere Schneide; Fräswerkzeug axial, mit Umschlag
cycle982-automatic-opposite = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug axial
cycle982-automatic-opposite-reversal = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug axial, mit Umschlag
cycle982-automatic-radial = Automatisch messen: beide Längen, Radius; Fräswerkzeug oder Bohrer radial
cycle982-automatic-radial-reversal = Automatisch messen: beide Längen, Radius; Fräswerkzeug oder Bohrer radial, mit Umschlag
cycle982-automatic-upper-radial = Automatisch messen: obere Schneide; Fräswerkzeug radial
cycle982-automatic-upper-radial-reversal = Automatisch messen: obere Schneide; Fräswerkzeug radial, mit Umschlag
cycle982-automatic-opposite-radial = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug radial
cycle982-automatic-opposite-radial-reversal = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug radial, mit Umschlag
cycle982-automatic-workpiece = Automatisch messen: beide Längen, Radius; Drehwerkzeug, Fräswerkzeug oder Bohrer axial (WKS)
cycle982-automatic-reversal-workpiece = Automatisch messen: beide Längen, Radius; Fräswerkzeug oder Bohrer axial, mit Umschlag (WKS)
cycle982-automatic-upper-workpiece = Automatisch messen: obere Schneide; Fräswerkzeug axial (WKS)
cycle982-automatic-upper-reversal-workpiece = Automatisch messen: obere Schneide; Fräswerkzeug axial, mit Umschlag (WKS)
cycle982-automatic-opposite-workpiece = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug axial (WKS)
cycle982-automatic-opposite-reversal-workpiece = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug axial, mit Umschlag (WKS)
cycle982-automatic-radial-workpiece = Automatisch messen: beide Längen, Radius; Fräswerkzeug oder Bohrer radial (WKS)
cycle982-automatic-radial-reversal-workpiece = Automatisch messen: beide Längen, Radius; Fräswerkzeug oder Bohrer radial, mit Umschlag (WKS)
cycle982-automatic-upper-radial-workpiece = Automatisch messen: obere Schneide; Fräswerkzeug radial (WKS)
cycle982-automatic-upper-radial-reversal-workpiece = Automatisch messen: obere Schneide; Fräswerkzeug radial, mit Umschlag (WKS)
cycle982-automatic-opposite-radial-workpiece = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug radial (WKS)
cycle982-automatic-opposite-radial-reversal-workpiece = Automatisch messen: obere Schneide, Länge entgegen der Anfahrrichtung; Fräswerkzeug radial, mit Umschlag (WKS)
cycle982-incremental-measure = Inkrementell messen: Länge L1 oder L2; Drehwerkzeug, Fräswerkzeug oder Bohrer axial
cycle982-incremental-measure-reversal = Inkrementell messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer axial, mit Umschlag
cycle982-incremental-measure-radius = Inkrementell messen: Radius; Fräswerkzeug axial
cycle982-incremental-measure-radius-reversal = Inkrementell messen: Radius; Fräswerkzeug axial, mit Umschlag
cycle982-incremental-measure-radial = Inkrementell messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial
cycle982-incremental-measure-radial-reversal = Inkrementell messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial, mit Umschlag
cycle982-incremental-measure-radius-radial = Inkrementell messen: Radius; Fräswerkzeug radial
cycle982-incremental-measure-radius-radial-reversal = Inkrementell messen: Radius; Fräswerkzeug radial, mit Umschlag
cycle982-incremental-measure-workpiece = Inkrementell messen: Länge L1 oder L2; Drehwerkzeug, Fräswerkzeug oder Bohrer axial (WKS)
cycle982-incremental-measure-reversal-workpiece = Inkrementell messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer axial, mit Umschlag (WKS)
cycle982-incremental-measure-radius-workpiece = Inkrementell messen: Radius; Fräswerkzeug axial (WKS)
cycle982-incremental-measure-radius-reversal-workpiece = Inkrementell messen: Radius; Fräswerkzeug axial, mit Umschlag (WKS)
cycle982-incremental-measure-radial-workpiece = Inkrementell messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial (WKS)
cycle982-incremental-measure-radial-reversal-workpiece = Inkrementell messen: Länge L1 oder L2; Fräswerkzeug oder Bohrer radial, mit Umschlag (WKS)
cycle982-incremental-measure-radius-radial-workpiece = Inkrementell messen: Radius; Fräswerkzeug radial (WKS)
cycle982-incremental-measure-radius-radial-reversal-workpiece = Inkrementell messen: Radius; Fräswerkzeug radial, mit Umschlag (WKS)

task-measure-axis = In einer Achse messen
task-measure-axis-words = messen vermessen Wendeschneidplatte Drehmeißel angetriebenes Werkzeug Schaftfräser Fräser
task-measure-all = Automatisch messen: alle Werte
task-measure-all-words = automatisch alle Werte Wendeschneidplatte Drehmeißel angetriebenes Werkzeug Schaftfräser Fräser
mvar-edges = Umschlag (Fräswerkzeug, Bohrer)
second-edge-without = ohne
second-edge-with = mit: 2. Antastung, Spindel um 180° gedreht
second-edge-with-words = Umschlag zwei Schneiden Mittelwert 180°
mvar-extent = Maße des Fräswerkzeugs
extent-plain = eine Länge; automatisch: Längen und Radius
extent-plain-words = Länge L1 L2
extent-radius = Radius; nicht automatisch
extent-radius-words = Durchmesser
extent-length-radius = Länge und Radius, 2 Seiten; weder automatisch noch inkrementell
extent-length-radius-words = Durchmesser zwei Punkte
extent-upper = obere Schneide, abgewandte Seite umfahren; nur automatisch
extent-upper-words = Nutfräser Scheibenfräser T-Nutenfräser Scheibe Länge Radius
extent-upper-opposite = obere Schneide, Länge entgegen der Anfahrrichtung; nur automatisch
extent-upper-opposite-words = Nutfräser Scheibenfräser T-Nutenfräser Scheibe Länge Radius Gegenrichtung
mvar-tool-axis = Lage von Fräswerkzeug oder Bohrer
tool-axis-axial = axial: Radius in der Ordinate (G18: X)
tool-axis-radial = radial: Radius in der Abszisse (G18: Z)
ma-lathe-radius = Radius, in der Abszisse angetastet (G18: Z)
ma-lathe-radius-ordinate = Radius, in der Ordinate angetastet (G18: X)
ma-lathe-l2-radius = L2 und Radius, in der Abszisse angetastet (G18: Z)
ma-lathe-l1-radius = L1 und Radius, in der Ordinate angetastet (G18: X)

param-ma-lathe-measured = Zu messendes Maß
param-ma-lathe-measured-help = Zu messendes Maß; es bestimmt auch die Achse der Antastung. Der Radius liegt bei axialem Werkzeug in der Ordinate, bei radialem in der Abszisse. Startposition: vor der anzutastenden Messtasterseite.
param-md-incremental = Messrichtung
param-md-incremental-help = Richtung, in der das Werkzeug von seiner aktuellen Position zum Messtaster fährt.
param-sta1-milling-spindle = Startwinkel der Frässpindel
param-sta1-milling-spindle-help = Winkel, auf den die stehende Frässpindel vor der 1. Antastung dreht, damit eine Schneide zum Messtaster zeigt. Ohne Wirkung bei drehender Spindel und mit _CHBIT[20]=1.
param-cora-second-edge = Korrekturwinkel der zweiten Schneide
param-cora-second-edge-help = Wird zu den 180° addiert, um die die Spindel für die 2. Antastung dreht; für eine zweite Schneide, die nicht genau gegenüberliegt.
param-fa-present-position = Messweg
param-fa-present-position-help = Das Werkzeug steht vor dem Messtaster; die Antastung muss innerhalb des doppelten Messwegs ab dieser Position liegen. Immer in mm, in X als Radius.

need-axis-ignored = Wird nicht ausgewertet: Die Länge dieses Bohrers liegt in der Applikate (Settingdatum 42950 = 0).
need-direction-incremental = Bei inkrementellen Messvarianten bestimmt die Startposition die Messrichtung nicht.
need-start-angle-spindle = Die stehende Frässpindel dreht auf diesen Winkel; ohne Eingabe gilt der Wert eines früheren Aufrufs.
need-start-angle-milling = Gilt für Fräswerkzeuge.
need-second-edge = Gilt für die 2. Antastung einer Messung mit Umschlag.

check-tool-reference = _CBIT[5]=1: Die Werte in _TP gelten im aktiven WKS, obwohl die 2. Stelle von _MVAR maschinenbezogen angibt.
check-tool-reference-hint = _CBIT[5] auf 0 setzen oder die werkstückbezogene Messvariante (_TPW) wählen; danach Messtaster neu kalibrieren.
check-lathe-tool-type-hint = Drehwerkzeug (Typ 5xy), Fräswerkzeug (1xy, 711 bis 799) oder Bohrer (2xy) verwenden; $TC_DP1 prüfen.
check-turning-digits = Die Stellen 3 bis 5 von { $value } gelten für Fräswerkzeuge und Bohrer, aktiv ist aber ein Drehwerkzeug.
check-turning-digits-hint = Für das Drehwerkzeug { $plain } wählen oder vor dem Aufruf das Fräswerkzeug einwechseln.
check-tip-direction = Ein Werkzeug mit Schneidenlage { $tip } zeigt in die andere Richtung: Sein Rücken würde den Messtaster berühren.
check-tip-direction-hint = Werkzeug auf der anderen Seite des Messtasters positionieren und _MD ändern oder $TC_DP2 prüfen.
check-drill-radius = Der Zyklus misst bei einem Bohrer keinen Radius.
check-drill-radius-hint = Messvariante mit 4. Stelle = 0 wählen oder ein Fräswerkzeug einwechseln; $TC_DP1 prüfen.
check-drill-plane = Mit Settingdatum 42950 = 0 liegt die Bohrerlänge bei G18 in Y; in dieser Achse misst der Zyklus nicht.
check-drill-applicate = Mit Settingdatum 42950 = 0 misst der Zyklus beim Bohrer nur die Länge: in einer Achse, ohne Umschlag.
check-drill-applicate-hint = 1, 11, 100001 oder 100011 mit G17 (Bohrer in Z) oder G19 (in X) wählen oder das Settingdatum auf 2 setzen und mit G18 messen.
check-length-assignment = Settingdatum 42950 ist { $value }: L1 und L2 von Fräswerkzeugen und Bohrern liegen in anderen Achsen als bei Drehwerkzeugen.
check-length-assignment-hint = Settingdatum 42950 ($SC_TOOL_LENGTH_TYPE) vorher auf 2 setzen; für Bohrer in G17 oder G19 ist auch 0 möglich.
check-spindle-stays = Diese Messvariante dreht die Spindel oder misst zweimal, aber _CHBIT[20]=1 unterdrückt das Positionieren der Spindel.
check-spindle-stays-hint = _CHBIT[20] auf 0 setzen oder eine Messvariante xxx0x1 wählen, bei der jede Stelle x 0 oder 1 ist: ein Punkt, ohne Umschlag.
check-spindle-turns = Die Frässpindel müsste auf _STA1 drehen, lässt sich aber nicht positionieren.
check-spindle-turns-hint = Schneide zum Messtaster drehen, _CHBIT[20] auf 1 setzen und eine Messvariante xxx0x1 wählen: ein Punkt, ohne Umschlag.
check-side-radius = Das Werkzeug tastet mit dem Umfang an, sein Radius ist aber 0: Die Länge ist nicht berechenbar.
check-side-radius-hint = Radius in den Werkzeugdaten eintragen oder in Richtung der Werkzeugachse messen.
check-radius-length = { $length } des Werkzeugs ist 0, aber der Radius wird aus dieser Länge berechnet.
check-radius-length-hint = Diese Länge zuerst messen oder eintragen oder mit dem Radius messen (4. Stelle = 2; nicht inkrementell).
