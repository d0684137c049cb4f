"""The interactive page of one flight: what its script is given, and the parts of the page around it.

`columns` packs the log, `drawn` divides the flight into phases, `panels` says what is drawn together, `sections` are the parts in
HTML, and `run_report` puts them together. The script is `reporting/assets/flight.js`, built from `web/` in the repository.
"""
