# Aufrufe mit Argumenten in Klammern: was an einem Argument falsch ist und was die Argumentliste neuerer Steuerungen bedeutet.

list-text-wanted = { $param } erwartet einen Text, aber { $value } ist eine Zahl.
list-text-wanted-hint = Wert in Anführungszeichen schreiben.
list-number-wanted = { $param } erwartet eine Zahl, aber „{ $value }“ ist ein Text.
list-number-wanted-hint = Wert ohne Anführungszeichen schreiben.
list-text-unquoted = { $param }: { $value } steht ohne Anführungszeichen, und das Programm definiert keine solche Variable.
list-text-unquoted-hint = Wert in Anführungszeichen schreiben, wenn er selbst der Name ist.
list-arguments-many = Zu viele Argumente für { $name }: zulässig { $most }, im Aufruf { $count }.
list-arguments-many-hint = Kommas zählen und überzählige Argumente löschen.
list-selection = Argument { $place } in { $name } darf nicht { $value } sein.
list-selection-hint = Einen dieser Werte wählen: { $choices }.

newer-open = { $param } = { $value }: Bedeutung in der Argumentliste neuerer Steuerungen unbekannt. Der Wert bleibt unverändert, wird aber weder geprüft noch simuliert.
newer-target = { $value } steht in Argument 2, bei neueren Steuerungen die NV-Nummer; diese Messvariante korrigiert aber keine NV.
newer-target-hint = NV: 3. Stelle von Argument 1 auf 1 setzen. Werkzeug: Argument 3 (S_KNUM1) verwenden. Sonst Argument 2 leer lassen.
write-newer-tool = Neuere Steuerungen erwarten die Werkzeugkorrektur in Argument 3 (S_KNUM1, siehe Alarm 61328); Code unbekannt.
write-newer-zero = Welcher NV { $value } in der Argumentliste neuerer Steuerungen entspricht, ist unbekannt; bekannt sind nur 1 bis 99 und 9999.
write-newer = { $param } = { $value } bedeutet in der Argumentliste neuerer Steuerungen etwas anderes, oder die Bedeutung ist unbekannt.
convert-newer = { $param } = { $value }: Die ältere Argumentliste hat keine Entsprechung für diesen Wert der neueren, oder die Bedeutung ist unbekannt.
convert-newer-hint = Aufruf neu als Zuweisungen schreiben.
