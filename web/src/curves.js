// The share that passes along each input, and the errors in time.
import { inText, OF_VARIANTS, shape } from "./marks.js";
import { element, path, Plot, scaleFor } from "./plot.js";

const DASHES = ["", "7 4", "2 3", "10 3 2 3"];

function legend(root, sweep) {
  if (sweep.variants.length < 2) return;
  const text = sweep.variants.map((name, v) => `<span>${inText(OF_VARIANTS[v % 4], `v${v % 6}`)} ${escaped(name)}</span>`).join("");
  root.insertAdjacentHTML("beforeend", `<p class="legend">${text}</p>`);
}

function escaped(text) {
  const box = document.createElement("i");
  box.textContent = text;
  return box.innerHTML;
}

function figure(root, title) {
  const box = document.createElement("figure");
  box.append(Object.assign(document.createElement("figcaption"), { textContent: title }));
  root.append(box);
  return box;
}

export function shares(root, sweep) {
  legend(root, sweep);
  const box = document.createElement("div");
  box.className = "curves";
  root.append(box);
  for (const { path: input, variants } of sweep.shares) {
    const axis = sweep.inputs.find((one) => one.path === input);
    const spec = { x: scaleFor(axis), y: { kind: "linear", low: 0, high: 1 }, xTitle: "", yTitle: "passed", height: 200, label: `share that passes along ${input}` };
    new Plot(figure(box, input), spec, (plot) => variants.forEach((points, v) => share(plot, axis, points, v, variants.length)));
  }
}

function share(plot, axis, points, v, count) {
  const aside = axis.names ? 0.14 * (v - (count - 1) / 2) : 0;
  const at = points.map(([x]) => plot.x.at(axis.names ? axis.names.indexOf(x) + aside : x));
  const line = (k) => points.map((point, i) => [at[i], plot.y.at(point[k])]);
  if (axis.names) {
    points.forEach(([, , low, high], i) => element("line", { x1: at[i], x2: at[i], y1: plot.y.at(low), y2: plot.y.at(high), class: `line v${v % 6}` }, plot.inside));
  } else {
    const area = [...line(2), ...line(3).reverse()];
    element("path", { d: `${path(area)}Z`, class: `area v${v % 6}` }, plot.inside);
    element("path", { d: path(line(1)), class: `line v${v % 6}`, "stroke-dasharray": DASHES[v % 4] }, plot.inside);
  }
  points.forEach(([x, estimate, low, high, n], i) => {
    const mark = element("path", { d: shape(OF_VARIANTS[v % 4], 4), transform: `translate(${at[i]} ${plot.y.at(estimate)})`, class: `dot v${v % 6}` }, plot.over);
    element("title", {}, mark, `${x}: ${(100 * estimate).toFixed(0)} % of ${n} flights (${(100 * low).toFixed(0)} to ${(100 * high).toFixed(0)} %)`);
  });
}

// One plot for each error and variant; those of an error share their axes.
export function errors(root, sweep) {
  if (!sweep.errors.length) {
    root.innerHTML = `<p class="note">There are no histories of errors.</p>`;
    return;
  }
  root.innerHTML = `<p class="legend"><span><i class="band-key"></i>5 to 95 % of the flights still flying</span><span><i class="line-key"></i>median</span>
    <span><i class="line-key largest"></i>flight with the largest error</span><span><i class="line-key limit"></i>limit of a requirement</span></p>`;
  for (const error of sweep.errors) {
    const box = document.createElement("div");
    box.className = "curves";
    root.insertAdjacentHTML("beforeend", "<h3></h3>");
    root.lastChild.textContent = error.title;
    root.append(box);
    const y = range(error);
    error.variants.forEach((band, v) => {
      if (!band) return;
      const spec = { x: { kind: "linear", low: 0, high: error.times.at(-1) }, y, xTitle: "time [s]", yTitle: "", height: 210, label: `${error.title} in time, ${sweep.variants[v]}` };
      new Plot(figure(box, `${sweep.variants[v] || "all flights"}; largest: run ${band.run}`), spec, (plot) => drawBand(plot, error, band, v));
    });
  }
}

// Linear up to some size, logarithmic beyond it, so that a loss and a good flight are seen in one picture.
function range(error) {
  let most = error.linear;
  for (const band of error.variants) {
    for (const key of ["low", "high", "largest"]) for (const e of band?.[key] ?? []) most = Math.max(most, Math.abs(e ?? 0));
  }
  for (const { size } of error.limits) most = Math.max(most, size);
  return { kind: "asinh", linear: error.linear, low: -1.3 * most, high: 1.3 * most };
}

function drawBand(plot, error, band, v) {
  const at = error.times.map((t) => plot.x.at(t));
  const line = (values) => values.map((value, i) => [at[i], value == null ? null : plot.y.at(value)]);
  const known = band.low.map((value) => value != null);
  const only = (points) => points.filter((_, i) => known[i]);
  element("path", { d: `${path([...only(line(band.low)), ...only(line(band.high)).reverse()])}Z`, class: `area v${v % 6}` }, plot.inside);
  for (const { from_s, until_s, size } of error.limits) {
    for (const sign of [-1, 1]) {
      const level = plot.y.at(sign * size);
      element("line", { x1: plot.x.at(from_s), x2: plot.x.at(until_s), y1: level, y2: level, class: "limit" }, plot.inside);
    }
  }
  element("path", { d: path(line(band.largest)), class: "largest" }, plot.inside);
  element("path", { d: path(line(band.median)), class: `line v${v % 6}` }, plot.inside);
}
