// A number that one types or slides: the number field holds the value, the slider moves it.
import {element} from "./element.js";
import {plain} from "./numbers.js";

const STEPS = 1000;

// spec: {key, name, unit, factor: SI units of one, low, high: of the slider (SI), log, holds(value), needs: what holds
// asks for, optional}
export class Field {
  constructor(spec, value, changed) {
    Object.assign(this, {spec, key: spec.key});
    const id = `whatif-${spec.key}`;
    this.number = element("input", {id, type: "number", step: "any", inputmode: "decimal", "data-key": spec.key});
    this.slider = element("input", {type: "range", min: 0, max: STEPS, step: 1, "aria-label": `${spec.name}, slider`});
    this.row = element("div", {class: "field"}, element("label", {for: id}, `${spec.name}${spec.unit ? ` (${spec.unit})` : ""}`),
      this.slider, this.number);
    this.number.addEventListener("input", () => this.show() || changed(this));
    this.slider.addEventListener("input", () => {
      this.number.value = Number((this.slid() / spec.factor).toPrecision(3));
      this.show(false);
      changed(this);
    });
    this.set(value);
  }
  // The value in SI units; null where none is given; NaN where it does not do.
  value() {
    if (this.number.value === "") return this.spec.optional && !this.number.validity.badInput ? null : NaN;
    const value = Number(this.number.value) * this.spec.factor;
    return Number.isFinite(value) && this.spec.holds(value) ? value : NaN;
  }
  set(value) {
    this.number.value = value === null ? "" : Number((value / this.spec.factor).toPrecision(12));
    this.show();
  }
  // Marks a value that does not do, and moves the slider along.
  show(moves = true) {
    const value = this.value(), wrong = Number.isNaN(value);
    this.number.setAttribute("aria-invalid", wrong);
    if (moves && !wrong && value !== null) this.slider.value = this.place(value);
    this.slider.setAttribute("aria-valuetext", wrong || value === null ? "none" : `${plain(value / this.spec.factor)} ${this.spec.unit}`);
  }
  slid() {
    const {low, high, log} = this.spec, part = Number(this.slider.value) / STEPS;
    return log ? low * (high / low) ** part : low + (high - low) * part;
  }
  place(value) {
    const {low, high, log} = this.spec;
    return Math.round(STEPS * (log ? Math.log(Math.max(value, low) / low) / Math.log(high / low) : (value - low) / (high - low)));
  }
}
