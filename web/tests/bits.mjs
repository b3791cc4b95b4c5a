// node bits.mjs PAGE TARGETS: drives the hybrid's arm to every target, one after another, and hashes its poses, then a camera's images.

import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

const [page, targets] = process.argv.slice(2);
const { wrap, REACHED } = await import(pathToFileURL(`${page}/module.js`));
const module = await WebAssembly.compile(await readFile(`${page}/tpg_web.wasm`));
if (WebAssembly.Module.imports(module).length) throw new Error("the module imports something");
const { arms, eye } = wrap((await WebAssembly.instantiate(module, {})).exports);

let [hash, actions, reached, count] = [0xcbf29ce484222325n, 0, 0, 0];
const add = byte => { hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n); };
for (const target of JSON.parse(await readFile(targets, "utf8"))) {
  arms.aim(...target);
  for (;;) {
    if (arms.view(0).state >= REACHED) break;
    arms.act(0, 1);
    actions++;
    for (const ticks of arms.view(0).pose) {
      for (const byte of [ticks & 255, (ticks >> 8) & 255]) add(byte);
    }
  }
  reached += arms.view(0).state === REACHED ? 1 : 0;
  count++;
}
for (let action = 0; action < 200; action++) {
  eye.act();
  eye.view().pixels.forEach(add);
}
console.log(`${reached} of ${count} reached, ${actions} actions, all ${hash.toString(16).padStart(16, "0")}`);
