// An answer that is kept beside the ones that follow: another wave, another caisson, another soil.
import {element, symbolic} from "./element.js";

export class Kept {
  // now(): {name, rows, ...} of what is answered now, or null; changed(): shows it; more: further buttons
  constructor(now, changed, ...more) {
    Object.assign(this, {now, changed, value: null});
    this.keep = element("button", {type: "button"}, "Keep this answer beside the next");
    this.drop = element("button", {type: "button", hidden: ""}, "Drop the kept answer");
    this.told = element("p", {class: "quiet", role: "status"});
    this.keep.addEventListener("click", () => this.take(now()));
    this.drop.addEventListener("click", () => this.take(null));
    this.element = element("div", {class: "keeps"}, this.keep, this.drop, ...more, this.told);
  }
  take(value) {
    this.value = value;
    this.drop.hidden = value === null;
    this.say(value === null ? "" : `Kept: ${value.name}.`);
    this.changed();
  }
  say(text) {
    this.told.replaceChildren(...symbolic(text));
  }
  // The text of a row of the kept answer: with how much more the new one is, where both are numbers.
  beside(key, value) {
    const row = this.value && this.value.rows.find(([name]) => name === key);
    if (!row) return "";
    const [, , text, old] = row, both = Number.isFinite(value) && Number.isFinite(old) && old !== 0 && typeof value === "number";
    const more = both ? Math.round(1000 * (value / old - 1)) / 10 : 0;
    return more === 0 ? text : `${text} (now ${more > 0 ? "+" : "−"}${Math.abs(more)} %)`;
  }
}

// Of fields: what is asked, as "Peak 1000 kN/m, Duration 0.2 s".
export function askedText(fields) {
  return fields.filter(({row, number}) => !row.hidden && number.value !== "").map(({spec, number}) =>
    `${spec.name} ${number.value}${spec.unit ? ` ${spec.unit}` : ""}`).join(", ");
}
