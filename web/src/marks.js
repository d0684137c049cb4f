// Marks that differ by shape as well as colour. A path about (0, 0) of some half size.
const SHAPES = {
  circle: (r) => `M${-r} 0a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`,
  square: (r) => `M${-r} ${-r}H${r}V${r}H${-r}Z`,
  triangle: (r) => `M0 ${-1.2 * r}L${1.1 * r} ${0.9 * r}H${-1.1 * r}Z`,
  diamond: (r) => `M0 ${-1.3 * r}L${1.3 * r} 0 0 ${1.3 * r} ${-1.3 * r} 0Z`,
  cross: (r) => `M${-r} ${-r}L${r} ${r}M${r} ${-r}L${-r} ${r}`,
};
export const OF_VARIANTS = ["circle", "square", "triangle", "diamond"];
export const OF_STATES = ["circle", "triangle", "cross", "square", "diamond"]; // passed, missed, lost, no result, not judged

export function shape(name, r) {
  return SHAPES[name](r);
}

export function inText(name, kind) {
  return `<svg class="mark ${kind}" width="14" height="14" viewBox="-7 -7 14 14" aria-hidden="true"><path d="${shape(name, 4.6)}"/></svg>`;
}
