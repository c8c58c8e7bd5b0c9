#include "sliding_report.h"

#include "base/text.h"

namespace upbead {

namespace {

std::string seconds(const std::optional<double>& value) {
  return value ? significant(*value, 4) + " s" : "none";
}

std::string wrong_by(const std::optional<double>& error) {
  return error ? " (wrong by up to " + with_unit(*error, "m") + ")" : "";
}

std::string distances(const SlidingSummary& s) {
  const Sliding& slid = s.history.by_history;
  std::string text = "  S           " + with_unit(slid.residual, "m") + wrong_by(s.error_estimate) +
                     " by eq. (4) on F_T(t), in " + std::to_string(slid.slips.size()) +
                     (slid.slips.size() == 1 ? " slip" : " slips") + "; with the vertical motion in N' " +
                     with_unit(s.history.with_normal_force.residual, "m") + "\n";
  if (s.coupled)
    text += "  S, coupled  " + with_unit(s.coupled->slip.residual, "m") + wrong_by(s.coupled->error_estimate) +
            " slipping as a whole on its ground; F_T up to " + with_unit(s.coupled->peak_shear, "N/m") +
            ", N' down to " + with_unit(s.coupled->least_normal, "N/m") + "\n";
  else if (!s.why_not_coupled.empty())
    text += "  S, coupled  not told: " + s.why_not_coupled + "\n";
  if (s.pulse)
    text += "  S_CAL       " + with_unit(s.pulse->paper, "m") +
            " by eq. (7) with tau_0 = " + seconds(s.pulse->duration) + " (k = " + significant(s.pulse->factor) +
            "), S_1 " + with_unit(s.pulse->paper_parts.accelerating, "m") + " and S_2 " +
            with_unit(s.pulse->paper_parts.braking, "m") + "; the same pulse integrated " +
            with_unit(s.pulse->exact, "m") + "\n";
  return text;
}

}  // namespace

std::string describe(const SlidingSummary& s) {
  const HistorySliding& h = s.history;
  std::string text = "sliding     friction " + significant(s.friction) + ", W' " + with_unit(s.buoyant_weight, "N/m") +
                     ", uplift " + s.uplift + "\n";
  text += "  F_Smax      " + with_unit(h.peak_force, "N/m") + " at " + significant(h.peak_force_time, 4) +
          " s, of it mu U " + with_unit(s.friction * h.uplift_at_peak, "N/m", h.peak_force) + "; mu W' " +
          with_unit(h.resistance, "N/m") + ", r = " + significant(h.ratio, 4) + "\n";
  if (h.least_normal_force < 0.)
    text += "  warning     N' falls to " + with_unit(h.least_normal_force, "N/m") + ": the caisson would lift\n";
  if (h.by_history.slips.empty() && h.ratio <= 1.)
    text += "  S           0 m" + wrong_by(s.error_estimate) + ": F_S stays below mu W'\n";
  else
    text += distances(s);
  if (h.own && h.own->by_exact)
    text += "  tau_0       of this history at this r: " + seconds(h.own->by_paper) + " by eq. (7), " +
            seconds(h.own->by_exact) + " integrated, " + seconds(h.own->by_excess) + " by the time above mu W', " +
            seconds(h.own->by_impulse) + " by impulse\n";
  return text;
}

}  // namespace upbead
