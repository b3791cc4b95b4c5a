// Two arms among the same moving balls: the shipped policy's, and one that walks straight to its target.

import { Camera } from "./solids.js";
import { paint } from "./scene.js";

const NAMES = ["Policy", "Straight walk"];
const ENDS = ["", "there", "hit by a ball", "out of time"];
const REACHED = 1;
// Steps in each picture: a step is 3 ticks a joint at most.
const SPEED = 2;
const thousands = number => number.toLocaleString("en");

export class Balls {
  constructor(module, { scenes, behaviours, worst }, colours, still) {
    Object.assign(this, { module, scenes, behaviours, worst, colours, scene: 0, running: !still });
    const parent = document.getElementById("balls"), find = id => document.getElementById(id);
    this.cards = NAMES.map(name => this.card(parent, name));
    this.button = find("run-balls");
    this.button.addEventListener("click", () => this.run(!this.running));
    find("next-scene").addEventListener("click", () => this.begin((this.scene + 1) % this.scenes.length));
    this.run(this.running);
    this.begin(0);
  }

  /** True while an arm is on its way. */
  get busy() {
    return NAMES.some((_, arm) => this.module.view(arm).state === 0);
  }

  card(parent, name) {
    const stage = document.createElement("div");
    stage.className = "stage";
    stage.innerHTML = `<canvas role="img" aria-label="${name} among moving balls"></canvas><p class="badge" role="status"></p>
      <p class="numbers"></p>`;
    parent.append(stage);
    const part = selector => stage.querySelector(selector), camera = new Camera();
    return { name, camera, stage, canvas: part("canvas"), badge: part(".badge"), numbers: part(".numbers") };
  }

  run(running) {
    this.running = running;
    this.button.textContent = running ? "Pause" : "Run";
    this.button.setAttribute("aria-pressed", String(running));
  }

  begin(scene) {
    this.scene = scene;
    this.module.begin(this.scenes[scene]);
    this.ways = NAMES.map((_, arm) => [this.place(arm)]);
    this.dirty = true;
  }

  place(arm) {
    return { point: this.module.view(arm).points[4], driver: driver(arm) };
  }

  act() {
    NAMES.forEach((_, arm) => {
      if (this.module.view(arm).state !== 0) return;
      for (let step = 0; step < SPEED; step++) this.module.act(arm);
      this.ways[arm].push(this.place(arm));
      this.dirty = true;
    });
  }

  frame(still) {
    if (this.running) {
      if (still) while (this.busy) this.act();
      else if (this.cards.some(({ stage }) => visible(stage))) this.act();
    }
    if (!this.dirty) return;
    this.dirty = false;
    const { target } = this.scenes[this.scene];
    this.cards.forEach((card, arm) => {
      const view = this.module.view(arm), ways = this.ways[arm];
      paint(card.canvas, card.camera, this.colours, { ...view, driver: driver(arm), target, ways, large: true });
      this.tell(card, view, arm);
    });
  }

  tell({ name, badge, numbers }, { state, steps, distance, clearance, behaviour }, arm) {
    const doing = state === 0 ? this.behaviours[behaviour].replaceAll("_", " ") : ENDS[state];
    const words = steps === 0 ? name : `${name}: ${doing}`;
    if (badge.textContent !== words) badge.textContent = words;
    badge.className = `badge ${state === 0 ? driver(arm) : state === REACHED ? "reached" : "ended"}`;
    const cost = arm === 0 ? ` · at most ${thousands(this.worst)} instructions a step` : "";
    numbers.textContent = `${steps} steps · ${distance.toFixed(0)} mm to the target · nearest ball ${clearance.toFixed(0)} mm${cost}`;
  }
}

const driver = arm => arm === 0 ? "graph" : "planner";

/** True if a part of an element is to be seen: nobody misses the first scene. */
function visible(element) {
  const { top, bottom } = element.getBoundingClientRect();
  return bottom > 0 && top < innerHeight;
}
