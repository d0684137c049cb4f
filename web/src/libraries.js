// All that the pages use of other people's work, built once: a page's own script stands behind it and finds it in `libraries`.
export {
  AmbientLight, ArrowHelper, BufferAttribute, BufferGeometry, CapsuleGeometry, CircleGeometry, Color, DirectionalLight, DoubleSide,
  EdgesGeometry, Euler, Fog, Group, Line, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  PerspectiveCamera, PlaneGeometry, Quaternion, Raycaster, RingGeometry, Scene, Sphere, Vector2, Vector3, WebGLRenderer,
} from "three";
export { default as uPlot } from "uplot";
export { unzlibSync } from "fflate";
