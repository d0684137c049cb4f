// The page of a flight that is flown now: what comes from the server is drawn, what is done on the page is asked of the server.
import { Breaker } from "./live_break.js";
import { Ghosts } from "./live_ghosts.js";
import { Link } from "./live_link.js";
import { LiveScene } from "./live_scene.js";
import { Past } from "./live_past.js";
import { gamepad } from "./live_gamepad.js";
import { Table } from "./live_table.js";
import { Clock } from "./clock.js";
import { fixed } from "./data.js";
import { onSchemeChange } from "./colours.js";
import { Panels } from "./panels.js";

const ORDERS = { heading_deg: 10, altitude_m: 5, airspeed_m_s: 1 }; // what a key adds
const ANSWER_MS = 100; // what was asked for is drawn within this time after a press, and pictures wait for it
const find = (id) => document.getElementById(id);

function start() {
  const facts = JSON.parse(find("live").textContent);
  const past = new Past(facts.columns);
  const clock = new Clock(0, 1);
  const panels = new Panels(past.view(), clock);
  for (const group of facts.panels) for (const panel of group.panels) panels.add(find(`panels-${group.name}`), panel);
  const link = new Link();
  const breaker = new Breaker(find("break"), facts, link);
  const table = new Table(find("actuators"), find("sensors"), find("modes"), facts, link, (name) => breaker.open(name));
  const scene = picture(facts, past, breaker);
  const page = { facts, past, link, scene, frames: 0, state: {}, wanted: {} };
  const ghosts = new Ghosts(find("ghosts"), facts, link, scene);
  link.listen("frame", (values) => {
    if (page.leaving) return;
    past.take(values);
    ghosts.take(values);
    page.frames += 1;
    page.fresh = true;
  });
  link.listen("state", (state) => {
    Object.assign(page.state, state);
    showState(page);
    ghosts.show(state.ghosts);
    table.broken = state.broken ?? table.broken;
    if (scene) scene.broken = Object.keys(table.broken).some((name) => name in facts.actuators);
    page.fresh = true;
  });
  link.listen("story", showStory);
  link.listen("role", ({ flies }) => {
    page.flies = flies;
    document.body.dataset.flies = flies;
    showState(page);
  });
  link.listen("other", () => {
    page.leaving = true; // who flies comes back first, and goes on flying
    setTimeout(() => location.reload(), page.flies ? 0 : 1500);
  });
  link.listen("gone", () => showState(page));
  link.listen("saved", showSaved);
  link.listen("not saved", ({ why }) => link.say(why));
  link.said = (text) => {
    page.said = text;
    showState(page);
  };
  controls(page);
  forms(page);
  keys(page);
  gamepad((name, sign) => order(page, name, sign), () => page.link.ask("pause", { on: !page.state.paused }), page);
  onSchemeChange(() => {
    scene?.recolour();
    panels.redraw();
  });
  let pressed = -Infinity;
  addEventListener("pointerdown", ({ target }) => { if (target.closest?.("button")) pressed = performance.now(); }, true);
  const answering = () => performance.now() - Math.max(link.askedAt, pressed) < ANSWER_MS;
  let behind = false; // the picture
  const draw = () => {
    requestAnimationFrame(draw);
    if (!past.time) return;
    if (page.fresh) {
      table.show(past.now);
      readout(page);
      behind = true;
      page.fresh = false;
    }
    if (!behind || answering() || !scene?.idle) return;
    scene.follow();
    behind = false;
  };
  setInterval(() => {
    if (document.hidden || !past.time || answering()) return;
    [clock.start, clock.end, clock.now] = [past.first, past.time, past.time];
    clock.range = [Math.max(past.time - 60, past.first), Math.max(past.time, past.first + 1)];
    panels.renew(past.view());
  }, 200);
  requestAnimationFrame(draw);
  link.open();
  window.flightLive = page;
  document.body.dataset.drawn = "yes";
}

// The report's own scene; a click in it chooses what to break. Null where there is no WebGL.
function picture(facts, past, breaker) {
  const canvas = document.querySelector(".picture canvas");
  if (!document.createElement("canvas").getContext("webgl2")) {
    for (const each of [canvas, ...document.querySelectorAll("[data-view]")]) each.hidden = true;
    return null;
  }
  const scene = new LiveScene(canvas, facts, past.now);
  canvas.addEventListener("click", (e) => {
    if (scene.orbit.moved > 6) return; // the camera was turned
    const name = scene.at(e.offsetX, e.offsetY);
    if (name) breaker.open(name);
  });
  const views = [...document.querySelectorAll("[data-view]")];
  const look = (view) => {
    scene.look(view);
    for (const button of views) button.setAttribute("aria-pressed", button.dataset.view === view);
  };
  for (const button of views) button.addEventListener("click", () => look(button.dataset.view));
  look("chase");
  return scene;
}

function showState({ link, state, flies, said }) {
  const status = find("status");
  const gone = !link.there && "The server has gone. What was saved is safe; start testbed live again for another flight.";
  const words = gone || said || state.ended || (flies === false && "Another page flies, this one looks on.") || (state.paused ? "paused" : "flying");
  status.textContent = words;
  status.classList.toggle("wrong", Boolean(gone || said || state.ended));
  document.querySelector("[data-do=pause]").textContent = state.paused ? "Go on" : "Pause";
  if (state.speed && document.activeElement !== find("speed")) find("speed").value = String(state.speed);
  for (const each of document.querySelectorAll("button:not([data-view]), form input, form select, #ghosts input, #speed, #back")) each.disabled = Boolean(gone) || flies === false;
}

