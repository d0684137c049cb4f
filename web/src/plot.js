// A small plot in SVG: two axes on which the caller draws. It follows the width of its box.
const NS = "http://www.w3.org/2000/svg";
const MARGIN = { left: 50, right: 12, top: 10, bottom: 36 };

export function element(name, attributes = {}, parent = null, text = "") {
  const made = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text) made.textContent = text;
  parent?.append(made);
  return made;
}

export function short(value) {
  if (value == null || Number.isNaN(value)) return "-";
  const size = Math.abs(value);
  if (size >= 1e4 || (size > 0 && size < 1e-3)) return value.toExponential(1);
  return String(Number(value.toPrecision(3)));
}

function steps(low, high, most) {
  const raw = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((m) => m * power >= raw);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
}

function decades(from, to) {
  const found = [];
  for (let p = Math.ceil(Math.log10(from) - 1e-9); 10 ** p <= to * (1 + 1e-9); p++) found.push(10 ** p);
  return found;
}

// What a scale does to numbers: {kind: linear | log | asinh | choice, low, high, linear?, names?}.
const CURVES = {
  linear: { to: (v) => v, from: (v) => v, ticks: (s, most) => steps(s.low, s.high, most) },
  log: { to: Math.log10, from: (v) => 10 ** v, ticks: (s) => decades(s.low, s.high) },
  asinh: {
    to: (v, s) => Math.asinh(v / s.linear),
    from: (v, s) => Math.sinh(v) * s.linear,
    ticks: (s) => {
      const sizes = decades(s.linear, Math.max(-s.low, s.high, s.linear));
      return [...sizes.map((v) => -v), 0, ...sizes].filter((v) => v >= s.low && v <= s.high);
    },
  },
  choice: { to: (v) => v, from: (v) => v, ticks: (s) => s.names.map((_, i) => i) },
};

export function scale(spec, begin, end) {
  const curve = CURVES[spec.kind];
  const [a, b] = [curve.to(spec.low, spec), curve.to(spec.high, spec)];
  const at = (v) => begin + ((curve.to(v, spec) - a) / (b - a || 1)) * (end - begin);
  return {
    at,
    invert: (p) => curve.from(a + ((p - begin) / (end - begin)) * (b - a), spec),
    ticks: (most) => curve.ticks(spec, most).map((v) => ({ at: at(v), text: spec.names ? spec.names[v] : short(v) })),
  };
}

// The scale that some numbers ask for: names, a logarithm where most of them are far below the largest, else linear.
export function scaleFor({ values, names }) {
  if (names) return { kind: "choice", names, low: -0.5, high: names.length - 0.5 };
  let [low, high] = [Infinity, -Infinity];
  for (const v of values) {
    if (v == null) continue;
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  if (!(low <= high)) return { kind: "linear", low: 0, high: 1 };
  const sorted = values.filter((v) => v != null).sort((a, b) => a - b);
  if (low > 0 && sorted[sorted.length >> 1] < 0.1 * high) return { kind: "log", low: low / 1.3, high: high * 1.3 };
  const more = 0.04 * (high - low || 1);
  return { kind: "linear", low: low - more, high: high + more };
}

export class Plot {
  // `draw(plot)` is called whenever the plot has a new size; plot.inside is the group to draw into, plot.x and plot.y the scales.
  constructor(root, { x, y, xTitle, yTitle, height = 240, label = "" }, draw) {
    Object.assign(this, { root, spec: { x, y, xTitle, yTitle, height, label }, drawInside: draw, width: 0 });
    this.svg = element("svg", { class: "plot", role: "img", "aria-label": label, height }, root);
    this.observer = new ResizeObserver(() => this.draw());
    this.observer.observe(root);
  }

  draw(again = false) {
    const width = Math.floor(this.root.clientWidth);
    if (width < 40 || (width === this.width && !again)) return;
    const { x, y, xTitle, yTitle, height } = this.spec;
    this.width = width;
    this.svg.replaceChildren();
    this.svg.setAttribute("width", width);
    const [left, right, top, bottom] = [MARGIN.left, width - MARGIN.right, MARGIN.top, height - MARGIN.bottom];
    this.box = { left, right, top, bottom };
    this.x = scale(x, left, right);
    this.y = scale(y, bottom, top);
    const axes = element("g", { class: "axes" }, this.svg);
    const room = Math.floor((right - left) / (x.names?.length ?? 1) / 6.2);
    for (const { at, text } of this.x.ticks(Math.max(2, (right - left) / 70))) {
      element("line", { x1: at, x2: at, y1: top, y2: bottom }, axes);
      const shown = text.length > room && x.names ? `${text.slice(0, Math.max(room - 1, 1))}…` : text;
      const label = element("text", { x: at, y: bottom + 14, "text-anchor": "middle" }, axes, shown);
      if (shown !== text) element("title", {}, label, text);
    }
    for (const { at, text } of this.y.ticks(5)) {
      element("line", { x1: left, x2: right, y1: at, y2: at }, axes);
      const shown = text.length > 8 ? `${text.slice(0, 7)}…` : text;
      const label = element("text", { x: left - 5, y: at + 4, "text-anchor": "end" }, axes, shown);
      if (shown !== text) element("title", {}, label, text);
    }
    element("rect", { x: left, y: top, width: right - left, height: bottom - top, class: "frame" }, axes);
    element("text", { x: (left + right) / 2, y: height - 4, "text-anchor": "middle", class: "title" }, axes, xTitle);
    if (yTitle) element("text", { x: 11, y: (top + bottom) / 2, "text-anchor": "middle", class: "title", transform: `rotate(-90 11 ${(top + bottom) / 2})` }, axes, yTitle);
    const clip = `clip-${(Plot.count = (Plot.count ?? 0) + 1)}`;
    element("rect", { x: left, y: top, width: right - left, height: bottom - top }, element("clipPath", { id: clip }, this.svg));
    this.inside = element("g", { "clip-path": `url(#${clip})` }, this.svg);
    this.over = element("g", {}, this.svg);
    this.drawInside(this);
  }

  remove() {
    this.observer.disconnect();
    this.svg.remove();
  }
}

// A path through points [x, y] in pixels; where y is not a number the line has a gap.
export function path(points) {
  let [text, pen] = ["", false];
  for (const [x, y] of points) {
    const there = x != null && y != null && Number.isFinite(y);
    if (there) text += `${pen ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
    pen = there;
  }
  return text;
}
