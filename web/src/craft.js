// One aircraft as its shape says, posed by a row of its flight's columns: what is true in its surfaces, what is believed at their edges.
import {
  ArrowHelper, BufferAttribute, BufferGeometry, CapsuleGeometry, CircleGeometry, Color, DoubleSide, EdgesGeometry, Group, LineBasicMaterial,
  LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, PlaneGeometry, RingGeometry, Vector3,
} from "three";
import { attitude, deflection, fromBody } from "./attitude.js";
import { colour } from "./colours.js";

const RADIAN = Math.PI / 180;
const FASTEST_RPS = 7; // as propellers are drawn: faster ones would seem to stand
const SEEN_DEG = 1; // a surface that is this far from its command has a ghost
const GHOST_CHORD = 2.5; // so long that one sees it beside the surface

function quad(points) {
  const geometry = new BufferGeometry();
  const at = points.map((p) => fromBody(p));
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(at.flatMap((v) => [v.x, v.y, v.z])), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  geometry.computeVertexNormals();
  return geometry;
}

// A surface of which the trailing edge is further from the hinge.
function longer([a, b, c, d]) {
  const further = (hinge, edge) => edge.map((v, i) => hinge[i] + GHOST_CHORD * (v - hinge[i]));
  return [a, b, further(b, c), further(a, d)];
}

function shade(value) {
  // Full effect is the fixed colour of a surface; none is the colour of a failure.
  const part = Number.isFinite(value) ? Math.min(Math.max(value, 0), 1) : 0; // what does not follow its command has none of it
  return new Color(colour("failure")).lerp(new Color(colour("whole")), part);
}

export class Craft {
  // `tint` is the colour of its body, of several in one picture; `faint` makes it one that is not there.
  constructor(flight, columns, tint = "body", faint = false) {
    Object.assign(this, { flight, columns, tint, faint });
    this.size = flight.shape.span_m;
    this.reach = Math.max(this.size, ...flight.shape.bodies.map(({ start, end }) => Math.abs(start[0] - end[0])));
    this.group = new Group();
    this.parts = [];
    const { panels, bodies, propulsors } = flight.shape;
    panels.forEach((panel) => this.panel(panel));
    bodies.forEach((body) => this.body(body));
    propulsors.forEach((propulsor) => this.propulsor(propulsor));
    this.wind = this.arrow(0.08);
    this.needle = this.arrow(0.06);
    this.around = new Group().add(this.wind, this.needle);
  }

  material(about = {}) {
    return new MeshLambertMaterial(this.faint ? { side: DoubleSide, transparent: true, opacity: 0.45, ...about } : { side: DoubleSide, ...about });
  }

