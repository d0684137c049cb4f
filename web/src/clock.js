// One time for everything on the page: the cursor, and the range of time that is shown.
export class Clock {
  constructor(start, end) {
    this.start = start;
    this.end = end;
    this.now = start;
    this.range = [start, end];
    this.playing = false;
    this.speed = 1;
    this.listeners = [];
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  tell(what) {
    for (const listener of this.listeners) listener(what);
  }

  go(t) {
    this.now = Math.min(Math.max(t, this.start), this.end);
    this.tell("now");
  }

  show(from, to) {
    this.range = [Math.max(from, this.start), Math.min(to, this.end)];
    this.tell("range");
  }

  play(on = !this.playing) {
    if (on && this.now >= this.end) this.now = this.start;
    this.playing = on;
    this.last = performance.now();
    this.tell("playing");
    if (on) requestAnimationFrame(() => this.tick());
  }

  tick() {
    if (!this.playing) return;
    const present = performance.now();
    this.go(this.now + ((present - this.last) / 1000) * this.speed);
    this.last = present;
    if (this.now >= this.end) this.play(false);
    else requestAnimationFrame(() => this.tick());
  }
}
