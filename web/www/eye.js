// A camera that follows a ball: its image, the two windows that the policy reads, and where it turns.

import { decide } from "./decision.js";
import { Formulas } from "./formulas.js";

const [ROWS, COLUMNS] = [24, 32];
/** Seconds of an action, and of rest after a lost ball. */
const [SECONDS, REST] = [0.05, 1.2];
const MOVES = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };

export class Eye {
  constructor(parent, module, data, colours, still) {
    Object.assign(this, { module, data, colours, running: !still, owed: 0, rest: 0, seed: 1, held: null, dirty: true });
    parent.innerHTML = `<article class="camera"><div>
      <canvas tabindex="0" role="application" aria-label="The camera's image; arrow keys move the ball"></canvas>
      <div class="row"></div><p class="score" role="status"></p></div>
      <div><div class="formulas"></div><p class="note">${data.size}.</p>
      <details><summary>The C that drives it</summary><pre tabindex="0"></pre></details></div></article>`;
    const part = selector => parent.querySelector(selector);
    this.canvas = part("canvas");
    this.score = part(".score");
    part("pre").textContent = data.code;
    this.formulas = new Formulas(part(".formulas"), data);
    this.image = new OffscreenCanvas(COLUMNS, ROWS);
    this.buttons(part(".row"));
    this.pointer();
    new IntersectionObserver(entries => { this.visible = entries.at(-1).isIntersecting; }).observe(this.canvas);
  }

  buttons(row) {
    const add = (text, act) => {
      const button = document.createElement("button");
      button.textContent = text;
      button.addEventListener("click", () => act(button));
      row.append(button);
    };
    add("Another ball", () => this.restart());
    add(this.running ? "Pause" : "Run", button => {
      this.running = !this.running;
      button.textContent = this.running ? "Pause" : "Run";
    });
    add("Step", () => this.act());
  }

  pointer() {
    const { canvas } = this, place = ({ clientX, clientY }) => {
      const { left, top, width, height } = canvas.getBoundingClientRect();
      return [((clientY - top) / height - 0.5) * ROWS, ((clientX - left) / width - 0.5) * COLUMNS];
    };
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      this.hold(place(event));
    });
    canvas.addEventListener("pointermove", event => this.held && this.hold(place(event)));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { this.held = null; });
    canvas.addEventListener("keydown", event => {
      const move = MOVES[event.key];
      if (!move) return;
      event.preventDefault();
      this.hold(this.module.view().ball.map((at, axis) => at + move[axis]));
      this.held = null;
    });
  }

  /** Puts the ball at a place from the middle, where it stays while it is held. */
  hold(place) {
    if (this.module.view().ended) this.restart();
    this.held = place;
    this.module.drag(...place);
    this.dirty = true;
  }

  restart() {
    this.module.restart(++this.seed);
    this.rest = 0;
    this.dirty = true;
  }

  act() {
    if (this.module.view().ended) return this.restart();
    this.module.act();
    if (this.held) this.module.drag(...this.held);
    this.dirty = true;
  }

  frame(seconds) {
    if (!this.visible) return;
    if (this.running && this.module.view().ended) {
      this.rest += seconds;
      if (this.rest > REST) this.restart();
    } else if (this.running) {
      this.owed = Math.min(this.owed + seconds, 0.2);
      for (; this.owed >= SECONDS; this.owed -= SECONDS) this.act();
    }
    if (!this.dirty) return;
    this.dirty = false;
    const view = this.module.view(), decision = decide(this.data.table, view.seen);
    this.formulas.show(decision);
    this.paint(view, decision.end);
    const [down, right] = view.ball, text = view.ended ? "the ball is lost" : `ball ${Math.hypot(down, right).toFixed(1)} pixels from the middle`;
    if (this.score.textContent !== text) this.score.textContent = text;
  }

  /** Paints the image; the window that the policy follows is lit. */
  paint({ pixels, seen, action }, followed) {
    const { canvas, colours } = this, g = canvas.getContext("2d"), ratio = Math.min(devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!width || !height) return;
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    const data = new ImageData(COLUMNS, ROWS);
    pixels.forEach((grey, place) => data.data.set([grey, grey, grey, 255], 4 * place));
    this.image.getContext("2d").putImageData(data, 0, 0);
    g.setTransform(canvas.width / COLUMNS, 0, 0, canvas.height / ROWS, 0, 0);
    g.imageSmoothingEnabled = false;
    g.drawImage(this.image, 0, 0);
    [0, 1].forEach(window => {
      g.strokeStyle = window === followed ? colours.graph : colours.line;
      g.lineWidth = window === followed ? 0.4 : 0.2;
      g.strokeRect(seen[3 * window + 1] - 1, seen[3 * window] - 1, 3, 3);
    });
    g.strokeStyle = colours.graph;
    g.lineWidth = 0.3;
    g.beginPath();
    g.moveTo(COLUMNS / 2, ROWS / 2);
    g.lineTo(COLUMNS / 2 + 2 * action[1], ROWS / 2 + 2 * action[0]);
    g.stroke();
  }
}
