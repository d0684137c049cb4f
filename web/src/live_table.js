// The actuators and sensors: what is true of each and what the controller believes, side by side; and the axes that it has given up.
import { short } from "./plot.js";

const AXES = { p_dot: "roll", q_dot: "pitch", r_dot: "yaw", u_dot: "speed" };

export class Table {
  // `sensors` is the body of their table, which is not there where they are ideal.
  constructor(body, sensors, modes, facts, link, choose) {
    Object.assign(this, { facts, modes, broken: {} });
    const rows = (of, cells, into) =>
      Object.entries(of).map(([name, { title }]) => {
        const row = into.insertRow();
        row.dataset.actuator = name;
        const [who, truth, ...others] = Array.from({ length: cells }, () => row.insertCell());
        who.append(button(title, () => choose(name)));
        const mends = button("Mend", () => link.ask("mend", { actuator: name }));
        others.at(-1).append(mends);
        return { name, row, truth, belief: others[0], mends };
      });
    this.rows = rows(facts.actuators, 4, body);
    this.sensors = rows(facts.sensors, 3, sensors);
  }

  show(now) {
    for (const { name, row, truth, belief, mends } of this.rows) {
      const value = (what) => now[`${name}_${what}`][1];
      const broken = this.broken[name] ?? [];
      const { unit } = this.facts.actuators[name];
      put(truth, `${short(value("position"))} ${unit}, ${broken.length ? broken.join("; ") : effect(value("response"))}`);
      put(belief, this.believed(value, unit));
      row.classList.toggle("wrong", broken.length > 0 || !(value("response") > 0.99));
      row.classList.toggle("flagged", value("failed") > 0);
      mends.hidden = broken.length === 0;
    }
    for (const { name, row, truth, mends } of this.sensors) {
      const broken = this.broken[name] ?? [];
      put(truth, broken.join("; ") || "works");
      row.classList.toggle("wrong", broken.length > 0);
      mends.hidden = broken.length === 0;
    }
    const released = Object.entries(AXES).filter(([axis]) => now[`${axis}_released`][1] > 0 && !this.facts.never.includes(axis));
    put(this.modes, released.length ? `given up: ${released.map(([, words]) => words).join(", ")}` : "no axis is given up");
  }

  believed(value, unit) {
    const word = this.facts.beliefs[value("belief")] ?? "says nothing";
    const held = Number.isFinite(value("believed_position")) ? ` at ${short(value("believed_position"))} ${unit}` : "";
    const estimate = value("effectiveness_estimate");
    return `${word}${held}${Number.isFinite(estimate) ? `, ${effect(estimate)}` : ""}${value("failed") > 0 ? ", flagged" : ""}`;
  }
}

const effect = (share) => (Number.isFinite(share) ? `${(100 * share).toFixed(0)} %` : "does not follow");

// Text that is the same is not written again: a screen reader and the layout have nothing to do then.
function put(cell, text) {
  if (cell.textContent !== text) cell.textContent = text;
}

function button(text, act) {
  const made = Object.assign(document.createElement("button"), { type: "button", textContent: text });
  made.addEventListener("click", act);
  return made;
}
