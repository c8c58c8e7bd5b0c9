#include <cmath>

#include "base/text.h"
#include "expected_report.h"
#include "output/limits.h"
#include "output/output_schema.h"

namespace upbead {

namespace {

/// All that goes into summary.json of `expected`.
struct ToldExpected {
  const Design* design;
  const ExpectedAnswer* answer;
  const ExpectedTiming* timing;
  Headline expected, of_life;
  Checks checks;
  NumberedWarnings warnings;
  std::optional<Verdict> verdict;
  std::string why_no_nodes;
};
using Told = ToldExpected;
using Answer = ExpectedAnswer;

/// A value for each law, by the law's word; null where there is no value, or no wave slides the caisson.
Json by_law(const std::map<Law, Expectation>& laws, double Expectation::*member) {
  Json json = Json::object();
  for (const Law law : all_laws) {
    const auto found = laws.find(law);
    const bool told = found != laws.end() && std::isfinite(found->second.*member);
    json[word(law)] = told ? Json(found->second.*member) : Json();
  }
  return json;
}

/// The height, or null where there is none.
std::optional<double> if_finite(double height) {
  return std::isfinite(height) ? std::optional(height) : std::nullopt;
}

OutputSchema<WorstBase> worst_base_outputs() {
  using W = WorstBase;
  const auto finite = [](double W::*member) { return [member](const W& w) { return if_finite(w.*member); }; };
  return OutputSchema<W>()
      .key("peak_heel_pressure", finite(&W::heel_pressure), "Pa",
           "largest pressure of the landward edge of the base, stress varying linearly over the width in contact; null "
           "where the resultant leaves the base")
      .key("peak_toe_pressure", finite(&W::toe_pressure), "Pa", "the same of the seaward edge")
      .key("largest_eccentricity", &W::eccentricity, "m", "of the resultant, landward of the base's middle")
      .key("least_overturning_margin", finite(&W::overturning_margin), "",
           "moments that hold the caisson up over those that overturn it; null where nothing overturns");
}

OutputSchema<HighestOnBase> highest_on_base_outputs() {
  using H = HighestOnBase;
  return OutputSchema<H>()
      .key("height", &H::height, "m", "of that wave, or the limit")
      .object("goda", &H::goda, worst_base_outputs(), "by Goda's formulas with alpha_I, as `waves` has it")
      .object("dynamic", &H::dynamic, worst_base_outputs(), "by the reduced model")
      .reason("why_not_dynamic", &H::why_not_dynamic, "why `dynamic` is null");
}

const char* limit_of(const Told& told) {
  return word(told.design->tables.highest());
}

OutputSchema<StateAnswer> state_outputs() {
  using S = StateAnswer;
  return OutputSchema<S>()
      .key("significant_height", inner(&S::state, &SeaState::significant_height), "m", "H_1/3 at the wall")
      .key("period", inner(&S::state, &SeaState::period), "s", "T")
      .key("waves", inner(&S::state, &SeaState::waves), "", "their number")
      .key(
          "highest", [](const S& s) { return if_finite(s.heights.highest()); }, "m",
          "no wave is higher; null without a limit")
      .key("share_limited", inner(&S::heights, &RayleighHeights::taken), "",
           "of the waves, broken to the limit's height, or set aside by a cut")
      .key(
          "highest_breaker", [](const S& s) { return if_finite(s.before.heights.breaker); }, "m",
          "Goda's highest random breaker; null where h/L_0 >= 0.2, where his formulas know none")
      .key("deep_water_height", inner(&S::before, &SeaBefore::deep_water_height), "m",
           "H_0' that makes H_1/3 at the wall; the steepest sea's where none does")
      .key("significant_height_possible", inner(&S::before, &SeaBefore::reaches), "",
           "whether a sea comes with such an H_1/3")
      .key(
          "distance.LAW", [](const S& s) { return by_law(s.by_law, &Expectation::distance); }, "m", "expected sliding")
      .key(
          "threshold_height.LAW", [](const S& s) { return by_law(s.by_law, &Expectation::threshold); }, "m",
          "height from which waves slide; null where nothing does")
      .object("base", &S::base, highest_on_base_outputs(),
              "what presses on the base in the height that one of its waves exceeds");
}

OutputSchema<Headline> headline_outputs() {
  return OutputSchema<Headline>()
      .key("value", &Headline::value, "m", "S")
      .key(
          "law", [](const Headline& h) { return word(h.law); }, "", "by which")
      .key("why", &Headline::why, "", "and what the other laws say");
}

OutputSchema<Told> sliding_by_law_outputs() {
  const auto of = [](double Expectation::*member) {
    return [member](const Told& t) { return by_law(t.answer->total, member); };
  };
  OutputSchema<Told> schema;
  schema.object("headline", &Told::expected, headline_outputs(), "the distance to tell: the largest of all laws")
      .key("years", inner(&Told::design, &Design::tables, &DesignTables::sea, &SeaTable::years), "",
           "of the distances");
  for (const Law law : all_laws)
    schema.key(
        std::string("distance_") + word(law),
        [law](const Told& t) {
          const auto found = t.answer->total.find(law);
          return found == t.answer->total.end() ? std::nullopt : std::optional(found->second.distance);
        },
        "m", std::string("expected sliding in `years`") + (law == Law::dynamic ? "; null without a model" : ""));
  return schema.key("error_estimate.LAW", of(&Expectation::error), "m", "of the distance, by quadrature")
      .key("waves", inner(&Told::answer, &Answer::waves), "", "expected number")
      .key("waves_that_slide.LAW", of(&Expectation::sliding_waves), "", "expected number above the threshold")
      .key("threshold_height.LAW", of(&Expectation::threshold), "m",
           "height from which waves slide; null where nothing does")
      .object("base", inner(&Told::answer, &Answer::base), highest_on_base_outputs(),
              "what presses on the base in the highest wave of the worst sea state")
      .key("highest", inner(&Told::answer, &Answer::highest), "m", "the height that one wave exceeds, or the limit")
      .key("limit", limit_of, "", "of the heights: breaking, cut or none")
      .key("waves_limited", inner(&Told::answer, &Answer::taken), "",
           "expected number that broke to the limit's height, or that a cut set aside")
      .key(
          "share_limited", [](const Told& t) { return share_of(t.answer->taken, t.answer->all); }, "",
          "they are of all waves")
      .key("distance_limited.LAW", of(&Expectation::broken), "m", "of the distance, by waves that broke to the limit")
      .list("states[]", inner(&Told::answer, &Answer::states), state_outputs(), "each sea state");
}

Json quantiles(const LifeStatistics& statistics) {
  Json json;
  for (const Quantile& q : statistics.quantiles)
    json[significant(q.probability)] = std::isfinite(q.value) ? Json(q.value) : Json();
  return json;
}

OutputSchema<WorstOfLives> worst_of_lives_outputs(const std::string& unit, const std::string& beyond) {
  using W = WorstOfLives;
  using S = LifeStatistics;
  const auto exceeded =
      OutputSchema<Exceeded>()
          .key("limit", &Exceeded::limit, unit, "that `[limits]` gives")
          .key("probability", &Exceeded::probability, "", "share of the lives that go " + beyond + " it")
          .key("confidence_interval[]", &Exceeded::interval, "", "of that, 95 %");
  return OutputSchema<W>()
      .key(
          "mean", [](const W& w) { return if_finite(w.statistics.mean); }, unit,
          "of all lives; null where one has none")
      .keys_of(&W::statistics, OutputSchema<S>().key("quantiles.PROBABILITY", quantiles, unit,
                                                     "value that such a share of the lives does not exceed"))
      .keys_of(&W::beyond, exceeded);
}

OutputSchema<BaseOfLives> base_of_lives_outputs() {
  using B = BaseOfLives;
  return OutputSchema<B>()
      .object("peak_heel_pressure", &B::heel_pressure, worst_of_lives_outputs("Pa", "above"),
              "largest pressure of the landward edge in a life")
      .object("peak_toe_pressure", &B::toe_pressure, worst_of_lives_outputs("Pa", "above"),
              "largest pressure of the seaward edge in a life")
      .object("largest_eccentricity", &B::eccentricity, worst_of_lives_outputs("m", "above"),
              "largest eccentricity of the resultant in a life, landward of the base's middle")
      .object("least_overturning_margin", &B::overturning_margin, worst_of_lives_outputs("", "below"),
              "least margin against overturning in a life");
}

OutputSchema<WaysOfLives> ways_of_lives_outputs() {
  using W = WaysOfLives;
  return OutputSchema<W>()
      .object("sliding_factor", &W::sliding, worst_of_lives_outputs("", "below"),
              "least mu N'/F_T in a life while F_T acts landward; `limit` 1: below it the caisson starts to slide")
      .object("sliding_factor_seaward", &W::sliding_seaward, worst_of_lives_outputs("", "below"), "the same seaward")
      .object("overturning_margin", &W::overturning, worst_of_lives_outputs("", "below"),
              "least margin against overturning in a life; `limit`: `limits.overturning`, or 1")
      .object("heel_pressure", &W::heel_pressure, worst_of_lives_outputs("Pa", "above"),
              "largest pressure of the landward edge in a life, in motion, against `limits.dynamic_base_pressure`")
      .object("toe_pressure", &W::toe_pressure, worst_of_lives_outputs("Pa", "above"), "the same of the seaward edge")
      .object("circles", &W::circles, worst_of_lives_outputs("", "below"),
              "least factor of slip circles under the caisson in a life; `limit`: `limits.circles`, or 1")
      .key("waves", &W::waves, "", "answered for that, in all lives")
      .key("lower_worse", &W::lower_worse, "",
           "largest share by which a factor under a lower wave of some of the seas is below that under the highest");
}

Json probabilities(const MonteCarlo& found) {
  Json json;
  for (const Exceeded& e : found.statistics.exceeded)
    json[significant(e.limit)] = {{"value", e.probability}, {"confidence_interval", e.interval}};
  return json;
}

/// What one law says of the lives.
OutputSchema<MonteCarlo> lives_by_law_outputs() {
  using M = MonteCarlo;
  using S = LifeStatistics;
  const auto about = OutputSchema<S>()
                         .key("mean", &S::mean, "m", "mean S of a life")
                         .key("standard_error", &S::standard_error, "m", "of the mean")
                         .key("confidence_interval[]", &S::interval, "m", "of the mean, 95 %");
  return OutputSchema<M>()
      .key(
          "law", [](const M& m) { return word(m.law); }, "", "by which S was computed")
      .keys_of(&M::statistics, about)
      .key("waves_limited", &M::taken, "", "in all lives, that broke to the limit's height, or that a cut set aside")
      .key(
          "share_limited", [](const M& m) { return share_of(m.taken, m.waves); }, "", "they are of all waves")
      .key("highest", &M::highest, "m", "of the waves whose S was computed")
      .key("without_scatter", &M::without_scatter, "m",
           "expectation of a life by quadrature, nothing uncertain but the heights")
      .keys_of(&M::statistics, OutputSchema<S>()
                                   .key("lives_that_slide", &S::sliding_lives, "", "how many")
                                   .key("quantiles.PROBABILITY", quantiles, "m",
                                        "least S that such a share of the lives does not exceed")
                                   .or_left_out())
      .key("probability.LIMIT", probabilities, "", "of S above a limit (m): `value` and its 95 % `confidence_interval`")
      .or_left_out()
      .key("waves", &M::waves, "", "in all lives")
      .key("waves_computed", &M::answered, "", "of them those whose S was computed")
      .object(
          "base", &M::base, base_of_lives_outputs(),
          "what presses on the base at its worst in a life, by Goda's formulas with alpha_I; with the law `dynamic` "
          "by the reduced model, in motion, against `limits.dynamic_base_pressure`")
      .reason("why_no_base", &M::why_no_base, "why `base` is null")
      .object("ways", &M::ways, ways_of_lives_outputs(),
              "the worst of every way to fail in a life, by the reduced model under the worst wave of each storm; null "
              "where it has no slip circles, and by formulas");
}

OutputSchema<Told> lives_outputs() {
  const auto found = inner(&Told::answer, &Answer::monte_carlo);
  const auto asked = OutputSchema<LifeTable>()
                         .key("lives", &LifeTable::lives, "", "how many")
                         .key("years", &LifeTable::years, "", "of each")
                         .key("seed", &LifeTable::seed, "", "of the draws");
  return OutputSchema<Told>()
      .object("headline", &Told::of_life, headline_outputs(),
              "the mean S of a life to tell: the largest of formulas, own dynamics and slip node by node, where they "
              "are known")
      .keys_of(inner(&Told::design, &Design::tables, &DesignTables::life), asked)
      .key("limit", limit_of, "", "of the heights: breaking, cut or none")
      .keys_of(found, lives_by_law_outputs())
      .object("by_formulas", inner(&Told::answer, &Answer::formula_lives), lives_by_law_outputs(),
              "the same lives by the law `exact`, beside those by own dynamics; null where the lives are by formulas");
}

OutputSchema<NodeSliding> node_sliding_outputs() {
  using N = NodeSliding;
  return OutputSchema<N>()
      .key(
          "of", [](const N& n) { return n.of_lives ? "lives" : "record"; }, "",
          "whose S it is: a life's of `monte_carlo`, or that of `expected`")
      .key("mean", &N::mean, "m", "S of a life, or expected in the years of the record")
      .key("draw_error", &N::draw_error, "m", "standard error of the mean, by the draw of waves alone")
      .key("standard_error", &N::standard_error, "m", "and by that of lives, as of the block")
      .key("confidence_interval[]", &N::interval, "m", "of the mean, 95 %")
      .key("block", &N::block, "m", "the same by the law `dynamic`, which slides a rigid block under F_T")
      .key("ratio", &N::ratio, "", "mean over block, of the same waves; null where none of them slides as a block")
      .key("ground_error", &N::ground_error, "m",
           "bound of what the reduced ground adds to the error of the mean, by nested models")
      .key("waves", &N::waves, "", "different waves that were answered")
      .key("unanswered", &N::unanswered, "",
           "waves that could not be, to which the largest ratio of the others to the block was given")
      .key("all_waves", &N::is_whole, "", "whether these are all waves that may slide, and not a draw from them");
}

OutputSchema<Told> expected_timing_outputs() {
  const auto lives = [](double MonteCarlo::*member) {
    return [member](const Told& t) {
      const auto& found = t.answer->monte_carlo;
      return found && found->seconds > 0. ? std::optional((*found).*member / found->seconds) : std::nullopt;
    };
  };
  return OutputSchema<Told>()
      .key("read", inner(&Told::timing, &ExpectedTiming::read), "s", "reading")
      .key("quadrature", inner(&Told::answer, &Answer::quadrature_seconds), "s", "quadrature")
      .key("monte_carlo", inner(&Told::answer, &Answer::monte_carlo, &MonteCarlo::seconds), "s",
           "lives; null without `[life]`")
      .key("nodes", inner(&Told::answer, &Answer::nodes_seconds), "s", "waves node by node")
      .key("waves_per_second", lives(&MonteCarlo::waves), "1/s", "of all lives; absent without `[life]`")
      .or_left_out()
      .key("waves_computed_per_second", lives(&MonteCarlo::answered), "1/s", "those whose S was computed")
      .or_left_out()
      .key("total", inner(&Told::timing, &ExpectedTiming::total), "s", "since the start of the program");
}

OutputSchema<ModelUsed> used_model_outputs() {
  using M = ModelUsed;
  return OutputSchema<M>()
      .key("title", &M::title, "", "that of its case")
      .key("load", &M::load, "", "that the waves drive")
      .key("step", &M::step, "s", "of all answers")
      .key("shortest_rise", &M::shortest_rise, "s", "of the waves that might slide");
}

const OutputSchema<Told>& expected_outputs() {
  using E = Exceedance;
  const auto exceedance = OutputSchema<E>()
                              .key("height", &E::height, "m", "that was asked for")
                              .key("waves", &E::waves, "", "expected number above it");
  static const auto schema =
      OutputSchema<Told>()
          .key("title", inner(&Told::design, &Design::tables, &DesignTables::title), "", "that of the design")
          .program()
          .object("verdict", &Told::verdict, verdict_outputs(), "what all checks say together; null without any")
          .list("checks[]", &Told::checks, check_outputs(), "of the record and of the lives")
          .list("warnings[]", &Told::warnings, warning_outputs(), "[what may be wrong](expected.md#warnings)")
          .object(
              "expected", [](const Told& t) { return t.design->tables.sea ? &t : nullptr; }, sliding_by_law_outputs(),
              "expected sliding, by quadrature; null without `[sea]`")
          .named("exceedance.NAME", inner(&Told::answer, &Answer::exceedance), &E::name, exceedance,
                 "waves above the `heights` that were asked for")
          .object("model", inner(&Told::answer, &Answer::model), used_model_outputs(),
                  "of the law `dynamic`; null without one")
          .object("nodes", inner(&Told::answer, &Answer::nodes), node_sliding_outputs(),
                  "S with slip and lift node by node, of waves drawn from all; null where the model has no contact, "
                  "and where it is not known")
          .reason("why_no_nodes", &Told::why_no_nodes, "why `nodes` is null though the model has contact")
          .object(
              "monte_carlo", [](const Told& t) { return t.answer->monte_carlo ? &t : nullptr; }, lives_outputs(),
              "lives drawn at random; null without `[life]`")
          .object(
              "timing", [](const Told& t) { return &t; }, expected_timing_outputs(), "wall times")
          .versions();
  return schema;
}

}  // namespace

std::vector<OutputRow> rows_of_expected() {
  return expected_outputs().rows();
}

Json to_json(const Design& design, const ExpectedAnswer& answer, const ExpectedTiming& timing) {
  ToldExpected told{&design,
                    &answer,
                    &timing,
                    {},
                    {},
                    checks_of(design, answer),
                    warnings_of(design, answer),
                    {},
                    answer.why_no_nodes};
  append(told.checks, unjudged_limits(design.tables.limits, told.checks, false));
  if (!answer.total.empty()) told.expected = headline_of(answer);
  if (answer.monte_carlo) told.of_life = headline_of_life(answer);
  if (!told.checks.empty()) told.verdict = verdict_of(told.checks, told.warnings);
  return expected_outputs().to_json(told);
}

}  // namespace upbead
