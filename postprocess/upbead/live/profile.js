// The pressures of a wave on the caisson as one SVG: lengths of the section to one scale in both directions, pressures to
// the scale that stands beside them.
import {escaped, label, PAPER, SCREEN, tenths} from "./plot.js";
import {plain, quantity, scaleOf} from "./numbers.js";

const MARGIN = 14, FOOT_ROOM = 46, MOUND_SLOPE = 2, LONGEST = 0.42; // of the width, for the largest pressure

// A round pressure (Pa) a pixel: it jumps by 2 to 2.5 only, so that a wave that grows is seen to grow.
function pressureScale(largest, room) {
  const raw = largest / room, power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= raw * (1 - 1e-9));
}

// Pixels of metres and pascals.
function placed({section, pressure}, width) {
  const {water_depth: h, foundation_depth: bottom, crest, width: B, berm_width, berm_depth} = section, deepest = Math.max(h, bottom);
  const scaled = Math.min(pressure.eta_star, 1.5 * crest + 5), top = Math.max(crest, scaled) + 0.08 * (bottom + crest);
  const before = Math.max(berm_width + MOUND_SLOPE * Math.max(h - berm_depth, 0), 0.9 * (bottom + crest)), behind = 0.35 * B;
  const pixel = Math.min((width - 2 * MARGIN) / (before + B + behind), 330 / (top + deepest));
  const front = MARGIN + before * pixel + Math.max(0, (width - 2 * MARGIN - (before + B + behind) * pixel) / 2), level = MARGIN + top * pixel;
  const pascal = pressureScale(Math.max(pressure.p1, pressure.pu, 1), Math.min(LONGEST * width, front - MARGIN - 60));
  const base = level + bottom * pixel + Math.max(0, pressure.pu / pascal);
  return {pixel, pascal, front, level, X: (x) => front + x * pixel, Y: (z) => level - z * pixel, bed: level + deepest * pixel,
    height: Math.max(level + deepest * pixel, base + 18) + FOOT_ROOM};
}

const polygon = (points, attributes) => `<path d="M${points.map(([x, y]) => `${tenths(x)} ${tenths(y)}`).join("L")}Z" ${attributes}/>`;
const line = (x1, y1, x2, y2, attributes) => `<path d="M${tenths(x1)} ${tenths(y1)}L${tenths(x2)} ${tenths(y2)}" fill="none" ${attributes}/>`;

function ground({X, Y, bed}, {water_depth: h, foundation_depth: bottom, berm_depth: d, berm_width, width: B}, width, colours) {
  const foot = (top) => MOUND_SLOPE * Math.max(h - top, 0), toe = -berm_width - foot(d), heel = B + 0.25 * B;
  const mound = [[X(toe), Y(-h)], [X(-berm_width), Y(-d)], [X(0), Y(-d)], [X(0), Y(-bottom)], [X(B), Y(-bottom)], [X(heel), Y(-bottom)], [X(heel + foot(bottom)), Y(-h)]];
  return (h > Math.min(d, bottom) ? polygon(mound, `fill="${colours.rule}"`) : "") +
    line(0, Y(-h), width, Y(-h), `stroke="${colours.quiet}" stroke-width="1.5"`) + (bed > Y(-h) + 1 ? line(X(0), bed, X(B), bed, `stroke="${colours.rule}"`) : "");
}

// A text with paper around its letters, to be read over what is drawn.
const over = (x, y, text, colours, anchor = "end") => label(x, y, text, `fill="${colours.ink}" text-anchor="${anchor}" font-size="11.5" ` +
  `paint-order="stroke" stroke="${colours.paper}" stroke-width="4" stroke-linejoin="round"`);

function pressures(at, {section, pressure: p}, colours) {
  const {X, Y, pascal, front} = at, {foundation_depth: bottom, crest, width: B} = section, left = (value) => front - value / pascal, top = Math.min(p.eta_star, crest);
  const wall = [[front, Y(-bottom)], [left(p.p3), Y(-bottom)], [left(p.p1), Y(0)], [left(p.p4), Y(top)], [front, Y(top)]];
  const under = [[front, Y(-bottom)], [X(B), Y(-bottom)], [front, Y(-bottom) + p.pu / pascal]];
  const blue = `fill="${colours.lines[0]}" fill-opacity="0.28" stroke="${colours.lines[0]}" stroke-width="1.6"`, red = blue.replaceAll(colours.lines[0], colours.lines[2]);
  const told = (name, value) => `${name} ${quantity(value, "Pa")}`, arm = p.force > 0 ? p.force_moment / p.force : 0;
  return polygon(wall, blue) + polygon(under, red) +
    over(left(p.p1) - 5, Y(0) - 4, told("p₁", p.p1), colours) + over(left(p.p3) - 5, Y(-bottom) + 4, told("p₃", p.p3), colours) +
    (p.p4 > 0 ? over(left(p.p4) - 5, Y(top) + 4, told("p₄", p.p4), colours) : "") +
    over(front + 4, Y(-bottom) + p.pu / pascal + 13, told("pᵤ", p.pu), colours, "start") +
    arrow(front - 46, Y(-bottom + arm), front - 4, Y(-bottom + arm), colours.lines[0]) +
      over(front + 6, Y(-bottom + arm) + 4, `P ${quantity(p.force, "N/m")}`, colours, "start") +
    arrow(X(B / 3), Y(-bottom) + 34, X(B / 3), Y(-bottom) + 3, colours.lines[2]) + over(X(B / 3) + 8, Y(-bottom) + 26, `U ${quantity(p.uplift, "N/m")}`, colours, "start");
}

