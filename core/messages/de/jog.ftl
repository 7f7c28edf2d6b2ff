# Messen in JOG: Masken, Felder, Ergebnisse, was abgelehnt wird. Die Wörter sind die der Masken der Steuerung.

jog-mask-set-edge = Kante setzen
jog-mask-align-edge = Kante ausrichten
jog-mask-distance = Abstand von 2 Kanten
jog-mask-corner-right = Rechtwinklige Ecke
jog-mask-corner-any = Beliebige Ecke
jog-mask-pocket-rect = Rechtecktasche
jog-mask-hole-1 = 1 Bohrung
jog-mask-spigot-rect = Rechteckzapfen
jog-mask-spigot-1 = 1 Kreiszapfen
jog-mask-holes-2 = 2 Bohrungen
jog-mask-spigots-2 = 2 Kreiszapfen
jog-mask-holes-3 = 3 Bohrungen
jog-mask-spigots-3 = 3 Kreiszapfen
jog-mask-holes-4 = 4 Bohrungen
jog-mask-spigots-4 = 4 Kreiszapfen
jog-mask-align-plane = Ebene ausrichten
jog-mask-cal-length = Messtaster abgleichen, Länge
jog-mask-cal-radius = Messtaster abgleichen, Radius
jog-mask-tool-cal = Werkzeugmesstaster kalibrieren
jog-mask-tool-length = Werkzeug messen, Länge
jog-mask-tool-radius = Werkzeug messen, Radius

jog-field-zo = Nullpunktverschiebung
jog-field-direction = Messrichtung
jog-field-direction-2 = Messrichtung an P2
jog-field-axis = Messachse
jog-field-ref-axis = Bezugsachse
jog-field-angle-offset = Winkelkorrektur
jog-field-spec-angle = Sollwinkel
jog-field-corner = Ecke
jog-field-pos = Lage
jog-field-l = Länge L
jog-field-w = Breite W
jog-field-diameter = Durchmesser
jog-field-contact-angle = Antastwinkel
jog-field-dz = Zustellung D{ $axis }
jog-field-x0 = { $axis }0
jog-field-y0 = { $axis }0
jog-field-x1 = { $axis }1
jog-field-y1 = { $axis }1
jog-field-z0 = { $axis }0
jog-field-d = Durchmesser des Rings
jog-field-set-p1 = P1 setzen
jog-field-cal-kind = Kalibrieren
jog-field-v = Versatz V
jog-field-activate = Diese Nullpunktverschiebung aktivieren?
jog-field-position-axis = Rundachse positionieren?

jog-result-meas-x0 = Gemessen { $axis }0
jog-result-meas-y0 = Gemessen { $axis }0
jog-result-meas-l = Gemessen L
jog-result-meas-w = Gemessen W
jog-result-diameter = Gemessener Durchmesser
jog-result-alpha = Winkel α
jog-result-beta = Winkel β

jog-line-inactive = { $offset } wurde korrigiert, ist aber nicht aktiv.
jog-line-tilted = Das neue WKS hat eine neue Ausrichtung.
jog-line-turned = Das Werkstück ist um die Werkzeugachse gedreht. Beim Verfahren im WKS beachten.
jog-line-rotary = Die NV der Rundachse { $axis } wurde korrigiert. Das Werkstück ist ausgerichtet, sobald die Achse verfahren ist.
jog-line-start = Zum Aktivieren NC-Start drücken.

jog-state-menu = Keine Maske ist offen.
jog-state-mask = Die Maske { $mask } ist offen.
jog-state-ready = Alle Punkte sind gespeichert. Berechnen drücken.
jog-state-busy = Eine Messung läuft.
jog-state-activate = Das Aktivierungsbild wartet auf NC-Start.
jog-state-moving = Die Aktivierung läuft.
jog-state-alarm = Ein Alarm steht an. RESET drücken.

