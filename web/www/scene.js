// One arm with its target and the way of its hand.

import { add, cross, length, mix, scale, sub, unit } from "./vector.js";
import { box, cylinder, draw, path, rgb, shadow, shadowOf } from "./solids.js";

/** Reads the colours of the style sheet: again whenever the scheme changes. */
export function colours() {
  const style = getComputedStyle(document.documentElement), of = name => style.getPropertyValue(`--${name}`).trim();
  const plain = Object.fromEntries(["text", "soft", "floor", "rim", "line", "shadow", "graph", "network", "planner", "target", "ball", "lit", "card", "edge",
    "fill", "dark", "metal"].map(name => [name, of(name)]));
  return { ...plain, solid: Object.fromEntries(["metal", "dark", "graph", "network", "planner"].map(name => [name, rgb(plain[name])])) };
}

/** The solids of an arm whose joints are at these points; its joints have the colour of whoever drives. */
function solids(points, colours, driver) {
  const [shoulder, bracket, elbow, wrist, tip] = points, { metal, dark } = colours.solid, accent = colours.solid[driver];
  const side = unit(cross(sub(bracket, shoulder), sub(elbow, bracket)));
  const across = (point, half, radius, colour) =>
    cylinder(sub(point, scale(side, half)), add(point, scale(side, half)), radius, colour);
  const hand = sub(tip, wrist), knuckle = add(wrist, scale(hand, 0.52)), finger = offset => {
    const by = scale(side, offset);
    return box(add(knuckle, by), add(tip, by), side, 6, 13, dark);
  };
  const palm = add(wrist, scale(hand, 0.1));
  return [
    cylinder([0, 0, 0], [0, 0, 26], 82, dark, 36),
    cylinder([0, 0, 26], [0, 0, shoulder[2] - 34], 50, metal, 30),
    box([0, 0, shoulder[2] - 36], [0, 0, shoulder[2] + 4], side, 66, 44, dark),
    across(shoulder, 37, 25, accent),
    box(shoulder, bracket, side, 40, 32, metal),
    box(mix(shoulder, bracket, 0.86), add(bracket, scale(unit(sub(bracket, shoulder)), 14)), side, 46, 36, dark),
    box(bracket, elbow, side, 36, 30, metal),
    across(elbow, 31, 22, accent),
    box(elbow, wrist, side, 34, 27, metal),
    across(wrist, 25, 18, accent),
    box(palm, knuckle, side, 38, 26, metal),
    finger(-13), finger(13),
  ];
}

/** Draws a scene into a canvas; `ways` are the places of the hand, each with the driver that led there. */
export function paint(canvas, camera, colours, { points, driver, target, ways, large, balls = [] }) {
  const g = canvas.getContext("2d"), ratio = Math.min(devicePixelRatio || 1, 2);
  const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio].map(Math.round);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  if (!width || !height) return;
  camera.fit(width, height);
  g.clearRect(0, 0, width, height);
  table(g, camera, colours, large);
  const arm = solids(points, colours, driver);
  shadow(g, camera, arm, colours.shadow);
  for (const { at, radius } of balls) disc(g, camera, shadowOf(at), radius, colours.shadow);
  plumb(g, camera, colours, target);
  trace(g, camera, colours, ways, true);
  // What lies behind the arm is drawn before it.
  const near = point => camera.into.reduce((sum, part, i) => sum + part * point[i], 0);
  const behind = near(target) > near(points[4]), middle = near(mix(points[2], points[4], 0.5));
  const obstacles = [...balls].sort((a, b) => near(b.at) - near(a.at));
  const paintBalls = back => obstacles.filter(({ at }) => near(at) > middle === back)
    .forEach(({ at, radius }) => ball(g, camera, colours.ball, at, radius));
  paintBalls(true);
  if (behind) ball(g, camera, colours.target, target);
  draw(g, camera, arm);
  trace(g, camera, colours, ways, false);
  paintBalls(false);
  if (!behind) return ball(g, camera, colours.target, target);
  // A ring tells where the target is behind the arm.
  const [x, y, zoom] = camera.project(target);
  g.beginPath();
  g.arc(x, y, 15 * zoom, 0, 7);
  g.strokeStyle = colours.target;
  g.lineWidth = 1.5 * zoom;
  g.stroke();
}

