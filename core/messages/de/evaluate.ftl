# Entscheidungen eines Messzyklus nach dem Messen. Zahlen in mm.
evaluate-safe-area = Differenz { $difference } mm überschreitet den Vertrauensbereich: Nichts wird korrigiert.
evaluate-safe-area-angle = Differenz { $difference }° überschreitet den Vertrauensbereich: Nichts wird korrigiert.
evaluate-difference = Differenz { $difference } mm überschreitet die zulässige Maßdifferenz: Nichts wird korrigiert.
evaluate-oversize = Differenz { $difference } mm liegt über der oberen Toleranz: { $follows }.
evaluate-undersize = Differenz { $difference } mm liegt unter der unteren Toleranz: { $follows }.
evaluate-whole = Differenz { $difference } mm liegt in der Toleranz, aber außerhalb des Bereichs der Mittelwertbildung: { $follows }.
evaluate-mean = Differenz { $difference } mm ergibt Mittelwert { $mean } mm außerhalb des Nullkorrekturbereichs: { $follows }.
# Was aus den vier davor folgt.
evaluate-corrects-whole = Die ganze Differenz wird korrigiert
evaluate-corrects-both = Korrigiert wird um das Mittel beider Differenzen
evaluate-corrects-zero = Das Mittel beider Differenzen ist 0, nichts wird korrigiert
evaluate-corrects-mean = Korrigiert wird um den Mittelwert
evaluate-corrects-nothing = Es ist keine Korrektur gewählt, nichts wird korrigiert
evaluate-corrects-simulated = Diese Simulation korrigiert nichts
evaluate-restarts = Der Mittelwert beginnt neu: { $name } wird 0.
evaluate-small = Differenz { $difference } mm ergibt Mittelwert { $mean } mm im Nullkorrekturbereich: Nichts wird korrigiert.
evaluate-kept = Differenz zum gespeicherten Wert höchstens { $limit } mm (_TZL), daher unverändert: { $data }.
evaluate-repeat = Messung wiederholt, weil die Differenz zu groß ist: Wiederholung { $count } von höchstens 4.
evaluate-halt = Programmierter Halt (M0): Weiter mit NC START.
evaluate-activated = Das korrigierte Frame ist sofort aktiv.
evaluate-not-activated = Das korrigierte Frame wird aktiv, wenn das Programm es wieder aufruft (G54, G500 …).
evaluate-distortion = Das gemessene Dreieck weicht um { $distortion } mm vom Solldreieck ab; nur unter { $limit } mm wird das Frame korrigiert.
evaluate-handed-back = Der Zyklus löst keinen Alarm aus: { $name } erhält die Alarmnummer { $alarm }, und das Programm läuft weiter.
evaluate-tool-safe-area = Differenz { $difference } mm erreicht oder überschreitet den Vertrauensbereich, { $limit } mm: Dieser Wert wird nicht korrigiert.
evaluate-tool-difference = Differenz { $difference } mm erreicht oder überschreitet die zulässige Maßdifferenz, { $limit } mm: Dieser Wert wird nicht korrigiert.
evaluate-tool-small = Differenz { $difference } mm liegt im Nullkorrekturbereich, { $limit } mm: Dieser Wert wird nicht korrigiert.
evaluate-tool-geometry = Differenz { $difference } mm und bisheriger Verschleiß werden in die Geometrie eingerechnet; der Verschleiß wird 0.
evaluate-tool-wear = Differenz { $difference } mm wird im Verschleiß korrigiert.
evaluate-tool-simulated = Differenz { $difference } mm wird nicht korrigiert: Diese Simulation korrigiert nichts.
evaluate-compensation-make = Die Korrekturtabelle dieses Messtasterherstellers (_TP_CF = { $make }) liegt in der Steuerung und steht in keinem Handbuch: Die Simulation subtrahiert nichts. Bei _MT_COMP = 2 gelten eigene Tabellen in _MT_EC_R und _MT_EC_L.
evaluate-compensation = Vom Messwert werden { $amount } mm aus Korrekturtabelle { $table } subtrahiert.
evaluate-screen = Die Steuerung zeigt das Messergebnisbild, bis der Zyklus endet.
evaluate-screen-stays = Die Steuerung zeigt das Messergebnisbild bis zum Aufruf des nächsten Messzyklus; das Programm läuft weiter.
evaluate-screen-halt = Die Steuerung zeigt das Messergebnisbild. Programmierter Halt (M0): Weiter mit NC START.
evaluate-log-full = Das Protokoll { $file } und seine neun Folgedateien sind voll und nehmen nichts mehr auf. Die Steuerung hält an und verlangt einen neuen Namen in _PROTNAME[1].
evaluate-log-deleted = Das Protokoll { $file } dieses Laufs wird neu begonnen: Seine { $lines } Zeilen werden gelöscht.
evaluate-log-none = Vor diesem Aufruf wurde kein Protokoll begonnen: CYCLE105 schreibt nichts. CYCLE100 beginnt ein Protokoll.
# Was ein Aufruf mit Daten der Maschine tut, bevor er misst.
check-erases = _CBIT[13]=1: Dieser Aufruf setzt zuerst _TP[], _TPW[], _WP[], _KB[], _EV[], _MV[] und das Bit selbst auf 0.
check-erases-hint = _CBIT[13] vor dem Aufruf auf 0 setzen oder die Daten danach neu eintragen und neu kalibrieren.
check-converts = { $bit } passt nicht zum Grundsystem der Maschine (MD 10240): Dieser Aufruf rechnet zuerst { $value ->
        [1] von inch in mm
       *[other] von mm in inch
    } um: { $data }.
