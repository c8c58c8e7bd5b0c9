// The wave of a reduced model by Goda's formulas: H, T, level and angle make P, U and their course (docs/waves.md, "A wave as
// a load of a run"), which the modes then answer. Where the page has a design, its wave is taken.
import {COURSES} from "./course.js";
import {Field} from "./field.js";
import {formulaAnswer} from "./formulas.js";
import {designWave} from "./goda.js";
import {HIGHEST_OVER_SIGNIFICANT} from "./heights.js";
import {heelText, plain, quantity} from "./numbers.js";
import {contradictions} from "./validity.js";

export const GODA = "goda_"; // before the name of a course, as a shape

function specs({height, period, angle, crest, least}) {
  const positive = {holds: (value) => value >= 1e-3 && value <= 1e4, needs: "a number from 0.001 to 10,000"};
  return [
    {spec: {key: "wave_height", name: "Highest wave H", unit: "m", factor: 1, low: 0.1 * height, high: 1.6 * height, ...positive}, value: height},
    {spec: {key: "wave_period", name: "Period T", unit: "s", factor: 1, low: 0.3 * period, high: 1.6 * period, holds: (value) => value >= 0.01 && value <= 1e4,
      needs: "a period from 0.01 to 10,000 s"}, value: period},
    {spec: {key: "wave_rise", name: "Water level above the section's", unit: "m", factor: 1, low: -0.6 * least, high: crest, holds: Number.isFinite,
      needs: "a number"}, value: 0},
    {spec: {key: "wave_angle", name: "Angle β to the wall's normal", unit: "°", factor: 1, low: 0, high: 75, holds: (value) => value >= 0 && value < 90,
      needs: "an angle from 0 to below 90 degrees"}, value: angle},
  ];
}

export class GodaWave {
  constructor(model, changed) {
    Object.assign(this, {model, table: model.wave, followed: null});
    this.above = document.querySelector(".formulas");
    const {design, given, profile} = model.wave, {section} = design, least = Math.min(section.water_depth, section.foundation_depth, section.berm_depth),
      own = designWave(given, section, design.water);
    this.significant = given.significant_height || given.deep_water_height ? own.significant / own.height : 1 / HIGHEST_OVER_SIGNIFICANT; // of H
    this.fields = specs({height: own.height, period: given.period, angle: given.angle, crest: section.crest, least}).map(({spec, value}) => new Field(spec, value, changed));
    const spread = profile && formulaAnswer(profile.design, profile.given, 0).pressure;
    this.arm = spread && spread.force_moment / spread.force;
    if (this.above) this.above.addEventListener("answered", ({detail}) => {
      this.followed = detail;
      changed(null);
    });
  }
  keys() {
    return this.above ? [] : this.fields.map(({key}) => key);
  }
  // As formulas.js answers, of the fields or of the design above.
  answer() {
    if (this.above) {
      if (!this.followed) throw new Error("The wave above has no answer.");
      return this.followed;
    }
    const [height, period, rise, angle] = this.fields.map((field) => field.value()), {design} = this.table;
    const refused = contradictions(design.section, design.water, rise);
    if (refused.length > 0) throw new Error(refused.join(". ") + ".");
    return {...formulaAnswer(design, {height, period, angle, significant_height: this.significant * height}, rise), design};
  }
  // The wave of the model's load k, and what Goda's formulas tell of it.
  made(course, k, count) {
    const answer = this.answer(), {water} = answer.design, {time, force} = COURSES[course](answer, this.table, water), per = this.model.modes.readings.force.feedthrough[k];
    if (!(Math.abs(per) > 0)) throw new Error(`The load '${this.model.loads[k].name}' puts no horizontal force on the caisson: choose another one.`);
    const peak = Math.max(...force);
    if (!(peak > 0 && Number.isFinite(peak))) throw new Error("This wave does not press on the wall.");
    this.last = {answer, course, peak, upliftPerForce: answer.pressure.uplift / peak};
    return {time, loads: Array.from({length: count}, (_, i) => force.map((value) => i === k ? value / per : 0))};
  }
  // Rows of the table: [key, name, text, value].
  rows() {
    const {answer} = this.last, {pressure: p, wave, section, stability: s} = answer;
    return [["goda.height", "H", quantity(wave.height, "m"), wave.height], ["goda.alpha_star", "α*", plain(p.alpha_star), p.alpha_star],
      ["goda.force", "P by Goda", quantity(p.force, "N/m"), p.force],
      ["goda.uplift", "U by Goda", quantity(p.uplift, "N/m"), p.uplift],
        ["goda.submerged_weight", "W′ at this level", quantity(section.submerged_weight, "N/m"), section.submerged_weight],
      ["goda.safety_sliding", "S.F. sliding, by Goda", plain(s.safety_sliding, 3), s.safety_sliding],
      ["goda.safety_overturning", "S.F. overturning, by Goda", plain(s.safety_overturning, 3), s.safety_overturning],
      ["goda.heel_pressure", "p_e, heel pressure by Goda", heelText(answer), s.heel_pressure]];
  }
  // Sentences that warn: where the formulas do not hold, and where the model is of another caisson.
  warnings() {
    const {answer} = this.last, {pressure: p, section} = answer, list = answer.warnings.map(({text}) => text), {base, mass} = this.model,
      weight = mass * answer.design.water.gravity;
    if (p.alpha_I > p.alpha_2 && !(this.last.course === "church_roof" && this.table.force === "impulse"))
      list.push(`P of Goda's formulas with alpha_I = ${plain(p.alpha_I, 3)} already is an effective sliding force, which the caisson's dynamics make ` +
        "another one of: where F_T/P is below 1 the reduction counts twice");
    if (base && Math.abs(section.width - base.width) > 0.01 * base.width)
      list.push(`B is ${plain(section.width)} m, the model's caisson is ${plain(base.width)} m wide: P, U and W′ are those of B, the modes those of the ` +
        "model; reduce the case anew");
    if (mass > 0 && Math.abs(section.weight - weight) > 0.01 * weight)
      list.push(`W is ${quantity(section.weight, "N/m")}, the model's caisson weighs ${quantity(weight, "N/m")}: the modes are those of the model; reduce ` +
        "the case anew");
    return list;
  }
  // The load's spread over the wall is that of the model.
  notes() {
    const {answer: {pressure: p, rise}, course} = this.last, arm = p.force_moment / p.force,
      list = ["P, U and their course are those of a load by a wave of upbead run; it begins at 0 s."];
    if (this.arm && Math.abs(this.arm / arm - 1) > 1e-3)
      list.push(`The load keeps its spread over the wall, whose M_P is ${plain(100 * Math.abs(this.arm / arm - 1), 2)} % ${this.arm < arm ? "below" : "above"} ` +
        "that of Goda's formulas for this wave: so are the parts of N′, pressures and margin that come of it.");
    if (!this.arm) list.push("How the load is spread over the wall is the case's, not Goda's: N′, pressures and margin come of that.");
    if (rise !== 0) list.push("The level moves Goda's pressures and W′; the water of the model's sea and ground stays at its own level.");
    if (course === "church_roof" || course === "sine") list.push(`${course === "sine" ? "Half a sine of T/2" : "The church roof"} is an assumption of ours (docs/waves.md).`);
    if (this.table.course === "standing") list.push("The case's own course, a standing wave, is not among these: upbead run has it.");
    if (!this.above) list.push(`H_1/3 is ${plain(this.significant, 3)} H.`);
    if (this.above) list.push("The wave, μ and W′ are those asked above, by formulas.");
    return list;
  }
}
