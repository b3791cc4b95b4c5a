// CartPole, Pendulum and MountainCar: drawn from the state, pushed by buttons. No dynamics here: those are the module's.

import { decide } from "./decision.js";
import { Formulas } from "./formulas.js";

/** The page's additions to each problem: its rhythm, its pushes, its sliders, its drawing. */
const PROBLEMS = [
  {
    seconds: 0.02, unit: "actions upright",
    pushes: [["Push left", 3, -0.6], ["Push right", 3, 0.6], ["Kick cart", 1, 1]],
    sliders: [["Half length", 0.5, 0.1, 2.5, 0.05, "m"], ["Force", 10, 2, 30, 0.5, "N"]],
    draw: drawCart, ended: "fallen",
  },
  {
    seconds: 0.05, unit: "return",
    pushes: [["Spin left", 1, 4], ["Spin right", 1, -4]],
    sliders: [["Mass", 1, 0.3, 2.5, 0.05, "kg"], ["Length", 1, 0.5, 1.6, 0.05, "m"]],
    draw: drawPendulum, ended: "ended",
  },
  {
    seconds: 1 / 30, unit: "return",
    pushes: [["Push left", 1, -0.03], ["Push right", 1, 0.03]],
    sliders: [["Force", 0.001, 0.0005, 0.002, 0.00005, ""], ["Slope", 0.0025, 0.001, 0.004, 0.0001, ""]],
    draw: drawCar, ended: "at the goal",
  },
];

export class Control {
  constructor(parent, module, data, number, colours, still) {
    Object.assign(this, { module, data, colours, owed: 0, seed: 1, running: !still, rest: 0, decision: null }, PROBLEMS[number]);
    this.values = this.sliders.map(([, value]) => value);
    const article = document.createElement("article");
    article.className = "problem";
    article.innerHTML = `<div class="head"><h3>${data.title}</h3><span class="score" aria-live="off"></span></div>
      <canvas role="img" aria-label="${data.title}, driven by its policy"></canvas>
      <div class="row"></div><div class="sliders"></div><div class="formulas"></div>
      <p class="note">${data.size}. On real Gymnasium, 1,000 unseen episodes: ${data.result}.</p>
      <details><summary>The C that drives it</summary><pre tabindex="0"></pre></details>`;
    parent.append(article);
    this.canvas = article.querySelector("canvas");
    this.score = article.querySelector(".score");
    article.querySelector("pre").textContent = data.code;
    this.formulas = new Formulas(article.querySelector(".formulas"), data);
    this.buttons(article.querySelector(".row"));
    this.knobs(article.querySelector(".sliders"));
    this.now = this.before = module.view();
    new IntersectionObserver(entries => { this.visible = entries.at(-1).isIntersecting; }).observe(this.canvas);
    this.dirty = true;
  }

  buttons(row) {
    const add = (text, act) => {
      const button = document.createElement("button");
      button.textContent = text;
      button.addEventListener("click", act);
      row.append(button);
      return button;
    };
    for (const [text, value, by] of this.pushes) add(text, () => this.push(value, by));
    add("New start", () => this.restart());
    const run = add(this.running ? "Pause" : "Run", () => {
      this.running = !this.running;
      run.textContent = this.running ? "Pause" : "Run";
    });
    add("Step", () => { this.act(); this.before = this.now; });
  }

  knobs(parent) {
    this.sliders.forEach(([name, value, least, most, step, unit], constant) => {
      const label = document.createElement("label");
      label.className = "slider";
      label.innerHTML = `<span>${name}</span><input type="range" min="${least}" max="${most}" step="${step}" value="${value}"><output></output>`;
      const [input, output] = [label.querySelector("input"), label.querySelector("output")];
      const show = () => { output.textContent = `${Number(input.value)} ${unit}`; };
      input.addEventListener("input", () => {
        this.values[constant] = Number(input.value);
        this.module.set(constant, this.values[constant]);
        show();
        this.dirty = true;
      });
      show();
      parent.append(label);
    });
  }

