// The answer of the formulas in words and numbers.
import {heelText, plain, quantity} from "./numbers.js";

const metresOrZero = (value) => value < 1e-9 ? "0" : quantity(value, "m"); // less than a nanometre is round-off

// [caption, [[key of summary.json, name, text, value] ...]] of each table.
export function tablesOfDesign(answer) {
  const {section, wave, pressure: p, without, stability: s} = answer, of = (key, name, value, unit) => [key, name,
    unit === undefined ? plain(value) : quantity(value, unit), value];
  return [
    ["Wave", [of("height", "highest wave H", wave.height, "m"), of("significant_height", "H_1/3", wave.significant, "m"),
      of("wavelength", "wavelength L at the wall", p.wavelength, "m"),
      of("water_depth", "depth h", section.water_depth, "m"), of("submerged_weight", "W′ at this level", section.submerged_weight, "N/m")]],
    ["Coefficients", ["alpha_1", "alpha_2", "alpha_3", "alpha_I", "alpha_star", "lambda_1", "lambda_2", "lambda_3"]
      .map((key) => of(key, key === "alpha_star" ? "α* = max(α_2, α_I, 0)" : key.replace("alpha", "α").replace("lambda", "λ"), p[key]))],
    ["Pressure, with α*", [of("p1", "p_1, at still water", p.p1, "Pa"), of("p3", "p_3, at the bottom", p.p3, "Pa"), of("p4", "p_4, at the crest", p.p4, "Pa"),
      of("pu", "p_u, uplift at the edge", p.pu, "Pa"),
      of("eta_star", "η*, height of the pressure", p.eta_star, "m"), of("force", "P", p.force, "N/m"), of("without_alpha_I.force", "P without α_I", without.force, "N/m"),
      of("uplift", "U", p.uplift, "N/m"), of("force_moment", "M_P, about the bottom's level", p.force_moment, "N m/m"),
        of("uplift_moment", "M_U, about the heel", p.uplift_moment, "N m/m")]],
    ["Safety", [of("safety_sliding", "against sliding", s.safety_sliding), of("safety_overturning", "against overturning", s.safety_overturning),
      ["heel_pressure", "p_e, under the heel", heelText(answer), s.heel_pressure]]],
    ["Sliding", [of("tau_0F", "τ_0F", answer.tau_0F, "s"), of("k", "k(α*)", answer.k), of("tau_0", "τ_0 = k τ_0F", answer.tau_0, "s"),
      of("sliding_force", "F_Smax = P + μ U", s.sliding_force, "N/m"),
      of("ratio", "r = F_Smax/(μ W′)", s.ratio), ...[["sliding_paper", "S by eq. (7)"], ["sliding_exact", "S exact, eqs. (4), (6)"],
        ["sliding_combined", "S combined (1998)"]]
        .map(([key, name]) => [key, name, metresOrZero(answer[key]), answer[key]])]],
  ];
}

const factor = (safety) => plain(safety, 3) + (safety < 1 ? ": does not hold" : "");

export function headlineOfDesign({pressure, stability, sliding_exact: S}) {
  return [["P", quantity(pressure.force, "N/m")], ["U", quantity(pressure.uplift, "N/m")], ["S.F. sliding", factor(stability.safety_sliding)], ["S.F. overturning", factor(stability.safety_overturning)],
    ["S exact", metresOrZero(S)]];
}

// What the numbers stand on.
export function notesOfDesign({wave, stability}, asked, notes) {
  const list = [...notes, "The standing wave of finite height, in crest and trough, is told by upbead waves alone."];
  if (asked.section.width !== asked.own.width) list.push("W and W′ were moved in proportion to B, of the same mean density" +
    (asked.section.centroid === undefined ? "" : ", and t with B") + "; other weights may be given.");
  if (stability.ratio > 1) list.push("S is of the rigid block of Shimosako and Takahashi (1994) under a triangle of τ_0; P with α_I is an effective sliding force.");
  if (wave.height < wave.significant * 1.2) list.push("H is near H_1/3: in the surf zone waves have broken to the depth.");
  return list;
}

export function spokenDesign({pressure, stability, sliding_exact: S, warnings}) {
  return `P ${quantity(pressure.force, "N/m")}, U ${quantity(pressure.uplift, "N/m")}, safety against sliding ${plain(stability.safety_sliding, 3)}, against overturning ` +
    `${plain(stability.safety_overturning, 3)}, S ${metresOrZero(S)}. ${warnings.length === 0 ? "No warning." : `${warnings.length} warning${warnings.length > 1 ? "s" : ""}.`}`;
}
