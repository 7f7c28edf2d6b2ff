# The handbook: the words around its pages, read by `cargo xtask book`.

book-title = Probewright handbook
book-spoken = English
book-about = Guides, concepts, measuring in JOG, commissioning, alarms, machine data, and a page for each measuring cycle and macro.
book-basics = Basics
book-reference = Reference
book-cycles = SINUMERIK cycles
book-macros = NCT macros
book-skip = Skip to the text
book-contents = Contents
book-search = Search the handbook
book-results = Search results
book-found = Results:
book-none = Nothing found.
book-absent = The search index could not be loaded.
book-turn = Previous and next page
book-previous = Previous page
book-next = Next page
