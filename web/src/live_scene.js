// The report's scene of a flight that goes on: its trail grows, a click finds what it hits, and other controllers fly beside it.
import { Raycaster, Sphere, Vector2, Vector3 } from "three";
import { colour } from "./colours.js";
import { Scene } from "./scene.js";
import { Trail } from "./trail.js";

const POINTS = 6000; // when there are so many, every second one is left out
const FIRST_EVERY_S = 0.1;
const SLOW_MS = 50; // between pictures that the processor draws
const PRESENT = 1; // row of the columns, of which the first is the flight's

export class LiveScene extends Scene {
  constructor(canvas, facts, now) {
    const slow = drawnByProcessor();
    super(canvas, [{ flight: { ...facts, phases: [] }, columns: now }], !slow);
    Object.assign(this, { slow, broken: false, drawn: -Infinity });
  }

  // Whether it is time for another picture: the processor, where it draws them, has to fly, too.
  get idle() {
    return !this.slow || performance.now() - this.drawn > SLOW_MS;
  }

  track(one) {
    Object.assign(one, { trail: new Trail(this.three, POINTS), times: [], every: FIRST_EVERY_S });
  }

  shade() {}

  flown({ trail }) {
    return trail.count;
  }

  // Shows the present row.
  follow() {
    for (const one of this.seen) this.grow(one);
    this.show(PRESENT);
    this.drawn = performance.now();
  }

  // The flights of other controllers, by name, as faint aircraft: their columns have the present row, too.
  beside(ghosts, facts) {
    for (const { craft, label, trail } of this.seen.splice(1)) {
      label.remove();
      trail.remove();
      this.three.remove(craft.group, craft.around);
    }
    ghosts.forEach(({ name, now }, i) => this.seen.push(this.add({ flight: { ...facts, phases: [] }, columns: now, name }, `v${(i + 1) % 6}`, true)));
    this.follows(0);
    this.recolour();
  }

  // One more point of the trail, if it is time for one; nothing is sent to the graphics hardware else.
  grow(one) {
    const { craft, times, trail } = one;
    const time = craft.columns.time_s[PRESENT];
    while (times.length && times[times.length - 1] > time) times.pop(); // gone back
    const back = trail.count > times.length;
    trail.count = times.length;
    if (!(times.length && time < times[times.length - 1] + one.every)) this.extend(one, time);
    else if (back) trail.changed();
  }

  extend(one, time) {
    const at = this.place(one.craft.columns, PRESENT);
    if (!Number.isFinite(at.x)) return;
    if (one.times.length === POINTS) this.thin(one);
    one.times.push(time);
    one.trail.add(at, this.ordered(one.craft.columns, PRESENT), one.tint === "body" ? this.phase(one.craft) : colour(one.tint));
    one.trail.changed();
  }

  phase({ flight, columns }) {
    const flagged = Object.keys(flight.actuators).some((name) => columns[`${name}_failed`][PRESENT] > 0);
    return colour(flagged ? "flagged" : this.broken ? "unnoticed" : "healthy");
  }

  thin(one) {
    one.trail.thin();
    one.times = one.times.filter((_, k) => k % 2 === 0);
    one.every *= 2;
  }

  // The actuator at a point of the picture [px], if there is one.
  at(x, y) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    const hits = this.seen[0].craft.parts.filter((part) => part.actuator).flatMap((part) => this.hit(ray, part));
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

// Whether there is no graphics hardware: smooth edges would take half of the time of a picture.
function drawnByProcessor() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const name = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
  return /swiftshader|llvmpipe|software|basic render/i.test(gl.getParameter(name));
}
