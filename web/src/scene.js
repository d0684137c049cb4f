// The replay in three dimensions: the aircraft with its surfaces, thrust, wind, and the trail behind and before it.
import {
  AmbientLight, ArrowHelper, BufferAttribute, BufferGeometry, CapsuleGeometry, Color, DirectionalLight, DoubleSide, EdgesGeometry,
  GridHelper, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, PerspectiveCamera, Quaternion, RingGeometry,
  Scene as Three, Vector3, WebGLRenderer,
} from "three";
import { attitude, deflection, fromBody } from "./attitude.js";
import { colour, PHASES } from "./colours.js";

const RADIAN = Math.PI / 180;
const GRID_M = 10;

function quad(points) {
  const geometry = new BufferGeometry();
  const at = points.map((p) => fromBody(p));
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(at.flatMap((v) => [v.x, v.y, v.z])), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  geometry.computeVertexNormals();
  return geometry;
}

function shade(value) {
  // Full effect is the fixed colour of a surface; none is the colour of a failure.
  const part = Number.isFinite(value) ? Math.min(Math.max(value, 0), 1) : 0; // what does not follow its command has none of it
  return new Color(colour("failure")).lerp(new Color(colour("whole")), part);
}

export class Scene {
  constructor(canvas, flight, columns) {
    this.flight = flight;
    this.columns = columns;
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.three = new Three();
    this.camera = new PerspectiveCamera(40, 1, 0.05, 5000);
    this.view = "chase";
    this.size = flight.shape.span_m;
    this.three.add(new AmbientLight(0xffffff, 1.6));
    const sun = new DirectionalLight(0xffffff, 1.8);
    sun.position.set(-3, 10, -4);
    this.three.add(sun);
    this.aircraft = new Group();
    this.three.add(this.aircraft);
    this.parts = [];
    this.build();
    this.trail();
    this.grid = null;
    this.recolour();
    new ResizeObserver(() => this.draw()).observe(canvas.parentElement);
  }

