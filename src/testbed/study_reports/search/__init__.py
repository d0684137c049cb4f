"""What is shown of a search. `words` has the sentences, `figures` the pictures, `report` the whole page."""
