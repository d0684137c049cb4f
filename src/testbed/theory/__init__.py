"""The paper's ideal plant and its figure 3, flown by the same compiled law."""
