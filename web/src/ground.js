// What is around the aircraft: sky with a horizon, and ground with a grid whose cells fit the height of the eye above it.
import { BackSide, BufferAttribute, CanvasTexture, Color, Fog, Mesh, MeshBasicMaterial, PlaneGeometry, RepeatWrapping, SphereGeometry, SRGBColorSpace } from "three";
import { colour } from "./colours.js";

export const FAR_M = 60000;
const WIDE_M = 1.2 * FAR_M;
const PIXELS = 512; // of a cell

export class Ground {
  constructor(three, level, sharpest) {
    this.three = three;
    this.level = level;
    const sphere = new SphereGeometry(0.9 * FAR_M, 16, 32);
    sphere.setAttribute("color", new BufferAttribute(new Float32Array(3 * sphere.attributes.position.count), 3));
    this.sky = new Mesh(sphere, new MeshBasicMaterial({ vertexColors: true, side: BackSide, depthWrite: false, fog: false }));
    this.canvas = Object.assign(document.createElement("canvas"), { width: PIXELS, height: PIXELS });
    this.texture = new CanvasTexture(this.canvas);
    Object.assign(this.texture, { wrapS: RepeatWrapping, wrapT: RepeatWrapping, anisotropy: sharpest, colorSpace: SRGBColorSpace });
    this.plane = new Mesh(new PlaneGeometry(WIDE_M, WIDE_M).rotateX(-Math.PI / 2), new MeshBasicMaterial({ map: this.texture, depthWrite: false }));
    [this.sky.renderOrder, this.plane.renderOrder] = [-3, -2];
    three.fog = new Fog(0, 300, 0.6 * FAR_M);
    three.add(this.sky, this.plane);
  }

  recolour() {
    const [horizon, zenith] = [new Color(colour("horizon")), new Color(colour("sky"))];
    const { position, color } = this.sky.geometry.attributes;
    for (let k = 0; k < position.count; k++) {
      const height = Math.max(position.getY(k) / (0.9 * FAR_M), 0);
      horizon.clone().lerp(zenith, Math.sqrt(height)).toArray(color.array, 3 * k);
    }
    color.needsUpdate = true;
    this.three.fog.color.copy(horizon);
    this.divide();
  }

  // One cell with ten times ten smaller ones.
  divide() {
    const g = this.canvas.getContext("2d");
    g.fillStyle = colour("ground");
    g.fillRect(0, 0, PIXELS, PIXELS);
    g.strokeStyle = colour("ground-line");
    for (let k = 0; k <= 10; k++) {
      g.lineWidth = k % 10 ? 2 : 5;
      const at = (k * PIXELS) / 10;
      g.beginPath();
      g.moveTo(at, 0);
      g.lineTo(at, PIXELS);
      g.moveTo(0, at);
      g.lineTo(PIXELS, at);
      g.stroke();
    }
    this.texture.needsUpdate = true;
  }

  // Keeps everything below the eye, and the eye above the ground.
  follow(eye) {
    eye.y = Math.max(eye.y, this.level + 0.3);
    const height = Math.max(eye.y - this.level, 1);
    const cell = 10 ** Math.ceil(Math.log10(height));
    this.texture.repeat.set(WIDE_M / cell, WIDE_M / cell);
    const snapped = (v) => Math.round(v / cell) * cell;
    this.plane.position.set(snapped(eye.x), this.level, snapped(eye.z));
    this.sky.position.copy(eye);
    this.three.fog.near = 3 * height;
    this.three.fog.far = Math.min(Math.max(0.2 * FAR_M, 80 * height), 0.5 * FAR_M);
  }
}
