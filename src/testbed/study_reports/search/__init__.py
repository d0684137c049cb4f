"""What is shown of a search. `words` has the sentences, `sections` the parts of the page in HTML, `figures` the pictures, `report`
the whole page."""
