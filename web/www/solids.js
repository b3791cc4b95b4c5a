// Convex solids in perspective on a 2D canvas: shaded faces, and shadows on the table.

import { add, cross, dot, mix, scale, sub, unit } from "./vector.js";

const LIGHT = unit([0.45, -0.5, 1.1]);

/** A camera that looks at a point from an angle: `turn` about the vertical axis, `tilt` above the table, rad. */
export class Camera {
  constructor() {
    Object.assign(this, { turn: 0.9, tilt: 0.42, distance: 1750, centre: [0, 0, 200] });
  }
  /** Fits the camera to a canvas of that size, in its own pixels. */
  fit(width, height) {
    const [c, s, ct, st] = [Math.cos(this.turn), Math.sin(this.turn), Math.cos(this.tilt), Math.sin(this.tilt)];
    Object.assign(this, { width, height, right: [c, s, 0], up: [-s * st, c * st, ct], into: [-s * ct, c * ct, -st] });
    this.focus = Math.min(width * 1.75, height * 2.2);
    this.eye = add(this.centre, scale(this.into, -this.distance));
  }
  /** Returns place on the canvas and pixels a millimetre. */
  project(point) {
    const from = sub(point, this.centre);
    const zoom = this.focus / (this.distance + dot(from, this.into));
    return [this.width / 2 + dot(from, this.right) * zoom, this.height * 0.55 - dot(from, this.up) * zoom, zoom];
  }
}

/** A box along the way from one point to another; `side` is its axis of width. */
export function box(from, to, side, width, height, colour) {
  const along = sub(to, from), up = unit(cross(side, along));
  const [w, h] = [scale(side, width / 2), scale(up, height / 2)];
  const corner = (end, a, b) => add(end, add(scale(w, a), scale(h, b)));
  const ring = end => [corner(end, -1, -1), corner(end, 1, -1), corner(end, 1, 1), corner(end, -1, 1)];
  return prism(ring(from), ring(to), colour);
}

/** A cylinder about the way from one point to another. */
export function cylinder(from, to, radius, colour, sides = 22) {
  const axis = unit(sub(to, from)), u = unit(cross(axis, Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0])), v = cross(axis, u);
  const ring = end => Array.from({ length: sides }, (_, i) => {
    const angle = 2 * Math.PI * i / sides;
    return add(end, add(scale(u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle))));
  });
  return prism(ring(from), ring(to), colour);
}

function prism(bottom, top, colour) {
  const points = [...bottom, ...top], count = bottom.length;
  const faces = [bottom, top, ...bottom.map((_, i) => [bottom[i], bottom[(i + 1) % count], top[(i + 1) % count], top[i]])];
  const centre = scale(points.reduce(add), 1 / points.length);
  return { points, centre, colour, faces: faces.map(corners => face(corners, centre)) };
}

function face(corners, inside) {
  const middle = scale(corners.reduce(add), 1 / corners.length);
  let normal = unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[1])));
  if (dot(normal, sub(middle, inside)) < 0) normal = scale(normal, -1);
  return { corners, middle, normal };
}

/** Draws solids, the farthest first. No two of them may pass through each other but at joints. */
export function draw(g, camera, solids) {
  const depth = solid => dot(sub(solid.centre, camera.eye), camera.into);
  for (const { faces, colour } of [...solids].sort((a, b) => depth(b) - depth(a))) {
    for (const { corners, middle, normal } of faces) {
      const away = sub(camera.eye, middle);
      if (dot(normal, away) <= 0) continue;
      const glint = Math.max(0, dot(unit(add(LIGHT, unit(away))), normal)) ** 24;
      const light = 0.56 + 0.5 * Math.max(0, dot(normal, LIGHT)) + 0.08 * normal[2];
      g.fillStyle = g.strokeStyle = shade(colour, light, 0.16 * glint);
      path(g, camera, corners);
      g.fill();
      // Closes the hair lines between faces.
      g.lineWidth = 0.7;
      g.stroke();
    }
  }
}

/** Draws the shadows of solids on the table, as one. */
export function shadow(g, camera, solids, colour) {
  g.fillStyle = colour;
  g.beginPath();
  for (const { points } of solids) {
    const ground = points.map(point => sub(point, scale(LIGHT, point[2] / LIGHT[2])));
    hull(ground.map(point => camera.project(point))).forEach(([x, y], i) => i ? g.lineTo(x, y) : g.moveTo(x, y));
    g.closePath();
  }
  g.fill();
}

/** Returns the point on the table that a point's shadow falls on. */
export const shadowOf = point => sub(point, scale(LIGHT, point[2] / LIGHT[2]));

export function path(g, camera, points, close = true) {
  g.beginPath();
  points.map(point => camera.project(point)).forEach(([x, y], i) => i ? g.lineTo(x, y) : g.moveTo(x, y));
  if (close) g.closePath();
}

/** The convex hull of points of a plane, in one direction of turning. */
function hull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  const half = points => points.reduce((chain, point) => {
    while (chain.length > 1 && turn(chain.at(-2), chain.at(-1), point) <= 0) chain.pop();
    return [...chain, point];
  }, []).slice(0, -1);
  return [...half(sorted), ...half(sorted.reverse())];
}

function shade(colour, light, glint) {
  const lit = mix(scale(colour, Math.min(light, 1)), [255, 255, 255], Math.min(0.9, Math.max(0, light - 1) * 0.6 + glint));
  return `rgb(${lit.map(part => Math.round(Math.min(255, part))).join(" ")})`;
}

/** Reads a colour of the style sheet as red, green and blue. */
export function rgb(text) {
  const hex = text.trim().replace("#", "");
  const full = hex.length === 3 ? [...hex].map(digit => digit + digit).join("") : hex;
  return [0, 2, 4].map(place => parseInt(full.slice(place, place + 2), 16));
}
