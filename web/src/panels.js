// Panels on one cursor and one range of time. Truth is a solid line, belief dashed, a command dotted; each has a colour of its own.
import { uPlot } from "uplot";
import { colour } from "./colours.js";
import { fixed, rowAt } from "./data.js";

const HEIGHT = 150;
const STROKES = { truth: [], belief: [7, 4], command: [2, 3], second: [10, 3, 2, 3], third: [4, 2], v0: [], v1: [7, 4], v2: [2, 3], v3: [10, 3, 2, 3], v4: [12, 3], v5: [4, 2] };

function number(value) {
  if (value == null || Number.isNaN(value)) return "-";
  const size = Math.abs(value);
  return fixed(value, size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

function bands(plot, panel) {
  const { ctx } = plot;
  const { left, top, width, height } = plot.bbox;
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, width, height);
  ctx.clip();
  for (const { from_s, until_s, low, high, passed } of panel.bands ?? []) {
    const x0 = plot.valToPos(from_s, "x", true);
    const x1 = plot.valToPos(until_s, "x", true);
    const y0 = plot.valToPos(high, "y", true);
    const y1 = plot.valToPos(low, "y", true);
    ctx.fillStyle = colour(passed ? "band" : "band-missed");
    ctx.fillRect(x0, y0, x1 - x0, y1 - y0);
    ctx.strokeStyle = colour(passed ? "band-edge" : "missed");
    ctx.setLineDash(passed ? [] : [6, 4]);
    ctx.lineWidth = devicePixelRatio;
    ctx.strokeRect(x0, y0, x1 - x0, y1 - y0);
    ctx.setLineDash([]);
  }
  for (const { from_s, until_s } of panel.missed ?? []) {
    const x0 = plot.valToPos(from_s, "x", true);
    ctx.fillStyle = colour("band-missed");
    ctx.fillRect(x0, top, Math.max(plot.valToPos(until_s, "x", true) - x0, devicePixelRatio), height);
  }
  for (const level of panel.limits ?? []) {
    const y = plot.valToPos(level, "y", true);
    ctx.strokeStyle = colour("limit");
    ctx.setLineDash([2, 4]);
    ctx.beginPath();
    ctx.moveTo(left, y);
    ctx.lineTo(left + width, y);
    ctx.stroke();
    ctx.setLineDash([]);
  }
  for (const { time_s, style } of panel.failures ?? []) {
    const x = plot.valToPos(time_s, "x", true);
    ctx.strokeStyle = colour(style);
    ctx.lineWidth = 1.5 * devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, top);
    ctx.lineTo(x, top + height);
    ctx.stroke();
  }
  ctx.restore();
}

// The present time as a line over the plot: moving it costs no drawing.
function place(hand, plot, clock) {
  const x = plot.valToPos(clock.now, "x");
  hand.hidden = x < 0 || x > plot.over.clientWidth;
  hand.style.transform = `translateX(${x}px)`;
  if (plot.cursor.left == null || plot.cursor.left < 0) plot.setLegend({ idx: rowAt(plot.data[0], clock.now) }); // no pointer there
}

function options(panel, width, clock) {
  const axis = { stroke: colour("muted"), grid: { stroke: colour("grid"), width: 1 }, ticks: { show: false }, font: "11px system-ui" };
  return {
    width,
    height: HEIGHT,
    padding: [8, 8, 0, 0],
    cursor: { sync: { key: "time" }, drag: { x: true, y: false }, points: { size: 5 } },
    legend: { live: true },
    scales: {
      x: { time: false, range: () => clock.range },
      y: { range: (u, low, high) => span(panel, low, high) },
    },
    axes: [{ ...axis, size: 24 }, { ...axis, size: 46 }],
    series: [
      { label: "t [s]", value: (u, v) => number(v) },
      ...panel.series.map(({ label, style }) => ({
        label,
        stroke: colour(style),
        width: style === "truth" ? 1.6 : 1.4,
        dash: STROKES[style],
        points: { show: false },
        value: (u, v) => number(v),
      })),
    ],
    hooks: {
      drawClear: [(plot) => bands(plot, panel)],
      setSelect: [
        (plot) => {
          if (plot.select.width < 5) return;
          clock.show(plot.posToVal(plot.select.left, "x"), plot.posToVal(plot.select.left + plot.select.width, "x"));
          plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
        },
      ],
      ready: [
        (plot) => {
          plot.over.addEventListener("click", (e) => clock.go(plot.posToVal(e.offsetX, "x")));
          plot.over.addEventListener("dblclick", () => clock.show(clock.start, clock.end));
        },
      ],
    },
  };
}

