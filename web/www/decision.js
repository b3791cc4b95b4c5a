// The decision of a graph: each bid computed from the graph's table, in 32-bit floats as the generated code does.
// A test holds that the action which the highest bids lead to is the one that the module takes.

const OPERATIONS = {
  sub: (a, b) => a - b,
  add: (a, b) => a + b,
  mul: (a, b) => a * b,
  div: (a, b) => a / b,
  negate_if_less: (a, b) => a < b ? -a : a,
  abs: a => Math.abs(a),
  min: (a, b) => a < b ? a : b,
  max: (a, b) => a > b ? a : b,
};

/** Computes every bid at a state, and follows the highest, of equal ones the last, from the root to an action or a leaf. */
export function decide({ values, teams }, state) {
  const known = [];
  for (const value of values) {
    if ("input" in value) known.push(state[value.input]);
    else if ("constant" in value) known.push(Math.fround(value.constant));
    else known.push(Math.fround(OPERATIONS[value[0]](known[value[1]], known[value[2]])));
  }
  const edges = teams.map(team => team.map(([bid]) => Number.isNaN(known[bid]) ? -Infinity : known[bid]));
  const way = [];
  for (let team = 0; ;) {
    const best = edges[team].lastIndexOf(Math.max(...edges[team])), [, to] = teams[team][best];
    way.push(teams.slice(0, team).flat().length + best);
    if ("end" in to) return { bids: edges.flat(), way, end: to.end };
    team = to.team;
  }
}
