// Histories of an answer as one SVG: panels below each other with one axis of time.
import {scaleOf, ticks} from "./numbers.js";

const LEFT = 64, RIGHT = 10, HEAD = 24, GAP = 16, FOOT = 40, HEIGHT = 190;
export const SCREEN = {ink: "var(--ink)", quiet: "var(--quiet)", rule: "var(--rule)", warn: "var(--warn)", lines: [0, 1, 2, 3].map((i) => `var(--c${i})`)};
export const PAPER = {ink: "#1c2430", quiet: "#5c6773", rule: "#d8dde3", warn: "#9a4a00", lines: ["#0b62a4", "#2a7f3f", "#c0392b", "#1c2430"]};

// [{title, unit, lines: [{name, y, colour, dashed}]}] of what an answer has.
export function panelsOf(answer, friction, weight) {
  const forces = [{name: "P", y: answer.P, colour: 0}, {name: "F_T", y: answer.F, colour: 2}];
  if (friction) {
    const resists = answer.F.map((_, n) => friction * Math.max(weight - (answer.U ? answer.U[n] : 0), 0));
    forces.push({name: "μ (W′ − U)", y: resists, colour: 3, dashed: true});
  }
  const panels = [{title: "Force and shear force at the bottom", unit: "N/m", lines: forces}];
  if (answer.N) {
    panels.push({title: "Normal force N′ on the base", unit: "N/m", lines: [{name: "N′", y: answer.N, colour: 1}]});
    panels.push({title: "Pressure under the edges, in motion", unit: "Pa", lines: [
      {name: "heel (landward)", y: answer.heel, colour: 2}, {name: "toe (seaward)", y: answer.toe, colour: 0, dashed: true}]});
  }
  return panels;
}

// Of many points the least and the largest of each of `spans` spans, so that no peak is lost: [index ...].
function thinned(time, y, spans) {
  if (time.length <= 2 * spans) return Array.from(time.keys());
  const kept = [0];
  for (let s = 0; s < spans; ++s) {
    const from = Math.floor(s * time.length / spans), to = Math.floor((s + 1) * time.length / spans);
    let low = from, high = from;
    for (let n = from; n < to; ++n) {
      if (y[n] < y[low]) low = n;
      if (y[n] > y[high]) high = n;
    }
    if (low === high) kept.push(low); else kept.push(Math.min(low, high), Math.max(low, high));
  }
  kept.push(time.length - 1);
  return kept;
}

function rangeOf(lines) {
  let low = 0, high = 0;
  for (const {y} of lines)
    for (const value of y) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  const room = 0.06 * (high - low || 1);
  return [low - (low < 0 ? room : 0), high + room];
}

export const tenths = (value) => Math.round(10 * value) / 10;
export const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
export const label = (x, y, text, attributes) => `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" ${attributes}>${escaped(text)}</text>`;

// F_T with its subscript.
const name = (text) => escaped(text).replace(/^([A-Z])_([A-Z])$/, '<tspan font-style="italic">$1</tspan><tspan dy="3" font-size="9">$2</tspan>');

function legend(lines, width, y, colours) {
  let x = width - RIGHT, text = "";
  for (const {name: words, colour, dashed} of lines.filter(({faint}) => !faint).reverse()) {
    x -= 7 * words.length + 6;
    text += `<text x="${x}" y="${y}" fill="${colours.ink}">${name(words)}</text><path d="M${x - 24} ${y - 4}h18" stroke="${colours.lines[colour]}" ` +
      `stroke-width="2.4" fill="none"${dashed ? ' stroke-dasharray="6 4"' : ""}/>`;
    x -= 34;
  }
  return text;
}

