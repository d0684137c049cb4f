"""The paper's theory, computed with the functions that fly: `ideal` is its ideal plant, `figure_3` draws its figure 3; its
section 4 (noise, model error) and what its section 5.2 leaves open (bandwidth, decoupling) are modules too."""
