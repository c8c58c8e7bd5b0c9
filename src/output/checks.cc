#include "output/checks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "base/text.h"

namespace upbead {

namespace {

/// In the order of FailureMode.
constexpr const char* mode_words[] = {"strength of the ground",
                                      "bearing and slip circles",
                                      "momentary liquefaction of the ground",
                                      "residual pore pressure of a storm",
                                      "sliding landward",
                                      "sliding seaward",
                                      "sliding distance",
                                      "overturning landward",
                                      "overturning seaward",
                                      "heel pressure",
                                      "toe pressure",
                                      "settlement",
                                      "tilt",
                                      "failure over the life"};
static_assert(std::size(mode_words) == static_cast<std::size_t>(FailureMode::other));

}  // namespace

Check check_of(FailureMode mode, const std::string& name, const std::string& unit, const std::optional<double>& demand,
               const std::string& measure, const std::string& assumption) {
  Check check;
  check.mode = mode;
  check.name = name;
  check.unit = unit;
  check.demand = demand;
  check.measure = measure;
  check.assumption = assumption;
  return check;
}

Check at_most(Check check, const std::optional<double>& capacity) {
  check.capacity = capacity;
  if (!capacity) return check;
  if (check.demand && *check.demand > 0.) check.margin = *capacity / *check.demand;
  check.holds = check.demand && *check.demand <= *capacity;
  return check;
}

Check at_least_as(Check check, const std::optional<double>& capacity) {
  check.at_least = true;
  check.capacity = capacity;
  if (!capacity) return check;
  if (check.demand) check.margin = *check.demand / *capacity;
  check.holds = check.demand && *check.demand >= *capacity;
  return check;
}

Check not_checked(Check check, const std::string& why) {
  check.demand = check.margin = std::nullopt;
  check.holds.reset();
  check.why_not = why;
  return check;
}

Check in_doubt(const Check& check, const std::string& why) {
  return why.empty() || !check.holds || !*check.holds ? check : not_checked(check, why);
}

namespace {

/// In which order checks are bad: those that fail, hold, have no limit, were not checked.
int rank(const Check& check) {
  if (!check.why_not.empty()) return 3;
  return check.holds ? (*check.holds ? 1 : 0) : 2;
}

/// The less the worse; a demand without bound is the worst.
double goodness(const Check& check) {
  if (!check.demand) return -HUGE_VAL;
  if (check.capacity) return check.margin.value_or(HUGE_VAL);
  return check.at_least ? *check.demand : -*check.demand;
}

}  // namespace

std::string mode_of(const Check& check) {
  return check.mode == FailureMode::other ? check.name : mode_words[static_cast<std::size_t>(check.mode)];
}

std::string name_of(const Check& check) {
  return check.name + (check.wave.empty() ? "" : ", wave " + check.wave) +
         (check.level.empty() ? "" : " at " + check.level);
}

bool is_worse(const Check& a, const Check& b) {
  return rank(a) != rank(b) ? rank(a) < rank(b) : goodness(a) < goodness(b);
}

Checks worst_of_each(const std::vector<Checks>& several) {
  Checks worst;
  for (const Checks& list : several)
    for (const Check& check : list) {
      const auto same = std::find_if(worst.begin(), worst.end(), [&check](const Check& other) {
        return other.name == check.name && other.wave == check.wave;
      });
      if (same == worst.end())
        worst.push_back(check);
      else if (is_worse(check, *same))
        *same = check;
    }
  return worst;
}

std::string margin_text(double margin) {
  return significant(margin, digits_apart(margin, 1., 3));
}

std::string text_of(const Check& check) {
  if (!check.why_not.empty()) return name_of(check) + ": not checked: " + check.why_not;
  const int digits = check.demand && check.capacity ? digits_apart(*check.demand, *check.capacity, 4) : 4;
  std::string text = name_of(check) + ": " +
                     (check.demand     ? with_unit(*check.demand, check.unit, 0., digits)
                      : check.at_least ? "not found"
                                       : "without bound") +
                     (check.probability ? " (probability " + significant(*check.probability, 3) + ")" : "");
  if (!check.capacity) return text + ", no limit given";
  text += (check.at_least ? " against at least " : " against ") + with_unit(*check.capacity, check.unit, 0., digits) +
          ": " + (*check.holds ? "holds" : "DOES NOT HOLD");
  return text + (check.margin ? ", margin " + margin_text(*check.margin) : std::string());
}

Verdict verdict_of(const Checks& checks, const NumberedWarnings& warnings) {
  Verdict verdict;
  std::string unjudged;
  for (const Check& check : checks) {
    // a key of [limits], or a target of [reliability]; mu W' is a capacity, and no limit
    const bool given = check.capacity && (!check.limit.empty() || check.mode == FailureMode::failure_of_life);
    if (given && !check.why_not.empty()) {
      ++verdict.unjudged;
      unjudged += (unjudged.empty() ? "" : ", ") + name_of(check);
    }
    if (!check.holds) continue;
    ++verdict.checked;
    if (!*check.holds) ++verdict.failing;
    if (!verdict.governing || is_worse(check, *verdict.governing)) verdict.governing = check;
  }
  if (verdict.checked > 0) verdict.holds = verdict.failing == 0;
  const std::string n = std::to_string(verdict.checked);
  if (!verdict.holds)
    verdict.text = "none: no check has a limit";
  else if (verdict.checked == 1)
    verdict.text =
        *verdict.holds ? "the only check with a limit holds: " : "DOES NOT HOLD: the only check with a limit fails: ";
  else
    verdict.text = *verdict.holds ? "all " + n + " checks with a limit hold; the least margin: "
                                  : "DOES NOT HOLD: " + std::to_string(verdict.failing) + " of " + n +
                                        " checks with a limit fail; the worst: ";
  if (verdict.governing) verdict.text += text_of(*verdict.governing);
  const bool at_rest_alone = std::all_of(checks.begin(), checks.end(), [](const Check& check) {
    return !check.holds || (check.mode == FailureMode::strength && check.by == "statics");
  });
  if (verdict.checked > 0 && at_rest_alone) verdict.text += "; no check judges what the loads do to it";
  if (verdict.unjudged > 0) verdict.text += "; given limits that were not checked: " + unjudged;
  std::set<std::string> told;
  for (const NumberedWarning& warning : warnings)
    if (warning.voids && told.insert(warning.name).second)
      verdict.why_void += (verdict.why_void.empty() ? "" : "; ") + warning.name;
  if (!verdict.why_void.empty()) {
    verdict.holds.reset();
    verdict.text = "VOID, as the warnings say: " + verdict.why_void + ". Without them: " + verdict.text;
  }
  return verdict;
}

std::string verdict_text(const Verdict& verdict, const Checks& checks, std::size_t most) {
  if (checks.empty()) return "";
  std::string text = "checks\n";
  int left_out = 0;
  for (const Check& check : checks)
    if (checks.size() <= most || (check.holds && !*check.holds))
      text += "  " + text_of(check) + "\n";
    else
      ++left_out;
  if (left_out > 0) text += "  " + std::to_string(left_out) + " others hold or have no limit, see summary.json\n";
  return text + "verdict     " + verdict.text + "\n";
}

OutputSchema<Check> check_outputs() {
  using C = Check;
  return OutputSchema<C>()
      .key("name", &C::name, "", "what is checked")
      .key("mode", mode_of, "", "the way to fail that it is about")
      .reason("limit", &C::limit, "key of `[limits]` that it is held to, given or not; null where none is made for it")
      .key("by", &C::by, "",
           "the route: `formulas` (Goda's, and of the standing wave), `dynamics` (of the solved scene), or `statics`; "
           "of a "
           "probability the method that found it, as `form`")
      .reason("wave", &C::wave, "the wave, or load by a wave, that demands it; null: all loads of the scene")
      .reason("level", &C::level, "level of still water at which it is worst; null without `[levels]`")
      .key("unit", &C::unit, "", "of demand and capacity")
      .key("demand", &C::demand, "", "what the wave demands, in that unit; null: without bound, or not checked")
      .key("capacity", &C::capacity, "",
           "what the section bears: mu W', or a limit of `[limits]`; null where none is given")
      .object("balance", &C::balance,
              OutputSchema<Balance>()
                  .key("acting", &Balance::acting, "", "force or moment that acts")
                  .key("resisting", &Balance::resisting, "", "that which resists")
                  .key("unit", &Balance::unit, "", "of both"),
              "of a demand that is a factor of safety: what it compares")
      .or_left_out()
      .key("probability", &C::probability, "", "of failure, of a demand that is a reliability index")
      .or_left_out()
      .key("margin", &C::margin, "",
           "above 1 where it holds: capacity over demand, or demand over capacity of what must not fall below; null "
           "without a capacity, or where nothing is demanded")
      .key("holds", &C::holds, "", "whether it holds; null without a capacity, and where it was not checked")
      .key(
          "at_least", [](const C& c) { return c.at_least ? std::optional(true) : std::nullopt; }, "",
          "true where the demand must not fall below the capacity; left out where it must not exceed it")
      .or_left_out()
      .key("measure", &C::measure, "", "the key of the summary with the demand")
      .reason("assumption", &C::assumption, "assumption that the check rests on; null where there is none")
      .reason("why_not", &C::why_not, "why it was not checked; null where it was")
      .key("text", text_of, "", "all that in a line, as the terminal has it");
}

OutputSchema<Verdict> verdict_outputs() {
  using V = Verdict;
  const auto word = [](std::string Check::*member) {
    return [member](const V& v) {
      return v.governing && !((*v.governing).*member).empty() ? Json((*v.governing).*member) : Json();
    };
  };
  return OutputSchema<V>()
      .key("holds", &V::holds, "", "whether all checks hold; null where no check has a limit, or the verdict is void")
      .key("text", &V::text, "", "that in a sentence, with the governing check")
      .key("check", word(&Check::name), "", "name of the governing check: the worst of those with a limit")
      .key("by", word(&Check::by), "", "its route")
      .key("wave", word(&Check::wave), "", "its wave; null likewise")
      .key("level", word(&Check::level), "", "its level of still water; null likewise")
      .key("margin", inner(&V::governing, &Check::margin), "", "its margin")
      .key("failing", &V::failing, "", "number of checks that do not hold")
      .key("checked", &V::checked, "", "number of checks with a limit")
      .key("unjudged", &V::unjudged, "", "number of given limits that could not be checked: see their `why_not`")
      .reason("why_void", &V::why_void, "the warnings under which no verdict may be drawn; null where there is none");
}

}  // namespace upbead
