// Loads the module and its data, and draws what is to be seen at each frame of the screen.

import { load } from "./module.js";
import { ArmView } from "./arm.js";
import { Balls } from "./balls.js";
import { Control } from "./control.js";
import { Eye } from "./eye.js";
import { colours } from "./scene.js";

const still = matchMedia("(prefers-reduced-motion: reduce)");

async function begin() {
  const [module, data] = await Promise.all([load("tpg_web.wasm"), fetch("data.json").then(answer => answer.json())]);
  const arm = new ArmView(module.arms, data, colours());
  const balls = new Balls(module.balls, data.balls, arm.colours, still.matches);
  const eye = new Eye(document.getElementById("eye"), module.eye, data.eye, arm.colours, still.matches);
  const problems = document.getElementById("problems");
  const controls = data.problems.map((problem, i) => new Control(problems, module.problems[i], problem, i, arm.colours, still.matches));
  const again = () => {
    const fresh = colours();
    for (const part of [arm, balls, eye, ...controls]) Object.assign(part, { colours: fresh, dirty: true });
  };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
  new ResizeObserver(again).observe(document.body);
  let last = performance.now(), frames = 0, since = last;
  const page = { arm, balls, eye, controls, rate: 0 };
  const frame = now => {
    const seconds = Math.min(0.1, (now - last) / 1000);
    last = now;
    arm.frame(still.matches);
    balls.frame(still.matches);
    eye.frame(seconds);
    controls.forEach(control => control.frame(seconds));
    if (++frames === 30) {
      [page.rate, frames, since] = [30_000 / (now - since), 0, now];
    }
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  // For tests, and for whoever looks at it in the browser's console.
  globalThis.page = page;
}

begin().catch(error => {
  const failure = document.getElementById("failure");
  failure.hidden = false;
  failure.textContent = `The page cannot start: ${error.message}. It has to be opened from a file server.`;
});
