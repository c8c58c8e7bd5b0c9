#include "case/formula_checks.h"

#include <array>
#include <utility>

#include "output/limits.h"

namespace upbead {

namespace {

const char* const goda =
    "Goda's P and U with alpha* = max(alpha_2, alpha_I), which already is an effective sliding force";
const char* const trough_bound =
    "a bound of the trough after Sainflou (1928), suction under the base where it is worse: on the safe side, as no "
    "standing "
    "wave "
    "of finite height is known (why_no_standing)";
const char* const standing_wave = "the standing wave of finite height, in case the wave does not break";

/// The ways to fail in one direction, and the limit of sliding.
struct Direction {
  FailureMode sliding, overturning, pressure;
  std::optional<double> Limits::*factor;
};
constexpr Direction landward{FailureMode::sliding, FailureMode::overturning, FailureMode::heel_pressure,
                             &Limits::sliding_factor},
    seaward{FailureMode::sliding_seaward, FailureMode::overturning_seaward, FailureMode::toe_pressure,
            &Limits::seaward_sliding_factor};

/// Makes the checks of one wave.
class FormulaChecks {
 public:
  FormulaChecks(const FormulaAnswer& answer, const Limits& limits) : answer_(answer), limits_(limits) {}

  Check check(FailureMode mode, const std::string& name, const std::string& unit, const std::optional<double>& demand,
              const std::string& key, const char* assumption) const {
    Check check = check_of(mode, name, unit, demand, answer_.key + key, assumption);
    check.by = "formulas";
    check.wave = answer_.wave;
    check.level = answer_.level;
    check.has_rival = assumption != standing_wave;  // dynamics solve the wave that breaks
    return check;
  }

  /// The three checks of a direction; `names`: of sliding, overturning and pressure; `keys`: likewise.
  void add(const Direction& to, const Stability& s, const std::array<const char*, 3>& names,
           const std::array<const char*, 3>& keys, const char* assumption) {
    Check sliding = check(to.sliding, names[0], "", s.safety_sliding, keys[0], assumption);
    sliding.balance = Balance{s.force, s.safety_sliding * s.force, "N/m"};
    Check overturning = check(to.overturning, names[1], "", s.safety_overturning, keys[1], assumption);
    overturning.balance = Balance{s.moment, s.safety_overturning * s.moment, "N m/m"};
    list_.push_back(held_to(sliding, limits_, to.factor, limits_.sliding_factor.value_or(1.)));
    list_.push_back(held_to(overturning, limits_, &Limits::overturning, 1.));
    list_.push_back(held_to(check(to.pressure, names[2], "Pa", s.heel_pressure, keys[2], assumption), limits_,
                            &Limits::base_pressure));
  }

  void add_sliding_distance() {
    const FormulaSliding& s = answer_.sliding;
    list_.push_back(held_to(
        check(FailureMode::sliding_distance, "sliding distance by formulas", "m", s.distance, s.key, s.by.c_str()),
        limits_, &Limits::sliding));
  }

  void add_standing() {
    constexpr std::array<const char*, 3> names{"sliding by formulas, standing wave",
                                               "overturning by formulas, standing wave",
                                               "heel pressure p_e, standing wave"},
        seaward_names{"sliding seaward by formulas", "overturning seaward by formulas", "toe pressure p_e"},
        keys{"standing.safety_sliding", "standing.safety_overturning", "standing.heel_pressure"},
        seaward_keys{"standing.trough_safety_sliding", "standing.trough_safety_overturning", "standing.toe_pressure"};
    if (const auto& standing = answer_.standing.answer) {
      add(landward, standing->landward, names, keys, standing_wave);
      add(seaward, standing->seaward, seaward_names, seaward_keys,
          "the trough of the standing wave, suction under the base where it is worse");
    } else {
      add(seaward, answer_.standing.bound->seaward, seaward_names,
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

/// The factor that codes ask for against sliding and overturning: Goda (2000), Japanese practice.
constexpr double of_practice = 1.2;

}  // namespace

FormulaSliding larger_sliding(double exact, double combined) {
  const bool larger = combined > exact;
  return {larger ? combined : exact,
          std::string(larger ? "Shimosako and Takahashi (1998), a standing wave and a pulse"
                             : "eqs. (4) and (6) of Shimosako and Takahashi (1994), integrated") +
              "; tau_0 = k(alpha*) tau_0F",
          larger ? "sliding_combined" : "sliding_exact"};
}

Checks formula_checks(const FormulaAnswer& answer, const Limits& limits) {
  FormulaChecks checks(answer, limits);
  checks.add(landward, answer.stability, {"sliding by formulas", "overturning by formulas", "heel pressure p_e"},
             {"safety_sliding", "safety_overturning", "heel_pressure"}, goda);
  checks.add_sliding_distance();
  checks.add_standing();
  return checks.take();
}

NumberedWarnings levels_not_used(std::size_t levels, const std::string& told, const std::string& cure) {
  if (levels == 0) return {};
  return {{"levels_not_used", static_cast<double>(levels), 0., "1", told, cure}};
}

NumberedWarnings factor_warnings(const Checks& checks, const Limits& limits) {
  NumberedWarnings list;
  const auto warn = [&](FailureMode mode, FailureMode other_way, const std::optional<double>& given,
                        const std::string& key) {
    if (given) return;
    const Check* least = nullptr;
    for (const Check& check : checks)
      if (check.at_least && check.holds && check.demand && *check.capacity == 1. &&
          (check.mode == mode || check.mode == other_way) && (!least || *check.demand < *least->demand))
        least = &check;
    if (!least || *least->demand < 1. || *least->demand >= of_practice) return;
    list.push_back({"factor_below_practice", *least->demand, of_practice, "1",
                    text_of(*least) + ": that limit is equilibrium alone, and Japanese practice asks for 1.2",
                    "give limits." + key + ", 1.2 or as your code asks"});
  };
  warn(landward.sliding, seaward.sliding, limits.sliding_factor, "sliding_factor");
  warn(landward.overturning, seaward.overturning, limits.overturning, "overturning");
  return list;
}

}  // namespace upbead
