// What one may ask: the shape of the wave, a record, friction, W' and uplift.
import {choiceOf} from "./choice.js";
import {element} from "./element.js";
import {COURSES} from "./course.js";
import {Field} from "./field.js";
import {GODA, GodaWave} from "./goda_wave.js";
import {SHAPES, waveOf} from "./pulse.js";
import {readRecord} from "./record.js";

const POSITIVE = {holds: (value) => value > 0, needs: "a number above 0"};
const NOT_NEGATIVE = {holds: (value) => value >= 0, needs: "a number that is not negative"};
const UNITS = {"N/m": ["kN/m", 1e3], Pa: ["kPa", 1e3]};
const UPLIFTS = {none: "none", in_phase: "in phase with P", held: "held after the peak of P", computed: "computed pore pressure"};

// The case's own pulse, where it has one, to begin with.
function firstPulse({pulse, peak, duration: known}, end, factor) {
  const given = pulse && pulse.shape in SHAPES ? pulse : {}, duration = given.duration ?? (known || end);
  return {shape: "triangle", rise: given.shape === "step" ? 0 : 0.5 * duration, plateau: 0.3,
    plateau_duration: 5 * duration, start: 0, ...given, duration,
    peak: (given.peak < 0 ? -1 : 1) * (peak || factor)};
}

function pulseSpecs(load, end) {
  const [unit, factor] = UNITS[load.unit] || [load.unit, 1], first = firstPulse(load, end, factor), {duration} = first, peak = Math.abs(first.peak);
  const time = {unit: "s", factor: 1, low: duration / 20, high: 20 * duration, log: true};
  return [
    {key: "peak", name: "Peak", unit, factor, low: 0.05 * peak, high: 5 * peak, holds: (value) => value !== 0, needs: "a number that is not 0"},
    {key: "rise", name: "Rise", ...time, low: 0, high: 2 * duration, log: false, ...NOT_NEGATIVE},
    {key: "duration", name: "Duration", ...time, ...POSITIVE},
    {key: "plateau", name: "Plateau over peak", unit: "", factor: 1, low: 0.01, high: 0.99, holds: (value) => value > 0 && value < 1, needs: "a number between 0 and 1"},
    {key: "plateau_duration", name: "Plateau until", ...time, high: 100 * duration, ...POSITIVE},
    {key: "start", name: "Start", unit: "s", factor: 1, low: 0, high: end, ...NOT_NEGATIVE},
  ].map((spec) => ({spec, value: first[spec.key]}));
}

function slidingSpecs(known, load) {
  const weight = known ? known.weight : 10 * (load.peak || 1e6), optional = !known;
  return [
    {spec: {key: "friction", name: "Friction μ", unit: "", factor: 1, low: 0.1, high: 1, optional, ...POSITIVE}, value: known ? known.friction : null},
    {spec: {key: "weight", name: "Weight in water W′", unit: "kN/m", factor: 1e3, low: 0.1 * weight, high: 2 * weight, optional, ...POSITIVE}, value: known ? known.weight : null},
    {spec: {key: "uplift_per_force", name: "Uplift U over P", unit: "", factor: 1, low: 0, high: 1, ...NOT_NEGATIVE}, value: known ? known.uplift_per_force : 0},
    {spec: {key: "lag", name: "U comes after P by", unit: "s", factor: 1, low: 0, high: load.duration || 1, ...NOT_NEGATIVE}, value: known ? known.lag : 0},
  ];
}

function shapesOf(model) {
  const pulses = Object.keys(SHAPES).map((key) => [key, key.replace("_", " ")]);
  return Object.fromEntries([...pulses, ...(model.wave ? Object.keys(COURSES).map((key) => [GODA + key, `by Goda: ${key.replace("_", " ")}`]) : [])]);
}

// A wave of the case by Goda's formulas, or of a design above, comes before a pulse.
function firstShape({wave}, pulse) {
  if (!wave || !(wave.profile || document.querySelector(".formulas"))) return pulse;
  return GODA + (wave.course in COURSES ? wave.course : "church_roof");
}

