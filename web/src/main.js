// Everything that moves in report.html. The page is complete without it: story, requirements, metrics and static figures.
import { Quaternion, Vector3 } from "three";
import { attitude, deflection, fromBody } from "./attitude.js";
import { Clock } from "./clock.js";
import { onSchemeChange } from "./colours.js";
import { decode } from "./data.js";
import { Panels } from "./panels.js";
import { replay } from "./replay.js";
import { timeline } from "./timeline.js";

function start() {
  const began = performance.now();
  const flight = JSON.parse(document.getElementById("flight").textContent);
  const columns = decode(flight.data, document.getElementById("columns").textContent);
  const clock = new Clock(columns.time_s[0], columns.time_s[columns.time_s.length - 1]);
  document.body.classList.add("scripted");
  const scene = replay(document.getElementById("replay"), [{ flight, columns }], clock);
  const failures = flight.failures_s.map((time_s) => ({ time_s, style: "failure" }));
  const panels = new Panels(columns, clock);
  for (const group of flight.panels) {
    const root = document.getElementById(`panels-${group.name}`);
    for (const panel of group.panels) panels.add(root, { ...panel, failures });
  }
  anyColumn(document.getElementById("any-column"), failures, panels);
  timeline(document.getElementById("timeline"), flight, clock);
  moments(clock);
  onSchemeChange(() => {
    scene.recolour();
    panels.redraw();
  });
  requestAnimationFrame(() => {
    window.flightReport = { flight, columns, clock, panels, scene, drawn_ms: performance.now() - began, geometry: { attitude, deflection, fromBody, Quaternion, Vector3 } };
    document.body.dataset.drawn = "yes";
  });
}

// What was not met leads to its worst moment.
function moments(clock) {
  for (const link of document.querySelectorAll("[data-go]")) {
    link.addEventListener("click", (e) => {
      e.preventDefault();
      const at = Number(link.dataset.go);
      clock.show(at - 3, at + 3);
      clock.go(at);
      document.getElementById("timeline").scrollIntoView({ behavior: "smooth" });
    });
  }
}

// A panel of any column of the log, chosen by name.
function anyColumn(root, failures, panels) {
  const select = root.querySelector("select");
  let entry = null;
  const show = () => {
    entry?.plot?.destroy();
    entry?.box.remove();
    panels.made = panels.made.filter((made) => made !== entry);
    entry = panels.add(root, { title: select.value, series: [{ label: select.value, column: select.value, style: "truth" }], failures });
  };
  select.addEventListener("change", show);
  show();
}

start();
