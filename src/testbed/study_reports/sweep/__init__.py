"""The interactive page of a sweep: its answer in sentences, what its script is given, and the parts of the page around it.

`answer` has the sentences, `curves` what the script draws, `report` the page. The script is `reporting/assets/sweep.js`, built
from `web/` in the repository.
"""
