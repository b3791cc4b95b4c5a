// node browser.mjs PAGE CHROMIUM OUT: the page in a browser: reach, drag, reach; keys; lit bids; three widths; light and dark.

import { createServer } from "node:http";
import { mkdir, readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import assert from "node:assert/strict";
import { chromium } from "playwright-core";

const [folder, executablePath, out] = process.argv.slice(2);
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".json": "application/json", ".wasm": "application/wasm" };
const REACHED = 3;
/** Least and most calls of the canvases' drawing methods in the longest frame with all arms on their way: see `frames`. */
const CALLS = [1_000, 12_000];

const server = createServer(async (request, response) => {
  const path = normalize(new URL(request.url, "http://page").pathname), file = join(folder, path === "/" ? "index.html" : path);
  try {
    const body = await readFile(file);
    response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "text/plain" }).end(body);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise(done => server.listen(0, "127.0.0.1", done));
const url = `http://127.0.0.1:${server.address().port}/`;
await mkdir(out, { recursive: true });

const browser = await chromium.launch({
  executablePath,
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});

/** Opens the page; whatever goes wrong in it, or leaves this machine, is a failure. */
async function open(width, height, settings = {}) {
  const context = await browser.newContext({ viewport: { width, height }, ...settings });
  const tab = await context.newPage(), faults = [];
  tab.on("pageerror", error => faults.push(String(error)));
  tab.on("console", message => message.type() === "error" && faults.push(message.text()));
  tab.on("request", request => request.url().startsWith(url) || request.url().startsWith("data:") || faults.push(`request: ${request.url()}`));
  tab.on("response", response => response.status() < 400 || faults.push(`${response.status()} ${response.url()}`));
  await tab.goto(url);
  await tab.waitForFunction(() => globalThis.page);
  return { tab, close: async () => { assert.deepEqual(faults, []); await context.close(); } };
}

const reached = tab => tab.waitForFunction(end => page.arm.module.view(0).state === end, REACHED, { timeout: 30_000 });
const inside = tab => tab.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
const shot = (tab, name) => tab.screenshot({ path: join(out, `${name}.png`), fullPage: true });

/** The place of the target in the window. */
const place = tab => tab.evaluate(() => {
  const { arm } = page, box = arm.view.getBoundingClientRect(), [x, y] = arm.camera.project(arm.target), ratio = arm.view.width / box.width;
  return [box.left + x / ratio, box.top + y / ratio];
});

async function desktop() {
  const { tab, close } = await open(1280, 900);
  await reached(tab);
  const before = await tab.evaluate(() => page.arm.target);
  const [x, y] = await place(tab);
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x - 120, y + 70, { steps: 12 });
  await tab.mouse.up();
  const after = await tab.evaluate(() => page.arm.target);
  assert.ok(Math.hypot(...after.map((value, i) => value - before[i])) > 60, `the target follows the mouse: ${before} ${after}`);
  assert.equal(await tab.evaluate(() => page.arm.module.view(0).state < 3), true, "the arm is on its way");
  await tab.waitForTimeout(300);
  await shot(tab, "1280-moving");
  await reached(tab);
  assert.ok(await tab.evaluate(() => page.arm.module.view(0).distance) < 3);

  // The target by keys, and the view by keys.
  await tab.focus("#view");
  const held = await tab.evaluate(() => [...page.arm.target]);
  for (const key of ["PageUp", "PageUp", "ArrowLeft", "ArrowUp"]) await tab.keyboard.press(key);
  const moved = await tab.evaluate(() => [...page.arm.target]);
  assert.ok(Math.abs(moved[2] - held[2] - 24) < 1e-6 && Math.hypot(moved[0] - held[0], moved[1] - held[1]) > 10, `${held} ${moved}`);
  const turn = await tab.evaluate(() => page.arm.camera.turn);
  await tab.keyboard.press("Shift+ArrowLeft");
  assert.notEqual(await tab.evaluate(() => page.arm.camera.turn), turn);
  await tab.keyboard.press("Space");
  assert.equal(await tab.evaluate(() => page.arm.running), false);
  await tab.keyboard.press("Space");
  await reached(tab);

  // Another arm in the large view, by keys too.
  await tab.focus(".arm[aria-checked=true]");
  await tab.keyboard.press("ArrowRight");
  assert.equal(await tab.evaluate(() => page.arm.shown), 1);
  await tab.click(".arm >> nth=0");

  await decision(tab);
  await balls(tab);
  await eye(tab);
  await problems(tab);
  await tab.evaluate(() => scrollTo(0, 0));
  await tab.click("#another");
  const calls = Math.max(...await tab.evaluate(frames, 120));
  console.log(`${calls} calls in a frame at most, ${(await tab.evaluate(() => page.rate)).toFixed(1)} frames a second at 1280 x 900`);
  assert.ok(calls >= CALLS[0] && calls <= CALLS[1], `${calls} calls of drawing methods in a frame; accepted: ${CALLS.join(" to ")}`);
  await reached(tab);
  await tab.waitForFunction(() => !page.arm.busy);
  await tab.evaluate(() => [page.eye, ...page.controls].forEach(part => part.running = false));
  const atRest = await tab.evaluate(frames, 10);
  assert.ok(atRest.slice(2).every(count => count === 0), `a page at rest draws nothing: ${atRest}`);
  await close();
}

