// The connection to the server: frames of numbers and notes in words come down, numbered messages go up.
export class Link {
  constructor() {
    this.listeners = {};
    this.asked = new Map();
    this.next = 1;
    this.there = true;
    this.askedAt = -Infinity;
    this.said = () => {};
  }

  listen(what, listener) {
    (this.listeners[what] ??= []).push(listener);
  }

  tell(what, ...about) {
    for (const listener of this.listeners[what] ?? []) listener(...about);
  }

  open() {
    const socket = new WebSocket(`ws://${location.host}/flight${location.search}`);
    this.socket = socket;
    socket.binaryType = "arraybuffer";
    socket.addEventListener("message", ({ data }) => {
      if (typeof data === "string") this.note(JSON.parse(data));
      else this.tell("frame", new Float32Array(data));
    });
    socket.addEventListener("close", () => {
      this.there = false;
      this.tell("gone");
    });
  }

  note(note) {
    if (note.note === "refused") this.say(note.why);
    if (note.note === "done" || note.note === "refused") {
      this.asked.get(note.id)?.(note);
      this.asked.delete(note.id);
      return;
    }
    if (note.story) this.tell("story", note);
    this.tell(note.note, note);
  }

  say(text) {
    this.said(text);
    clearTimeout(this.forgets);
    if (text) this.forgets = setTimeout(() => this.said(""), 8000);
  }

  // Asks for something; the promise has the answer.
  ask(what, more = {}) {
    if (this.socket.readyState !== WebSocket.OPEN) return Promise.resolve({ note: "refused" });
    const id = this.next++;
    this.say("");
    this.askedAt = performance.now();
    this.socket.send(JSON.stringify({ id, do: what, ...more }));
    return new Promise((resolve) => this.asked.set(id, resolve));
  }
}
