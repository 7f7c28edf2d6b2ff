# CYCLE198 und CYCLE199.

user-program-intro = CYCLE198 läuft vor jeder Messung, CYCLE199 danach, von der Marke des Messzyklus bis zu ihrem M17. Dorthin gehören Zeilen, die den Messtaster ein- und ausschalten, die Spindel orientieren oder eine Abdeckung öffnen. Ein Programm dieser Seite, das sie enthält, zeigt bei jedem Aufruf, welche Zeilen davor und danach laufen.
user-program-cycles = Messzyklen
user-program-lines-before = Zeilen vor der Messung, zum Beispiel M27
user-program-lines-behind = Zeilen nach der Messung, zum Beispiel M28
user-program-case = Variable des CASE in der ausgelieferten Datei (leer: Zeilen zum Einfügen)
user-program-save = { $name } speichern
