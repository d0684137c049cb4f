// Which flights are looked at: those inside the brush, of some state and variant, with some words; and the one that is picked.
const [LOG, PAGE] = [1, 2]; // what is kept of a flight, as `study_reports.sweep.curves` says it

export class Chosen {
  constructor(sweep) {
    this.sweep = sweep;
    this.brush = null; // {x: axis, y: axis, from: [x, y], to: [x, y]}
    this.state = "";
    this.variant = "";
    this.words = "";
    this.picked = null;
    this.listeners = [];
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  set(changes) {
    Object.assign(this, changes);
    for (const listener of this.listeners) listener(changes);
  }

  brushed(i) {
    if (!this.brush) return true;
    const { x, y, from, to } = this.brush;
    const [a, b] = [x.values[i], y.values[i]];
    return a != null && b != null && a >= from[0] && a <= to[0] && b >= from[1] && b <= to[1];
  }

  has(i) {
    const flight = this.sweep.flights[i];
    if (!this.brushed(i)) return false;
    if (this.state !== "" && flight.state !== Number(this.state)) return false;
    if (this.variant !== "" && flight.variant !== Number(this.variant)) return false;
    return !this.words || this.text(i).includes(this.words);
  }

  // Its page relative to this one, or "".
  page(i) {
    return this.sweep.flights[i].kept === PAGE ? `flights/${this.label(i)}.html` : "";
  }

  // The command that makes its page, from its log or by flying it again; to be run in the folder above.
  command(i) {
    const { run, variant, kept } = this.sweep.flights[i];
    if (kept === LOG) return `python -m testbed report ${this.sweep.folder}/${this.label(i)}`;
    const name = this.sweep.in_file_names[variant];
    return `python -m testbed sweep ${this.sweep.folder}/sweep.yaml --only ${run}${name ? ` --variant ${name}` : ""}`;
  }

  label(i) {
    const { run, variant } = this.sweep.flights[i];
    const name = this.sweep.in_file_names[variant];
    return `run-${String(run).padStart(6, "0")}${name ? `-${name}` : ""}`;
  }

  // Everything that the words of a filter may be found in.
  text(i) {
    const { run, variant, state, missed, reason } = this.sweep.flights[i];
    const inputs = this.sweep.inputs.map(({ names, values }) => (names ? names[values[i]] : values[i]));
    const parts = [run, this.sweep.variants[variant], this.sweep.states[state], this.sweep.requirements[missed] ?? "", reason, ...inputs];
    return parts.join(" ").toLowerCase();
  }
}
