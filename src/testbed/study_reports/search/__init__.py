"""What is shown of a search. `words` has the sentences, `report` the whole page."""
