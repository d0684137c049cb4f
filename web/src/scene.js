// The picture in three dimensions: the aircraft of one flight or several with their trails, ground and horizon, and a camera that turns.
import { AmbientLight, DirectionalLight, PerspectiveCamera, Scene as Three, Vector3, WebGLRenderer } from "three";
import { Orbit } from "./camera.js";
import { colour, PHASES } from "./colours.js";
import { Craft } from "./craft.js";
import { lastOf } from "./data.js";
import { FAR_M, Ground } from "./ground.js";
import { Trail } from "./trail.js";

const OPENING_DEG = 40;
const MOST_POINTS = 4000; // of a trail
const LARGER_SPANS = 25;

export class Scene {
  // `flights` is [{flight, columns}], and if there are several, the `name` of each; the first is followed.
  constructor(canvas, flights, antialias = true) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias, alpha: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.three = new Three();
    this.camera = new PerspectiveCamera(OPENING_DEG, 1, 0.05, FAR_M);
    this.orbit = new Orbit(canvas, () => this.draw());
    this.three.add(new AmbientLight(0xffffff, 1.6));
    const sun = new DirectionalLight(0xffffff, 1.8);
    sun.position.set(-3, 10, -4);
    this.three.add(sun);
    const { north_m, altitude_m, east_m } = flights[0].columns;
    this.origin = new Vector3(north_m[0], altitude_m[0], east_m[0]);
    this.ground = new Ground(this.three, -this.origin.y);
    this.seen = flights.map((each, i) => this.add(each, flights.length > 1 ? `v${i % 6}` : "body"));
    this.follows(0);
    this.recolour();
    new ResizeObserver(() => this.draw()).observe(canvas.parentElement);
  }

  add({ flight, columns, name }, tint, faint = false) {
    const craft = new Craft(flight, columns, tint, faint);
    const one = { craft, name, tint, last: lastOf(columns.north_m) };
    this.three.add(craft.group, craft.around);
    if (name) one.label = this.label(name);
    this.track(one);
    return one;
  }

  label(name) {
    const made = Object.assign(document.createElement("span"), { className: "craft", textContent: name });
    this.canvas.parentElement.append(made);
    return made;
  }

  // The trail of a flight that is over.
  track(one) {
    const { craft, last } = one;
    const every = Math.max(1, Math.ceil(last / MOST_POINTS));
    one.rows = Array.from({ length: Math.floor(last / every) + 1 }, (_, k) => k * every);
    one.trail = new Trail(this.three, Math.max(one.rows.length, 2));
    for (const row of one.rows) one.trail.add(this.place(craft.columns, row), this.ordered(craft.columns, row), 0);
  }

  place(columns, row) {
    return new Vector3(columns.north_m[row], columns.altitude_m[row], columns.east_m[row]).sub(this.origin);
  }

  ordered({ altitude_command_m, altitude_m }, row) {
    return (altitude_command_m ?? altitude_m)[row] - this.origin.y;
  }

  recolour() {
    for (const one of this.seen) {
      one.craft.recolour();
      this.shade(one);
      one.trail.order(colour("command"));
      one.trail.changed();
      if (one.label) one.label.style.borderColor = colour(one.tint);
    }
    this.ground.recolour();
    this.draw();
  }

  // The colour of a trail: the phases of a flight that is alone, else its own.
  shade({ craft, tint, rows, trail }) {
    const { time_s } = craft.columns;
    let phase = 0;
    const shades = Object.fromEntries([...PHASES, tint].map((name) => [name, colour(name)]));
    const { phases } = craft.flight;
    rows.forEach((row, k) => {
      while (phase < phases.length - 1 && time_s[row] > phases[phase].until_s + 1e-9) phase += 1;
      trail.shade(k, shades[tint === "body" ? phases[phase].name : tint]);
    });
  }

  follows(i) {
    this.one = this.seen[i];
    for (const each of this.seen) {
      each.trail.sheet.visible = each.trail.path.visible = each === this.one;
      each.craft.needle.visible = false;
    }
  }

  look(view) {
    this.orbit.look(view);
    this.draw();
  }

  show(row) {
    for (const { craft, last } of this.seen) craft.show(Math.min(row, last), this.place(craft.columns, Math.min(row, last)));
    for (const { craft } of this.seen) if (craft !== this.one.craft) craft.needle.visible = false;
    this.one.trail.orderedUntil(this.flown(this.one, row));
    this.draw();
  }

  // How many points of a trail are at or before a row.
  flown({ rows }, row) {
    return Math.min(Math.floor(row / (rows[1] ?? 1)) + 1, rows.length);
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height || !this.one) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const { craft } = this.one;
    const wide = Math.max(1, 1 / this.camera.aspect);
    const [at, span, heading] = this.orbit.view === "whole" ? this.all() : [craft.group.position, craft.reach, craft.heading ?? 0];
    this.orbit.place(this.camera, at, heading, span * wide);
    this.camera.near = 0.05 * this.orbit.distance * span;
    this.enlarge(this.orbit.distance * span);
    this.ground.follow(this.camera.position);
    this.camera.lookAt(at);
    this.camera.updateProjectionMatrix();
    this.sky();
    this.renderer.render(this.three, this.camera);
    this.name(width, height);
  }

  // The sky of the style sheet ends at the horizon, wherever the camera looks.
  sky() {
    const ahead = this.camera.getWorldDirection(new Vector3());
    const far = new Vector3(ahead.x, 0, ahead.z).normalize().multiplyScalar(FAR_M).add(this.camera.position).project(this.camera);
    const down = Math.hypot(ahead.x, ahead.z) < 0.2 ? 0 : 50 * (1 - far.y); // from above there is no sky
    this.canvas.parentElement.style.setProperty("--down", `${Math.min(Math.max(down, 0), 100).toFixed(1)}%`);
  }

  // From far away an aircraft is drawn larger than it is, so that it is seen.
  enlarge(away_m) {
    for (const { craft } of this.seen) craft.group.scale.setScalar(Math.max(1, away_m / (LARGER_SPANS * craft.size)));
  }

  // The middle and the size of all trails, and the heading in which the first one began.
  all() {
    const [low, high] = [new Vector3(Infinity, Infinity, Infinity), new Vector3(-Infinity, -Infinity, -Infinity)];
    for (const { trail } of this.seen) {
      const point = new Vector3();
      for (let k = 0; k < trail.count; k++) {
        point.fromBufferAttribute(trail.flown, k);
        low.min(point);
        high.max(point);
      }
    }
    const size = Math.max(high.distanceTo(low) / 1.8, this.one.craft.size);
    return [low.add(high).multiplyScalar(0.5), size, this.one.craft.columns.heading_deg[0] * (Math.PI / 180)];
  }

  // Puts the name of each flight where it is in the picture.
  name(width, height) {
    for (const { craft, label } of this.seen.filter((one) => one.label)) {
      const at = craft.group.position.clone().add(new Vector3(0, 0.3 * craft.size, 0)).project(this.camera);
      label.hidden = at.z > 1;
      label.style.transform = `translate(${((at.x + 1) / 2) * width}px, ${((1 - at.y) / 2) * height}px)`;
    }
  }
}
