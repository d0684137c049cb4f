// What is around the aircraft: ground up to a horizon, with a grid whose cells fit the height of the eye above it. The sky is the style
// sheet's, behind the canvas: filling it here would take half of the time of a picture where there is no graphics hardware.
import { BufferAttribute, BufferGeometry, Color, Fog, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, PlaneGeometry } from "three";
import { colour } from "./colours.js";

export const FAR_M = 60000;
const CELLS = 60; // of the grid, to each side half of them

// Lines of unit cells, each in short pieces: some drivers drop a line that begins far behind the eye.
function lines() {
  const half = CELLS / 2;
  const points = [];
  for (let i = -half; i <= half; i++) for (let j = -half; j < half; j++) points.push(i, 0, j, i, 0, j + 1, j, 0, i, j + 1, 0, i);
  return new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
}

export class Ground {
  constructor(three, level) {
    this.three = three;
    this.level = level;
    this.plane = new Mesh(new PlaneGeometry(2 * FAR_M, 2 * FAR_M).rotateX(-Math.PI / 2), new MeshBasicMaterial({ depthWrite: false }));
    this.grid = new LineSegments(lines(), new LineBasicMaterial({ depthWrite: false }));
    [this.plane.renderOrder, this.grid.renderOrder] = [-2, -1];
    three.fog = new Fog(0, 300, FAR_M);
    three.add(this.plane, this.grid);
  }

  recolour() {
    this.three.fog.color.copy(new Color(colour("horizon")));
    this.plane.material.color.set(colour("ground"));
    this.grid.material.color.set(colour("ground-line"));
  }

  // Keeps everything below the eye, and the eye above the ground.
  follow(eye) {
    eye.y = Math.max(eye.y, this.level + 0.3);
    const height = Math.max(eye.y - this.level, 1);
    const cell = 10 ** Math.round(Math.log10(0.5 * height));
    const snapped = (v) => Math.round(v / cell) * cell;
    this.grid.scale.setScalar(cell);
    this.grid.position.set(snapped(eye.x), this.level, snapped(eye.z));
    this.plane.position.set(eye.x, this.level, eye.z);
    this.three.fog.near = 3 * height;
    this.three.fog.far = 0.45 * CELLS * cell;
  }
}
