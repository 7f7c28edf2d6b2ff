# Was an den Werten eines Aufrufs falsch ist, und die Abhilfe (-hint). Längen in mm, außer bei Werten wie eingegeben.

check-missing = { $param } fehlt.
check-delivered = { $param } ist nicht angegeben: Es gilt die Vorbesetzung { $value }{ $unit }.
check-not-a-number = „{ $value }“ ist keine Zahl.
check-not-a-number-hint = Ziffern mit Punkt oder Komma eingeben, zum Beispiel 12.5.
check-expression = „{ $value }“ ist erst beim Programmlauf bekannt und wird deshalb nicht geprüft.
check-no-value = { $name } hat hier keinen Wert: Der Aufruf wird nicht simuliert.
check-no-value-hint = { $name } vor dem Aufruf einen Wert zuweisen oder den Wert in der Maschineneinrichtung angeben.
check-too-large = { $value } liegt außerhalb des Bereichs jeder Maschine.
check-too-large-hint = Zahl und Exponent prüfen.
check-not-whole = { $value } ist keine ganze Zahl.
check-not-whole-hint = Wert ohne Nachkommastellen eingeben.
check-text-long = Der Text ist länger als { $most } Zeichen.
check-text-long-hint = Text auf die Länge kürzen, die die Steuerung speichert.
check-text-characters = Der Text enthält Anführungszeichen oder Steuerzeichen.
check-text-characters-hint = Text ohne Anführungszeichen und Steuerzeichen eingeben.
check-range = { $param } darf nicht { $value }{ $unit } sein.
check-range-choice-hint = Einen dieser Werte wählen: { $choices }.
check-range-both-hint = Wert von { $min } bis { $max }{ $unit } eingeben.
check-range-from-hint = Mindestens { $min }{ $unit } eingeben.
check-range-above-hint = Mehr als { $min }{ $unit } eingeben.
check-range-below-hint = Weniger als { $max }{ $unit } eingeben.
check-unusual = { $param }: { $value }{ $unit } ist ungewöhnlich.
check-unusual-hint = Üblich sind { $min } bis { $max }{ $unit }.
check-variant = { $cycle } hat keine Messvariante { $value }.
check-variant-pair = „{ $one }: { $first }“ und „{ $other }: { $second }“ passen nicht zusammen: { $cycle } hat keine Messvariante { $value }.
check-variant-hint = Messvariante aus der Liste wählen.
check-variant-near-hint = Ähnliche Messvarianten: { $near }. Nicht jede Kombination der Stellen ist zulässig.

check-knum-zero = { $code } bezeichnet keine Nullpunktverschiebung.
check-knum-zero-hint = Zulässig: 0 (keine), 1 bis 99 (G54 …), 1000, 1011 bis 1026, 1051 bis 1066 (Basis), 2000 (System), 9999 (aktives Frame).
check-knum-no-system = { $code } bezeichnet das Systemframe $P_SETFR, das es an dieser Maschine nicht gibt.
check-knum-no-system-hint = Anderes Frame wählen oder Bit 0 in MD 28082 setzen.
check-knum-is-tool-hint = Code einer Werkzeugkorrektur: Frame angeben oder, falls vorhanden, Messvariante mit Werkzeugkorrektur wählen.
check-knum-is-zero-hint = Code einer NV: zulässige D-Nummer angeben oder, falls vorhanden, Messvariante mit NV-Korrektur wählen.
check-knum-digit-4 = Die 4. Stelle von rechts in { $code } (bei fünfstelligen D-Nummern die 6.) hat einen unzulässigen Wert.
check-knum-digit-5 = Die 5. Stelle von rechts in { $code } (bei fünfstelligen D-Nummern die 7.) hat einen unzulässigen Wert.
check-knum-digit-6 = Die 6. Stelle von rechts in { $code } (bei fünfstelligen D-Nummern die 8.) hat einen unzulässigen Wert.
check-knum-digit-7 = Die 7. Stelle von rechts in { $code } (bei fünfstelligen D-Nummern die 9.) oder eine höhere hat einen unzulässigen Wert.
check-knum-edge-none = { $code } bezeichnet keine D-Nummer.
check-knum-edge-large = Die D-Nummer in { $code } ist größer als { $largest }, die größte D-Nummer dieser Steuerung.
check-knum-seven-digits-hint = Von rechts: 3 Stellen D-Nummer. 0 oder 1: Länge, 2: Radius. 1: invertiert. 1 bis 3: L1 bis L3, 4: Radius. 0 bis 3: Korrekturart.
check-knum-nine-digits-hint = Von rechts: 5 Stellen D-Nummer. 0 oder 1: Länge, 2: Radius. 1: invertiert. 1 bis 3: L1 bis L3, 4: Radius. 0 bis 3: Korrekturart.

