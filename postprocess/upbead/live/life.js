// Expected sliding over the caisson's width: numbers that `upbead expected` computed when the page was made. They follow no
// slider; where other values are asked than they were computed with, they are greyed and the reason is told.
import {element} from "./element.js";
import {plain, quantity, scaleOf, ticks} from "./numbers.js";
import {label, SCREEN, tenths} from "./plot.js";
import {saveButton} from "./save.js";

const LAWS = {paper: "eq. (7)", exact: "exact", combined: "combined"};
const SAME = ["water_depth", "foundation_depth", "berm_depth", "crest", "berm_width", "bed_slope", "friction"];
const WORDS = {water_depth: "h", foundation_depth: "h′", berm_depth: "d", crest: "h_c", berm_width: "B_M", bed_slope: "tan θ", friction: "μ"};
const LIFE_LEFT = 58, LIFE_RIGHT = 12, LIFE_TOP = 30, LIFE_HEIGHT = 210, LIFE_FOOT = 40;

const differs = (a, b) => Math.abs(a - b) > 1e-9 * Math.max(Math.abs(a), Math.abs(b));

// Why the classes are not of what is asked; null where they are.
function reasonOf(own, asked) {
  const list = SAME.filter((key) => differs(own[key], asked[key])).map((key) => `${WORDS[key]} is ${plain(asked[key])}, in the classes ${plain(own[key])}`);
  for (const [key, name] of [["weight", "W"], ["submerged_weight", "W′"]])
    if (differs(own[key] / own.width, asked[key] / asked.width)) list.push(`${name} is ${plain(asked[key] / asked.width / 1e3)} kN/m of each metre of B, in the classes ${plain(own[key] / own.width / 1e3)} kN/m`);
  return list.length === 0 ? null : list.join("; ");
}

// [{name, values, colour, dashed}]
function linesOf({laws, lives}) {
  const lines = Object.entries(laws).map(([law, values], i) => ({name: LAWS[law], values, colour: i, dashed: law === "paper"}));
  return lives ? [...lines, {name: `lives, ${lives.law}`, values: lives.mean, colour: 3, dashed: true}] : lines;
}

// From S to pixels, with its ticks [value, text]: by powers of ten where the classes are far from each other.
function axisOf(values, bottom) {
  const most = Math.max(...values, 1e-3), least = Math.max(Math.min(...values.filter((value) => value > 0), most), 1e-6 * most), [factor, unit] = scaleOf("m", most);
  if (most < 30 * least)
    return {Y: (s) => bottom - s / (1.05 * most) * LIFE_HEIGHT, ticks: ticks(0, 1.05 * most * factor, 4).map(([value, words]) => [value / factor, words]), unit,
      shown: () => true};
  const low = Math.floor(Math.log10(least)), high = Math.log10(1.3 * most), marks = Array.from({length: Math.floor(high) - low + 1}, (_, i) => 10 ** (low + i));
  return {Y: (s) => bottom - (Math.log10(s) - low) / (high - low) * LIFE_HEIGHT, ticks: marks.map((value) => [value, quantity(value, "m")]), unit: "",
    shown: (s) => s >= 10 ** low};
}

function curves(life, width, at) {
  const lines = linesOf(life), bottom = LIFE_TOP + LIFE_HEIGHT, {Y, unit, shown, ...axis} = axisOf(lines.flatMap(({values}) => values), bottom);
  const low = life.widths[0], high = life.widths.at(-1), X = (b) => LIFE_LEFT + (b - low) / (high - low) * (width - LIFE_LEFT - LIFE_RIGHT);
  let text = label(0, 12, `E(S)${unit && ` (${unit})`} over B (m)`, `fill="${SCREEN.ink}" font-weight="600"`);
  for (const [value, words] of axis.ticks)
    text += `<path d="M${LIFE_LEFT} ${tenths(Y(value))}H${width - LIFE_RIGHT}" stroke="${SCREEN.rule}"/>` +
      label(LIFE_LEFT - 6, Y(value) + 4, words, `fill="${SCREEN.quiet}" text-anchor="end" font-size="11"`);
  for (const [value, words] of ticks(low, high, width < 560 ? 4 : 8)) text += label(X(value), bottom + 16, words,
    `fill="${SCREEN.quiet}" text-anchor="middle" font-size="11"`);
  lines.forEach(({name, values, colour, dashed}, i) => {
    const stroke = `stroke="${SCREEN.lines[colour]}" stroke-width="1.8" fill="none"${dashed ? ' stroke-dasharray="6 4"' : ""}`,
      points = values.map((value, n) => [X(life.widths[n]), value]).filter(([, value]) => shown(value));
    text += (points.length > 1 ? `<path d="M${points.map(([x, value]) => `${tenths(x)} ${tenths(Y(value))}`).join("L")}" ${stroke}/>` : "") +
      points.map(([x, value]) => `<circle cx="${tenths(x)}" cy="${tenths(Y(value))}" r="3" fill="${SCREEN.lines[colour]}"/>`).join("") +
      `<path d="M${width - 150} ${LIFE_TOP + 8 + 18 * i}h22" ${stroke}/>` + label(width - 122, LIFE_TOP + 12 + 18 * i, name, `fill="${SCREEN.ink}"`);
  });
  return svgOf(text + (at >= low && at <= high ? markOf(X(at), at, bottom) : ""), width, bottom + LIFE_FOOT);
}

