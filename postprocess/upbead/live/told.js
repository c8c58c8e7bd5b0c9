// An answer in words and numbers: the rows of the table, and sentences about where the model holds.
import {percent, plain, quantity} from "./numbers.js";

const margin = (value) => value === null ? "nothing overturns" : plain(value, 3);
const pressure = (value) => value === null ? "the resultant leaves the base" : quantity(value, "Pa");
const EDGES = {"-1": "the seaward edge", 0: "the whole base", 1: "the landward edge"};
const lifts = ({worst, time}) => worst.lifts === null ? "never" : `${EDGES[worst.lifts.edge]}, at ${quantity(time[worst.lifts.n], "s")}`;
const circleText = ({circle: {factor, n, circle, computed}, time}) => circle === null ? `0: the resultant leaves the base at ${quantity(time[n], "s")}` :
  `${plain(factor, 3)}, ${circle.side > 0 ? "landward" : "seaward"} at ${quantity(time[n], "s")}, by ${computed ? "computed" : "still water's"} pore pressure`;
const meters = (value) => value === 0 ? "0" : quantity(value, "m");

// When the base first lifts, as a mark in the histories; null where it never does.
export function liftOf({worst, time}) {
  if (!worst || worst.lifts === null) return null;
  const at = time[worst.lifts.n];
  return {time: at, text: `${EDGES[worst.lifts.edge].replace("its ", "")}, ${quantity(at, "s")}`};
}

// [key of `upbead respond`, name, text, value or null]
export function rowsOf(answer, asked) {
  const rows = [
    ["peak_force", "largest P", quantity(answer.peak_force, "N/m"), answer.peak_force],
    ["peak_force_seaward", "least P (seaward)", quantity(answer.peak_force_seaward, "N/m"), answer.peak_force_seaward],
    ["peak_shear", "largest F_T", quantity(answer.peak_shear, "N/m"), answer.peak_shear],
    ["peak_shear_time", "at", quantity(answer.peak_shear_time, "s"), answer.peak_shear_time],
    ["ratio", "peak F_T / peak P", answer.ratio === null ? "none" : percent(answer.ratio, 3), answer.ratio],
    ["peak_shear_seaward", "least F_T (seaward)", quantity(answer.peak_shear_seaward, "N/m"), answer.peak_shear_seaward],
  ];
  if (!asked) return rows;
  rows.push(["sliding", "sliding distance S, eq. (4)", meters(answer.S), answer.S], ["slips", "slips", String(answer.slips), answer.slips]);
  if (answer.worst) rows.push(
    ["least_normal_force", "least N′", quantity(answer.worst.leastN, "N/m"), answer.worst.leastN],
    ["peak_heel_pressure", "largest heel pressure in motion", pressure(answer.worst.heel), answer.worst.heel],
    ["peak_toe_pressure", "largest toe pressure in motion", pressure(answer.worst.toe), answer.worst.toe],
    ["base_lifts", "the base first lifts", lifts(answer), answer.worst.lifts && answer.time[answer.worst.lifts.n]],
    ["least_overturning_margin", "least margin against overturning", margin(answer.worst.margin), answer.worst.margin]);
  if (answer.circle) rows.push(["circle_factor", "least factor of slip circles", circleText(answer), answer.circle.factor]);
  return rows;
}

// What stays in sight while one drags.
export function headline(answer, asked) {
  const told = [["largest F_T", quantity(answer.peak_shear, "N/m")], ["of largest P", answer.ratio === null ? "none" : percent(answer.ratio, 3)]];
  return asked ? [...told, ["S", meters(answer.S)]] : told;
}

export function rowsOfTrust({beyond_band, error_estimate}) {
  return [
    ["error_estimate", "error of F_T, at most", error_estimate === null ? "not known" : percent(error_estimate), error_estimate],
    ["beyond_band", "part of F_T beyond what was checked", percent(beyond_band), beyond_band],
  ];
}

// [{text, warns}] of how far the numbers hold.
export function trustSentences({validity}, {beyond_band, error_estimate}) {
  const limit = validity.tolerance, list = [];
  if (error_estimate === null)
    list.push({warns: true, text: "The model holds nothing that tells how wrong its answer to a wave is: make it again with upbead reduce."});
  else
    list.push({warns: error_estimate > limit, text: `The history of F_T is wrong by at most ${percent(error_estimate)} of its largest value, by two larger models` +
      (error_estimate > limit ? `: more than the model's tolerance of ${percent(limit)}. Reduce again with such a wave in the case, or march it with upbead run.` : ".")});
  if (beyond_band > limit)
    list.push({warns: true, text: `${percent(beyond_band)} of F_T lies beyond ${plain(validity.highest_frequency, 3)} Hz, up to which the model has been checked ` +
      `(tolerance ${percent(limit)}): reduce again with a shorter pulse, or march it with upbead run.`});
  return list;
}

// What the numbers stand on, as far as it depends on what is asked.
export function notesOf(model, answer, sliding) {
  const notes = [];
  if (!sliding) return model.mass > 0 ? ["S and what presses on the base are told where friction and W′ are given."] : [];
  if (answer.S !== 0)
    notes.push("S is of a rigid block under F_T of a caisson that sticks." + (model.slips ? " upbead respond also tells S of the caisson that slides as a rigid block on the moving ground." : ""));
  if (model.contact) notes.push("The page slides the caisson as a whole, and its bottom cannot lift: upbead respond answers slip and lift node by node by this model, upbead expected S of whole lives.");
  if (answer.worst) {
    notes.push("Heel and toe pressure in motion vary linearly over the width in contact and grow without bound as the resultant comes to the edge. " +
      "limits.base_pressure, 400 to 600 kPa, was made for p_e by Goda's formulas, not for them.");
    if (answer.worst.lifts) notes.push(`The base lifts (${lifts(answer)}): the model's ground sticks to it and bears a tension, so that F_T, N′ and all pressures ` +
      "are doubtful from then on; upbead run with regions.caisson.interface.kind = \"friction\" lets it lift.");
  }
  if (answer.circle && answer.circle.factor < 1)
    notes.push("On the least safe slip circle the ground under the caisson would slip: a factor below 1 of a moment is a permanent displacement and not yet a collapse.");
  if (answer.circle) notes.push(`Slip circles are those of the model's family, whose least factor was up to ${percent(model.circles.gap)} above that of a full search.`);
  if (!model.base) notes.push("The model's file does not tell what stands on the base: no N′, pressures or margin.");
  if (model.sliding && model.sliding.uplift === "history") notes.push("The case's uplift is a record of its own wave; here it is the one chosen above.");
  return notes;
}

// For those who hear the page.
export function spoken(answer, asked, trust) {
  const ratio = answer.ratio === null ? "" : `, ${percent(answer.ratio, 2)} of the largest P`;
  return `Largest F_T ${quantity(answer.peak_shear, "N/m")}${ratio}.` + (asked ? ` S ${meters(answer.S)}.` : "") + ` ${trust.map(({text}) => text).join(" ")}`;
}