  push(value, by) {
    if (this.now.ended) this.restart();
    this.module.push(value, by);
    this.before = this.now = this.module.view();
    this.dirty = true;
  }

  restart() {
    this.module.restart(++this.seed);
    this.before = this.now = this.module.view();
    this.rest = 0;
    this.dirty = true;
  }

  act() {
    if (this.now.ended) return this.restart();
    this.before = this.now;
    this.module.act();
    this.now = this.module.view();
    this.decision = decide(this.data.table, this.now.seen);
    this.formulas.show(this.decision);
    this.dirty = true;
  }

  frame(seconds) {
    if (!this.visible) return;
    if (this.running && this.now.ended) {
      this.rest += seconds;
      if (this.rest > 1.6) this.restart();
    } else if (this.running) {
      this.owed = Math.min(this.owed + seconds, 0.2);
      while (this.owed >= this.seconds) {
        this.owed -= this.seconds;
        this.act();
      }
      this.dirty = true;
    }
    if (!this.dirty) return;
    this.dirty = false;
    const part = this.running && !this.now.ended ? this.owed / this.seconds : 1;
    const state = this.before.state.map((value, i) => value + (this.now.state[i] - value) * part);
    this.paint(state);
    const { score, lastScore, ended } = this.now, last = Number.isNaN(lastScore) ? "" : ` · last ${lastScore.toFixed(0)}`;
    const text = `${ended ? `${PROBLEM_END(this)} · ` : ""}${this.unit} ${score.toFixed(0)}${last}`.replaceAll("-", "−");
    if (this.score.textContent !== text) this.score.textContent = text;
  }

  paint(state) {
    const { canvas, colours } = this, g = canvas.getContext("2d"), ratio = Math.min(devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!width || !height) return;
    if (canvas.width !== Math.round(width * ratio)) Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    g.lineCap = g.lineJoin = "round";
    this.draw(g, colours, { width, height, state, action: this.now.action, values: this.values, acted: this.decision !== null });
  }
}

const PROBLEM_END = control => control.now.ended ? PROBLEMS.find(problem => problem.draw === control.draw).ended : "";

function arrow(g, colour, x, y, way) {
  if (!way) return;
  g.strokeStyle = g.fillStyle = colour;
  g.lineWidth = 4;
  g.beginPath();
  g.moveTo(x, y);
  g.lineTo(x + way, y);
  g.stroke();
  const head = Math.sign(way) * 9;
  g.beginPath();
  g.moveTo(x + way + head, y);
  g.lineTo(x + way, y - 7);
  g.lineTo(x + way, y + 7);
  g.fill();
}

function drawCart(g, colours, { width, height, state: [x, , theta], action, values: [half], acted }) {
  const metre = width / 5.4, rail = height - 42, place = width / 2 + x * metre;
  g.strokeStyle = colours.line;
  g.lineWidth = 3;
  g.beginPath();
  g.moveTo(width / 2 - 2.4 * metre, rail);
  g.lineTo(width / 2 + 2.4 * metre, rail);
  g.stroke();
  g.lineWidth = 2;
  for (const end of [-2.4, 0, 2.4]) {
    g.beginPath();
    g.moveTo(width / 2 + end * metre, rail - 6);
    g.lineTo(width / 2 + end * metre, rail + 6);
    g.stroke();
  }
  g.fillStyle = colours.metal;
  g.beginPath();
  g.roundRect(place - 30, rail - 27, 60, 22, 6);
  g.fill();
  g.fillStyle = colours.dark;
  for (const wheel of [-17, 17]) {
    g.beginPath();
    g.arc(place + wheel, rail - 3, 6, 0, 7);
    g.fill();
  }
  const long = Math.min(2 * half * metre * 1.25, height - 85), [hx, hy] = [place, rail - 26];
  g.strokeStyle = colours.graph;
  g.lineWidth = 9;
  g.beginPath();
  g.moveTo(hx, hy);
  g.lineTo(hx + long * Math.sin(theta), hy - long * Math.cos(theta));
  g.stroke();
  g.fillStyle = colours.text;
  g.beginPath();
  g.arc(hx, hy, 5, 0, 7);
  g.fill();
  if (acted) arrow(g, colours.network, place + (action ? 38 : -38), rail - 16, action ? 22 : -22);
}

