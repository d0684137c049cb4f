// The way of a flight: where it flew, and the height that was ordered there, with what is between them.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Line, LineBasicMaterial, Mesh, MeshBasicMaterial } from "three";

const line = (positions, material) => {
  const made = new Line(new BufferGeometry(), material);
  made.geometry.setAttribute("position", positions);
  made.frustumCulled = false; // its bounds change while it grows
  return made;
};

export class Trail {
  constructor(group, most) {
    const room = (size) => new BufferAttribute(new Float32Array(size * most), 3);
    [this.flown, this.ordered, this.between, this.colours] = [room(3), room(3), room(6), room(3)];
    this.line = line(this.flown, new LineBasicMaterial({ vertexColors: true }));
    this.line.geometry.setAttribute("color", this.colours);
    this.path = line(this.ordered, new LineBasicMaterial({ depthWrite: false })); // where both are the same, one sees the trail
    this.line.renderOrder = 1;
    const sheet = new BufferGeometry();
    sheet.setAttribute("position", this.between);
    sheet.setIndex(Array.from({ length: most - 1 }, (_, k) => [2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 1, 2 * k + 3, 2 * k + 2]).flat());
    this.sheet = new Mesh(sheet, new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.18, depthWrite: false }));
    this.sheet.frustumCulled = false;
    this.group = group;
    group.add(this.line, this.path, this.sheet);
    this.count = 0;
  }

  // One more point: where it is, and the height that is ordered.
  add(at, height, shade) {
    const k = this.count++;
    at.toArray(this.flown.array, 3 * k);
    [at.x, height, at.z].forEach((v, i) => (this.ordered.array[3 * k + i] = v));
    at.toArray(this.between.array, 6 * k);
    [at.x, height, at.z].forEach((v, i) => (this.between.array[6 * k + 3 + i] = v));
    this.shade(k, shade);
  }

  shade(k, shade) {
    new Color(shade).toArray(this.colours.array, 3 * k);
  }

  // To be called when points have changed.
  changed() {
    for (const each of [this.flown, this.ordered, this.between, this.colours]) each.needsUpdate = true;
    this.line.geometry.setDrawRange(0, this.count);
  }

  // What was ordered is drawn for the first points only, those that have been flown.
  orderedUntil(count) {
    this.path.geometry.setDrawRange(0, count);
    this.sheet.geometry.setDrawRange(0, 6 * Math.max(count - 1, 0));
  }

  // Leaves every second point out.
  thin() {
    const arrays = [this.flown, this.ordered, this.colours, this.between].map(({ array }) => [array, array === this.between.array ? 6 : 3]);
    for (const [array, size] of arrays) for (let k = 0; 2 * k < this.count; k++) array.copyWithin(size * k, 2 * size * k, 2 * size * k + size);
    this.count = Math.ceil(this.count / 2);
  }

  remove() {
    this.group.remove(this.line, this.path, this.sheet);
    for (const { geometry } of [this.line, this.path, this.sheet]) geometry.dispose();
  }

  order(colour) {
    this.path.material.color.set(colour);
    this.sheet.material.color.set(colour);
  }
}