check-converts-hint = Sind die Daten schon richtig, vor dem Aufruf { $bit } auf { $value } setzen.
evaluate-erased = _CBIT[13]=1: _TP[], _TPW[], _WP[], _KB[], _EV[], _MV[] und das Bit selbst sind jetzt 0.
evaluate-converted = { $bit } passte nicht zum Grundsystem der Maschine und ist jetzt { $value }. Umgerechnet { $value ->
        [1] von inch in mm
       *[other] von mm in inch
    }: { $data }.

# A measurement in one line: what was measured.
answer-diameter = Durchmesser
answer-width = Breite
answer-length = Länge
answer-centre = Mittelpunkt
answer-position = Position
answer-angle = Winkel
answer-corner = Eckpunkt
answer-tool-length = Werkzeuglänge
answer-radius = Radius
answer-trigger = Triggerpunkt
answer-skew = Lageabweichung
answer-probe-length = Länge des Messtasters
answer-value = Messwert
# What is corrected.
answer-frame = { $frame }
answer-frame-fine = { $frame }, fein
answer-tool = T{ $tool } D{ $edge }
answer-tool-offset = T{ $tool } D{ $edge } DL{ $offset }
answer-register = Korrekturspeicher { $register }
answer-probe = Messtasterdaten
# What follows.
answer-within = Innerhalb der Grenzen
answer-within-area = Im Vertrauensbereich
answer-beyond = Außerhalb der Grenzen
answer-rework = Nacharbeit
answer-scrap = Ausschuss
answer-alarm = Alarm { $code }
answer-stopped = Nicht weiter simuliert
answer-measured = Gemessen
answer-why-within = Die Abweichung beträgt höchstens { $limit }{ $unit ->
        [deg] °
        [inch]  inch
       *[mm]  mm
    }.
answer-why-area = Keine Toleranz angegeben. Die Abweichung liegt im Vertrauensbereich von { $limit }{ $unit ->
        [deg] °
        [inch]  inch
       *[mm]  mm
    }.
answer-why-measured = Für diese Messung ist kein Grenzwert festgelegt.

screen-tool-probe = Werkzeugmesstaster kalibrieren
screen-tool = Werkzeug messen
screen-probe = Werkstückmesstaster kalibrieren
screen-workpiece = Werkstückmessung
screen-set = Sollwert
screen-actual = Istwert
screen-difference = Differenz
screen-until-end = Sichtbar, bis der Zyklus endet.
screen-until-start = Wartet auf NC START: Messergebnisbild quittieren.
screen-until-next = Sichtbar bis zum Aufruf des nächsten Messzyklus.
screen-waits = Das Programm wartet auf NC START.
