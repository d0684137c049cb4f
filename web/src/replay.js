// The replay's picture and its controls: play, speed, scrub, views and keys.
import { fixed, lastOf, rowAt } from "./data.js";
import { Flat } from "./flat.js";
import { Scene } from "./scene.js";
import { VIEWS } from "./camera.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8];

// `?webgl=0` in the address asks for the flat picture, which is also drawn where there is no WebGL.
function picture(canvas, flights) {
  const wanted = new URLSearchParams(location.search).get("webgl") !== "0";
  const there = wanted && document.createElement("canvas").getContext("webgl2");
  return there ? new Scene(canvas, flights) : new Flat(canvas, flights[0].flight, flights[0].columns);
}

const AXES = { p_dot: "roll", q_dot: "pitch", r_dot: "yaw", u_dot: "speed" };

// What the controller takes for broken, flags and has given up in a row, each on a line of its own.
function thought(flight, columns, row) {
  const at = (name) => columns[name]?.[row];
  const lines = Object.entries(flight.actuators).map(([name, { unit }]) => {
    const held = at(`${name}_believed_position`);
    const word = flight.beliefs[at(`${name}_belief`)] ?? "works";
    const said = [at(`${name}_failed`) > 0 ? "flagged" : "", word === "works" ? "" : `believed ${word}${Number.isFinite(held) ? ` at ${held.toFixed(1)} ${unit}` : ""}`];
    const words = said.filter(Boolean).join(", ");
    return words && `${name.replaceAll("_", " ")}: ${words}`;
  });
  // What is so from the first row on is how the aircraft or the controller is made, and nothing that was given up.
  const given = Object.keys(AXES).filter((axis) => at(`${axis}_released`) > 0 && !(columns[`${axis}_released`][0] > 0));
  if (given.length) lines.push(`given up: ${given.map((axis) => AXES[axis]).join(", ")}`);
  return lines.filter(Boolean).map((line) => `\n${line}`).join("");
}

// `flights` is [{flight, columns}], and if there are several, the `name` of each; the first is followed until another is chosen.
export function replay(root, flights, clock) {
  const chosen = flights.length > 1 ? `<label>follow <select data-do="follow"></select></label>` : "";
  root.innerHTML = `
    <div class="picture"><canvas role="img" tabindex="0" aria-label="replay of the flight"></canvas><output></output></div>
    <div class="buttons">
      <button type="button" data-do="play" title="space">Play</button>
      <label>speed <select data-do="speed">${SPEEDS.map((s) => `<option value="${s}"${s === 1 ? " selected" : ""}>${s} x</option>`).join("")}</select></label>
      ${Object.keys(VIEWS).map((v, i) => `<button type="button" data-view="${v}" title="key ${i + 1}">${v}</button>`).join("")}
      ${chosen}
      <input type="range" min="${clock.start}" max="${clock.end}" step="any" value="${clock.now}" aria-label="time">
    </div>
    <p class="note">Surfaces and discs are coloured by what they truly do for their command, edges and thrust arrows by the belief of ${flights[0].flight.believer ?? "the controller"}; a ghost is where a surface that does not follow is commanded to be.
    The sheet leads from the trail to the ordered height, the needle to the ordered heading. Drag to turn; wheel, two fingers, + and - zoom. Keys: space plays, arrows step, 1 to 4 choose the view.</p>`;
  const scene = picture(root.querySelector("canvas"), flights);
  let followed = flights[0];
  const follow = root.querySelector("[data-do=follow]");
  follow?.append(...flights.map(({ name }, i) => new Option(name, i)));
  follow?.addEventListener("change", () => {
    followed = flights[follow.value];
    scene.follows?.(Number(follow.value));
    clock.go(clock.now);
  });
  const [output, play, slider] = ["output", "[data-do=play]", "input"].map((s) => root.querySelector(s));
  const views = [...root.querySelectorAll("[data-view]")];
  const look = (view) => {
    scene.look(view);
    for (const button of views) button.setAttribute("aria-pressed", button.dataset.view === view);
  };
  views.forEach((button) => button.addEventListener("click", () => look(button.dataset.view)));
  play.addEventListener("click", () => clock.play());
  slider.addEventListener("input", () => clock.go(Number(slider.value)));
  root.querySelector("[data-do=speed]").addEventListener("change", (e) => {
    clock.speed = Number(e.target.value);
  });
  document.addEventListener("keydown", (e) => {
    if (e.target.matches("input:not([type=range]), select, textarea") || e.ctrlKey || e.metaKey || e.altKey) return;
    const keys = {
      " ": () => clock.play(),
      ArrowRight: () => clock.go(clock.now + (e.shiftKey ? 1 : 0.1)),
      ArrowLeft: () => clock.go(clock.now - (e.shiftKey ? 1 : 0.1)),
      "+": () => scene.orbit?.zoom(0.8),
      "-": () => scene.orbit?.zoom(1.25),
    };
    Object.keys(VIEWS).forEach((view, i) => (keys[i + 1] = () => look(view)));
    if (!keys[e.key] || (e.key === " " && e.target.matches("button, summary"))) return;
    e.preventDefault();
    keys[e.key]();
  });
  clock.listen(() => {
    const { flight, columns } = followed;
    const row = Math.min(rowAt(columns.time_s, clock.now), lastOf(columns.north_m));
    scene.show(rowAt(columns.time_s, clock.now));
    slider.value = clock.now;
    slider.setAttribute("aria-valuetext", `${clock.now.toFixed(2)} s`);
    play.textContent = clock.playing ? "Pause" : "Play";
    const { altitude_m, airspeed_m_s, roll_deg } = columns;
    output.textContent = `${clock.now.toFixed(2)} s   ${altitude_m[row].toFixed(1)} m   ${airspeed_m_s[row].toFixed(1)} m/s   bank ${fixed(roll_deg[row], 1)} deg${thought(flight, columns, row)}`;
  });
  look("chase");
  return scene;
}