  arrow(head) {
    const made = new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 1, 0xffffff, head * this.size, 0.6 * head * this.size);
    made.visible = false;
    return made;
  }

  panel({ points, actuator, sense }) {
    const surface = new Mesh(quad(points), this.material());
    const edge = new LineSegments(new EdgesGeometry(surface.geometry), new LineBasicMaterial());
    const group = new Group().add(surface, edge);
    group.matrixAutoUpdate = !actuator;
    const ghost = actuator && !this.faint ? new Mesh(quad(longer(points)), new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.55, depthWrite: false })) : null;
    if (ghost) {
      ghost.add(new LineSegments(new EdgesGeometry(ghost.geometry), new LineBasicMaterial()));
      ghost.matrixAutoUpdate = ghost.visible = false;
      this.group.add(ghost);
    }
    this.group.add(group);
    this.parts.push({ kind: "panel", group, surface, edge, ghost, actuator, points, sense });
  }

  body({ start, end, radius_m }) {
    const [a, b] = [fromBody(start), fromBody(end)];
    const length = a.distanceTo(b);
    const surface = new Mesh(new CapsuleGeometry(radius_m, Math.max(length - 2 * radius_m, 0.01), 6, 16), this.material());
    surface.position.copy(a).add(b).multiplyScalar(0.5);
    surface.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), b.clone().sub(a).normalize());
    this.group.add(surface);
    this.parts.push({ kind: "body", surface });
  }

  // A ring in the colour of what is true; within it the blades of a propeller.
  propulsor({ at, diameter_m, actuator, jet }) {
    const surface = new Mesh(new RingGeometry(0.44 * diameter_m, 0.5 * diameter_m, 40), this.material({ transparent: true, opacity: this.faint ? 0.4 : 0.85 }));
    const blades = new Group();
    const haze = new Mesh(new CircleGeometry(0.44 * diameter_m, 32), new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.16, depthWrite: false }));
    if (!jet) blades.add(new Mesh(new PlaneGeometry(0.075 * diameter_m, 0.92 * diameter_m), this.material()), haze);
    const disc = new Group().add(surface, blades);
    disc.rotation.y = Math.PI / 2;
    disc.position.copy(fromBody(at));
    const arrow = this.arrow(0.08);
    arrow.position.copy(disc.position);
    this.group.add(disc, arrow);
    this.parts.push({ kind: "propulsor", surface, blades, haze, arrow, actuator });
  }

  recolour() {
    for (const { kind, surface, blades, edge } of this.parts) {
      edge?.material.color.set(colour("muted"));
      surface.material.color.set(colour(kind === "propulsor" ? "whole" : this.tint));
      blades?.children.forEach((blade) => blade.material.color.set(colour("text")));
    }
    this.wind.setColor(new Color(colour("third")));
    this.needle.setColor(new Color(colour("command")));
  }

  // Poses it as in a row, at a place in the picture; false if there is nothing to show.
  show(row, at) {
    if (!Number.isFinite(at.x + at.y + at.z)) return false;
    const c = this.columns;
    this.group.position.copy(at);
    this.heading = c.heading_deg[row] * RADIAN;
    this.group.quaternion.copy(attitude(c.roll_deg[row] * RADIAN, c.pitch_deg[row] * RADIAN, this.heading));
    const passed = Math.min(Math.abs(c.time_s[row] - (this.time ?? c.time_s[row])), 0.1);
    this.time = c.time_s[row];
    for (const part of this.parts) if (part.actuator) this.pose(part, row, passed);
    this.blow(row, at);
    this.point(row, at);
    return true;
  }

  pose(part, row, passed) {
    const effect = this.columns[`${part.actuator}_response`][row];
    const believed = this.believed(part.actuator, row, effect);
    part.surface.material.color.copy(shade(effect));
    if (part.kind === "panel") this.deflect(part, row, effect, believed);
    else this.push(part, row, believed, passed);
  }

  deflect(part, row, effect, believed) {
    const [a, b, , trailing] = part.points;
    const turned = (deg) => deflection(a, b, trailing, deg * RADIAN, part.sense);
    const [position, commanded] = ["position", "command"].map((what) => this.columns[`${part.actuator}_${what}`]?.[row]);
    part.group.matrix.copy(turned(position));
    part.edge.material.color.copy(shade(believed));
    if (!part.ghost) return;
    part.ghost.visible = !(effect > 0.99) && Math.abs(commanded - position) > SEEN_DEG;
    if (!part.ghost.visible) return;
    part.ghost.material.color.set(colour("command"));
    part.ghost.children[0].material.color.set(colour("text"));
    part.ghost.matrix.copy(turned(commanded));
  }

  push({ actuator, arrow, blades, haze }, row, believed, passed) {
    const left = this.columns[`${actuator}_effectiveness`][row];
    const thrust = this.columns[`${actuator}_position`][row] * left;
    blades.visible = left > 0; // a propeller that is lost is not there
    const [low, high] = this.flight.actuators[actuator].limits;
    const share = thrust / Math.max(Math.abs(low), Math.abs(high));
    blades.rotation.z -= 2 * Math.PI * FASTEST_RPS * Math.sqrt(Math.min(Math.abs(share), 1)) * passed;
    haze.visible = arrow.visible = Math.abs(share) > 0.005;
    arrow.setDirection(new Vector3(Math.sign(thrust) || 1, 0, 0));
    arrow.setLength(Math.max(Math.abs(share) * 1.6 * this.size, 1e-3), 0.08 * this.size, 0.05 * this.size);
    arrow.setColor(shade(believed));
  }

  // What the controller thinks that an actuator does for its command: nothing where it takes it for broken, else its estimate.
  believed(actuator, row, effect) {
    const word = this.flight.beliefs?.[this.columns[`${actuator}_belief`]?.[row]];
    if (["lost", "held", "reversed", "swings"].includes(word)) return 0;
    return this.flight.estimates ? this.columns[`${actuator}_effectiveness_estimate`][row] : effect;
  }

  blow(row, at) {
    const c = this.columns;
    if (!c.wind_north_m_s || this.faint) return;
    const wind = new Vector3(c.wind_north_m_s[row], -c.wind_down_m_s[row], c.wind_east_m_s[row]);
    const speed = wind.length();
    this.wind.visible = speed > 0.05;
    if (!this.wind.visible) return;
    this.wind.position.copy(at).add(new Vector3(0, 0.35 * this.size, 0));
    this.wind.setDirection(wind.normalize());
    this.wind.setLength((speed / 5) * this.size, 0.08 * this.size, 0.05 * this.size);
  }

  // A needle to the heading that is ordered.
  point(row, at) {
    const ordered = this.columns.heading_command_deg?.[row] * RADIAN;
    this.needle.visible = !this.faint && Number.isFinite(ordered);
    if (!this.needle.visible) return;
    this.needle.position.copy(at);
    this.needle.setDirection(new Vector3(Math.cos(ordered), 0, Math.sin(ordered)));
    this.needle.setLength(1.1 * this.size, 0.06 * this.size, 0.036 * this.size);
  }
}
