// The page of a design: from the fields to pressures, safety and sliding by formulas, at every move.
import {checkItems, checksOfDesign} from "./checks.js";
import {DesignControls} from "./design_controls.js";
import {designToml, numbersCsv} from "./design_save.js";
import {headlineOfDesign, notesOfDesign, spokenDesign, tablesOfDesign} from "./design_told.js";
import {element, symbolic} from "./element.js";
import {formulaAnswer} from "./formulas.js";
import {askedText, Kept} from "./kept.js";
import {Life} from "./life.js";
import {linkButton, openLinked} from "./link.js";
import {profileDrawing} from "./profile.js";
import {saveButton} from "./save.js";
import {contradictions} from "./validity.js";

const QUIET = 700; // ms after the last move until the answer is said aloud

class DesignPage {
  constructor(root, design) {
    Object.assign(this, {root, design});
    this.controls = new DesignControls(design, () => this.update());
    this.wrong = element("p", {class: "wrong", role: "alert"});
    this.aloud = element("p", {class: "aloud", role: "status"});
    this.headline = element("dl", {class: "headline"});
    this.figure = element("figure");
    this.tables = element("div", {class: "tables"});
    this.warnings = element("ul", {class: "trust"});
    this.checks = element("ul", {class: "checks"});
    this.kept = new Kept(() => this.toKeep(), () => this.answer && this.show(), linkButton((text) => this.kept.say(text)));
    this.notes = element("ul", {class: "notes"});
    const answer = element("div", {class: "answer"}, this.wrong, this.kept.element, this.checks, this.warnings, this.figure, this.tables, this.notes, this.buttons(), this.aloud);
    this.life = design.life ? new Life(design.life) : null;
    root.append(this.headline, element("div", {class: "whatif-parts"}, this.controls.form, answer), ...(this.life ? [this.life.element] : []));
    new ResizeObserver(([{contentRect}]) => {
      this.width = Math.max(280, Math.floor(contentRect.width)); // kept: to ask for it after every move lays the page out once more
      if (this.answer) this.draw();
    }).observe(this.figure);
    this.width = Math.max(280, Math.floor(this.figure.clientWidth));
    this.update();
    openLinked(root);
  }
  // What is kept of this answer.
  toKeep() {
    const {ofWave, level, ofCaisson} = this.controls;
    return this.answer && {name: askedText([...ofWave, level, ...ofCaisson]), rows: tablesOfDesign(this.answer).flatMap(([, rows]) => rows)};
  }
  buttons() {
    const save = (text, make) => saveButton(text, () => this.answer && make());
    return element("div", {class: "saves"},
      save("Numbers (CSV)", () => ["numbers.csv", numbersCsv(this.design.title, this.asked, this.answer, tablesOfDesign(this.answer)), "text/csv"]),
      save("Design (TOML)", () => ["design.toml", designToml(this.asked, this.controls.given(), this.answer.rise), "text/plain"]),
      save("Picture (SVG)", () => ["pressures.svg", profileDrawing(this.answer, 900, {forFile: true, alt: this.alt()}), "image/svg+xml"]));
  }
  // An answer to something else never stays.
  update() {
    clearTimeout(this.silence);
    this.answer = null;
    try {
      this.answer = this.ask();
    } catch (error) {
      this.wrong.textContent = `No answer. ${error.message}`;
    }
    this.root.classList.toggle("unanswered", !this.answer);
    this.root.dispatchEvent(new CustomEvent("answered", {detail: this.answer && {...this.answer, design: this.asked}}));
    if (!this.answer) return;
    this.wrong.textContent = "";
    this.show();
    if (this.life) this.life.follow(this.asked.section);
    this.silence = setTimeout(() => { this.aloud.textContent = spokenDesign(this.answer); }, QUIET);
  }
  ask() {
    const mistakes = this.controls.mistakes();
    if (mistakes.length > 0) throw new Error(mistakes.join(". ") + ".");
    const rise = this.controls.rise();
    this.asked = this.controls.asked();
    const refused = contradictions(this.asked.section, this.asked.water, rise);
    if (refused.length > 0) throw new Error(refused.join(". ") + ".");
    const answer = formulaAnswer(this.asked, this.controls.given(), rise);
    if (tablesOfDesign(answer).some(([, rows]) => rows.some(([, , , value]) => value !== null && !Number.isFinite(value)))) throw new Error("The answer is not finite: give a wave and a section that press on the wall.");
    return answer;
  }
  alt() {
    const {pressure: p} = this.answer;
    return `Pressures on the caisson, to scale: p1 ${Math.round(p.p1)} Pa at still water, p3 ${Math.round(p.p3)} Pa at the bottom, p4 ${Math.round(p.p4)} Pa at the crest, pu ${Math.round(p.pu)} Pa under the seaward edge`;
  }
  show() {
    this.headline.replaceChildren(...headlineOfDesign(this.answer).map(([name, text]) => element("div", {}, element("dt", {}, ...symbolic(name)), element("dd", {}, text))));
    this.showTables();
    this.checks.replaceChildren(...checkItems(checksOfDesign(this.answer, this.design.held_to)));
    const {warnings} = this.answer;
    this.warnings.replaceChildren(...(warnings.length === 0 ? [element("li", {class: "quiet"}, "No warning: wave and section are within what the formulas were made for.")]
      : warnings.map(({name, text}) => element("li", {class: "warned", "data-warning": name}, ...symbolic(text)))));
    this.notes.replaceChildren(...notesOfDesign(this.answer, {...this.asked, own: this.design.section},
      this.design.notes).map((text) => element("li", {}, ...symbolic(text))));
    this.draw();
  }
  // The rows stay, their numbers change.
  showTables() {
    const told = tablesOfDesign(this.answer);
    if (!this.cells) {
      this.cells = told.map(([, rows]) => rows.map(([key]) => element("data", {"data-key": key})));
      this.tables.append(...told.map(([caption, rows], t) => element("table", {}, element("caption", {}, caption), element("tbody", {}, ...rows.map(([, name], i) =>
        element("tr", {}, element("th", {scope: "row"}, ...symbolic(name)), element("td", {}, this.cells[t][i], element("span", {class: "kept"}))))))));
    }
    told.forEach(([, rows], t) => rows.forEach(([, , text, value], i) => {
      this.cells[t][i].value = String(value);
      this.cells[t][i].textContent = text;
      const kept = this.kept.beside(rows[i][0], value);
      this.cells[t][i].nextSibling.textContent = kept && `kept ${kept}`;
    }));
  }
  draw() {
    this.figure.innerHTML = profileDrawing(this.answer, this.width, {alt: this.alt()});
  }
}

for (const script of document.querySelectorAll("script.design-model")) new DesignPage(script.parentNode, JSON.parse(script.textContent));
