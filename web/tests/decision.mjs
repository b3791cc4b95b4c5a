// node decision.mjs PAGE TARGETS GRAPH: the graph's arm goes to every target, and each problem acts through a hundred episodes;
// each action is the one that the page would light.

import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";
import assert from "node:assert/strict";

const [page, targets, graph] = process.argv.slice(2);
const [{ wrap, REACHED }, { decide }] = await Promise.all(["module.js", "decision.js"].map(file => import(pathToFileURL(`${page}/${file}`))));
const { arms, problems } = wrap((await WebAssembly.instantiate(await readFile(`${page}/tpg_web.wasm`), {})).instance.exports);
const { arm: { table }, problems: tables } = JSON.parse(await readFile(`${page}/data.json`, "utf8"));
const moves = JSON.parse(await readFile(graph, "utf8")).actions.map(({ move }) => move);

const GRAPH = 1, ends = new Set(), lengths = new Set();
let actions = 0;
for (const target of JSON.parse(await readFile(targets, "utf8"))) {
  arms.aim(...target);
  while (arms.view(GRAPH).state < REACHED) {
    const before = arms.view(GRAPH).pose;
    arms.act(GRAPH, 1);
    const { pose, state, seen } = arms.view(GRAPH), { end, way } = decide(table, seen);
    // A refused action ends the episode where the arm was.
    if (state <= REACHED) assert.deepEqual(pose.map((ticks, joint) => ticks - before[joint]), moves[end], `action ${actions}: ${seen}`);
    ends.add(end);
    lengths.add(way.length);
    actions++;
  }
}
assert.ok(ends.size === moves.length && lengths.size > 3, "a test that sees every action and ways of many lengths");

problems.forEach((problem, number) => {
  const lit = new Set(), { title } = tables[number];
  for (let seed = 0; seed < 100; seed++) {
    problem.restart(seed);
    for (let step = 0; step < 200 && !problem.view().ended; step++) {
      problem.act();
      const { seen, action } = problem.view(), { end } = decide(tables[number].table, seen);
      // The pendulum's ends are its leaves, whose torques are not in the table.
      if (title !== "Pendulum") assert.equal(end, action, `${title}: ${seen}`);
      lit.add(end);
      actions++;
    }
  }
  assert.ok(lit.size > 1, `${title}: a test that sees more than one end`);
});
console.log(`${actions} actions are those that the page lights`);
