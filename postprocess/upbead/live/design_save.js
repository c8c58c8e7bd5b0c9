// The numbers of a page of a design as a table, and what was asked as a design file that `upbead waves` reads.

export function numbersCsv(title, asked, answer, tables) {
  const quoted = (text) => `"${String(text).replaceAll('"', '""')}"`, rows = tables.flatMap(([, list]) => list);
  const head = [`# ${title}`, ...answer.warnings.map(({name, text}) => `# warning ${name}: ${text}`)];
  return [...head, "key,value,name", ...rows.map(([key, name, , value]) => [key, value, quoted(name)].join(","))].join("\n") + "\n";
}

const toml = (value) => typeof value === "string" ? JSON.stringify(value) : String(value);
const tableText = (name, values) => `[${name}]\n${Object.entries(values).filter(([, value]) => value !== undefined).map(([key, value]) => `${key} = ${toml(value)}\n`).join("")}`;

// given: keys of [waves.NAME]; a level besides the section's own is [levels] page.
export function designToml({title, water, section, duration, combined, limits}, given, rise) {
  return [`title = ${toml(title)}\ngravity = ${toml(water.gravity)}\n`, ...(rise === 0 ? [] : [tableText("levels", {page: rise})]),
    tableText("fluid", {density: water.density}),
    tableText("section", section), tableText("duration", duration), tableText("combined", combined),
    ...(Object.keys(limits).length === 0 ? [] : [tableText("limits", limits)]), tableText("waves.page", given)].join("\n");
}