check-probe-number = Die Messtasternummer { $number } gibt es nicht.
check-probe-number-hint = Nummer von 1 bis { $fields } wählen.
check-probe-type = Die 3. Stelle von rechts in der Messtasternummer darf nicht { $type } sein.
check-probe-type-hint = 0 für einen Multitaster eingeben, 1 für einen Monotaster oder bidirektionalen Messtaster.
check-cora-off = Der Korrekturwinkel wirkt nicht: _CBIT[8] ist 0.
check-cora-off-hint = _CBIT[8]=1 setzen oder für den Korrekturwinkel 0 eingeben.
check-empirical-memory = Den Erfahrungswertspeicher { $number } gibt es nicht; Anzahl der Erfahrungswerte im Feld: { $size }.
check-mean-memory = Den Mittelwertspeicher { $number } gibt es nicht; Anzahl der Mittelwerte im Feld: { $size }.
check-memory-hint = Kleinere Nummer wählen oder das Feld und { $array } vergrößern.
check-mean-off = Der Mittelwert wird nicht von Werkstück zu Werkstück gespeichert: _CHBIT[4] ist 0.
check-mean-off-hint = _CHBIT[4]=1 setzen, wenn der Mittelwert gespeichert werden soll.
check-tolerance-order = Die obere Toleranz, { $upper } mm, liegt unter der unteren, { $lower } mm.
check-tolerance-order-hint = _TUL und _TLL vertauschen oder ihre Vorzeichen korrigieren.
check-band-difference = Das halbe Toleranzfeld, { $small } mm, ist größer als _TDIF, { $large } mm: Bei manchen Gutteilen entfällt die Korrektur.
check-zero-mean = _TZL, { $small } mm, ist größer als _TMV, { $large } mm: Der Zyklus korrigiert nie über den Mittelwert.
check-difference-safe = _TDIF, { $small } mm, ist größer als _TSA, { $large } mm: Das Programm hält an, bevor _TDIF wirkt.
check-bands-hint = Reihenfolge vom kleinsten zum größten Wert einhalten: _TZL, _TMV, halbes Toleranzfeld, _TDIF, _TSA.
check-rotation = Eine Koordinatendrehung ist aktiv.
check-rotation-hint = Drehung vor dem Aufruf abwählen: Dieser Zyklus misst parallel zu den Maschinenachsen.
check-infeed = Die Zustellung, { $infeed } mm, bringt den Messtaster nicht nach unten zum Messelement.
check-infeed-hint = Negative Zustellung eingeben; liegt das Messtastergehäuse auf der Minus-Seite der Applikate, eine positive.

check-ball = Die Messtasterkugel, { $ball } mm, passt nicht hinein.
check-ball-hint = Eingegebenes Maß korrigieren oder Messtaster mit kleinerer Kugel verwenden.
check-path-long = Der Messweg würde in der gegenüberliegenden Wand beginnen: Die Kugel hat nur { $free } mm Weg.
check-path-long-hint = _FA kleiner als { $free } mm wählen.
check-zone-wide = Die Schutzzone, { $zone } mm, ist nicht kleiner als das Messelement, { $size } mm.
check-zone-wide-hint = Schutzzone kleiner als { $limit } mm wählen, damit die Kugel daneben passt.
check-zone-none-hint = Keine Schutzzone passt hinein: Messvariante ohne Schutzzone wählen oder kleinere Kugel verwenden.
check-zone-narrow = Die Schutzzone, { $zone } mm, ist nicht größer als das Messelement, { $size } mm.
check-zone-narrow-hint = Schutzzone größer als { $limit } mm wählen, damit die Kugel neben das Messelement passt.
check-zone-ball = Zwischen Messelement und Schutzzone ist kein Platz für die Messtasterkugel, { $ball } mm.
check-zone-shortens = Die Schutzzone verkürzt den Messweg auf { $free } mm.
check-zone-shortens-hint = Schutzzone so ändern, dass mehr Weg bleibt; sonst darf das Werkstück höchstens um den verkürzten Messweg abweichen.
check-differential-mono = Die Differenzmessung dreht die Spindel; ein Monotaster misst nur in einer Richtung.
check-differential-mono-hint = Multitaster oder Messvariante ohne Differenzmessung verwenden.
check-differential-axis = Differenzmessung ist nur in der Ebene möglich.
check-differential-axis-hint = Messachse 1 oder 2 wählen.
check-mono-spindle = Der Zyklus dreht einen Monotaster vor jeder Antastung, aber diese Spindel lässt sich nicht positionieren.
check-mono-spindle-hint = Multitaster verwenden.
check-differential-spindle = Die Differenzmessung dreht die Spindel, aber diese Spindel lässt sich nicht positionieren.
check-differential-spindle-hint = Messvariante ohne Differenzmessung und einen kalibrierten Messtaster verwenden.
check-knum-no-additive = Diese Maschine hat keine Summenkorrekturen.
check-knum-no-additive-hint = Stattdessen Länge oder Radius korrigieren oder Bit 8 in MD 18080 setzen.
check-target-not-offered = { $param } = { $value } gehört nicht zu den Korrekturzielen, die die Masken dieser Maschine anbieten.
check-target-not-offered-hint = Einstellbare NV oder letztes Basisframe, bei Werkzeugen eine D-Nummer wählen, oder { $entry } in GUD6 auf 1 setzen.
check-knum-no-setup = Diese Maschine hat keine Einrichtekorrekturen.
check-knum-no-setup-hint = Stattdessen Länge oder Radius korrigieren oder Bit 4 in MD 18112 setzen.

