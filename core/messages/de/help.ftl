# Hilfeseiten: was alle oder die meisten SINUMERIK-Zyklen gemeinsam haben, und die Überschriften.

help-section-measures = Was gemessen wird
help-section-does = Was der Zyklus macht
help-section-before = Startposition des Messtasters
help-section-before-tool = Startposition des Werkzeugs
help-section-before-call = Voraussetzungen
help-section-order = Ablauf
help-section-corrects = Was korrigiert wird
help-section-leaves = Ergebnisse
help-section-wrong = Mögliche Fehler
help-values = Eingaben: { $names }.
help-alarms = Mögliche Alarme: { $names }.

help-probe-loaded = Der Messtaster ist in der Spindel (Werkzeugtyp 710 oder 1x0), seine D-Nummer ist aktiv; G40 ist programmiert, kein Maßstabsfaktor ist aktiv.
help-probe-turning = Auf einer Drehmaschine mit dritter Linearachse: Werkzeugtyp 5xy, Länge bis zur Kugelmitte, SD 42950 gleich 2. Schneidenlage 5 oder 7 misst in G17, 6 oder 8 in G19. Positionen in X sind Radien, auch mit DIAMON.
help-wrong-tool = _TNUM oder die D-Nummer in _KNUM gehört nicht zum Werkzeug, das diese Fläche bearbeitet hat: Ein gutes Werkzeug wird falsch korrigiert.
help-wrong-chip = Ein Span oder Grat auf der Fläche verfälscht das Maß: Fläche reinigen und _TDIF so wählen, dass ein solcher Wert nicht korrigiert wird.
help-wrong-conditions = Der Messtaster ist mit anderem Vorschub oder anderer Spindelstellung kalibriert: Die Ergebnisse haben einen konstanten Fehler. In anderer Ebene: ebenso, mit _CBIT[16]=1 ein Alarm.
help-wrong-kept = Ein Parameter, den dieser Aufruf nicht schreibt, hat noch den Wert eines früheren Aufrufs: Grenzwert, Schutzzone oder Winkel.
help-order-block = Eine Antastung: bis _FA vor die Sollposition, von dort mit Messvorschub höchstens zweimal _FA weit, nach dem Schaltsignal zurück. Ist _NMSP größer als 1, wiederholt der Zyklus die Antastung; es gilt der Mittelwert.
help-ends-at-start = Endposition: wieder die Startposition.
help-wrong-reach = Die Fläche liegt mehr als _FA hinter ihrer Sollposition: Der Messtaster schaltet nicht, Alarm 61301.
help-wrong-in-the-way = Ein Hindernis liegt im Weg: Mit _CHBIT[2]=1 löst eine Berührung beim Positionieren Alarm 61302 aus.
help-corrects-tool = Ein Werkzeug (_TNUM, _TNAME oder _TENV): Verschleiß, mit _CHBIT[6]=1 Geometrie. _KNUM bestimmt Schneide, Länge oder Radius oder stattdessen eine Einrichte- oder Summenkorrektur. _KNUM=0: nichts.
help-corrects-chain = Differenz über _TSA: Alarm 61303, Programm hält an. Über _TDIF: Meldung 62306, keine Korrektur. Außerhalb von _TUL, _TLL oder _TMV: ganze Differenz. In _TMV: mit _K gewichteter Mittelwert, wenn größer als _TZL.
help-corrects-zero = Die NV aus _KNUM, um Istwert minus Sollwert; ihre Drehung bleibt. Ziel: Feinverschiebung, falls vorhanden; mit _CHBIT[21]=1 oder _KNUM=2000 Grobverschiebung. _KNUM=0: keine Korrektur.
help-corrects-zero-area = Differenz über _TSA: Alarm 61303, Programm hält an, keine Korrektur.
help-corrects-when = Die Korrektur gilt, sobald die G-Funktion (G54 …) wieder programmiert wird; nur mit _KNUM=9999 gilt sie sofort.
help-corrects-trigger = Die Messtasterdaten: Weicht ein Triggerpunkt um mehr als _TZL vom Wert in _WP ab, speichert der Zyklus ihn neu. Über _TSA: Alarm 61303, nichts wird gespeichert.
help-wrong-first = Erste Kalibrierung: Die gespeicherten Werte sind 0, daher muss _TSA größer als der Kugelradius sein.
help-wrong-later = Vorschub, Ebene, Spindelstellung oder, in Fräszyklen, _CBIT[14] ist bei späteren Messungen anders: Die gespeicherten Werte gelten dort nicht.
help-calibrated = Der Messtaster ist in dieser Ebene und in den Richtungen dieser Messung kalibriert, mit demselben Vorschub.
help-uncalibrated = Der Messtaster muss nicht kalibriert sein; er schaltet in allen Richtungen, die Spindel lässt sich positionieren, und die Messachse liegt in der Ebene.
help-turned-over = Den ersten Punkt tastet der Zyklus mit um 180° gedrehter Spindel an, dann in der ursprünglichen Spindelstellung. Es gilt der Mittelwert: Die Lageabweichung hebt sich auf.
help-turned-over-stored = Der Zyklus speichert in _WP auch die Lageabweichung und den Triggerpunkt dieser Richtung samt Lageabweichung. Sie gelten nur für diese Spindelstellung.
help-no-spindle = Die Spindel lässt sich nicht positionieren: Alarm 61372.

