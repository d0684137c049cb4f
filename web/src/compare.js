// Everything that moves in the page of a comparison: a timeline for each flight, and panels with all flights on one cursor.
import { Clock } from "./clock.js";
import { onSchemeChange } from "./colours.js";
import { decode } from "./data.js";
import { Panels } from "./panels.js";
import { replay } from "./replay.js";
import { timeline } from "./timeline.js";

function start() {
  const began = performance.now();
  const comparison = JSON.parse(document.getElementById("comparison").textContent);
  const columns = decode(comparison.data, document.getElementById("columns").textContent);
  const clock = new Clock(columns.time_s[0], columns.time_s[columns.time_s.length - 1]);
  document.body.classList.add("scripted");
  const panels = new Panels(columns, clock);
  for (const group of comparison.panels) {
    const root = document.getElementById(`panels-${group.name}`);
    for (const panel of group.panels) panels.add(root, panel);
  }
  const bars = document.getElementById("timelines");
  const until = Math.max(...comparison.flights.map(({ phases }) => phases[phases.length - 1].until_s));
  comparison.flights.forEach((flight, i) => {
    const box = document.createElement("div");
    box.className = "flight-bar";
    box.append(Object.assign(document.createElement("p"), { className: "note", textContent: flight.name }));
    bars.append(box);
    timeline(box, { ...flight, events: [] }, clock, until);
    if (i < comparison.flights.length - 1) box.querySelector(".buttons").remove();
  });
  mergeLegends(bars);
  const picture = document.getElementById("replay"); // not there where a log does not say where its aircraft was
  const flown = comparison.flights.map((flight, i) => ({ flight, name: flight.key, columns: own(columns, i) }));
  const scene = picture && replay(picture, flown, clock);
  clock.go(clock.now);
  onSchemeChange(() => {
    scene?.recolour();
    panels.redraw();
  });
  requestAnimationFrame(() => {
    window.comparison = { comparison, columns, clock, panels, scene, drawn_ms: performance.now() - began };
    document.body.dataset.drawn = "yes";
  });
}

// The columns of one of the flights, by their names in its log.
function own(columns, i) {
  const its = Object.entries(columns).filter(([name]) => name.startsWith(`${i}:`));
  return { time_s: columns.time_s, ...Object.fromEntries(its.map(([name, values]) => [name.slice(2), values])) };
}

// One legend for all timelines, with each phase once.
function mergeLegends(bars) {
  const legends = [...bars.querySelectorAll(".legend")];
  const kept = legends.pop();
  const there = () => [...kept.children].map((entry) => entry.textContent);
  for (const legend of legends) {
    for (const entry of [...legend.children]) if (!there().includes(entry.textContent)) kept.append(entry);
    legend.remove();
  }
}

start();
