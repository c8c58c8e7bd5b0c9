#include "case/formula_checks.h"

#include <array>
#include <utility>

namespace upbead {

namespace {

const char* const goda =
    "Goda's P and U with alpha* = max(alpha_2, alpha_I), which already is an effective sliding force";
const char* const trough_bound =
    "a bound of the trough after Sainflou (1928), without suction under the base: on the safe side, as no standing "
    "wave "
    "of finite height is known (why_no_standing)";
const char* const standing_wave = "the standing wave of finite height, in case the wave does not break";

/// Makes the checks of one wave.
class FormulaChecks {
 public:
  FormulaChecks(const FormulaAnswer& answer, const Limits& limits) : answer_(answer), limits_(limits) {}

  Check check(const std::string& name, const std::string& unit, const std::optional<double>& demand,
              const std::string& key, const char* assumption) const {
    Check check = check_of(name, unit, demand, answer_.key + key, assumption);
    check.by = "formulas";
    check.wave = answer_.wave;
    check.level = answer_.level;
    return check;
  }

  /// The three checks of a direction; `names`: of sliding, overturning and pressure; `keys`: likewise.
  void add(const Stability& s, const std::array<const char*, 3>& names, const std::array<const char*, 3>& keys,
           const char* assumption) {
    list_.push_back(at_least_as(check(names[0], "", s.safety_sliding, keys[0], assumption), 1.));
    list_.push_back(
        at_least_as(check(names[1], "", s.safety_overturning, keys[1], assumption), limits_.overturning.value_or(1.)));
    list_.push_back(at_most(check(names[2], "Pa", s.heel_pressure, keys[2], assumption), limits_.base_pressure));
  }

  void add_sliding_distance() {
    if (answer_.sliding)
      list_.push_back(at_most(
          check("sliding distance by formulas", "m", answer_.sliding, "sliding_exact", answer_.sliding_by.c_str()),
          limits_.sliding));
  }

  void add_standing() {
    constexpr std::array<const char*, 3> landward{"sliding by formulas, standing wave",
                                                  "overturning by formulas, standing wave",
                                                  "heel pressure p_e, standing wave"},
        seaward{"sliding seaward by formulas", "overturning seaward by formulas", "toe pressure p_e"},
        keys{"standing.safety_sliding", "standing.safety_overturning", "standing.heel_pressure"},
        seaward_keys{"standing.trough_safety_sliding", "standing.trough_safety_overturning", "standing.toe_pressure"};
    if (const auto& standing = answer_.standing.answer) {
      add(standing->landward, landward, keys, standing_wave);
      add(standing->seaward, seaward, seaward_keys, "the trough of the standing wave, without suction under the base");
    } else {
      add(answer_.standing.bound->seaward, seaward,
          {"trough_bound.safety_sliding", "trough_bound.safety_overturning", "trough_bound.toe_pressure"},
          trough_bound);
    }
  }

  Checks take() { return std::move(list_); }

 private:
  const FormulaAnswer& answer_;
  const Limits& limits_;
  Checks list_;
};

}  // namespace

Checks formula_checks(const FormulaAnswer& answer, const Limits& limits) {
  FormulaChecks checks(answer, limits);
  checks.add(answer.stability, {"sliding by formulas", "overturning by formulas", "heel pressure p_e"},
             {"safety_sliding", "safety_overturning", "heel_pressure"}, goda);
  checks.add_sliding_distance();
  checks.add_standing();
  return checks.take();
}

}  // namespace upbead