function panel({title, unit, lines}, now, end, width, top, colours, mark) {
  const [low, high] = rangeOf(lines), [factor, unitName] = scaleOf(unit, Math.max(-low, high));
  const narrow = width < 560, head = top + HEAD + (narrow ? 16 : 0), bottom = top + HEIGHT;
  const X = (t) => LEFT + t / end * (width - LEFT - RIGHT), Y = (v) => bottom - (v - low) / (high - low) * (bottom - head);
  let text = label(0, top + 12, `${title} (${unitName})`, `fill="${colours.ink}" font-weight="600"`) +
    legend(lines, width, top + (narrow ? 28 : 12), colours);
  for (const [value, words] of ticks(low * factor, high * factor, 4)) {
    const y = Y(value / factor).toFixed(1);
    text += `<path d="M${LEFT} ${y}H${width - RIGHT}" stroke="${value === 0 ? colours.quiet : colours.rule}"/>` +
      label(LEFT - 6, Number(y) + 4, words, `fill="${colours.quiet}" text-anchor="end" font-size="11"`);
  }
  if (mark) text += lifted(X(mark.time), width - RIGHT, head, bottom, colours);
  for (const {y, colour, dashed, faint, time = now} of lines) {
    const points = thinned(time, y, Math.ceil(width / 3)).map((n) => `${tenths(X(time[n]))} ${tenths(Y(y[n]))}`);
    text += `<path d="M${points.join("L")}" fill="none" stroke="${colours.lines[colour]}" stroke-width="${faint ? 1.2 : 1.7}"${faint ? ' stroke-opacity="0.5"' : ""}${dashed ? ' stroke-dasharray="6 4"' : faint ? ' stroke-dasharray="2 2"' : ""}/>`;
  }
  return text;
}

// From the time on at which the base lifts the model, whose ground sticks to it, is doubtful: shaded.
function lifted(from, to, head, bottom, colours) {
  return `<path d="M${tenths(from)} ${head}H${to}V${bottom}H${tenths(from)}Z" fill="${colours.warn}" fill-opacity="0.08"/>` +
    `<path d="M${tenths(from)} ${head}V${bottom}" stroke="${colours.warn}" stroke-dasharray="3 3"/>`;
}

function timeAxis(end, width, y, colours, mark, kept) {
  const notes = [...(mark ? ["shaded: after the base lifts"] : []), ...(kept ? ["dotted: kept"] : [])].join("; ");
  let text = label(0, y + 32, notes, `fill="${mark ? colours.warn : colours.quiet}"`) + label(width - RIGHT, y + 32, "time (s)", `fill="${colours.quiet}" text-anchor="end"`);
  for (const [value, words] of ticks(0, end, width < 560 ? 4 : 8))
    text += label(LEFT + value / end * (width - LEFT - RIGHT), y + 16, words, `fill="${colours.quiet}" text-anchor="middle" font-size="11"`);
  return text;
}

// Names of the warnings of a scene under which no verdict may be drawn; "" where none is.
export const voidsOf = ({warnings = []}) => [...new Set(warnings.filter(({voids}) => voids).map(({name}) => name))].join("; ");

// The SVG's text. Of a picture for elsewhere the colours are those of light paper.
export function drawing(time, panels, width, {forFile = false, alt = "", mark = null, voids = ""} = {}) {
  const colours = forFile ? PAPER : SCREEN, kept = panels.flatMap(({lines}) => lines).filter(({faint}) => faint);
  const end = Math.max(time[time.length - 1], ...kept.map((line) => line.time[line.time.length - 1])), below = panels.length * (HEIGHT + GAP) - GAP;
  const inside = panels.map((one, i) => panel(one, time, end, width, i * (HEIGHT + GAP), colours, mark)).join("") + timeAxis(end, width, below, colours, mark, kept.length > 0);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${below + FOOT}" role="img" aria-label="${escaped(alt).replace(/"/g, "&quot;")}" ` +
    `font-family="system-ui, DejaVu Sans, sans-serif" font-size="12">${forFile ? '<rect width="100%" height="100%" fill="#fff"/>' : ""}${inside}${voids && voidMark(voids)}</svg>`;
}

function voidMark(voids) {
  return `<text class="void" x="50%" y="50%" text-anchor="middle" font-size="26" font-weight="700" style="fill:#b00020;font-size:26px" opacity="0.5">VOID: ${escaped(voids)}</text>`;
}
