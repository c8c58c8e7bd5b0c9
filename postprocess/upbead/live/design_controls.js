// The form of a page of a design: fields of design_fields.js, and what moves along with what was moved.
import {choiceOf} from "./choice.js";
import {specOfLevel, specsOfCaisson, specsOfDepths, specsOfWave} from "./design_fields.js";
import {element} from "./element.js";
import {Field} from "./field.js";

const BY = {height: "H at the wall", deep_water_height: "H₀′, it breaks"};
const OF_HEIGHT = {height: ["height", "significant_height"], deep_water_height: ["deep_water_height"]};

export class DesignControls {
  constructor(design, changed) {
    Object.assign(this, {design, changed});
    this.waves = Object.entries(design.waves);
    const make = ({spec, value}) => new Field(spec, value, (field) => this.moved(field));
    this.ofWave = specsOfWave(Object.values(design.waves)).map(make);
    this.level = make(specOfLevel(design.section));
    this.ofCaisson = specsOfCaisson(design.section).map(make);
    this.ofDepths = specsOfDepths(design.section).map(make);
    this.all = Object.fromEntries([...this.ofWave, this.level, ...this.ofCaisson, ...this.ofDepths].map((field) => [field.key.slice("design-".length), field]));
    this.wave = choiceOf("design-wave", "Wave of the design", Object.fromEntries(this.waves.map(([name], i) => [i, name])), "0");
    this.by = choiceOf("design-by", "Given by", BY, "height");
    const levels = Object.entries(design.levels);
    this.named = choiceOf("design-level", "Level of the design", Object.fromEntries([["0", "section, 0 m"],
      ...levels.map(([name, rise], i) => [i + 1, `${name}, ${rise} m`])]), "0");
    this.wave.select.addEventListener("input", () => this.takeWave());
    this.by.select.addEventListener("input", () => this.moved(null));
    this.named.select.addEventListener("input", () => {
      this.level.set([0, ...Object.values(design.levels)][Number(this.named.select.value)]);
      this.moved(null);
    });
    this.arrange(levels.length > 0);
    this.takeWave();
  }
  arrange(hasLevels) {
    const part = (name, ...rows) => element("fieldset", {}, element("legend", {}, name), ...rows), rows = (fields) => fields.map(({row}) => row);
    this.form = element("form", {class: "controls", "aria-label": "What if, by formulas"},
      part("Wave", ...(this.waves.length > 1 ? [this.wave.row] : []), this.by.row, ...rows(this.ofWave)),
      part("Still water", ...(hasLevels ? [this.named.row] : []), this.level.row),
      part("Caisson", ...rows(this.ofCaisson)),
      element("details", {}, element("summary", {}, "Depths and mound"), ...rows(this.ofDepths)));
    this.form.addEventListener("submit", (event) => event.preventDefault());
  }
  // The values of a wave as the design gives them.
  takeWave() {
    const given = this.waves[Number(this.wave.select.value)][1];
    this.by.select.value = given.deep_water_height === undefined ? "height" : "deep_water_height";
    for (const key of ["height", "deep_water_height", "period", "angle"]) if (given[key] !== undefined) this.all[key].set(given[key]);
    this.all.significant_height.set(given.significant_height ?? null);
    this.moved(null);
  }
  // W and W' grow with B, of the same mean density; one weight moves the other, as the buoyancy W - W' stays (scatter.weight
  // of a design has it so).
  moved(field) {
    const {width, weight, submerged_weight: submerged} = this.all, last = this.last;
    if (last && field === width && width.value() > 0)
      for (const one of [weight, submerged]) one.set(last[one.key] * width.value() / last[width.key]);
    if (last && field === weight && weight.value() > 0) submerged.set(last[submerged.key] + weight.value() - last[weight.key]);
    if (last && field === submerged && submerged.value() > 0) weight.set(last[weight.key] + submerged.value() - last[submerged.key]);
    if ([width, weight, submerged].every((one) => one.value() > 0)) this.last = Object.fromEntries([width, weight, submerged].map((one) => [one.key, one.value()]));
    const asked = OF_HEIGHT[this.by.select.value];
    for (const keys of Object.values(OF_HEIGHT)) for (const key of keys) this.all[key].row.hidden = !asked.includes(key);
    if (this.form.isConnected) this.changed();
  }
  mistakes() {
    return Object.values(this.all).filter((field) => !field.row.hidden && Number.isNaN(field.value())).map(({spec}) => `${spec.name}: give ${spec.needs}`);
  }
  // Keys of [waves.NAME].
  given() {
    const keys = [...OF_HEIGHT[this.by.select.value], "period", "angle"];
    return Object.fromEntries(keys.map((key) => [key, this.all[key].value()]).filter(([, value]) => value !== null));
  }
  rise() {
    return this.level.value();
  }
  // The design with its section as asked; t stays the same part of B.
  asked() {
    const section = {...this.design.section}, own = section.width;
    for (const field of [...this.ofCaisson, ...this.ofDepths]) section[field.key.slice("design-".length)] = field.value();
    if (section.centroid !== undefined && section.width !== own) section.centroid *= section.width / own;
    return {...this.design, section};
  }
}