const markOf = (x, width, bottom) => `<path d="M${tenths(x)} ${LIFE_TOP}V${bottom}" stroke="${SCREEN.ink}" stroke-dasharray="2 3"/>` +
  label(x + 4, bottom - 6, `B ${plain(width)}`, `fill="${SCREEN.ink}" font-size="11"`);
const svgOf = (inside, width, height) => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" role="img" aria-label="Expected sliding over the width; the table has its numbers" ` +
  `font-family="system-ui, DejaVu Sans, sans-serif" font-size="12">${inside}</svg>`;

function tableOfClasses(life) {
  const lines = linesOf(life), cell = (value) => element("td", {}, value < 1e-9 ? "0" : quantity(value, "m"));
  const head = element("tr", {}, element("th", {scope: "col"}, "B"), ...lines.map(({name}) => element("th", {scope: "col"}, name)));
  return element("table", {}, element("caption", {}, "E(S) of each class"), element("thead", {}, head), element("tbody", {}, ...life.widths.map((width, n) =>
    element("tr", {}, element("th", {scope: "row"}, quantity(width, "m")), ...lines.map(({values}) => cell(values[n]))))));
}

function classesCsv(life) {
  const lines = linesOf(life), head = ["B (m)", ...lines.map(({name}) => `E(S) (m) ${name.replace(",", "")}`)].join(",");
  return [`# ${life.title}, computed by ${life.program}`, head, ...life.widths.map((width, n) => [width, ...lines.map(({values}) => values[n])].join(","))].join("\n") + "\n";
}

function wordsOfLives(lives, scatter) {
  if (!lives) return "";
  const scattered = scatter.length === 0 ? "nothing scatters" : `scatter of ${scatter.join(", ").replaceAll("_", " ")}`;
  return ` Mean of ${lives.lives} lives of ${plain(lives.years)} years, ${scattered}.`;
}

export class Life {
  constructor(life) {
    Object.assign(this, {life, asked: life.section});
    const {title, years, waves, limit, lives, scatter, program} = life;
    this.figure = element("figure");
    this.reason = element("p", {class: "warned", role: "status"});
    const told = `Computed beforehand by ${program} (upbead expected) for “${title}”: ${life.widths.length} widths, W, W′ and t in proportion to B. ` +
      (waves === null ? "Storms of a life are drawn; there is no record to sum." : `E(S) of ${plain(waves)} waves in ${plain(years)} years.`) +
      ` Highest waves: ${limit}.` + wordsOfLives(lives, scatter) +
      " The waves are those of the design's sea: H, T, level and angle above change nothing here.";
    this.body = element("div", {class: "life-body"}, this.figure, tableOfClasses(life));
    const save = saveButton("Classes (CSV)", () => ["expected.csv", classesCsv(life), "text/csv"]);
    this.element = element("section", {class: "life", "aria-label": "Storm and life"}, element("h2", {}, "Storm and life"), element("p", {class: "quiet"}, told),
      this.reason, this.body, element("div", {class: "saves"}, save));
    new ResizeObserver(([{contentRect}]) => this.draw(Math.max(280, Math.floor(contentRect.width)))).observe(this.figure);
  }
  follow(asked) {
    this.asked = asked;
    const why = reasonOf(this.life.section, asked), text = why === null ? "" : `Not of what is asked: ${why}. Make the page anew with upbead expected of that design.`;
    if (this.reason.textContent !== text) this.reason.textContent = text;
    this.element.classList.toggle("stale", why !== null);
    if (this.width) this.draw(this.width);
  }
  draw(width) {
    this.width = width;
    this.figure.innerHTML = curves(this.life, width, this.asked.width);
  }
}
