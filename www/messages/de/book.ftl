# Das Handbuch: die Worte um seine Seiten, gelesen von `cargo xtask book`.

book-title = Probewright-Handbuch
book-spoken = Deutsch
book-about = Anleitungen, Konzepte und Begriffe, Messen im JOG, Inbetriebnahme, Alarme, Maschinendaten und eine Seite zu jedem Messzyklus und Makro.
book-basics = Grundlagen
book-reference = Nachschlagen
book-cycles = SINUMERIK-Zyklen
book-macros = NCT-Makros
book-skip = Zum Text springen
book-contents = Inhalt
book-search = Handbuch durchsuchen
book-results = Suchergebnisse
book-found = Treffer:
book-none = Nichts gefunden.
book-absent = Der Suchindex konnte nicht geladen werden.
book-turn = Vorherige und nächste Seite
book-previous = Vorherige Seite
book-next = Nächste Seite
