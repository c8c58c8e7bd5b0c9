// A record of one's own: a header line, then times and loads, as docs/records.md has it. What is not sure is refused
// with the line and a cure; `upbead respond` reads more kinds of tables.

const TIME_UNITS = {s: 1, ms: 1e-3, sec: 1, min: 60};
const LOAD_UNITS = {"N/m": {"N/m": 1, "kN/m": 1e3, "MN/m": 1e6}, Pa: {Pa: 1, kPa: 1e3, MPa: 1e6}};
const TIME_NAMES = ["time", "t", "zeit", "temps", "tiempo", "tempo", "時間", "時刻"];
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

// A unit of a force or a pressure as a part of a name: upbead respond reads some of them, this page none.
const UNREAD = /[\s_/.-]([kMG]?N|[kKMGhH]?Pa|KN|MPA|KPA|m?bar|psi|kgf|tf|gf|lbf|kips?|mH2O|mAq)(?=[\s_/.-]|$)/;

function separatorOf(header) {
  if (header.includes(";")) return ";";
  return header.includes("\t") && !header.includes(",") ? "\t" : ",";
}

// "p1 (kPa)" or "p1 [kPa]": its name and unit.
function heading(cell) {
  const text = cell.trim().replace(/^"(.*)"$/, "$1").trim(), found = /^(.+?)\s*[([]([^()[\]]*)[)\]]$/.exec(text);
  return found ? {name: found[1], unit: found[2].trim()} : {name: text, unit: ""};
}

function number(cell, separator, where) {
  const text = separator === "," ? cell.trim() : cell.trim().replace(",", ".");
  const value = NUMBER.test(text) ? Number(text) : NaN;
  if (!Number.isFinite(value)) throw new Error(`${where}: '${cell.trim()}' is not a number; give one such as 1.5e6`);
  return value;
}

// {heads, rows, lines}: numbers by row, and the line of each.
function tableOf(text) {
  const lines = text.replace(/^\ufeff/, "").split(/\r?\n/).map((line, i) => ({line, at: i + 1})).filter(({line}) => line.trim());
  const first = lines.findIndex(({line}) => !/^\s*[#%]/.test(line));
  if (first < 0) throw new Error("an empty file: write a header line and rows of numbers");
  const separator = separatorOf(lines[first].line), heads = lines[first].line.split(separator).map(heading);
  if (heads.every(({name}) => NUMBER.test(name)))
    throw new Error("the first line holds numbers, not the names of the columns: put a header line such as time,force above them");
  const body = lines.slice(first + 1), commas = separator !== "," && body.some(({line}) => line.includes(","));
  const rows = body.map(({line, at}) => {
    const cells = line.split(separator);
    if (commas && cells.some((cell) => cell.includes(".")))
      throw new Error(`line ${at}: a point where other numbers have decimal commas: leave out what groups thousands`);
    if (cells.length !== heads.length) throw new Error(`line ${at}: ${cells.length} cells, in the header ${heads.length}`);
    return cells.map((cell) => number(cell, separator, `line ${at}`));
  });
  return {heads, rows, lines: body.map(({at}) => at)};
}

const isTime = ({name, unit}) => TIME_NAMES.includes(name.toLowerCase()) || unit in TIME_UNITS;

function factorOf({name, unit}, units, wanted, own = "") {
  const hidden = unit === "" && name !== own && UNREAD.exec(name);
  if (hidden) throw new Error(`the name '${name}' holds '${hidden[1]}', a unit that is not read there: write it in brackets behind the name, one of ${Object.keys(units).join(", ")}`);
  if (unit === "") return 1;
  if (unit in units) return units[unit];
  throw new Error(`the unit '${unit}' of column '${name}' is none of ${wanted}; write one of ${Object.keys(units).join(", ")}`);
}

// Which column is which load: by their names, or the only one.
function columnsOf(heads, loads) {
  if (!isTime(heads[0])) throw new Error("the first column is not sure to be the time: call it 'time (s)' or 'time (ms)'");
  const values = heads.slice(1);
  if (values.length === 0) throw new Error("a wave without a load: give a time (s) and a load in every row");
  if (values.length === 1 && loads.length === 1) return [0];
  return values.map(({name}, i) => {
    const at = loads.findIndex((load) => load.name === name);
    if (at < 0) throw new Error(`column '${name}' is no load of the model; its loads are ${loads.map((load) => load.name).join(", ")}`);
    if (values.findIndex((other) => other.name === name) < i) throw new Error(`two columns are called '${name}': give each load once`);
    return at;
  });
}

function requireAscending(time, lines) {
  if (time.length < 2) throw new Error("a wave of one time: give two times or more");
  if (time[0] < 0) throw new Error(`the wave starts at ${time[0]} s, before the response: let it start at 0 or later`);
  for (let n = 1; n < time.length; ++n)
    if (!(time[n] > time[n - 1])) throw new Error(`line ${lines[n]}: ${time[n]} s does not follow ${time[n - 1]} s; let the times ascend`);
}

// The wave of a text; `loads` of the model. Throws Error with what is wrong.
export function readRecord(text, loads) {
  const {heads, rows, lines} = tableOf(text), columns = columnsOf(heads, loads);
  const ofTime = factorOf(heads[0], TIME_UNITS, "a time"), time = rows.map((row) => row[0] * ofTime);
  requireAscending(time, lines);
  const wave = {time, loads: loads.map(() => rows.map(() => 0))};
  columns.forEach((k, i) => {
    const unit = loads[k].unit, factor = factorOf(heads[i + 1], LOAD_UNITS[unit] || {}, `the load, ${unit}`, loads[k].name);
    wave.loads[k] = rows.map((row) => row[i + 1] * factor);
  });
  if (wave.loads.every((values) => values.every((value) => value === 0)))
    throw new Error("the wave is zero throughout: is a wrong column read as the load?");
  return wave;
}
