// The page of a model of soils: a slider for each key, and F_T under the loads of the case at every move.
import {element, symbolic} from "./element.js";
import {Field} from "./field.js";
import {quantity} from "./numbers.js";
import {drawing, panelsOf, voidsOf} from "./plot.js";
import {soilAnswer, soilSystemOf} from "./soil_system.js";

// The two last words of a dotted key: "seabed shear modulus".
const nameOf = (key) => key.split(".").slice(1).join(" ").replaceAll("_", " ");

class SoilSliders {
  constructor(root, data) {
    this.system = soilSystemOf(data);
    this.voids = voidsOf(data);
    this.fields = data.keys.map(({key, low, high, logarithmic, value}) => new Field({key, name: nameOf(key), unit: "", factor: 1, low, high,
      log: Boolean(logarithmic), holds: (given) => given >= low * (1 - 1e-12) && given <= high * (1 + 1e-12)}, value, () => this.update()));
    this.headline = element("dl", {class: "headline", role: "status"});
    this.wrong = element("p", {class: "wrong", role: "alert"});
    this.figure = element("figure");
    const form = element("form", {class: "controls"}, element("fieldset", {}, element("legend", {}, "Soil (SI units)"), ...this.fields.map(({row}) => row)));
    root.append(this.headline, element("div", {class: "whatif-parts"}, form, element("div", {class: "answer"}, this.wrong, this.figure)));
    root.answerOf = (soil) => soilAnswer(this.system, soil);
    new ResizeObserver(() => this.answer && this.draw()).observe(this.figure);
    this.update();
  }
  update() {
    const wrong = this.fields.filter((field) => Number.isNaN(field.value()));
    this.wrong.textContent = wrong.map(({spec}) => `No answer: ${spec.name} is outside ${spec.low} to ${spec.high}, for which the model was made.`).join(" ");
    if (wrong.length) return;
    this.answer = soilAnswer(this.system, Object.fromEntries(this.fields.map((field) => [field.key, field.value()])));
    this.draw();
  }
  draw() {
    const {P, F} = this.answer, most = (y) => y.reduce((largest, value) => Math.max(largest, value), 0), ratio = most(F) / most(P);
    const told = [["peak_shear", "largest F_T", most(F), quantity(most(F), "N/m")], ["ratio", "F_T over peak P", ratio, ratio.toFixed(3)], ...(this.voids ? [["void", "no number may be relied on", this.voids, `VOID: ${this.voids}`]] : [])];
    this.headline.replaceChildren(...told.map(([key, name, value, text]) => element("div", {}, element("dt", {}, ...symbolic(name)),
      element("dd", {}, element("data", {value, "data-key": key}, text)))));
    this.figure.innerHTML = drawing(this.answer.time, panelsOf(this.answer), Math.max(this.figure.clientWidth, 320), {alt: "Histories of P and F_T", voids: this.voids});
  }
}

for (const script of document.querySelectorAll("script.whatif-soils")) new SoilSliders(script.parentElement, JSON.parse(script.textContent));