// Range of the axis: the signals, and the limits where the signals come near them; never so narrow that rounding shows.
function span(panel, low, high) {
  if (low == null || high == null) return [0, 1];
  if (panel.range) return [Math.min(low, panel.range[0]), Math.max(high, panel.range[1])];
  const least = panel.least ?? 0.1;
  for (const level of panel.limits ?? []) {
    const reach = 0.35 * Math.max(high - low, least);
    if (level > high && level - high < reach) high = level;
    if (level < low && low - level < reach) low = level;
  }
  const more = Math.max(0.06 * (high - low), 0.5 * (least - (high - low)));
  return [low - more, high + more];
}

// What a controller never says is null throughout: of NaN throughout, uPlot makes an axis on which nothing is drawn.
const said = (values) => (values.some(Number.isFinite) ? values : Array(values.length).fill(null));

export class Panels {
  constructor(columns, clock) {
    this.columns = columns;
    this.clock = clock;
    this.made = [];
    clock.listen((what) => this.follow(what));
    new ResizeObserver(() => this.resize()).observe(document.body);
  }

  add(root, panel) {
    const box = document.createElement("figure");
    box.className = "panel";
    box.append(Object.assign(document.createElement("figcaption"), { textContent: panel.title }));
    root.append(box);
    const entry = { box, panel, plot: null };
    this.made.push(entry);
    // Drawn when first seen, so that opening the report does not wait for what is far below or folded away.
    entry.seen = new IntersectionObserver(([seen]) => {
      if (seen.isIntersecting) this.draw(entry);
    }, { rootMargin: "200px" });
    entry.seen.observe(box);
    // Those that no one has scrolled to are drawn once there is time, for print.
    (window.requestIdleCallback ?? setTimeout)(() => {
      if (!entry.plot && box.offsetParent) this.draw(entry);
    });
    return entry;
  }

  draw(entry) {
    entry.seen.disconnect();
    const { box, panel } = entry;
    entry.plot?.destroy();
    entry.plot = new uPlot(options(panel, Math.max(box.clientWidth, 120), this.clock), this.data(panel), box);
    const canvas = box.querySelector("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", panel.title);
    entry.hand = document.createElement("i");
    entry.hand.className = "hand";
    entry.plot.over.append(entry.hand);
    queueMicrotask(() => place(entry.hand, entry.plot, this.clock)); // after uPlot's own first drawing, which empties the legend
  }

  data(panel) {
    return [this.columns.time_s, ...panel.series.map(({ column }) => said(this.columns[column]))];
  }

  // Other rows, as of a flight that goes on.
  renew(columns) {
    this.columns = columns;
    for (const { plot, panel, hand } of this.made.filter((entry) => entry.plot)) {
      plot.setData(this.data(panel));
      place(hand, plot, this.clock);
    }
  }

  redraw() {
    for (const entry of this.made) if (entry.plot) this.draw(entry);
  }

  resize() {
    for (const { plot, box, hand } of this.made) {
      if (plot && plot.width !== box.clientWidth && box.clientWidth > 0) {
        plot.setSize({ width: box.clientWidth, height: HEIGHT });
        place(hand, plot, this.clock);
      }
    }
  }

  follow(what) {
    for (const { plot, box, hand } of this.made) {
      if (!plot || !box.offsetParent) continue;
      if (what === "range") plot.setScale("x", { min: this.clock.range[0], max: this.clock.range[1] });
      place(hand, plot, this.clock);
    }
  }
}
