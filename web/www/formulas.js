// A policy as formulas: the bid that wins is lit, and what it leads to.

const NAMES = {
  theta: "θ", omega: "ω", cos_theta: "cos θ", sin_theta: "sin θ", negate_if_less: "negate_if_less", position: "position", velocity: "velocity",
};

/** Writes a formula as people do: Greek letters, a real minus, four digits. */
export function readable(formula) {
  return formula
    .replace(/\b[a-z_]+\b/g, word => NAMES[word] ?? word)
    .replace(/\d+\.\d+/g, number => String(Number(Number(number).toPrecision(4))))
    .replaceAll(" * ", " · ")
    .replaceAll("-", "−");
}

const bidText = value => value.toPrecision(3).replace("Infinity", "∞").replace("-", "−");

/** The formulas of a policy; of a great one, `along`, only the teams that a decision goes through. */
export class Formulas {
  constructor(parent, { teams, leaves }, along = false) {
    this.bids = [];
    this.leaves = [];
    this.along = along;
    let place = parent;
    const add = (tag, name, text = "") => {
      const element = document.createElement(tag);
      element.className = name;
      element.textContent = text;
      place.append(element);
      return element;
    };
    const row = (name, label, formula) => {
      const element = add("div", name);
      for (const [part, text] of [["to", label], ["formula", readable(formula)]]) {
        const cell = document.createElement("span");
        cell.className = part;
        cell.textContent = text;
        element.append(cell);
      }
      element.lastChild.title = formula;
      return element;
    };
    this.teams = teams.map((team, index) => {
      place = parent;
      const group = place = add("div", "group");
      group.hidden = along;
      add("p", "team", index === 0 ? `team ${team.id}, the root: the highest bid wins` : `team ${team.id}`);
      for (const [name, formula] of team.shared) row("bid", name, formula);
      for (const { to, formula } of team.bids) {
        const element = row("bid", to.replaceAll("_", " "), formula), value = document.createElement("span");
        value.className = "value";
        element.append(value);
        this.bids.push({ element, value, group });
      }
      return group;
    });
    place = parent;
    for (const { id, number, values } of leaves) {
      add("p", "team", `leaf ${id}`);
      for (const [name, formula] of values) this.leaves.push({ number, element: row("bid leaf", name, formula) });
    }
    if ([...teams.flatMap(team => team.bids)].some(({ formula }) => formula.includes("negate_if_less"))) {
      add("p", "note", "negate_if_less(a, b) is −a where a < b, else a.");
    }
  }

  show({ bids, way, end }) {
    const lit = new Set(way);
    const shown = new Set(way.map(edge => this.bids[edge].group));
    if (this.along) {
      this.teams.forEach(group => { group.hidden = !shown.has(group); });
      way.forEach((edge, step) => { this.bids[edge].group.style.order = step; });
    }
    this.bids.forEach(({ element, value, group }, edge) => {
      element.classList.toggle("lit", lit.has(edge));
      if (this.along && !shown.has(group)) return;
      value.textContent = bidText(bids[edge]);
    });
    for (const { number, element } of this.leaves) element.classList.toggle("lit", number === end);
  }
}