const circle = (radius, count = 72) => Array.from({ length: count }, (_, i) => {
  const angle = 2 * Math.PI * i / count;
  return [radius * Math.cos(angle), radius * Math.sin(angle), 0];
});

function table(g, camera, colours, large) {
  const [x, y, zoom] = camera.project([0, 0, 0]);
  const light = g.createRadialGradient(x, y, 0, x, y, 540 * zoom);
  light.addColorStop(0, colours.floor);
  light.addColorStop(1, colours.rim);
  path(g, camera, circle(500));
  g.fillStyle = light;
  g.fill();
  g.strokeStyle = colours.line;
  g.lineWidth = zoom * 1.6;
  for (const radius of [125, 250, 375, 500]) {
    path(g, camera, circle(radius));
    g.stroke();
  }
  if (!large) return;
  for (let spoke = 0; spoke < 12; spoke++) {
    const [c, s] = [Math.cos(spoke * Math.PI / 6), Math.sin(spoke * Math.PI / 6)];
    path(g, camera, [[125 * c, 125 * s, 0], [500 * c, 500 * s, 0]], false);
    g.stroke();
  }
}

/** The plumb line of the target, and its shadow. */
function plumb(g, camera, colours, target) {
  const foot = [target[0], target[1], 0], zoom = camera.project(shadowOf(target))[2];
  disc(g, camera, shadowOf(target), 15, colours.shadow);
  path(g, camera, [target, foot], false);
  g.strokeStyle = colours.target;
  g.globalAlpha = 0.55;
  g.lineWidth = 2 * zoom;
  g.setLineDash([9 * zoom, 7 * zoom]);
  g.stroke();
  g.setLineDash([]);
  const [x, y] = camera.project(foot);
  g.beginPath();
  g.ellipse(x, y, 9 * zoom, 9 * zoom * Math.max(0.2, Math.sin(camera.tilt)), 0, 0, 7);
  g.stroke();
  g.globalAlpha = 1;
}

/** A round shadow on the table. */
function disc(g, camera, place, size, colour) {
  const [x, y, zoom] = camera.project(place), radius = size * zoom;
  g.fillStyle = colour;
  g.beginPath();
  g.ellipse(x, y, radius, radius * Math.max(0.2, Math.sin(camera.tilt)), 0, 0, 7);
  g.fill();
}

function ball(g, camera, colour, place, size = 15) {
  const [x, y, zoom] = camera.project(place), radius = size * zoom, [red, green, blue] = rgb(colour);
  const light = g.createRadialGradient(x - radius * 0.35, y - radius * 0.4, radius * 0.1, x, y, radius);
  light.addColorStop(0, "#fff");
  light.addColorStop(0.28, `rgb(${red} ${green} ${blue})`);
  light.addColorStop(1, `rgb(${red * 0.62} ${green * 0.62} ${blue * 0.62})`);
  g.beginPath();
  g.arc(x, y, radius, 0, 7);
  g.fillStyle = light;
  g.fill();
}

/** The way of the hand, in the colour of who drove; on the table its shadow. */
function trace(g, camera, colours, ways, ground) {
  g.lineJoin = g.lineCap = "round";
  for (let from = 0; from + 1 < ways.length;) {
    let to = from + 1;
    while (to + 1 < ways.length && ways[to + 1].driver === ways[to].driver) to++;
    const part = ways.slice(from, to + 1).map(({ point }) => ground ? shadowOf(point) : point);
    path(g, camera, part, false);
    g.strokeStyle = ground ? colours.shadow : colours[ways[to].driver];
    g.lineWidth = (ground ? 2 : 3.4) * camera.project(part[0])[2];
    g.globalAlpha = ground ? 0.5 : 0.85;
    g.stroke();
    from = to;
  }
  g.globalAlpha = 1;
}

/** Keeps a target where the arm may hope to reach it: above the table, outside of the base, within 440 mm of the shoulder. */
export function reachable(target) {
  let [x, y, z] = target;
  z = Math.max(15, z);
  const flat = Math.hypot(x, y) || 1, least = z < 170 ? 150 : 0;
  if (flat < least) [x, y] = [x * least / flat, y * least / flat];
  const from = sub([x, y, z], [0, 0, 125]), far = length(from);
  return far > 440 ? add([0, 0, 125], scale(from, 440 / far)).map((value, i) => i === 2 ? Math.max(15, value) : value) : [x, y, z];
}
