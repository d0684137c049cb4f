"""Reports and figures of finished flights. Nothing here flies, or depends on how the flights were made.

`flight` is a flight that draws, reports, saves and exports itself. `panels` says what is drawn together: by `figures`, by the page
of a flight (`run_report`) and by `comparison`; `story` and `words` tell it, and `export` writes it for other programs. All pages
are made with `html`.
"""
