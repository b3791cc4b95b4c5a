// The arm: a large view, four small ones, and what the four do.

import { ARMS, REACHED, STATES } from "./module.js";
import { Camera } from "./solids.js";
import { paint, reachable } from "./scene.js";
import { chart } from "./chart.js";
import { decide } from "./decision.js";
import { Formulas } from "./formulas.js";

const NAMES = { hybrid: "Hybrid", graph: "Graph", network: "Network", planner: "Planner" };
const LATEST = 2000;
const STEP = 12;
/** Milliseconds for which a decision is shown at least: nobody reads faster, and nothing flickers. */
const SHOWN = 700;
const thousands = number => Math.round(number).toLocaleString("en");

export class ArmView {
  constructor(module, { costs, arm: graph }, colours) {
    Object.assign(this, { module, costs, graph, colours, shown: 0, told: 0, running: true, speed: 4, target: [0, 300, 300], held: null });
    this.camera = new Camera();
    this.ways = ARMS.map(() => []);
    const find = id => document.getElementById(id);
    this.view = find("view");
    this.parts = Object.fromEntries(["driver", "distance", "course", "share", "facts", "run", "decider", "teams"].map(id => [id, find(id)]));
    this.cards = ARMS.map((name, arm) => this.card(find("arms"), name, arm));
    this.formulas = new Formulas(this.parts.teams, graph, true);
    this.pointer();
    this.keys();
    find("another").addEventListener("click", () => this.another());
    find("home").addEventListener("click", () => this.begin(() => module.home()));
    find("gather").addEventListener("click", () => this.begin(() => module.gather()));
    this.parts.run.addEventListener("click", () => this.run(!this.running));
    find("step").addEventListener("click", () => this.step());
    find("speed").addEventListener("input", event => { this.speed = Number(event.target.value); });
    this.select(0);
    this.aim(this.target);
  }

  /** True while any arm is on its way. */
  get busy() {
    return ARMS.some((_, arm) => this.module.view(arm).state < REACHED);
  }

  card(parent, name, arm) {
    const button = document.createElement("button");
    button.className = "arm";
    button.setAttribute("role", "radio");
    button.innerHTML = `<span class="name">${NAMES[name]}<span class="state"></span></span><canvas aria-hidden="true"></canvas>
      <span class="numbers"></span>`;
    button.addEventListener("click", () => this.select(arm));
    button.addEventListener("keydown", event => {
      const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (!by) return;
      event.preventDefault();
      this.select((arm + by + ARMS.length) % ARMS.length);
      this.cards[this.shown].button.focus();
    });
    parent.append(button);
    const part = selector => button.querySelector(selector);
    return { button, canvas: part("canvas"), state: part(".state"), numbers: part(".numbers") };
  }

  select(arm) {
    this.shown = arm;
    this.cards.forEach(({ button }, other) => {
      button.setAttribute("aria-checked", String(other === arm));
      button.tabIndex = other === arm ? 0 : -1;
    });
    this.dirty = true;
  }

  run(running) {
    this.running = running;
    this.parts.run.textContent = running ? "Pause" : "Run";
    this.parts.run.setAttribute("aria-pressed", String(running));
    this.dirty = true;
  }

  /** One action of each arm, to read what decides it. */
  step() {
    this.run(false);
    this.act(1);
  }

  /** A target drawn from the half space in front of and beside the base. */
  another() {
    const angle = 2 * Math.PI * Math.random(), far = 170 + 190 * Math.random();
    this.aim([far * Math.cos(angle), far * Math.sin(angle), 40 + 300 * Math.random()]);
  }

  aim(target) {
    this.target = reachable(target);
    this.begin(() => this.module.aim(...this.target));
  }

  begin(act) {
    act();
    this.ways = ARMS.map((_, arm) => [this.place(arm)]);
    this.dirty = true;
  }

  place(arm) {
    const { points, distance, state } = this.module.view(arm);
    return { point: points[4], distance, driver: STATES[state] in this.colours ? STATES[state] : this.driver(arm) };
  }

