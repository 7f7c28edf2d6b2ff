# CYCLE116: Kreis durch Punkte.

cycle116-title = Kreis durch Punkte
cycle116-help = Berechnet Mittelpunkt und Radius eines Kreises aus drei oder vier Punkten der Ebene, zum Beispiel aus einzeln gemessenen Punkten.
cycle116-words = Kreis Mittelpunkt Bohrungsmitte Zentrum Mitte Radius drei 3 Punkte vier 4 Punkte berechnen ausrechnen Kreisbogen Bogen Bohrung Welle Zapfen Rechenzyklus
cycle116-circle = Mittelpunkt und Radius aus Punkten
cycle116-three = drei Punkte
cycle116-four = vier Punkte
cycle116-no-circle = Die Punkte liegen auf einer Geraden oder aufeinander: Es lässt sich kein Kreis berechnen.
cycle116-no-circle-hint = Punkte wählen, die auf dem Kreis weit auseinanderliegen, zum Beispiel je ein Drittel des Umfangs.

param-116-count = Anzahl der Punkte
param-116-count-help = Drei Punkte bestimmen den Kreis; bei vier gehen alle ein: Ein ungenauer Punkt hat weniger Einfluss.
param-116-abscissa = Abszisse eines Punkts
param-116-abscissa-help = Koordinate des Punkts in der 1. Achse der Ebene.
param-116-ordinate = Ordinate eines Punkts
param-116-ordinate-help = Koordinate des Punkts in der 2. Achse der Ebene.
need-116-points = Ein Kreis braucht mindestens drei Punkte.
need-116-fourth = Vier Punkte sind gewählt.

result-116-abscissa = Mittelpunkt, Abszisse
result-116-ordinate = Mittelpunkt, Ordinate
result-116-radius = Radius
result-116-status = 0: Kreis berechnet; 1: kein Kreis
result-116-alarm = 0, ohne Kreis die Alarmnummer
