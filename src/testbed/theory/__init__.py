"""The paper's theory, with the functions that fly: `ideal` its ideal plant, `figure_3` its figure of the estimates."""