function showStory({ story, events }) {
  const item = (text) => Object.assign(document.createElement("li"), { textContent: text });
  find("story").replaceChildren(...story.map(item));
  find("events").replaceChildren(...events.toReversed().map(({ time_s, text }) => item(`${time_s.toFixed(1)} s: ${text}`)));
}

function showSaved({ folder, command, time_s }) {
  const said = document.createElement("p");
  said.append(`The first ${time_s.toFixed(1)} s are saved in ${folder}, with report.html. They fly again to the same bytes by`);
  const share = Object.assign(document.createElement("a"), { href: `/report.html${location.search}`, textContent: "Share: one file that replays it" });
  share.download = "";
  find("saved").replaceChildren(said, Object.assign(document.createElement("pre"), { textContent: command }), share);
}

function readout({ past }) {
  const now = (name) => past.now[name][1];
  const [height, speed, turn] = [now("altitude_m"), now("airspeed_m_s"), now("heading_deg")];
  document.querySelector(".picture output").textContent =
    `${past.time.toFixed(1)} s   ${height.toFixed(1)} m   ${speed.toFixed(1)} m/s   heading ${(Math.round(turn) + 360) % 360} deg   bank ${fixed(now("roll_deg"), 0)} deg`;
  const back = find("back");
  if (document.activeElement !== back) {
    back.max = past.time.toFixed(1);
    back.value = past.time;
    find("back-to").textContent = `${past.time.toFixed(1)} s`;
  }
  for (const input of find("order").querySelectorAll("input")) {
    const column = input.name.replace(/_([^_]+|m_s)$/, "_command_$1");
    if (!input.dataset.touched) input.value = Number(now(column).toFixed(1));
  }
}

function controls(page) {
  const { link } = page;
  const back = find("back");
  const does = {
    pause: () => link.ask("pause", { on: !page.state.paused }),
    save: () => link.ask("save"),
    restart: () => {
      page.wanted = {};
      link.ask("restart");
    },
  };
  for (const [name, act] of Object.entries(does)) document.querySelector(`[data-do=${name}]`).addEventListener("click", act);
  find("speed").addEventListener("change", (e) => {
    link.ask("speed", { times: Number(e.target.value) });
    e.target.blur();
  });
  back.addEventListener("input", () => (find("back-to").textContent = `${Number(back.value).toFixed(1)} s`));
  back.addEventListener("change", () => {
    page.wanted = {};
    link.ask("rewind", { time_s: Number(back.value) });
    back.blur();
  });
}

function forms(page) {
  const { link } = page;
  const on = (id, act) =>
    find(id).addEventListener("submit", (e) => {
      e.preventDefault();
      const inputs = [...e.target.querySelectorAll("input")];
      act(inputs.map((input) => input.valueAsNumber), inputs);
    });
  for (const input of find("order").querySelectorAll("input")) input.addEventListener("input", () => (input.dataset.touched = "yes"));
  find("choose").addEventListener("submit", (e) => {
    e.preventDefault();
    link.ask("choose", Object.fromEntries(new FormData(e.target)));
  });
  on("order", (_, inputs) => {
    const touched = inputs.filter((input) => input.dataset.touched && input.value !== "");
    for (const { name, valueAsNumber } of touched) page.wanted[name] = { value: valueAsNumber, at: performance.now() };
    link.ask("order", { command: Object.fromEntries(touched.map((input) => [input.name, input.valueAsNumber])) });
    for (const input of inputs) delete input.dataset.touched;
  });
  on("wind", (wind_m_s) => link.ask("blow", { air: { wind_m_s, duration_s: 2 } }));
  on("turbulence", ([w20_m_s]) => link.ask("blow", { air: { w20_m_s } }));
  on("gust", ([u, v, w, duration_s, hold_s]) => link.ask("blow", { air: { magnitude_m_s: [u, v, w], duration_s, hold_s } }));
}

// Arrows turn and climb, space pauses.
function keys(page) {
  const turn = { ArrowLeft: ["heading_deg", -1], ArrowRight: ["heading_deg", 1], ArrowUp: ["altitude_m", 1], ArrowDown: ["altitude_m", -1] };
  document.addEventListener("keydown", (e) => {
    if (e.target.matches("input, select, textarea") || e.ctrlKey || e.metaKey || e.altKey || !page.flies) return;
    if (e.repeat && e.key === " ") return e.preventDefault(); // held, it is one press
    if (e.key === " " && !e.target.matches("button, summary")) page.link.ask("pause", { on: !page.state.paused });
    else if (turn[e.key]) order(page, ...turn[e.key]);
    else if ("+-".includes(e.key)) page.scene?.orbit.zoom(e.key === "+" ? 0.8 : 1.25);
    else return;
    e.preventDefault();
  });
}

// Keys that follow each other add up, while what was ordered is approached.
function order(page, name, sign) {
  const { wanted } = page;
  const present = page.past.now[name.replace(/_([^_]+|m_s)$/, "_command_$1")][1];
  const off = Math.abs(present - wanted[name]?.value);
  const approached = (name === "heading_deg" ? Math.min(off, 360 - off) : off) > 0.5;
  const recent = wanted[name] && (approached || performance.now() - wanted[name].at < 5000);
  let value = (recent ? wanted[name].value : Math.round(present)) + sign * ORDERS[name];
  if (name === "heading_deg") value = (value + 360) % 360;
  wanted[name] = { value, at: performance.now() };
  page.link.ask("order", { command: { [name]: value } }).then(({ note }) => note === "done" || delete wanted[name]);
}

start();