  /** The policy that acted last. */
  driver(arm) {
    const { state } = this.module.view(arm);
    return state < REACHED ? STATES[state] : this.ways[arm].at(-1)?.driver ?? (arm === 3 ? "planner" : arm === 2 ? "network" : "graph");
  }

  /** Lets every arm act, and notes the way of its hand. */
  act(count) {
    for (let arm = 0; arm < ARMS.length; arm++) {
      if (this.module.view(arm).state >= REACHED) continue;
      const before = this.module.view(arm).actions;
      this.module.act(arm, count);
      const { actions } = this.module.view(arm), way = this.ways[arm];
      const driver = arm === 3 ? "planner" : actions[1] > before[1] ? "network" : "graph";
      way.push({ ...this.place(arm), driver });
      if (way.length > LATEST) way.splice(1, 1);
      this.dirty = true;
    }
  }

  /** To the end at once: for those who want no motion. */
  finish() {
    while (this.busy) this.act(6);
  }

  frame(still) {
    if (this.running) still ? this.finish() : this.act(this.speed);
    if (!this.dirty) return;
    this.dirty = false;
    const { camera, colours, target } = this;
    const scene = arm => ({ points: this.module.view(arm).points, driver: this.driver(arm), target, ways: this.ways[arm] });
    paint(this.view, camera, colours, { ...scene(this.shown), large: true });
    this.cards.forEach(({ canvas }, arm) => paint(canvas, camera, colours, scene(arm)));
    // The last one to be painted fits the camera: the pointer asks for the large view.
    camera.fit(this.view.width, this.view.height);
    this.tell();
  }

  tell() {
    const { state, distance, actions, pose } = this.module.view(this.shown), { parts } = this;
    const [first, second] = actions, all = first + second, name = ARMS[this.shown], driver = this.driver(this.shown);
    const ended = state > REACHED;
    const words = state === REACHED ? `there after ${all} actions` : ended ? `ended: ${STATES[state]}` : `the ${driver} drives`;
    const badge = `badge ${ended ? "ended" : driver}`;
    if (parts.driver.textContent !== words) parts.driver.textContent = words;
    if (parts.driver.className !== badge) parts.driver.className = badge;
    parts.distance.textContent = distance.toFixed(1);
    const [graph, network] = name === "planner" ? [0, 0] : [first, second];
    parts.share.querySelector(".graph").style.flex = graph;
    parts.share.querySelector(".network").style.flex = network;
    parts.share.style.visibility = name === "planner" ? "hidden" : "visible";
    parts.share.setAttribute("aria-label", `${graph} actions of the graph, ${network} of the network`);
    const percent = part => all ? `${part} (${(100 * part / all).toFixed(0)} %)` : "0";
    const rows = name === "planner" ? [["actions", all]] :
      [["by the graph", percent(graph)], ["by the network", percent(network)]];
    const mean = this.instructions(this.shown);
    rows.push(["instructions each", mean === null ? "not measured" : all ? thousands(mean) : "–"]);
    rows.push(["motors, ticks", pose.join(" ")]);
    parts.facts.innerHTML = rows.map(([what, value]) => `<dt>${what}</dt><dd>${value}</dd>`).join("");
    this.tellDecision();
    chart(parts.course, this.ways[this.shown].map(({ distance, driver }) => [distance, driver]), this.colours);
    this.cards.forEach((card, arm) => this.tellCard(card, arm));
  }

  /** The way of the graph's last decision; while the arm moves, not at every action. */
  tellDecision() {
    const { state, actions, seen } = this.module.view(this.shown), now = performance.now(), { decider, teams } = this.parts;
    const moves = this.running && state < REACHED && this.drawn === this.shown;
    if (moves && now - this.told < SHOWN) return;
    this.told = now;
    this.drawn = this.shown;
    const driver = this.driver(this.shown), acted = actions[0] + actions[1] > 0, lit = acted && driver === "graph";
    teams.classList.toggle("past", !lit);
    if (!acted) decider.textContent = "Nothing has been decided yet.";
    else if (!lit) decider.textContent = `The ${driver} decided: it has no bids.`;
    if (!lit) return;
    const decision = decide(this.graph.table, seen), { teams: all } = this.graph;
    const ways = all.flatMap(({ id, bids }) => bids.map(({ to }) => [id, to.replaceAll("_", " ")]));
    this.decision = decision;
    decider.textContent = [...decision.way.map(edge => `team ${ways[edge][0]}`), ways[decision.way.at(-1)][1]].join(" → ");
    this.formulas.show(decision);
  }

