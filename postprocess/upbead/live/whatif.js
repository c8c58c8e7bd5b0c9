// The page that answers: from the controls to numbers, sentences and pictures, at every move.
import {checkItems, checksOfModel} from "./checks.js";
import {choiceOf} from "./choice.js";
import {Controls} from "./controls.js";
import {element, symbolic} from "./element.js";
import {askedText, Kept} from "./kept.js";
import {linkButton, openLinked, stateOf, takeState} from "./link.js";
import {drawing, panelsOf, voidsOf} from "./plot.js";
import {answerOf, histories, modelOf, trustOf} from "./respond.js";
import {historiesCsv, saveButton, waveCsv} from "./save.js";
import {headline, liftOf, notesOf, rowsOf, rowsOfTrust, spoken, trustSentences} from "./told.js";

const STILL = 150, SILENT = 700; // ms after the last move until the error is told, and until it is said aloud
const WORK = 120000; // modes times times that are answered within a frame

class WhatIf {
  constructor(root, data) {
    Object.assign(this, {root, all: [data, ...(data.others ?? [])]});
    this.kept = new Kept(() => this.toKeep(), () => this.answer && this.show(), linkButton((text) => this.kept.say(text)));
    if (this.all.length > 1) root.append(this.choice());
    this.build(data);
    openLinked(root);
  }
  // Of several models, each of a soil: the one that answers; what was asked is asked of it, too.
  choice() {
    const soil = choiceOf("soil", "Soil", Object.fromEntries(this.all.map(({soil: name}, i) => [i, name])), "0");
    soil.select.addEventListener("input", () => {
      const {soil: _, ...asked} = stateOf(this.root);
      this.parts.forEach((part) => part.remove());
      this.build(this.all[Number(soil.select.value)]);
      takeState(this.root, asked);
    });
    return element("div", {class: "soil"}, soil.row);
  }
  build(data) {
    const {root} = this;
    Object.assign(this, {data, model: modelOf(data), voids: voidsOf(data), key: null, answer: null});
    this.controls = new Controls(this.model, () => this.update());
    this.checks = element("ul", {class: "checks"});
    this.table = element("tbody");
    this.trust = element("ul", {class: "trust"});
    this.notes = element("ul", {class: "notes"});
    this.outside = element("ul", {class: "trust"});
    this.wrong = element("p", {class: "wrong", role: "alert"});
    this.aloud = element("p", {class: "aloud", role: "status"});
    this.figure = element("figure");
    const tables = element("div", {class: "tables"}, element("table", {}, element("caption", {}, "Answer"), this.table), element("div", {}, this.checks, this.trust, this.outside, this.notes));
    const answer = element("div", {class: "answer"}, this.wrong, this.kept.element, tables, this.figure, this.buttons(), this.aloud);
    this.headline = element("dl", {class: "headline"});
    this.parts = [this.headline, element("div", {class: "whatif-parts"}, this.controls.form, answer)];
    root.append(...this.parts);
    new ResizeObserver(() => this.answer && this.draw()).observe(this.figure);
    this.update();
  }
  // What is kept of this answer: its rows and its histories.
  toKeep() {
    const {shape, recordName, record, ofPulse, ofSliding} = this.controls, of = record ? recordName : shape.select.selectedOptions[0].textContent;
    const fields = askedText([...(record ? [] : [...ofPulse, ...this.controls.ofGoda()]), ...ofSliding]);
    return this.answer && {name: [this.model.soil, of, fields].filter(Boolean).join(", "), rows: this.rows(), time: this.answer.time, panels: this.panels(), head: this.headlines()};
  }
  buttons() {
    const save = (text, make) => saveButton(text, () => this.answer && make());
    return this.saves = element("div", {class: "saves"},
      save("Histories (CSV)", () => ["histories.csv", historiesCsv(this.model.title + (this.voids && `; VOID, as the warnings say: ${this.voids}`), this.answer, this.rows()), "text/csv"]),
      save("Wave (CSV)", () => ["wave.csv", waveCsv(this.answer.wave, this.model.loads), "text/csv"]),
      save("Picture (SVG)", () => ["answer.svg", drawing(this.answer.time, this.drawn(), 900, {forFile: true, alt: this.alt(), mark: liftOf(this.answer), voids: this.voids}), "image/svg+xml"]));
  }
  // Answers what is asked now; an answer to something else never stays.
  update() {
    clearTimeout(this.later);
    clearTimeout(this.silence);
    try {
      const mistakes = this.controls.mistakes();
      if (mistakes.length > 0) throw new Error(mistakes.join(". ") + ".");
      this.ask(Math.ceil(WORK / this.model.modes.count));
    } catch (error) {
      this.answer = null;
      this.wrong.textContent = `No answer. ${error.message}`;
    }
    this.root.classList.toggle("unanswered", !this.answer);
    if (!this.answer) return;
    this.wrong.textContent = "";
    this.show();
    this.later = setTimeout(() => this.settle(), STILL);
  }
  ask(mostTimes) {
    const wave = this.controls.wave(), sliding = this.controls.sliding(), key = JSON.stringify([wave, sliding !== null]);
    if (key !== this.key || (this.history.rough && mostTimes === Infinity)) this.history = histories(this.model, wave, sliding !== null, mostTimes);
    this.key = key;
    this.sliding = sliding;
    this.answer = answerOf(this.model, this.history, sliding);
    const {peak_shear: F, S = 0} = this.answer;
    if (!Number.isFinite(F) || !Number.isFinite(S)) {
      this.key = null;
      throw new Error("The answer is not finite.");
    }
  }
  rows() {
    return [...rowsOf(this.answer, this.sliding), ...this.ofGoda("rows"), ...(this.told ? rowsOfTrust(this.told) : [])];
  }
  // What the wave by Goda's formulas tells, where it is asked.
  ofGoda(what) {
    return this.controls.course() ? this.controls.goda[what]() : [];
  }
  panels() {
    return panelsOf(this.answer, this.sliding && this.sliding.friction, this.sliding && this.sliding.weight);
  }
  headlines() {
    return headline(this.answer, this.sliding);
  }
  // Panels with the lines of the kept answer behind those of this one.
  drawn() {
    const kept = this.kept.value ? this.kept.value.panels : [], {time} = this.kept.value ?? {};
    return this.panels().map((panel) => {
      const before = kept.find(({title}) => title === panel.title);
      return {...panel, lines: [...(before ? before.lines.map((line) => ({...line, time, faint: true})) : []), ...panel.lines]};
    });
  }
  alt() {
    return `Histories over ${this.answer.time.at(-1)} s: ${this.panels().map(({title}) => title).join("; ")}`;
  }
  showRows() {
    const before = Object.fromEntries(this.kept.value ? this.kept.value.head : []), lift = liftOf(this.answer);
    this.headline.replaceChildren(...(this.voids ? [element("div", {}, element("dt", {}, "no number may be relied on"), element("dd", {class: "warned"}, `VOID: ${this.voids}`))] : []),
      ...this.headlines().map(([name, text]) => element("div", {}, element("dt", {}, ...symbolic(name)),
      element("dd", {}, text, ...(before[name] ? [element("span", {class: "kept"}, `kept ${before[name]}`)] : [])))),
    ...(lift ? [element("div", {class: "lifts"}, element("dt", {}, "the base lifts"), element("dd", {class: "warned"}, lift.text))] : []));
    this.table.replaceChildren(...this.rows().map(([key, name, text, value]) =>
      element("tr", {}, element("th", {scope: "row"}, ...symbolic(name)), element("td", {}, element("data", {value: String(value), "data-key": key}, text), ...this.keptText(key, value)))));
  }
  keptText(key, value) {
    const text = this.kept.beside(key, value);
    return text ? [element("span", {class: "kept"}, `kept ${text}`)] : [];
  }
  show() {
    this.told = null;
    this.showRows();
    this.checks.replaceChildren(...checkItems(checksOfModel(this.answer, this.sliding, this.model.limits ?? {}), this.voids));
    this.outside.replaceChildren(...this.ofGoda("warnings").map((text) => element("li", {class: "warned"}, ...symbolic(text))));
    this.notes.replaceChildren(...[...this.ofGoda("notes"), ...notesOf(this.model, this.answer, this.sliding)].map((text) => element("li", {}, ...symbolic(text))));
    this.trust.replaceChildren(element("li", {class: "quiet"}, ...symbolic(this.answer.rough
      ? `While something moves, the answer is looked at ${this.answer.time.length} times, exact but for peaks between them; all times and the error of F_T follow at rest.`
      : "How wrong F_T may be is told when nothing moves.")));
    this.draw();
  }
  draw() {
    this.figure.innerHTML = drawing(this.answer.time, this.drawn(), Math.max(300, Math.floor(this.figure.clientWidth)), {alt: this.alt(), mark: liftOf(this.answer), voids: this.voids});
  }
  // At rest: all times of `respond`, and how wrong they may be.
  settle() {
    try {
      if (this.answer.rough) {
        this.ask(Infinity);
        this.show();
      }
      this.told = trustOf(this.model, this.history);
    } catch (error) {
      const rough = this.answer.rough ? ` The numbers are those of ${this.answer.time.length} times.` : "";
      return this.trust.replaceChildren(element("li", {class: "warned"}, ...symbolic(`How wrong F_T may be is not told: ${error.message}.${rough}`)));
    }
    const sentences = trustSentences(this.model, this.told);
    this.trust.replaceChildren(...sentences.map(({text, warns}) => element("li", warns ? {class: "warned"} : {}, ...symbolic(text))));
    this.showRows();
    this.silence = setTimeout(() => { this.aloud.textContent = (this.voids && `Void: ${this.voids}. `) + spoken(this.answer, this.sliding, sentences); }, SILENT - STILL);
  }
}

for (const script of document.querySelectorAll("script.whatif-model"))
  new WhatIf(script.parentNode, JSON.parse(script.textContent));