// Its head is at the second point.
function arrow(x1, y1, x2, y2, colour) {
  const along = x2 > x1, tip = along ? [[x2, y2], [x2 - 9, y2 - 4.5], [x2 - 9, y2 + 4.5]] : [[x2, y2], [x2 - 4.5, y2 + 9], [x2 + 4.5, y2 + 9]];
  return line(x1, y1, x2, y2, `stroke="${colour}" stroke-width="2.4"`) + polygon(tip, `fill="${colour}"`);
}

// The water on both sides, with the triangle of its level.
function still({X, Y, front}, {water_depth: h, width: B}, width, colours) {
  const sea = (from, to) => polygon([[from, Y(0)], [to, Y(0)], [to, Y(-h)], [from, Y(-h)]], `fill="${colours.lines[0]}" fill-opacity="0.08"`) +
    line(from, Y(0), to, Y(0), `stroke="${colours.lines[0]}" stroke-width="1.2"`);
  const x = 0.5 * (X(B) + width), y = Y(0), level = polygon([[x, y], [x - 5, y - 8], [x + 5, y - 8]], `fill="none" stroke="${colours.ink}"`) +
    line(x - 8, y + 3, x + 8, y + 3, `stroke="${colours.ink}"`) + line(x - 4, y + 6, x + 4, y + 6, `stroke="${colours.ink}"`);
  return sea(0, front) + sea(X(B), width) + level;
}

function water({Y, front}, {rise, pressure}, own, colours) {
  const before = rise === 0 ? "" : line(0, Y(-rise), front, Y(-rise), `stroke="${colours.quiet}" stroke-dasharray="3 4"`) +
    over(4, Y(-rise) + (rise > 0 ? 13 : -4), own, colours, "start");
  return before + line(front - 30, Y(pressure.eta_star), front, Y(pressure.eta_star), `stroke="${colours.quiet}" stroke-dasharray="6 4"`) +
    over(front - 34, Y(pressure.eta_star) + 4, `η* ${plain(pressure.eta_star, 3)} m`, colours);
}

// A round number of metres and of pascals, as lengths.
function scales(at, width, colours) {
  const y = at.height - 14, metres = [1, 2, 5, 10, 20, 50, 100].find((value) => value * at.pixel >= 40) ?? 200, pascals = 50 * at.pascal,
    [factor, unit] = scaleOf("Pa", 10 * pascals);
  const bar = (x, length, text, colour) => line(x, y, x + length, y, `stroke="${colour}" stroke-width="3"`) +
    label(x, y - 7, text, `fill="${colours.quiet}" font-size="11"`);
  return bar(MARGIN, metres * at.pixel, `${metres} m`, colours.ink) + bar(MARGIN + metres * at.pixel + 40, 50, `${plain(pascals * factor, 3)} ${unit}`, colours.lines[0]);
}

// The SVG's text; answer: of formulas.js.
export function profileDrawing(answer, width, {forFile = false, alt = ""} = {}) {
  const colours = forFile ? {...PAPER, paper: "#fff"} : {...SCREEN, paper: "var(--paper)"}, at = placed(answer, width), {section} = answer, {X, Y} = at;
  const caisson = `<rect x="${tenths(X(0))}" y="${tenths(Y(section.crest))}" width="${tenths(section.width * at.pixel)}" height="${tenths((section.crest + section.foundation_depth) * at.pixel)}" ` +
    `fill="${colours.paper}" stroke="${colours.ink}" stroke-width="1.6"/>`;
  const inside = still(at, section, width, colours) + ground(at, section, width, colours) + water(at, answer, "level of the section", colours) + caisson + pressures(at, answer, colours) +
    scales(at, width, colours);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${Math.ceil(at.height)}" role="img" aria-label="${escaped(alt).replace(/"/g, "&quot;")}" ` +
    `font-family="system-ui, DejaVu Sans, sans-serif" font-size="12">${forFile ? '<rect width="100%" height="100%" fill="#fff"/>' : ""}${inside}</svg>`;
}
