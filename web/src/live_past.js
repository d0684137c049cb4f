// The last minute of a flight, twenty rows for each of its seconds; and its first and present row, as the scene reads columns.
const ROWS = 1200;
const EVERY_S = 0.05;

export class Past {
  constructor(names) {
    this.names = names;
    this.now = Object.fromEntries(names.map((name) => [name, new Float64Array(2)]));
    this.rows = Object.fromEntries(names.map((name) => [name, new Float64Array(2 * ROWS)]));
    this.clear();
  }

  clear() {
    [this.from, this.end, this.time] = [0, 0, 0];
    this.begun = false;
  }

  // The time of the first row that is kept.
  get first() {
    return this.end ? this.rows.time_s[this.from] : 0;
  }

  take(values) {
    if (values[0] < this.time) this.forget(values[0]); // gone back
    this.names.forEach((name, i) => {
      this.now[name][1] = values[i];
      if (!this.begun) this.now[name][0] = values[i];
    });
    this.begun = true;
    this.time = values[0];
    if (this.end && this.time < this.rows.time_s[this.end - 1] + EVERY_S) return;
    if (this.end === 2 * ROWS) this.move();
    this.names.forEach((name, i) => (this.rows[name][this.end] = values[i]));
    this.end += 1;
    this.from = Math.max(this.from, this.end - ROWS);
  }

  forget(after) {
    while (this.end > this.from && this.rows.time_s[this.end - 1] > after) this.end -= 1;
    if (this.end === this.from) [this.from, this.end] = [0, 0];
  }

  move() {
    for (const column of Object.values(this.rows)) column.copyWithin(0, this.from, this.end);
    [this.from, this.end] = [0, this.end - this.from];
  }

  // The columns of the rows that are kept.
  view() {
    return Object.fromEntries(this.names.map((name) => [name, this.rows[name].subarray(this.from, this.end)]));
  }
}
