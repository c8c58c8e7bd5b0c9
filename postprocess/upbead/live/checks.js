// What is held to a limit, beside the answer: [{name, text, holds}] as lines.
import {element, symbolic} from "./element.js";
import {plain, quantity} from "./numbers.js";

// At most or at least so much; a value of null is beyond all limits. Without a limit there is no check.
function checked(name, value, limit, unit, atLeast) {
  if (limit === undefined || limit === null) return [];
  const show = (number) => number === null ? "beyond all numbers" : number === 0 ? "0" : unit ? quantity(number, unit) : plain(number, 3);
  const holds = value !== null && (atLeast ? value >= limit : value <= limit);
  return [{name, holds, text: `${show(value)}, ${atLeast ? "at least" : "at most"} ${show(limit)}`}];
}

// Of the formulas: 1 where the design has no limit of a factor, as in `upbead waves`.
export function checksOfDesign({stability: s, sliding_exact: S}, limits) {
  return [...checked("S.F. against sliding", s.safety_sliding, limits.sliding_factor ?? 1, "", true),
    ...checked("S.F. against overturning", s.safety_overturning, limits.overturning ?? 1, "", true),
    ...checked("p_e, under the heel", s.safety_overturning <= 1 ? null : s.heel_pressure, limits.base_pressure, "Pa", false),
    ...checked("S exact", S, limits.sliding, "m", false)];
}

// Of the model: friction, and what the case has limits of.
export function checksOfModel({F, U, S, worst, circle}, sliding, limits) {
  if (!sliding) return [];
  const force = F.reduce((most, value, n) => Math.max(most, value + (U ? sliding.friction * U[n] : 0)), 0);
  return [...checked("F_T + μ U against μ W′", force, sliding.friction * sliding.weight, "N/m", false),
    ...checked("S by eq. (4)", Math.abs(S), limits.sliding, "m", false),
    ...(worst && worst.margin !== null ? checked("margin against overturning", worst.margin, limits.overturning, "", true) : []),
    ...(circle ? checked("slip circles", circle.factor, limits.circles, "", true) : [])];
}

export function checkItems(checks, voids = "") {
  return checks.map(({name, text, holds}) => element("li", {class: holds && !voids ? "holds" : "warned", "data-holds": holds},
    ...symbolic(name), ": ", text, element("strong", {}, (holds ? " holds" : " DOES NOT HOLD") + (voids && ": VOID"))));
}
