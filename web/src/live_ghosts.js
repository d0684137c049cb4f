// Other controllers that fly the same beside the flight: which of them, how they end, and where they are in the picture.
export class Ghosts {
  constructor(place, facts, link, scene) {
    Object.assign(this, { place, facts, scene, wanted: [], seen: [] });
    this.boxes = [...place.querySelectorAll("input")];
    place.addEventListener("change", async () => {
      const controllers = this.boxes.filter((box) => box.checked).map((box) => box.value);
      const { note } = await link.ask("ghosts", { controllers });
      if (note === "refused") this.check();
    });
  }

  // What the server says of them: how each one ended, by its name.
  show(outcomes) {
    if (!outcomes) return;
    this.wanted = Object.keys(outcomes);
    this.check();
    for (const box of this.boxes) {
      const ended = outcomes[box.value];
      box.parentElement.querySelector("span").textContent = ended ? ` (${ended})` : "";
    }
  }

  check() {
    for (const box of this.boxes) box.checked = this.wanted.includes(box.value);
  }

  // The present rows of a frame, which come after the flight's own.
  take(values) {
    const { columns } = this.facts;
    if (values.length !== columns.length * (this.wanted.length + 1)) return; // what it says of them is still to come
    const changed = this.wanted.join() !== this.seen.map(({ name }) => name).join();
    if (changed) this.seen = this.wanted.map((name) => ({ name, now: Object.fromEntries(columns.map((column) => [column, new Float64Array(2)])) }));
    this.seen.forEach(({ now }, k) => columns.forEach((column, i) => this.fill(now[column], values[columns.length * (k + 1) + i], changed)));
    if (changed) this.scene?.beside(this.seen, this.facts);
  }

  fill(rows, value, first) {
    rows[1] = value;
    if (first) rows[0] = value;
  }
}