/**
 * How often the canvases' drawing methods are called in each of some frames: what a frame costs, whatever else this machine does.
 * Runs in the page.
 */
async function frames(count) {
  const methods = CanvasRenderingContext2D.prototype, originals = {}, calls = [];
  let now = 0;
  for (const name of Object.getOwnPropertyNames(methods)) {
    const { value } = Object.getOwnPropertyDescriptor(methods, name);
    if (typeof value !== "function" || name === "constructor") continue;
    originals[name] = value;
    methods[name] = function (...given) {
      now++;
      return value.apply(this, given);
    };
  }
  while (calls.length < count) {
    await new Promise(requestAnimationFrame);
    calls.push(now);
    now = 0;
  }
  Object.assign(methods, originals);
  return calls;
}

/** Each team on the way of the arm's decision is shown with one lit bid; the network has none. */
async function decision(tab) {
  await tab.click("#another");
  await tab.click("#step");
  await tab.waitForFunction(() => document.querySelectorAll("#teams .lit").length > 0);
  const [lit, groups, way] = await tab.evaluate(() => [
    document.querySelectorAll("#teams .lit").length, document.querySelectorAll("#teams .group:not([hidden])").length, page.arm.decision.way.length,
  ]);
  assert.ok(lit === way && groups === way, `${lit} lit bids in ${groups} teams on a way of ${way}`);
  assert.equal(await tab.evaluate(() => page.arm.running), false, "a step is followed by rest");
  await tab.locator("#teams").screenshot({ path: join(out, "1280-decision.png") });
  await tab.click(".arm >> nth=2");
  await tab.waitForFunction(() => document.getElementById("decider").textContent.includes("network"));
  await tab.click(".arm >> nth=0");
  await tab.click("#run");
  await reached(tab);
}

/** Both arms among balls come to an end; the policy is at the target, and another scene begins. */
async function balls(tab) {
  await tab.locator("#balls canvas").first().scrollIntoViewIfNeeded();
  const state = arm => page.balls.module.view(arm).state;
  await tab.waitForFunction(() => [0, 1].every(arm => page.balls.module.view(arm).state !== 0), null, { timeout: 60_000 });
  assert.equal(await tab.evaluate(state, 0), 1, "the policy reaches the first scene's target");
  assert.ok(await tab.evaluate(() => page.balls.module.view(0).distance) < 3);
  await tab.click("#next-scene");
  assert.equal(await tab.evaluate(() => page.balls.scene), 1);
  await tab.waitForFunction(() => page.balls.module.view(0).steps > 10);
}

/** The camera follows the ball that a mouse and a key put somewhere, and begins anew with another. */
async function eye(tab) {
  const canvas = tab.locator("#eye canvas");
  await canvas.scrollIntoViewIfNeeded();
  const middle = () => tab.waitForFunction(() => Math.hypot(...page.eye.module.view().ball) < 3);
  const away = () => tab.evaluate(() => Math.hypot(...page.eye.module.view().ball));
  await middle();
  const { x, y, width, height } = await canvas.boundingBox();
  await tab.mouse.move(x + 0.5 * width, y + 0.5 * height);
  await tab.mouse.down();
  await tab.mouse.move(x + 0.8 * width, y + 0.3 * height);
  await tab.waitForTimeout(200);
  assert.ok(await away() > 8, "the ball stays where it is held");
  await canvas.screenshot({ path: join(out, "1280-eye.png") });
  await tab.mouse.up();
  await middle();
  await tab.evaluate(() => { page.eye.running = false; });
  const before = await tab.evaluate(() => page.eye.module.view().ball[1]);
  await canvas.focus();
  await tab.keyboard.press("ArrowRight");
  assert.ok(Math.abs(await tab.evaluate(() => page.eye.module.view().ball[1]) - before - 1) < 1e-3);
  assert.equal(await tab.locator("#eye .bid.lit").count(), 3, "a bid and what it leads to");
  await tab.getByRole("button", { name: "Another ball" }).click();
  assert.equal(await tab.evaluate(() => page.eye.seed), 2);
  await tab.evaluate(() => { page.eye.running = true; });
}

