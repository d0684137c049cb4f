// The replay where there is no WebGL: the track from above, and altitude over time.
import { colour } from "./colours.js";

export class Flat {
  constructor(canvas, flight, columns) {
    this.canvas = canvas;
    this.flight = flight;
    this.columns = columns;
    this.row = 0;
    new ResizeObserver(() => this.draw()).observe(canvas.parentElement);
  }

  recolour() {
    this.draw();
  }

  // From above and from the side is all that there is.
  look() {}

  show(row) {
    this.row = row;
    this.draw();
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    this.canvas.width = width * devicePixelRatio;
    this.canvas.height = height * devicePixelRatio;
    const { east_m, north_m, altitude_m, time_s } = this.columns;
    const half = this.canvas.width / 2;
    this.curve(east_m, north_m, [0, half], true, "track from above, north is up");
    this.curve(time_s, altitude_m, [half, 2 * half], false, "altitude over time");
  }

  curve(x, y, [left, right], square, title) {
    const g = this.canvas.getContext("2d");
    const pad = 24 * devicePixelRatio;
    const range = (v) => [v.reduce((a, b) => Math.min(a, b), Infinity), v.reduce((a, b) => Math.max(a, b), -Infinity)];
    const [[x0, x1], [y0, y1]] = [range(x), range(y)];
    const [w, h] = [right - left - 2 * pad, this.canvas.height - 2 * pad];
    let [kx, ky] = [w / Math.max(x1 - x0, 1), h / Math.max(y1 - y0, 2)];
    if (square) kx = ky = Math.min(kx, ky);
    const place = (k) => [left + pad + (x[k] - x0) * kx, this.canvas.height - pad - (y[k] - y0) * ky];
    let k = 0;
    for (const { name, until_s } of this.flight.phases) {
      g.strokeStyle = colour(name);
      g.lineWidth = 2 * devicePixelRatio;
      g.beginPath();
      g.moveTo(...place(Math.max(k - 1, 0)));
      for (; k < x.length && this.columns.time_s[k] <= until_s + 1e-9; k++) g.lineTo(...place(k));
      g.stroke();
    }
    g.fillStyle = colour("text");
    g.beginPath();
    g.arc(...place(this.row), 5 * devicePixelRatio, 0, 2 * Math.PI);
    g.fill();
    g.font = `${12 * devicePixelRatio}px system-ui`;
    g.fillText(title, left + pad, pad * 0.8);
  }
}
