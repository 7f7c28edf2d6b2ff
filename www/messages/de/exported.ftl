# Prüfung einer Maschine anhand dessen, was ihre Steuerung ausgegeben hat.

exported-intro = Einfügen oder hierher ziehen, was die Steuerung ausgibt: Maschinendaten (.TEA, INITIAL.INI), Definitionsdateien, den Text einer Serieninbetriebnahme. Oder Zeilen wie MD 18120 = 30 eingeben. Nichts verlässt diesen Browser.
exported-text = Ausgabe der Steuerung
exported-open = Dateien öffnen
exported-remove = { $name } entfernen
exported-has = Diese Maschine hat
exported-jog = Messen in JOG
exported-log = Protokollieren
exported-tool-probe = Werkzeugmesstaster
exported-large = NCU 3
exported-error = Fehler: { $count }
exported-warning = Warnungen: { $count }
exported-note = Hinweise: { $count }
exported-clean = In den verglichenen Daten fehlt nichts.
exported-channel = Kanal { $channel }
exported-alarm = Alarm { $number }: { $text }
exported-limit-error = Nötig: { $value }
exported-limit-warning = Empfohlen: { $value }
exported-limit-note = Üblich: { $value }
exported-default = Vorbesetzung: { $value }
exported-place = { $file }, Zeile { $line }
exported-missing = Nötig, aber nicht in dieser Ausgabe: { $count }
exported-more = Nicht gezeigt: { $count }
exported-save = Zu ändernde Zeilen speichern
exported-print = Drucken
exported-close = Schließen
exported-too-large = Die Dateien sind größer als { $most } MB: nur Maschinendaten und Definitionsdateien wählen.
exported-braking = Bremsweg
exported-deflection = Zulässige Auslenkung des Messtasters, mm
exported-delay = Zeit vom Signal bis zum Bremsen, s (MD 10050 × MD 10070)
exported-acceleration = Kleinste Verzögerung, m/s² (MD 32300)
exported-gain = Kleinste Kreisverstärkung Kv, (m/min)/mm (MD 32200)
exported-feed = Vorschub, mm/min