  build() {
    for (const { points, actuator, sense } of this.flight.shape.panels) {
      const surface = new Mesh(quad(points), new MeshLambertMaterial({ side: DoubleSide }));
      const edge = new LineSegments(new EdgesGeometry(surface.geometry), new LineBasicMaterial());
      const group = new Group();
      group.add(surface, edge);
      group.matrixAutoUpdate = !actuator;
      const ghost = actuator ? new LineSegments(edge.geometry, new LineBasicMaterial()) : null;
      if (ghost) {
        ghost.matrixAutoUpdate = ghost.visible = false;
        this.aircraft.add(ghost);
      }
      this.aircraft.add(group);
      this.parts.push({ kind: "panel", group, surface, edge, ghost, actuator, points, sense });
    }
    for (const { start, end, radius_m } of this.flight.shape.bodies) {
      const [a, b] = [fromBody(start), fromBody(end)];
      const length = a.distanceTo(b);
      const surface = new Mesh(new CapsuleGeometry(radius_m, Math.max(length - 2 * radius_m, 0.01), 6, 16), new MeshLambertMaterial());
      surface.position.copy(a).add(b).multiplyScalar(0.5);
      surface.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), b.clone().sub(a).normalize());
      this.aircraft.add(surface);
      this.parts.push({ kind: "body", surface });
    }
    for (const { at, diameter_m, actuator } of this.flight.shape.propulsors) {
      const place = fromBody(at);
      const disc = new Mesh(
        new RingGeometry(0.42 * diameter_m, 0.5 * diameter_m, 40),
        new MeshLambertMaterial({ side: DoubleSide, transparent: true, opacity: 0.85 }),
      );
      disc.rotation.y = Math.PI / 2;
      disc.position.copy(place);
      const arrow = new ArrowHelper(new Vector3(1, 0, 0), place, 1, 0xffffff, 0.1 * this.size, 0.06 * this.size);
      this.aircraft.add(disc, arrow);
      this.parts.push({ kind: "propulsor", surface: disc, arrow, actuator });
    }
    this.wind = new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 1, 0xffffff, 0.08 * this.size, 0.05 * this.size);
    this.wind.visible = false;
    this.three.add(this.wind);
  }

  trail() {
    const { time_s, north_m, east_m, altitude_m } = this.columns;
    const positions = new Float32Array(3 * time_s.length);
    this.colours = new Float32Array(3 * time_s.length);
    for (let k = 0; k < time_s.length; k++) {
      positions.set([north_m[k] - north_m[0], altitude_m[k] - altitude_m[0], east_m[k] - east_m[0]], 3 * k);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("color", new BufferAttribute(this.colours, 3));
    this.line = new Line(geometry, new LineBasicMaterial({ vertexColors: true }));
    this.three.add(this.line);
  }

  recolour() {
    const { time_s } = this.columns;
    const shades = Object.fromEntries(PHASES.map((name) => [name, new Color(colour(name))]));
    let k = 0;
    for (const { name, until_s } of this.flight.phases) {
      for (; k < time_s.length && time_s[k] <= until_s + 1e-9; k++) shades[name].toArray(this.colours, 3 * k);
    }
    this.line.geometry.attributes.color.needsUpdate = true;
    for (const part of this.parts) part.surface.material.color.set(colour("body"));
    if (this.grid) this.three.remove(this.grid);
    this.grid = new GridHelper(40 * GRID_M, 40, colour("grid"), colour("grid"));
    this.three.add(this.grid);
    this.wind.setColor(new Color(colour("third")));
    this.draw();
  }

  show(row) {
    this.row = row;
    const c = this.columns;
    const at = new Vector3(c.north_m[row] - c.north_m[0], c.altitude_m[row] - c.altitude_m[0], c.east_m[row] - c.east_m[0]);
    if (!Number.isFinite(at.x + at.y + at.z)) return;
    this.aircraft.position.copy(at);
    this.heading = c.heading_deg[row] * RADIAN;
    this.aircraft.quaternion.copy(attitude(c.roll_deg[row] * RADIAN, c.pitch_deg[row] * RADIAN, this.heading));
    for (const part of this.parts) this.pose(part, row);
    this.grid.position.set(Math.round(at.x / GRID_M) * GRID_M, this.floor(), Math.round(at.z / GRID_M) * GRID_M);
    this.blow(row, at);
    this.draw();
  }

  floor() {
    this.lowest ??= this.columns.altitude_m.reduce((a, b) => (b < a ? b : a), Infinity) - this.columns.altitude_m[0] - 4 * this.size;
    return this.lowest;
  }

  pose(part, row) {
    if (!part.actuator) return;
    const c = this.columns;
    const effect = c[`${part.actuator}_response`][row];
    const believed = this.believed(part.actuator, row, effect);
    part.surface.material.color.copy(shade(effect));
    if (part.kind === "panel") {
      const angle = c[`${part.actuator}_position`][row] * RADIAN;
      const [a, b, , trailing] = part.points;
      part.group.matrix.copy(deflection(a, b, trailing, angle, part.sense));
      part.edge.material.color.copy(shade(believed));
      const commanded = c[`${part.actuator}_command`]?.[row] * RADIAN;
      part.ghost.visible = !Number.isFinite(effect) && Number.isFinite(commanded);
      if (!part.ghost.visible) return;
      part.ghost.material.color.set(colour("command"));
      part.ghost.matrix.copy(deflection(a, b, trailing, commanded, part.sense));
    } else {
      const thrust = c[`${part.actuator}_position`][row] * c[`${part.actuator}_effectiveness`][row];
      const [low, high] = this.flight.actuators[part.actuator].limits;
      const most = Math.max(Math.abs(low), Math.abs(high));
      part.arrow.visible = Math.abs(thrust) > 0.005 * most;
      part.arrow.setDirection(new Vector3(Math.sign(thrust) || 1, 0, 0));
      part.arrow.setLength(Math.max((Math.abs(thrust) / most) * 1.6 * this.size, 1e-3), 0.08 * this.size, 0.05 * this.size);
      part.arrow.setColor(shade(believed));
    }
  }

  // What the controller thinks that an actuator does for its command: nothing where it takes it for broken, else its estimate.
  believed(actuator, row, effect) {
    const word = this.flight.beliefs?.[this.columns[`${actuator}_belief`]?.[row]];
    if (["lost", "held", "reversed", "swings"].includes(word)) return 0;
    return this.flight.estimates ? this.columns[`${actuator}_effectiveness_estimate`][row] : effect;
  }

  blow(row, at) {
    const c = this.columns;
    if (!c.wind_north_m_s) return;
    const wind = new Vector3(c.wind_north_m_s[row], -c.wind_down_m_s[row], c.wind_east_m_s[row]);
    const speed = wind.length();
    this.wind.visible = speed > 0.05;
    if (!this.wind.visible) return;
    this.wind.position.copy(at).add(new Vector3(0, 0.35 * this.size, 0));
    this.wind.setDirection(wind.normalize());
    this.wind.setLength((speed / 5) * this.size, 0.08 * this.size, 0.05 * this.size);
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const at = this.aircraft.position;
    const level = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), -(this.heading ?? 0));
    const far = this.size * Math.max(1, 1 / this.camera.aspect);
    const from = { chase: new Vector3(-1.9 * far, 0.9 * far, 0), side: new Vector3(0, 0.25 * far, 2.4 * far), top: new Vector3(-0.01, 12 * far, 0) };
    this.camera.position.copy(from[this.view].applyQuaternion(level)).add(at);
    this.camera.lookAt(at);
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.three, this.camera);
  }
}