function drawPendulum(g, colours, { width, height, state: [theta], action, values: [, long], acted }) {
  const reach = Math.max(0, Math.min(width, height) / 2 - 22), [cx, cy] = [width / 2, height / 2], rod = reach * Math.min(1, long / 1.6 + 0.25);
  g.strokeStyle = colours.line;
  g.lineWidth = 1.5;
  g.setLineDash([4, 6]);
  g.beginPath();
  g.arc(cx, cy, reach, 0, 7);
  g.stroke();
  g.setLineDash([]);
  g.strokeStyle = colours.graph;
  g.lineWidth = 13;
  g.beginPath();
  g.moveTo(cx, cy);
  g.lineTo(cx - rod * Math.sin(theta), cy - rod * Math.cos(theta));
  g.stroke();
  g.fillStyle = colours.dark;
  g.beginPath();
  g.arc(cx, cy, 9, 0, 7);
  g.fill();
  if (!acted || Math.abs(action) < 0.02) return;
  // A torque turns against the clock where it is positive, as the angle does.
  const span = Math.abs(action) / 2 * 1.5, from = -Math.PI / 2, to = from - Math.sign(action) * span, ring = 30;
  g.strokeStyle = g.fillStyle = colours.network;
  g.lineWidth = 4;
  g.beginPath();
  g.arc(cx, cy, ring, from, to, action > 0);
  g.stroke();
  g.save();
  g.translate(cx + ring * Math.cos(to), cy + ring * Math.sin(to));
  g.rotate(to + (action > 0 ? Math.PI : 0));
  g.beginPath();
  g.moveTo(0, 10);
  g.lineTo(-7, 0);
  g.lineTo(7, 0);
  g.fill();
  g.restore();
}

function drawCar(g, colours, { width, height, state: [position], action, acted }) {
  const x = place => 14 + (width - 28) * (place + 1.2) / 1.8, y = place => height - 34 - (height - 92) * (Math.sin(3 * place) + 1) / 2;
  g.beginPath();
  for (let place = -1.2; place <= 0.6001; place += 0.02) g.lineTo(x(place), y(place));
  g.strokeStyle = colours.line;
  g.lineWidth = 4;
  g.stroke();
  g.lineTo(x(0.6), height);
  g.lineTo(x(-1.2), height);
  g.fillStyle = colours.fill;
  g.fill();
  const [fx, fy] = [x(0.5), y(0.5)];
  g.strokeStyle = colours.soft;
  g.lineWidth = 2.5;
  g.beginPath();
  g.moveTo(fx, fy);
  g.lineTo(fx, fy - 40);
  g.stroke();
  g.fillStyle = colours.graph;
  g.beginPath();
  g.moveTo(fx, fy - 40);
  g.lineTo(fx + 19, fy - 33);
  g.lineTo(fx, fy - 26);
  g.fill();
  const slope = Math.atan2(y(position + 0.01) - y(position - 0.01), x(position + 0.01) - x(position - 0.01));
  g.save();
  g.translate(x(position), y(position));
  g.rotate(slope);
  g.fillStyle = colours.dark;
  for (const wheel of [-11, 11]) {
    g.beginPath();
    g.arc(wheel, -7, 6, 0, 7);
    g.fill();
  }
  g.fillStyle = colours.metal;
  g.beginPath();
  g.roundRect(-22, -25, 44, 15, 5);
  g.fill();
  g.beginPath();
  g.roundRect(-11, -34, 22, 11, 4);
  g.fill();
  if (acted && action !== 1) arrow(g, colours.network, action === 2 ? 28 : -28, -18, action === 2 ? 16 : -16);
  g.restore();
}
