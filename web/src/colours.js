// Colours of the page by their names in the style sheet, which has a light and a dark set.
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

export const PHASES = ["healthy", "unnoticed", "unseen", "flagged", "held", "recovered", "lost"];

export function onSchemeChange(redraw) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
}