jog-refused = Diese Taste hat in diesem Zustand keine Wirkung.
jog-mode = Hier lässt sich die Betriebsart nicht wechseln. Zuerst die Maske mit << verlassen.
jog-open = Eine Maske ist offen. Zuerst mit << verlassen.
jog-pending = Ein Alarm steht an. Zuerst mit RESET quittieren.
jog-no-mask = Keine Maske ist offen. Zuerst eine öffnen, zum Beispiel mit „mask set_edge“.
jog-all-stored = Alle Punkte sind gespeichert. Berechnen drücken oder einen Punkt verwerfen und neu messen.
jog-missing = Es fehlen Punkte: { $points }. Zuerst mit NC-Start messen.
jog-at-once = Diese Maske misst und rechnet mit NC-Start allein. NC-Start drücken.
jog-grey = { $point } ist nicht gespeichert und lässt sich nicht verwerfen.
jog-nothing-to-activate = Es gibt nichts zu aktivieren. Die NV ist schon aktiv, oder es wurde nichts korrigiert.
jog-no-jog = Diese Steuerung hat kein Messen in JOG. Die Einrichtung einer SINUMERIK verwenden.
jog-no-function = Es gibt keine Maske { $name }. Vorhanden: { $known }.
jog-no-field = Die Maske hat jetzt kein Feld { $field }. Vorhanden: { $known }.
jog-no-tool = Es gibt kein Werkzeug T{ $tool } mit D{ $edge }. In den Werkzeugen der Einrichtung eintragen.
jog-no-datum = Die Steuerung hat keine Variable { $name }. Name und Index prüfen.
jog-wrong-number = { $field } ist keine Zahl: { $text }. Eine Zahl eingeben, zum Beispiel 12.5.
jog-wrong-far = { $field } kann nicht { $value } sein. Einen Wert bis { $limit } eingeben.
jog-wrong-above = { $field } kann nicht { $value } sein. Einen Wert über 0 eingeben.
jog-wrong-below = { $field } kann nicht { $value } sein. 0 oder einen Wert über 0 eingeben.
jog-wrong-word = { $field } kann nicht { $text } sein. Eines davon eingeben: { $known }.
jog-ball = Die Messtasterkugel, { $value } mm, passt nicht hinein. Das Maß in der Maske prüfen.
jog-same-place = Beide Punkte liegen an derselben Stelle der Bezugsachse. Einen verwerfen und weiter entfernt messen.
jog-in-line = Die drei Punkte liegen auf einer Geraden, oder die Ebene steht senkrecht. Einen verwerfen und anderswo messen.

jog-script-command = Es gibt keinen Befehl „{ $text }“.
jog-script-command-hint = Einen davon verwenden: { $known }, oder ein Feld als NAME = WERT eingeben.
jog-script-alone = „{ $word }“ hat keinen Wert: { $text }
jog-script-alone-hint = „{ $word }“ allein in die Zeile schreiben.
jog-script-move = Keine Position einer Achse: { $text }
jog-script-move-hint = Achsen mit Zahlen schreiben, zum Beispiel „move X10 Y-5.5“.
jog-script-point = Kein Punkt: { $text }
jog-script-point-hint = P1, P2, P3 oder P4 schreiben.
jog-script-plc = Kein Bit der PLC: { $text }
jog-script-plc-hint = Punkt und Zustand schreiben, zum Beispiel „plc P2 on“.
jog-script-tool = Kein Werkzeug: { $text }
jog-script-tool-hint = T- und D-Nummer schreiben, zum Beispiel „tool T9 D1“.
jog-script-set = Keine Variable mit Wert: { $text }
jog-script-set-hint = Name und Wert schreiben, zum Beispiel „set _JM_I[4] = 1“.
jog-script-long = Das Skript hat mehr als { $limit } Zeilen.
jog-script-long-hint = In mehrere Skripte teilen.

jog-point = { $point }: { $place }
jog-offset-active = Aktiv: { $offset }
jog-truth = Das Werkstück liegt nach Startwert { $seed }: verschoben um X { $x }, Y { $y }, Z { $z } mm; gedreht um X { $a }, Y { $b }, Z { $c }°; Übermaß { $size } mm.
jog-takes = { $label } ({ $name })
jog-takes-one-of = { $label } ({ $name }): { $words }

jog-area-edge = Kante
jog-area-corner = Ecke
jog-area-hole = Tasche/Bohrung
jog-area-spigot = Zapfen
jog-area-plane = Ebene ausrichten
jog-area-calibrate = Messtaster abgleichen
jog-area-tool = Werkzeug messen

jog-word-none = nur Messen
jog-word-rotation = Koordinatendrehung
jog-word-yes = Ja
jog-word-no = Nein
jog-word-outside = Außen
jog-word-inside = Innen
jog-word-length = nur Länge
jog-word-length-and-diameter = Länge und Durchmesser

jog-show-translation = Verschiebung
jog-show-rotation = Drehung
jog-show-turned = Rundachse
jog-show-measuring = Beim Messen aktiv

jog-crash-hint = Achse in Gegenrichtung freifahren, dann mit kleinerem Schrittmaß anfahren.