  tellCard({ state, numbers }, arm) {
    const view = this.module.view(arm), all = view.actions[0] + view.actions[1], mean = this.instructions(arm);
    const words = view.state < REACHED ? "" : view.state === REACHED ? "there" : STATES[view.state];
    state.textContent = words;
    state.className = `state ${view.state === REACHED ? "reached" : view.state > REACHED ? "ended" : ""}`;
    const cost = mean === null ? "" : ` · ${all ? thousands(mean) : "–"} instr.`;
    numbers.textContent = `${view.distance.toFixed(1)} mm · ${all} actions${cost}`;
  }

  /** Mean instructions of the actions so far, from the means of each driver; null for the planner. */
  instructions(arm) {
    if (ARMS[arm] === "planner") return null;
    const [graph, network] = this.module.view(arm).actions;
    return (graph * this.costs.graph.mean + network * this.costs.network.mean) / Math.max(1, graph + network);
  }

  pointer() {
    const { view, camera } = this;
    const near = event => {
      const box = view.getBoundingClientRect(), ratio = view.width / box.width, [x, y, zoom] = camera.project(this.target);
      const off = Math.hypot((event.clientX - box.left) * ratio - x, (event.clientY - box.top) * ratio - y);
      return off < Math.max(22 * zoom, 26 * ratio);
    };
    view.addEventListener("pointerdown", event => {
      this.held = near(event) ? "target" : "view";
      this.last = [event.clientX, event.clientY];
      view.setPointerCapture(event.pointerId);
      view.classList.add("held");
    });
    view.addEventListener("pointermove", event => {
      if (!this.held) return view.classList.toggle("near", near(event));
      const [dx, dy] = [event.clientX - this.last[0], event.clientY - this.last[1]];
      this.last = [event.clientX, event.clientY];
      if (this.held === "view") return this.turn(-dx / 180, dy / 220);
      const { right, up } = camera, zoom = camera.project(this.target)[2] * view.clientWidth / view.width;
      this.aim(this.target.map((value, i) => value + (dx * right[i] - dy * up[i]) / zoom));
    });
    const release = () => { this.held = null; view.classList.remove("held"); };
    view.addEventListener("pointerup", release);
    view.addEventListener("pointercancel", release);
    view.addEventListener("wheel", event => {
      if (!event.ctrlKey && !view.matches(":focus")) return;
      event.preventDefault();
      camera.distance = Math.min(2600, Math.max(1100, camera.distance * Math.exp(event.deltaY / 900)));
      this.dirty = true;
    }, { passive: false });
  }

  turn(by, tilt) {
    this.camera.turn += by;
    this.camera.tilt = Math.min(1.35, Math.max(0.06, this.camera.tilt + tilt));
    this.dirty = true;
  }

  keys() {
    this.view.addEventListener("keydown", event => {
      const { right } = this.camera, [fx, fy] = [-right[1], right[0]];
      const ways = {
        ArrowRight: [right[0], right[1], 0], ArrowLeft: [-right[0], -right[1], 0], ArrowUp: [fx, fy, 0], ArrowDown: [-fx, -fy, 0],
        PageUp: [0, 0, 1], PageDown: [0, 0, -1],
      };
      const turns = { ArrowRight: [0.08, 0], ArrowLeft: [-0.08, 0], ArrowUp: [0, 0.06], ArrowDown: [0, -0.06] };
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.shiftKey && turns[event.key]) this.turn(...turns[event.key]);
      else if (ways[event.key]) this.aim(this.target.map((value, i) => value + STEP * ways[event.key][i]));
      else if (event.key === "n" || event.key === "N") this.another();
      else if (event.key === "s" || event.key === "S") this.step();
      else if (event.key === " ") this.run(!this.running);
      else return;
      event.preventDefault();
    });
  }
}
