// The map: every flight by two of the drawn inputs; how it ended by its shape. A drag chooses flights, a click picks one.
import { inText, OF_STATES, shape } from "./marks.js";
import { element, Plot, scaleFor, short } from "./plot.js";

const HEIGHT = 300;
const REACH = 12; // of a click [pixels]

// Names are spread about their line, always in the same way, so that flights do not hide one another.
function spread(axis, i) {
  const value = axis.values[i];
  return axis.names && value != null ? value + (((i * 0.618034) % 1) - 0.5) * 0.55 : value;
}

function select(label, options, chosen, act) {
  const box = document.createElement("label");
  box.textContent = `${label} `;
  const made = document.createElement("select");
  options.forEach(({ path }, i) => made.append(new Option(path, i, false, i === chosen)));
  made.addEventListener("change", () => act(Number(made.value)));
  box.append(made);
  return box;
}

export function map(root, sweep, chosen) {
  const axes = [...sweep.inputs, ...sweep.results];
  if (axes.length < 2) {
    root.innerHTML = `<p class="note">A map needs two values that vary.</p>`;
    return;
  }
  let [x, y] = [axes[0], axes[1]];
  let plots = [];
  const controls = document.createElement("p");
  controls.className = "buttons";
  const box = document.createElement("div");
  box.className = "maps";
  const clear = document.createElement("button");
  clear.type = "button";
  clear.textContent = "Choose all";
  clear.hidden = true;
  clear.addEventListener("click", () => chosen.set({ brush: null }));
  controls.append(
    select("across", axes, 0, (i) => show(axes[i], y)),
    select("up", axes, 1, (i) => show(x, axes[i])),
    clear,
  );
  const legend = document.createElement("p");
  legend.className = "legend";
  const told = document.createElement("p");
  told.className = "told";
  told.setAttribute("role", "status");
  root.append(controls, legend, box, told);

  function show(across, up) {
    [x, y] = [across, up];
    chosen.set({ brush: null });
    for (const plot of plots) plot.remove();
    box.replaceChildren();
    plots = sweep.variants.map((name, v) => draw(name, v));
    for (const plot of plots) plot.draw(); // now, and not when the browser has found their size
  }

  function draw(name, v) {
    const figure = document.createElement("figure");
    figure.innerHTML = "<figcaption></figcaption>";
    figure.firstChild.textContent = name;
    box.append(figure);
    const spec = { x: scaleFor(x), y: scaleFor(y), xTitle: x.path, yTitle: y.path, height: HEIGHT, label: `map of the flights ${name}` };
    return new Plot(figure, spec, (plot) => {
      plot.points = [];
      sweep.flights.forEach((flight, i) => {
        if (flight.variant !== v) return;
        const [a, b] = [spread(x, i), spread(y, i)];
        if (a == null || b == null) return;
        const [px, py] = [plot.x.at(a), plot.y.at(b)];
        const mark = element("path", { d: shape(OF_STATES[flight.state], 4.2), transform: `translate(${px.toFixed(1)} ${py.toFixed(1)})`, class: `flight s${flight.state}`, "data-flight": i }, plot.inside);
        plot.points.push({ i, px, py, mark });
      });
      plot.band = element("rect", { class: "brush", visibility: "hidden" }, plot.over);
      listen(plot);
      light();
    });
  }

  function nearest(plot, px, py) {
    let [best, least] = [null, REACH ** 2];
    for (const point of plot.points) {
      const far = (point.px - px) ** 2 + (point.py - py) ** 2;
      if (far < least) [best, least] = [point, far];
    }
    return best;
  }

  function listen(plot) {
    if (plot.heard) return;
    plot.heard = true;
    const place = (e) => {
      const at = plot.svg.getBoundingClientRect();
      const { left, right, top, bottom } = plot.box;
      return [Math.min(Math.max(e.clientX - at.left, left), right), Math.min(Math.max(e.clientY - at.top, top), bottom)];
    };
    let began = null;
    plot.svg.addEventListener("pointerdown", (e) => {
      if (e.button !== 0) return;
      began = place(e);
      if (e.pointerType !== "touch") plot.svg.setPointerCapture(e.pointerId);
    });
    plot.svg.addEventListener("pointermove", (e) => {
      const now = place(e);
      if (!began) {
        const point = nearest(plot, ...now);
        plot.svg.style.cursor = point ? "pointer" : "crosshair";
        if (point && !chosen.brush && chosen.picked == null) tell(point.i);
        return;
      }
      const [a, b] = [0, 1].map((k) => Math.min(began[k], now[k]));
      const [w, h] = [0, 1].map((k) => Math.abs(began[k] - now[k]));
      for (const [key, value] of Object.entries({ x: a, y: b, width: w, height: h, visibility: "visible" })) plot.band.setAttribute(key, value);
    });
    plot.svg.addEventListener("pointercancel", () => (began = null));
    plot.svg.addEventListener("pointerup", (e) => {
      if (!began) return;
      const [start, end] = [began, place(e)];
      began = null;
      plot.band.setAttribute("visibility", "hidden");
      if (Math.hypot(start[0] - end[0], start[1] - end[1]) < 5) {
        const point = nearest(plot, ...end);
        chosen.set(point ? { picked: point.i } : { picked: null, brush: null });
        return;
      }
      const [x0, x1] = [plot.x.invert(Math.min(start[0], end[0])), plot.x.invert(Math.max(start[0], end[0]))];
      const [y0, y1] = [plot.y.invert(Math.max(start[1], end[1])), plot.y.invert(Math.min(start[1], end[1]))];
      chosen.set({ picked: null, brush: { x, y, from: [x0, y0], to: [x1, y1] } });
    });
  }

  function light() {
    for (const plot of plots) {
      for (const { i, mark } of plot.points ?? []) {
        mark.classList.toggle("dim", !chosen.has(i));
        mark.classList.toggle("picked", chosen.picked === i);
      }
    }
    clear.hidden = !chosen.brush;
  }

  function tell(i) {
    const flight = sweep.flights[i];
    told.replaceChildren();
    const add = (html, text) => {
      const part = document.createElement(html);
      part.textContent = text;
      told.append(part, " ");
      return part;
    };
    const missed = flight.missed == null ? "" : `${sweep.requirements[flight.missed]}${flight.margin == null ? "" : `, by ${short(-flight.margin)}`}`;
    add("b", `Run ${flight.run}${sweep.variants[flight.variant] ? `, ${sweep.variants[flight.variant]}` : ""}: ${sweep.states[flight.state]}.`);
    add("span", [missed, ...[x, y].map((axis) => `${axis.path} ${axis.names ? axis.names[axis.values[i]] : short(axis.values[i])}`)].filter(Boolean).join("; "));
    if (chosen.page(i)) Object.assign(add("a", "Open its report"), { href: chosen.page(i) });
    else add("code", chosen.command(i));
  }

  function sum() {
    const among = sweep.flights.flatMap((flight, i) => (chosen.brushed(i) ? [flight] : []));
    const parts = sweep.variants.map((name, v) => {
      const here = among.filter((flight) => flight.variant === v);
      return `${name || "passed"} ${here.filter((flight) => flight.state === 0).length} of ${here.length}`;
    });
    told.textContent = chosen.brush ? `${among.length} flights chosen; passed: ${parts.join(", ")}. The table below lists them.` : "Drag over flights to choose them; click one for its report.";
  }

  chosen.listen((changes) => {
    light();
    if (changes.picked != null) tell(changes.picked);
    else if ("brush" in changes || "picked" in changes) sum();
  });
  legend.innerHTML = sweep.states
    .map((name, s) => [name, s, sweep.flights.filter((flight) => flight.state === s).length])
    .filter(([, , count]) => count)
    .map(([name, s, count]) => `<span>${inText(OF_STATES[s], `s${s}`)} ${name} (${count})</span>`)
    .join("");
  show(x, y);
}
