"""The paper's theory, computed with the functions that fly: `ideal` is its ideal plant, `figure_3` draws its figure 3."""
