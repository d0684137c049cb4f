// The flight in phases; a click moves everything to the phase's beginning and shows it.
import { PHASES } from "./colours.js";

const TITLES = {
  healthy: "healthy",
  unnoticed: "broken, not noticed",
  unseen: "held, not noticed",
  flagged: "noticed",
  held: "noticed and held",
  recovered: "recovered",
  lost: "lost",
};

// `until` is where its axis ends: by default where the flight should have ended, which is later than where a lost one did.
export function timeline(root, flight, clock, until = flight.phases[flight.phases.length - 1].until_s) {
  const titles = { ...TITLES, ...flight.titles };
  const span = until - clock.start || 1;
  const share = (t) => `${(100 * (t - clock.start)) / span}%`;
  const bar = document.createElement("div");
  bar.className = "bar";
  for (const { name, from_s, until_s } of flight.phases) {
    const phase = document.createElement("button");
    phase.type = "button";
    phase.className = `phase ${name}`;
    phase.dataset.phase = name;
    phase.style.left = share(from_s);
    phase.style.width = `${(100 * (until_s - from_s)) / span}%`;
    const words = document.createElement("span");
    words.textContent = titles[name];
    phase.append(words);
    phase.title = `${titles[name]}: ${from_s.toFixed(2)} to ${until_s.toFixed(2)} s`;
    phase.addEventListener("click", () => {
      const margin = Math.max(0.15 * (until_s - from_s), 0.5);
      clock.show(from_s - margin, until_s + margin);
      clock.go(from_s);
    });
    bar.append(phase);
  }
  for (const event of flight.events) {
    const mark = document.createElement("i");
    mark.className = `mark ${event.kind}`;
    mark.style.left = share(event.time_s);
    bar.append(mark);
  }
  const hand = document.createElement("i");
  hand.className = "hand";
  bar.append(hand);

  const times = document.createElement("p");
  times.className = "times";
  for (const t of [clock.start, ...flight.failures_s.slice(0, 3), clock.start + span]) {
    const mark = document.createElement("span");
    mark.textContent = `${+t.toFixed(1)} s`;
    mark.style.left = share(t);
    times.append(mark);
  }

  const legend = document.createElement("p");
  legend.className = "legend";
  for (const name of PHASES.filter((p) => flight.phases.some((phase) => phase.name === p))) {
    legend.insertAdjacentHTML("beforeend", `<span><i class="phase ${name}"></i>${titles[name]}</span>`);
  }
  if (flight.events.length) legend.insertAdjacentHTML("beforeend", "<span>strokes: events, listed below</span>");
  const buttons = document.createElement("p");
  buttons.className = "buttons";
  const button = (text, act) => {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = text;
    made.addEventListener("click", act);
    buttons.append(made);
  };
  if (flight.failures_s.length) {
    button("Zoom to failure", () => {
      const at = flight.failures_s[flight.failures_s.length - 1];
      clock.show(at - 1, at + 5);
      clock.go(at);
    });
  }
  button("Whole flight", () => clock.show(clock.start, clock.end));
  root.append(bar, times, legend, buttons);
  const fit = () => bar.querySelectorAll(".phase").forEach((phase) => phase.classList.toggle("narrow", phase.clientWidth < phase.firstChild.offsetWidth + 12));
  new ResizeObserver(() => {
    fit(); // a title that does not fit is left to the legend
    thin(times);
  }).observe(bar);
  clock.listen(() => {
    hand.style.left = share(clock.now);
  });
  clock.go(flight.failures_s[0] ?? clock.start);
}

// Hides each time that would stand in another: the first and the last one stay.
function thin(times) {
  const marks = [...times.children];
  marks.forEach((mark) => (mark.style.visibility = ""));
  const kept = [marks[0], marks[marks.length - 1]];
  for (const mark of marks.slice(1, -1)) {
    if (kept.every((other) => apart(mark.getBoundingClientRect(), other.getBoundingClientRect()))) kept.push(mark);
    else mark.style.visibility = "hidden";
  }
}

const apart = (a, b) => a.right + 4 < b.left || b.right + 4 < a.left;
