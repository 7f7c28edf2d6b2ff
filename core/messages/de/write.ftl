# Schreibweisen eines Aufrufs und was sie nicht ausdrücken können.

write-no-list = { $cycle } lässt sich in dieser Schreibweise nicht aufrufen.
write-no-list-variant = { $cycle }: Diese Messvariante oder dieses Korrekturziel lässt sich in dieser Schreibweise nicht aufrufen.
write-unpublished = Die Argumentliste von { $cycle } wird nicht geschrieben: Die Ziffern von Argument 1 sind nicht veröffentlicht.
write-unpublished-variant = Die Variante { $value } von { $cycle } wird nicht als Argumentliste geschrieben: Ihre Ziffern sind nicht veröffentlicht.
write-unpublished-alone = { $cycle } wird nicht geschrieben: Ältere Steuerungen haben ihn nicht, die Stellen seiner Argumente sind nicht veröffentlicht.
write-variant-open = Die Argumente bestimmen die Messvariante, { $value } ist aber erst beim Programmlauf bekannt.
write-no-list-hint = Stattdessen Zuweisungen und Aufruf schreiben.
write-zero = { $name }={ $value } wird als eigene Zuweisung geschrieben: Eine 0 in CYCLE_PARA lässt den vorherigen Wert bestehen.
write-beside = { $name }={ $value } wird als eigene Zuweisung geschrieben: Der Aufruf hat kein Argument dafür.
write-lost = { $name } entfällt: Die Argumentliste neuerer Steuerungen hat kein Argument dafür.
write-lost-hint = Aufruf als Zuweisungen schreiben, falls der Wert nötig ist, oder den Wert an der Steuerung einstellen.
write-expression = { $name }={ $value } wird als eigene Zuweisung geschrieben: Wäre { $value } gleich 0, ließe CYCLE_PARA den vorherigen Wert bestehen.
write-expression-lost = { $name }={ $value } ginge verloren: Die Argumentliste neuerer Steuerungen hat kein Argument dafür.
write-plane = _DMODE = 1 wird auch in Ebene { $plane } geschrieben: Welche Zahl welche Ebene bedeutet, ist nicht veröffentlicht.
write-plane-hint = Vor dem ersten Lauf die Ebene an der Steuerung prüfen.

convert-same = Der Aufruf hat bereits diese Schreibweise.
convert-lost = Beim Umwandeln entfallen: { $names }. Die ältere Steuerung hat keinen Parameter dafür.
convert-lost-hint = Prüfen, ob der Aufruf ohne diese Werte auskommt.
convert-others = { $cycle } in Zeile { $line } verwendet Werte dieses Aufrufs und erhielte andere Werte.
convert-others-hint = Auch den anderen Aufruf umwandeln oder dessen Werte davor schreiben.
convert-argument = Das Argument { $value } dieses Aufrufs ginge verloren: Andere Schreibweisen haben keinen Platz dafür.
convert-argument-hint = Im Aufruf die Zahl statt { $value } schreiben, dann den Aufruf umwandeln.
convert-expression = Der Aufruf bleibt unverändert: { $value } für { $name } kann an der Stelle des neuen Textes einen anderen Wert ergeben.
convert-expression-hint = { $name }={ $value } direkt vor den Aufruf schreiben; dazwischen darf nichts den Wert ändern.
convert-skipped = Der Aufruf bleibt unverändert: { $name } wird nur auf manchen Wegen zum Aufruf zugewiesen; im neuen Aufruf gälte der Wert immer.
convert-skipped-hint = { $name } auf jedem Weg zuweisen, oder direkt vor dem Aufruf.
convert-skip-block = Der Aufruf bleibt unverändert: { $name } wird in einem ausblendbaren Satz (/) zugewiesen; im neuen Aufruf gälte der Wert immer.
convert-skip-block-hint = { $name } ohne „/“ zuweisen, oder den Aufruf in derselben Ausblendebene schreiben.
convert-stays = Bleibt stehen, wird aber von der Argumentliste nicht gelesen: { $names }. Neuere Steuerungen haben dafür Settingdaten, soweit bekannt.
convert-read = Bleibt stehen, weil andere Anweisungen den Wert lesen (Zeile): { $names }.
convert-variable = Der Aufruf liest diese Variablen selbst, weil mehrere Zuweisungen zu ihm führen: { $names }.
convert-read-hint = Eine neuere Steuerung hat diese Variablen vielleicht nicht: Anweisungen prüfen, die sie lesen.
convert-overwrites = Der Aufruf bleibt unverändert: Zeile { $line } liest { $name }, der neue Aufruf würde einen anderen Wert zuweisen.
convert-overwrites-hint = Dort eine Variable mit anderem Namen als { $name } verwenden, dann den Aufruf umwandeln.
convert-called = Der Aufruf bleibt unverändert: { $program }, zwischen der Zuweisung von { $name } und dem Aufruf gerufen, kann den Wert lesen oder ändern.
convert-called-hint = { $name } direkt vor dem Aufruf zuweisen.
convert-unused = { $cycle } verwendet diese Werte in dieser Variante nicht, daher entfallen sie: { $names }.
convert-no-variant = Der Aufruf bleibt: Dieses Programm weist { $name } nichts zu; was gemessen wird, weiß nur das rufende Programm.
convert-no-variant-hint = { $name } vor dem Aufruf zuweisen oder das rufende Programm mit öffnen.
convert-added = Die Liste braucht Werte, die dieses Programm nicht zuweist; jetzt geschrieben: { $names }. Bisher galt, was in den Daten der Steuerung stand.
convert-added-hint = Diese Werte prüfen, oder sie vor dem Aufruf zuweisen und ihn erneut umwandeln.
convert-macro = Der Aufruf bleibt unverändert: Ein Makro liefert mehrere Werte des Aufrufs.
convert-macro-hint = Zuerst im Programm das Makro durch seinen Text ersetzen.

revise-taken = Von der neuen Messvariante nicht verwendet und aus dem Aufruf entfernt: { $names }.
revise-shared = Von der neuen Messvariante nicht verwendet, für einen späteren Aufruf im Programm belassen: { $names }.
variable-before = { $name } lässt sich nicht ändern: Keine Programmzeile vor dem Aufruf weist einen Wert zu.
variable-several = { $name } lässt sich nicht ändern: Je nach Programmablauf wird der Wert in verschiedenen Zeilen geschrieben: { $lines }.
variable-unclear = { $name } lässt sich nicht ändern: Ein Aufruf, eine Schleife oder ein Index bestimmt den Wert.
variable-calculated = { $name } lässt sich nicht ändern: Der Wert wird in Zeile { $lines } berechnet.
variable-number = { $name } lässt sich ändern, sobald eine Zahl eingegeben ist.
variable-unsolved = { $name } lässt sich nicht ändern: Aus dem Ausdruck folgt für diese Zahl kein Wert.
variable-same = { $name } hat diesen Wert schon.

revise-around = Die Zeilen { $lines } um den Aufruf ändern sich mit.
revise-around-left = Die Zeilen um den Aufruf gehören nicht mehr zu ihm (Zeile { $lines }).
revise-around-left-hint = Diese Zeilen „um den Aufruf“ in der Maske entfernen oder von Hand ändern.
around-stray = Diese Zeilen um { $name } gehören zu einem Aufruf mit anderer Nullpunktverschiebung oder in einer anderen Ebene.
around-stray-hint = Die Änderung unten anwenden oder die Zeilen entfernen, wenn sie nicht zu diesem Aufruf gehören.
around-stray-cure = Zeilen für diesen Aufruf