check-knum-rotation = Das globale Basisframe { $code } kann keine Drehung aufnehmen.
check-knum-rotation-hint = Einstellbares Frame oder Kanal-Basisframe wählen.
check-lathe-length = Die Länge eines Messtasters vom Typ 5xy endet an der Kugelmitte, _CBIT[14]=1 bedeutet aber Bezug auf den Kugelumfang.
check-lathe-length-hint = _CBIT[14]=0 setzen und die Länge bis zur Kugelmitte eintragen.
check-mirror-datum = Eine Achse ist gespiegelt, und MD 10610 ist nicht 0: Messzyklen unterstützen Spiegeln nur mit MD 10610=0.
check-mirror-datum-hint = Ohne Spiegelung messen oder MD 10610=0 setzen.
check-multi-probe = Diese Messung erfordert einen Multitaster; ein Monotaster schaltet nur in einer Richtung.
check-multi-probe-hint = Multitaster verwenden: { "_PRNUM" } mit zwei Stellen.
check-angles-sum = Startwinkel und alle Fortschaltwinkel ergeben ohne Vorzeichen zusammen { $sum }°, mehr als 360°.
check-angles-sum-hint = Kleineren Fortschaltwinkel wählen oder einen Startwinkel näher bei 0, mit Vorzeichen.
check-angles-same = Bei diesem Fortschaltwinkel fallen Punkte zusammen: Es lässt sich kein Kreis berechnen.
check-angles-same-hint = Fortschaltwinkel bei drei Punkten bis 120°, bei vier Punkten bis 90° wählen, jedoch nicht 0.
check-angles-wide = Bei { $points } Punkten ist ein Fortschaltwinkel über { $useful }° nicht sinnvoll.
check-angles-wide-hint = Fortschaltwinkel von höchstens { $useful }° wählen.
check-ball-unknown = Der Kugeldurchmesser dieses Messtasters ist nicht bekannt: Jedes gemessene Maß wäre um diesen Betrag falsch.
check-ball-unknown-hint = Messtaster in einer Bohrung kalibrieren und dabei den Kugeldurchmesser ermitteln.
check-spread-circle = Die Punkte liegen zu dicht beieinander: Der Durchmesser ist { $diameter }-mal, der Mittelpunkt { $centre }-mal so unsicher wie ein Punkt.
check-spread-centre = Die Punkte liegen zu dicht beieinander: Der Mittelpunkt ist { $centre }-mal so unsicher wie ein einzelner Punkt.
check-spread-circle-hint = Punkte über einen größeren Teil des Kreises verteilen.
check-spread-corner = Die Ecke ist { $factor }-mal so unsicher wie ein Punkt: Punkte weit von der Ecke oder dicht beieinander, oder Kanten fast parallel.
check-spread-corner-hint = Punkte weiter auseinander und näher an die Ecke legen.
check-spread-angle = Die Punkte liegen zu dicht beieinander: In { $length } mm Abstand ist die Richtung { $factor }-mal so unsicher wie ein einzelner Punkt.
check-spread-angle-hint = Messpunkte mit mindestens { $needed } mm Abstand wählen.
check-spread-triangle = Die drei Punkte liegen fast auf einer Geraden: { $length } mm daneben ist das Frame { $factor }-mal so unsicher wie ein einzelner Punkt.
check-spread-triangle-hint = Einen der Punkte weiter von der Geraden durch die beiden anderen entfernen.
check-braking = Mit { $name } = { $feed }{ $unit } läuft die Achse nach dem Signal noch { $path } mm; der Messtaster verträgt { $deflection } mm.
check-braking-hint = { $name } auf höchstens { $largest }{ $unit } setzen.