# Wo eine Maske auf der Steuerung ist.
where-title = Wo ist das an meiner Steuerung?
where-from = Diese Maske gibt es ab Messzyklen SW { $version }.
where-editor = Programmeditor: { $softkeys } (Messzyklen ab SW 6.2).
where-older = Programmeditor: { $softkeys } (Messzyklen bis SW 5.4). Die Unterstützung schreibt { $call }().
where-older-call = Programmeditor, Messzyklen bis SW 5.4: Die Unterstützung schreibt { $call }(). Die Softkeys dazu druckt das Handbuch nicht ab.
where-jog-newer = In JOG, Messzyklen ab SW 6.3: { $softkeys }.
where-jog-older = In JOG, Messzyklen bis SW 6.2: { $softkeys }.
where-jog-both = In JOG: { $softkeys }.
where-jog-needs = Fehlen die Softkeys: Nötig sind HMI Advanced (PCU 50) oder MMC 103, die Option „Betriebsartübergreifende Aktionen“ und in MA_JOG.COM ihre Zeilen ohne Semikolon.
where-jog-files = Dateien der Softkeys und Masken ab SW 6.3: COM_FILE.COM sowie MC_CST0.ARC oder MC_CST1.ARC.
where-jog-files-older = Dateien der Softkeys und Masken bis SW 6.2: MA_JOG.COM, JOG_MEAS.COM und BMP_FILE.ARC.
where-jog-settings = Die Maske hat kein Einstellbild. Was sie vorschlägt und wie sie fährt, steht in Anwenderdaten: _JM_I[] und _JM_B[] in GUD6, E_MESS_… in GUD7.
where-jog-settings-tool = Die Maske hat kein Einstellbild. Der Werkzeugmesstaster und das Anfahren stehen in E_MESS_MT_… (GUD7), das Ziel des Ergebnisses in _JM_B[0] (GUD6).
where-settings = Inbetriebnahme > Messzyklen > Automatisch messen legt fest, was die Masken anbieten (_MZ_MASK). Fehlen die Softkeys, siehe Schritte der Inbetriebnahme.
where-files = Dateien der Masken auf HMI Advanced: MCSUPP.COM, AEDITOR.COM, STARTUP.COM.
where-files-older = Dateien bis SW 5.4: MCSUPP_1.COM und MCSUPP_2.COM mit COV.COM (Softkeys), SC.COM (Masken) und den Hilfszyklen.
where-none-replaced = Ab SW 6.2 gibt es keine Maske. Die Maske zur Werkzeugmessung an Drehmaschinen verwenden oder den Aufruf schreiben.
where-none-log = Es gibt keine Maske. Den Aufruf ins Programm schreiben; das Protokoll selbst wird in seinen Anwenderdaten eingestellt.
where-none-helper = Es gibt keine Maske. Den Aufruf ins Programm schreiben.
where-none-block = Es gibt keine Maske. Den Satz ins Programm schreiben oder in MDI eingeben.