/** Every problem acts, lights one bid of each team on the way, and feels a push. */
async function problems(tab) {
  for (let number = 0; number < 3; number++) {
    await tab.locator(".problem canvas").nth(number).scrollIntoViewIfNeeded();
    await tab.waitForFunction(number => page.controls[number].decision !== null, number);
  }
  for (let number = 0; number < 3; number++) {
    const lit = await tab.locator(".problem").nth(number).locator(".bid.lit").count();
    assert.ok(lit >= 1, `problem ${number} lights what decided`);
    const [before, after] = await tab.evaluate(number => {
      const control = page.controls[number], [, value, by] = control.pushes[0], state = () => control.module.view().state[value];
      // A push after the end begins anew.
      if (control.now.ended) control.restart();
      const was = state();
      control.push(value, by);
      return [was, state() - by];
    }, number);
    assert.ok(Math.abs(before - after) < 1e-9, `a push on problem ${number}: ${before} ${after}`);
  }
  await tab.locator(".problem canvas").nth(1).scrollIntoViewIfNeeded();
  await tab.waitForFunction(() => page.controls[1].now.state[0] !== 0 && Math.cos(page.controls[1].now.state[0]) > 0.95, null, { timeout: 20_000 });
}

/** A canvas without a size, as on a page that is being closed, or with little room is no fault. */
async function narrow(tab) {
  await tab.evaluate(() => {
    for (const control of page.controls) {
      for (const room of ["0", "1px", "30px"]) {
        Object.assign(control.canvas.style, { width: room, height: room });
        control.paint(control.now.state);
      }
      control.canvas.removeAttribute("style");
    }
  });
}

async function phone() {
  const { tab, close } = await open(400, 860, { hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  await reached(tab);
  assert.ok(await inside(tab), "nothing is wider than a phone");
  const [x, y] = await place(tab), before = await tab.evaluate(() => page.arm.target);
  // A finger: the browser's own touch events, which become pointer events.
  const session = await tab.context().newCDPSession(tab);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await touch("touchStart", [{ x, y }]);
  for (let step = 1; step <= 8; step++) await touch("touchMove", [{ x: x + 8 * step, y: y - 4 * step }]);
  await touch("touchEnd", []);
  const after = await tab.evaluate(() => page.arm.target);
  assert.ok(Math.hypot(...after.map((value, i) => value - before[i])) > 30, "the target follows a finger");
  await reached(tab);
  await shot(tab, "400-light");
  await close();
  const dark = await open(400, 860, { colorScheme: "dark", deviceScaleFactor: 2 });
  await reached(dark.tab);
  await problems(dark.tab);
  await narrow(dark.tab);
  await shot(dark.tab, "400-dark");
  await dark.close();
}

/** Without motion the arm is there at once, and the problems wait. */
async function still() {
  const { tab, close } = await open(1280, 900, { reducedMotion: "reduce" });
  await tab.waitForFunction(end => [0, 3].every(arm => page.arm.module.view(arm).state === end), REACHED);
  await tab.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await tab.waitForTimeout(300);
  assert.ok(await tab.evaluate(() => page.controls.every(control => !control.running && control.now.actions === 0)));
  await tab.locator(".problem").nth(0).getByRole("button", { name: "Step" }).click();
  assert.equal(await tab.evaluate(() => page.controls[0].now.actions), 1);
  await close();
}

/** Pictures to look at. */
async function pictures() {
  for (const [width, height] of [[1280, 900], [1500, 1000]]) {
    for (const colorScheme of ["light", "dark"]) {
      const { tab, close } = await open(width, height, { colorScheme });
      await reached(tab);
      assert.ok(await inside(tab), `nothing is wider than ${width}`);
      await tab.evaluate(() => scrollTo(0, document.body.scrollHeight));
      await tab.waitForTimeout(700);
      await shot(tab, `${width}-${colorScheme}`);
      await close();
    }
  }
}

try {
  await desktop();
  await phone();
  await still();
  await pictures();
} finally {
  await browser.close();
  server.close();
}
