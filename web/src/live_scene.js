// The report's scene of a flight that goes on: the trail grows, and a click finds what it hits.
import { BufferAttribute, BufferGeometry, Color, Line, LineBasicMaterial, Raycaster, Sphere, Vector2, Vector3 } from "three";
import { colour } from "./colours.js";
import { Scene } from "./scene.js";

const POINTS = 8000; // when there are so many, every second one is left out
const FIRST_EVERY_S = 0.1;

export class LiveScene extends Scene {
  constructor(canvas, facts, now) {
    super(canvas, { ...facts, phases: [] }, now);
    this.broken = false;
  }

  trail() {
    const geometry = new BufferGeometry();
    this.colours = new Float32Array(3 * POINTS);
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * POINTS), 3));
    geometry.setAttribute("color", new BufferAttribute(this.colours, 3));
    this.line = new Line(geometry, new LineBasicMaterial({ vertexColors: true }));
    this.line.frustumCulled = false; // its bounds change all the time
    this.times = [];
    this.every = FIRST_EVERY_S;
    this.three.add(this.line);
  }

  // Shows the present row.
  follow() {
    const time = this.columns.time_s[1];
    while (this.times.length && this.times[this.times.length - 1] > time) this.times.pop(); // gone back
    this.lowest = Math.min(this.lowest ?? Infinity, this.columns.altitude_m[1] - this.columns.altitude_m[0] - 4 * this.size);
    this.show(1);
    const last = this.times[this.times.length - 1];
    if (last === undefined || time >= last + this.every) this.grow(time);
  }

  grow(time) {
    if (this.times.length === POINTS) this.thin();
    const k = this.times.push(time) - 1;
    const { position, color } = this.line.geometry.attributes;
    this.aircraft.position.toArray(position.array, 3 * k);
    const flagged = Object.keys(this.flight.actuators).some((name) => this.columns[`${name}_failed`][1] > 0);
    new Color(colour(flagged ? "flagged" : this.broken ? "unnoticed" : "healthy")).toArray(color.array, 3 * k);
    position.needsUpdate = color.needsUpdate = true;
    this.line.geometry.setDrawRange(0, k + 1);
  }

  thin() {
    const arrays = Object.values(this.line.geometry.attributes).map((each) => each.array);
    for (let k = 0; k < POINTS / 2; k++) for (const array of arrays) array.copyWithin(3 * k, 6 * k, 6 * k + 3);
    this.times = this.times.filter((_, k) => k % 2 === 0);
    this.every *= 2;
  }

  // The actuator at a point of the picture [px], if there is one.
  at(x, y) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    const hits = this.parts.filter((part) => part.actuator).flatMap((part) => this.hit(ray, part));
    return hits.sort((a, b) => a.distance - b.distance)[0]?.actuator;
  }

  hit(ray, { kind, surface, actuator }) {
    const hits = ray.intersectObject(surface, false);
    if (kind === "propulsor") {
      const ball = new Sphere(surface.getWorldPosition(new Vector3()), surface.geometry.parameters.outerRadius); // a turning propeller fills its disc
      const point = ray.ray.intersectSphere(ball, new Vector3());
      if (point) hits.push({ distance: point.distanceTo(ray.ray.origin) });
    }
    return hits.map(({ distance }) => ({ distance, actuator }));
  }
}
