// Everything that moves in the report of a sweep: the map, the curves, and the table of flights.
import { Chosen } from "./chosen.js";
import { errors, shares } from "./curves.js";
import { map } from "./map.js";
import { table } from "./table.js";

function start() {
  const began = performance.now();
  const sweep = JSON.parse(document.getElementById("sweep").textContent);
  const chosen = new Chosen(sweep);
  document.body.classList.add("scripted");
  map(document.getElementById("map"), sweep, chosen);
  shares(document.getElementById("shares"), sweep);
  errors(document.getElementById("errors"), sweep);
  table(document.getElementById("flights"), sweep, chosen);
  requestAnimationFrame(() => {
    window.sweepReport = { sweep, chosen, drawn_ms: performance.now() - began };
    document.body.dataset.drawn = "yes";
  });
}

start();
