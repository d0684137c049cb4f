"""The paper's theory as formulas, and its ideal plant with the functions that fly, for the scripts and tests that compare them."""
