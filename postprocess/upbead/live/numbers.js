// Numbers as people read them, as reporting/units.py has them: four digits, a prefix that suits the size.

const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""]], PREFIXED = ["N/m", "Pa", "N m/m"];

const superscript = (number) => String(number).replace(/[-\d]/g, (sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]);

const FORMATS = {}; // by decimals: to make one takes longer than to use it a hundred times

export function plain(value, digits = 4) {
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(Number(value.toPrecision(digits)))));
  if (exponent < -4 || exponent > 9) return `${(value / 10 ** exponent).toPrecision(digits)} × 10${superscript(exponent)}`.replace("-", "−");
  const decimals = Math.max(0, digits - 1 - exponent);
  return (FORMATS[decimals] ??= new Intl.NumberFormat("en", {maximumFractionDigits: decimals})).format(value).replace("-", "−");
}

// [factor, unit] by which a value is read best; 10 times a prefix itself is needed for it: 1,600 kN/m.
export function scaleOf(unit, size) {
  if (PREFIXED.includes(unit))
    for (const [prefix, name] of PREFIXES) if (size >= prefix * (prefix > 1e3 ? 10 : 1)) return [1 / prefix, name + unit];
  if (unit === "m" && size > 0 && size < 1) return [1e3, "mm"];
  return [1, unit];
}

export function quantity(value, unit) {
  const [factor, name] = scaleOf(unit, Math.abs(value));
  return `${plain(value * factor)} ${name}`.trim().replaceAll(" ", "\u00a0");
}

export const percent = (value, digits = 2) => `${plain(100 * value, digits)}\u00a0%`;

// Round numbers from low to high, as reporting/ticks.py has them: [value, text].
export function ticks(low, high, count) {
  if (!(high > low)) return [];
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= raw * (1 - 1e-9));
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), found = [];
  for (let i = Math.ceil(low / step - 1e-9); i <= Math.floor(high / step + 1e-9); ++i)
    found.push([i * step, (i * step + 0).toLocaleString("en", {minimumFractionDigits: decimals, maximumFractionDigits: decimals}).replace("-", "−")]);
  return found;
}

// As the program writes numbers in its sentences (significant() of src/base/text.cc): "0.05", "1e-05".
export function digits(value, count = 3) {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
  if (value === 0) return "0";
  const [mantissa, power] = value.toExponential(count - 1).split("e"), exponent = Number(power);
  const short = (text) => text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  if (exponent >= -4 && exponent < count) return short(value.toFixed(count - 1 - exponent));
  return `${short(mantissa)}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
}

// p_e of an answer of formulas.js, or why there is none.
export function heelText({stability: s, pressure, section}) {
  if (pressure.uplift >= section.submerged_weight) return "none: it floats up";
  return s.safety_overturning <= 1 ? "beyond all numbers: it overturns" : quantity(s.heel_pressure, "Pa");
}
