// The page that answers: from the controls to numbers, sentences and pictures, at every move.
import {Controls} from "./controls.js";
import {element, symbolic} from "./element.js";
import {drawing, panelsOf} from "./plot.js";
import {answerOf, histories, modelOf, trustOf} from "./respond.js";
import {historiesCsv, saveButton, waveCsv} from "./save.js";
import {headline, notesOf, rowsOf, rowsOfTrust, spoken, trustSentences} from "./told.js";

const STILL = 150, SILENT = 700; // ms after the last move until the error is told, and until it is said aloud
const WORK = 120000; // modes times times that are answered within a frame

class WhatIf {
  constructor(root, data) {
    this.root = root;
    this.model = modelOf(data);
    this.controls = new Controls(this.model, () => this.update());
    this.table = element("tbody");
    this.trust = element("ul", {class: "trust"});
    this.notes = element("ul", {class: "notes"});
    this.outside = element("ul", {class: "trust"});
    this.wrong = element("p", {class: "wrong", role: "alert"});
    this.aloud = element("p", {class: "aloud", role: "status"});
    this.figure = element("figure");
    const tables = element("div", {class: "tables"}, element("table", {}, element("caption", {}, "Answer"), this.table), element("div", {}, this.trust, this.outside, this.notes));
    const answer = element("div", {class: "answer"}, this.wrong, tables, this.figure, this.buttons(), this.aloud);
    this.headline = element("dl", {class: "headline"});
    root.append(this.headline, element("div", {class: "whatif-parts"}, this.controls.form, answer));
    new ResizeObserver(() => this.answer && this.draw()).observe(this.figure);
    this.update();
  }
  buttons() {
    const save = (text, make) => saveButton(text, () => this.answer && make());
    return this.saves = element("div", {class: "saves"},
      save("Histories (CSV)", () => ["histories.csv", historiesCsv(this.model.title, this.answer, this.rows()), "text/csv"]),
      save("Wave (CSV)", () => ["wave.csv", waveCsv(this.answer.wave, this.model.loads), "text/csv"]),
      save("Picture (SVG)", () => ["answer.svg", drawing(this.answer.time, this.panels(), 900, {forFile: true, alt: this.alt()}), "image/svg+xml"]));
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
  alt() {
    return `Histories over ${this.answer.time.at(-1)} s: ${this.panels().map(({title}) => title).join("; ")}`;
  }
  showRows() {
    this.headline.replaceChildren(...headline(this.answer, this.sliding).map(([name, text]) =>
      element("div", {}, element("dt", {}, ...symbolic(name)), element("dd", {}, text))));
    this.table.replaceChildren(...this.rows().map(([key, name, text, value]) =>
      element("tr", {}, element("th", {scope: "row"}, ...symbolic(name)), element("td", {}, element("data", {value: String(value), "data-key": key}, text)))));
  }
  show() {
    this.told = null;
    this.showRows();
    this.outside.replaceChildren(...this.ofGoda("warnings").map((text) => element("li", {class: "warned"}, ...symbolic(text))));
    this.notes.replaceChildren(...[...this.ofGoda("notes"), ...notesOf(this.model, this.answer, this.sliding)].map((text) => element("li", {}, ...symbolic(text))));
    this.trust.replaceChildren(element("li", {class: "quiet"}, ...symbolic(this.answer.rough
      ? `While something moves, the answer is looked at ${this.answer.time.length} times, exact but for peaks between them; all times and the error of F_T follow at rest.`
      : "How wrong F_T may be is told when nothing moves.")));
    this.draw();
  }
  draw() {
    this.figure.innerHTML = drawing(this.answer.time, this.panels(), Math.max(300, Math.floor(this.figure.clientWidth)), {alt: this.alt()});
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
    this.silence = setTimeout(() => { this.aloud.textContent = spoken(this.answer, this.sliding, sentences); }, SILENT - STILL);
  }
}

for (const script of document.querySelectorAll("script.whatif-model"))
  new WhatIf(script.parentNode, JSON.parse(script.textContent));
