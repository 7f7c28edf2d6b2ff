# CYCLE998: Titel, Suchwörter, Varianten, Texte der eigenen Parameter und Prüfungen.

cycle998-title = Winkel einer Fläche
cycle998-help = Misst, wie ein aufgespanntes Werkstück gedreht ist: einen Winkel aus zwei Punkten einer geraden Kante oder Fläche oder zwei Winkel einer schrägen Ebene aus drei Punkten.
cycle998-words = messen vermessen antasten Werkstück Winkel ausrichten Ausrichtung Kante ausrichten Ebene ausrichten Grunddrehung Drehung drehen Lage Fläche Planfläche Ebene schräg geneigt Neigung schief verdreht aufgespannt Rundtisch Rundachse C-Achse Nullpunktverschiebung NV NPV Frame G54 zwei drei Punkte Taster Messtaster Schraubstock Messuhr ausuhren parallel Schräglage Nullpunkt
cycle998-each-words = zwei Winkel

cycle998-one = Winkelmessung, Positionieren unter dem Sollwinkel
cycle998-one-differential = Winkelmessung als Differenzmessung
cycle998-one-paraxial = Winkelmessung, achsparallel positionieren
cycle998-two = Zweiwinkelmessung, Positionieren unter den Sollwinkeln
cycle998-two-paraxial = Zweiwinkelmessung, achsparallel positionieren

mvar-angles = Winkel
angles-one = ein Winkel, aus zwei Punkten
angles-one-words = Kante ausrichten Drehung Rundtisch Rundachse zwei Punkte Vertrauensbereich Sollposition
angles-two = zwei Winkel, aus drei Punkten
angles-two-words = schräg Ebene Raum Neigung drei Punkte Schwenken CYCLE800
mvar-positioning = Positionieren zwischen den Punkten
positioning-angle = unter dem Sollwinkel, von der Fläche weg
positioning-paraxial = achsparallel
positioning-paraxial-words = Achse achsparallel parallel Richtung ohne Sollwert

param-setval-point = Sollposition von P1
param-setval-point-help = Erwartete Position der Fläche in P1, in der Messachse. Die Seite, auf der der Messtaster steht, bestimmt die Messrichtung. Um mehr als _FA darf die Fläche nicht abweichen.
param-setval-point-applicate = Sollhöhe von P1
param-setval-point-applicate-help = Erwartete Position der Fläche in P1, in der Applikate (G17: Z).
param-ma-offset = Messachse und Versatzachse
param-ma-offset-help = Achse, in der die Fläche angetastet wird, und Achse, in der P2 gegenüber P1 versetzt ist. Der Winkel ist eine Drehung um die dritte, nicht genannte Achse.
ma-102 = Ordinate, Punkte entlang der Abszisse
ma-103 = Applikate, Punkte entlang der Abszisse
ma-201 = Abszisse, Punkte entlang der Ordinate
ma-203 = Applikate, Punkte entlang der Ordinate
ma-301 = Abszisse, Punkte entlang der Applikate
ma-302 = Ordinate, Punkte entlang der Applikate
param-id-points = Abstand von P1 zu P2
param-id-points-help = In Plus-Richtung der Versatzachse; P1 hat also die kleinere Koordinate. Je größer der Abstand, desto genauer der Winkel.
param-id-points-abscissa = Abstand von P1 zu P2
param-id-points-abscissa-help = In Plus-Richtung der Abszisse (G17: X). Je größer der Abstand, desto genauer der Winkel.
param-setv0-points = Abstand von P1 zu P3
param-setv0-points-help = In Plus-Richtung der Ordinate (G17: Y).
param-sta1-edge = Sollwinkel
param-sta1-edge-help = Sollwinkel der Fläche zur Plus-Richtung der Versatzachse, gegen den Uhrzeigersinn positiv. Beim Positionieren unter dem Sollwinkel auch Verfahrrichtung: nahe am Istwinkel wählen.
param-sta1-about-abscissa = Sollwinkel um die Abszisse
param-sta1-about-abscissa-help = Neigung von P1 zu P3; positiv, wenn die Fläche steigt. Beim Positionieren unter den Sollwinkeln auch Verfahrrichtung.
param-inca-about-ordinate = Sollwinkel um die Ordinate
param-inca-about-ordinate-help = Neigung von P1 zu P2; positiv, wenn die Fläche fällt. Beim Positionieren unter den Sollwinkeln auch Verfahrrichtung.
param-ra = Rundachse
param-ra-help = 0 dreht das Koordinatensystem um die nicht in _MA genannte Achse. Sonst Kanalachsnummer der Rundachse: Die Differenz wird zu ihrer NV addiert; zum Ausrichten danach die Rundachse verfahren.
param-fa-paraxial = Messweg
param-fa-paraxial-help = Die Fläche muss innerhalb des doppelten Messwegs ab der Position vor jedem Punkt liegen. Immer in mm.
param-tsa-angle = Vertrauensbereich des Winkels
param-tsa-angle-help = In Grad. Eine größere Differenz des Winkels hält das Programm mit Alarm 61303 an. Beim Positionieren unter dem Sollwinkel entfernt sich der Messtaster um diesen Winkel von der Fläche.

need-set-position = Die Sollposition bestimmt die Messrichtung und die erste Antastung.
need-axes-angle = Der Winkel liegt in der Ebene zweier Achsen.
need-direction-paraxial = Ohne Sollposition ist die Messrichtung anzugeben.
need-third-point = Eine Ebene braucht einen dritten Punkt.
need-second-angle = Eine Ebene hat zwei Winkel.
need-rotary = Angeben, welche Achse den Winkel ausgleicht; 0: das Koordinatensystem.

check-angle-steep = Winkel { $param } und Vertrauensbereich ergeben zusammen { $sum }°; ab 90° kann der Zyklus nicht positionieren.
check-angle-steep-hint = _TSA kleiner als { $limit }° wählen. Hier ist _TSA ein Winkel, keine Länge.
check-angle-reach = Durch _TSA liegt die Sollfläche am nächsten Punkt { $away } mm vor dem Messtaster: weiter als der ganze Messweg, { $path } mm.
check-angle-reach-hint = _FA auf mindestens { $needed } mm setzen oder _TSA verkleinern.
check-angle-reach-worst = Bei { $area }° Abweichung, dem ganzen Vertrauensbereich, liegt der nächste Punkt außerhalb des Messwegs: Alarm 61301 statt 61303.
check-angle-paraxial = Von Punkt zu Punkt liegt die Sollfläche um { $rise } mm versetzt: mehr als der ganze Messweg, { $path } mm.
check-angle-paraxial-hint = _FA größer als { $needed } mm oder eine Messvariante mit Positionieren unter dem Sollwinkel wählen.
check-rotary-axis = Die Kanalachse { $axis } hat keinen Namen oder ist keine Rundachse.
check-rotary-across = Diese Rundachse dreht nicht um die Achse, um die der Winkel gemessen wird: Sie kann ihn nicht ausgleichen.
check-rotary-across-hint = Rundachse angeben, die in der Ebene beider Achsen von _MA dreht, oder 0, um das Koordinatensystem zu drehen.
check-rotary-axis-hint = Kanalachsnummer der Rundachse eingeben oder 0, um das Koordinatensystem zu drehen. Achsen: MD 20080 und MD 30300.
