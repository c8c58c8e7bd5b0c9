// Tables and the picture as files.
import {element} from "./element.js";

const COLUMNS = [["P (N/m)", "P"], ["F_T (N/m)", "F"], ["U (N/m)", "U"], ["N' (N/m)", "N"], ["M' (N)", "M"], ["toe pressure (Pa)", "toe"], ["heel pressure (Pa)", "heel"]];

// Histories, after the numbers as comments.
export function historiesCsv(title, answer, rows) {
  const columns = COLUMNS.filter(([, key]) => answer[key]);
  const head = [`# ${title}`, ...rows.map(([key, name, , value]) => `# ${key} (${name}): ${value === null ? "none" : value}`)];
  const lines = Array.from(answer.time, (t, n) => [t, ...columns.map(([, key]) => answer[key][n])].join(","));
  return [...head, ["time (s)", ...columns.map(([name]) => name)].join(","), ...lines].join("\n") + "\n";
}

// The wave as `upbead respond` reads it.
export function waveCsv(wave, loads) {
  const lines = wave.time.map((t, n) => [t, ...wave.loads.map((values) => values[n])].join(","));
  return [["time (s)", ...loads.map(({name, unit}) => `${name} (${unit})`)].join(","), ...lines].join("\n") + "\n";
}

// A button that offers the file that make() returns as [name, text, type], or nothing where that is null.
export function saveButton(label, make) {
  const button = element("button", {type: "button"}, label);
  button.addEventListener("click", () => {
    const file = make();
    if (file) offer(...file);
  });
  return button;
}

function offer(name, text, type) {
  const address = URL.createObjectURL(new Blob([text], {type}));
  element("a", {href: address, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