export class Controls {
  constructor(model, changed) {
    Object.assign(this, {model, changed, record: null, recordName: ""});
    const load = model.loads[0], known = model.sliding;
    const fields = (list) => list.map(({spec, value}) => new Field(spec, value, (field) => this.moved(field)));
    this.goda = model.wave ? new GodaWave(model, (field) => this.follow(field)) : null;
    this.shape = choiceOf("shape", "Shape", shapesOf(model), firstShape(model, firstPulse(load, model.end, 1).shape));
    this.load = choiceOf("load", "Load", Object.fromEntries(model.loads.map(({name}, k) => [k, name])), String(model.wave ? model.wave.load : 0));
    const uplifts = Object.entries(UPLIFTS).filter(([key]) => key !== "computed" || "uplift" in model.modes.readings);
    this.uplift = choiceOf("uplift", "Uplift", Object.fromEntries(uplifts), known && known.uplift in UPLIFTS ? known.uplift : "none");
    this.ofPulse = fields(pulseSpecs(load, model.end));
    this.ofSliding = fields(slidingSpecs(known, load));
    this.all = Object.fromEntries([...this.ofPulse, ...this.ofGoda(), ...this.ofSliding].map((field) => [field.key, field]));
    this.shape.select.addEventListener("input", () => this.setWeight(null));
    for (const {select} of [this.shape, this.load, this.uplift]) select.addEventListener("input", () => this.moved(null));
    this.arrange();
  }
  // Two sets of fields and the place for a record.
  arrange() {
    this.file = element("input", {type: "file", id: "whatif-record", accept: ".csv,.txt"});
    this.back = element("button", {type: "button"}, "Back to the pulse");
    this.told = element("p", {class: "quiet", role: "status"});
    const record = element("div", {class: "drop"}, element("label", {for: "whatif-record"}, "Or a record: CSV with a time and a force (choose it, or drop it here)"), this.file, this.told, this.back);
    this.file.addEventListener("change", () => this.file.files[0] && this.read(this.file.files[0]));
    this.back.addEventListener("click", () => this.take(null, ""));
    record.addEventListener("dragover", (event) => event.preventDefault());
    record.addEventListener("drop", (event) => {
      event.preventDefault();
      if (event.dataTransfer.files[0]) this.read(event.dataTransfer.files[0]);
    });
    this.pulse = element("div", {}, this.shape.row, ...(this.model.loads.length > 1 ? [this.load.row] : []), ...[...this.ofPulse, ...this.ofGoda()].map(({row}) => row));
    const wave = element("fieldset", {}, element("legend", {}, "Wave"), this.pulse, record);
    const sliding = element("fieldset", {}, element("legend", {}, "Sliding"), this.ofSliding[0].row, this.ofSliding[1].row, this.uplift.row, this.ofSliding[2].row, this.ofSliding[3].row);
    this.form = element("form", {class: "controls", "aria-label": "What if"}, wave, ...(this.model.mass > 0 ? [sliding] : []));
    this.form.addEventListener("submit", (event) => event.preventDefault());
    this.reveal();
  }
  // Shows what the shape and the uplift ask for.
  reveal() {
    const keys = this.course() ? this.goda.keys() : SHAPES[this.shape.select.value]?.keys ?? [], follows = ["in_phase", "held"].includes(this.uplift.select.value);
    for (const field of [...this.ofPulse, ...this.ofGoda()]) field.row.hidden = !keys.includes(field.key);
    this.all.lag.row.hidden = !follows;
    this.all.uplift_per_force.row.hidden = !follows || this.course() !== null;
    this.pulse.hidden = this.record !== null;
    this.back.hidden = this.record === null;
  }
  ofGoda() {
    return this.goda ? this.goda.fields : [];
  }
  // That of the wave by Goda's formulas; null where another wave is asked.
  course() {
    const shape = this.shape.select.value;
    return this.record === null && shape.startsWith(GODA) ? shape.slice(GODA.length) : null;
  }
  // Something of the wave by Goda's formulas has moved.
  follow(field) {
    if (this.course() === null) return;
    this.setWeight(field);
    this.moved(field);
  }
  // W' is that of the level, and of the design where one is above: so is mu.
  setWeight(field) {
    if (this.course() === null || (field !== null && field.key !== "wave_rise")) return;
    try {
      const {section} = this.goda.answer();
      this.all.weight.set(section.submerged_weight);
      if (this.goda.above) this.all.friction.set(section.friction);
    } catch {
      return; // the answer tells why there is none
    }
  }
  // A rise beyond the duration, or a plateau within it, moves along with what was moved. A church roof would jump where
  // its rise is as long as its impulsive part.
  moved(field) {
    const {rise, duration, plateau_duration: plateau} = this.all, roof = this.shape.select.value === "church_roof";
    if (roof && plateau.value() <= duration.value())
      if (field === plateau) duration.set(0.5 * plateau.value()); else plateau.set(2 * duration.value());
    const part = roof ? 0.9 : 1, beyond = roof ? rise.value() >= duration.value() : rise.value() > duration.value();
    if (beyond && (roof || this.shape.select.value === "triangle"))
      if (field === rise) duration.set(rise.value() / part); else rise.set(part * duration.value());
    if (roof && plateau.value() <= duration.value()) plateau.set(2 * duration.value());
    this.reveal();
    this.changed();
  }
  async read(file) {
    try {
      this.take(readRecord(await file.text(), this.model.loads), file.name);
    } catch (error) {
      this.told.textContent = `${file.name} was not read: ${error.message}`;
    }
  }
  take(record, name) {
    Object.assign(this, {record, recordName: name});
    this.told.textContent = record ? `${name}: ${record.time.length} times up to ${record.time.at(-1)} s` : "";
    if (!record) this.file.value = "";
    this.reveal();
    this.changed();
  }
  // What is wrong with what is asked, as sentences.
  mistakes() {
    return Object.values(this.all).filter((field) => !field.row.hidden && !(this.record && !this.ofSliding.includes(field)) && Number.isNaN(field.value()))
      .map(({spec}) => `${spec.name}: give ${spec.needs}`);
  }
  wave() {
    if (this.record) return this.record;
    if (this.course()) return this.goda.made(this.course(), Number(this.load.select.value), this.model.loads.length);
    const pulse = {shape: this.shape.select.value};
    for (const field of this.ofPulse) pulse[field.key] = field.value();
    return waveOf(pulse, Number(this.load.select.value), this.model.loads.length, this.model.end);
  }
  // Of what S is asked with; null where friction or W' are not given.
  sliding() {
    const {friction, weight, uplift_per_force, lag} = this.all;
    if (!(this.model.mass > 0) || friction.value() === null || weight.value() === null) return null;
    return {friction: friction.value(), weight: weight.value(), drag: this.model.sliding ? this.model.sliding.drag : 0,
      uplift: this.uplift.select.value, uplift_per_force: this.course() ? this.goda.last.upliftPerForce : uplift_per_force.value(), lag: lag.value()};
  }
}
