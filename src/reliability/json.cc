#include "output/output_schema.h"
#include "reliability/answer.h"

namespace upbead {

namespace {

struct ToldReliability {
  const Design* design;
  const ReliabilityAnswer* answer;
  Checks checks;
  NumberedWarnings warnings;
  Verdict verdict;
};

OutputSchema<Chance> chance_outputs() {
  return OutputSchema<Chance>()
      .key("probability", &Chance::probability, "", "of failure; null where no method found one")
      .key("index", &Chance::index, "", "beta = -Phi^-1(probability); null where the probability is 0 or 1");
}

OutputSchema<MethodAnswer> method_outputs() {
  using M = MethodAnswer;
  return OutputSchema<M>()
      .key("probability", &M::probability, "", "of failure in one occasion; null where there is none")
      .key("index", &M::index, "", "beta of that probability")
      .key("variation", &M::variation, "", "coefficient of variation of a sampled probability; null for form and sorm")
      .key("evaluations", &M::evaluations, "", "of the limit state")
      .reason("why_not", &M::why_not, "why there is no probability, or what bounded it");
}

OutputSchema<DesignValue> value_outputs() {
  using V = DesignValue;
  return OutputSchema<V>()
      .key("acts_on", &V::acts_on, "", "key of the design, or the factor")
      .key("unit", &V::unit, "", "of the two values; empty where they have none")
      .key("characteristic", &V::characteristic, "", "number of the design; of a factor 1; in `unit`")
      .key("value", &V::value, "", "at the design point; in `unit`")
      .key("alpha", &V::alpha, "", "component of the unit vector to the design point in standard space")
      .key("importance", &V::importance, "", "alpha^2; all together make 1")
      .key("partial_factor", &V::partial_factor, "", "value over characteristic; null where that is 0");
}

OutputSchema<ModeAnswer> mode_outputs() {
  using M = ModeAnswer;
  const auto chance = chance_outputs();
  return OutputSchema<M>()
      .key("meaning", &M::meaning, "", "when it fails")
      .key("is_system", &M::is_system, "", "whether it is a gate of the fault tree")
      .reason("why_not", &M::why_not, "why there is no probability")
      .key("governing", &M::governing, "", "method with the least index; empty where none has one")
      .object("occasion", &M::occasion, chance, "one occasion")
      .object("year", &M::year, chance, "any of the occasions of a year")
      .object(
          "life", &M::life, chance,
          "any of the occasions of a life; at most, as they are taken as independent while friction and weight last")
      .key("spread", &M::spread, "", "largest difference of the index between two methods")
      .reason("disagreement", &M::disagreement, "methods that differ by more than 0.1 in their index")
      .key("ground_error", &M::ground_error, "",
           "estimate of the error of F_T at the design point, over its peak; null where F_T is not asked")
      .named("methods.METHOD", &M::methods, &MethodAnswer::method, method_outputs(), "each method asked for")
      .named("design_point.VARIABLE", &M::point, &DesignValue::variable, value_outputs(),
             "each variable where failure is likeliest; empty where no such point was found");
}

OutputSchema<CodeRow> code_outputs() {
  using R = CodeRow;
  return OutputSchema<R>()
      .key("code", &R::code, "", "whose demand it is")
      .key("what", &R::what, "", "is compared")
      .key("unit", &R::unit, "", "of value and target; empty where they have none")
      .key("value", &R::value, "", "found; in `unit`")
      .key("target", &R::target, "", "asked for; null where none is given; in `unit`")
      .key("at_least", &R::at_least, "", "whether the value must not fall below the target")
      .key("holds", &R::holds, "", "whether it does; null without value or target")
      .key("source", &R::source, "", "of the target")
      .reason("why_not", &R::why_not, "why there is no value");
}

const OutputSchema<ToldReliability>& reliability_outputs() {
  using T = ToldReliability;
  const auto table = [](auto member) { return inner(&T::design, &Design::tables, &DesignTables::reliability, member); };
  static const auto schema =
      OutputSchema<T>()
          .key("title", inner(&T::design, &Design::tables, &DesignTables::title), "", "that of the design")
          .program()
          .object("verdict", &T::verdict, verdict_outputs(), "what all checks say together")
          .list("checks[]", &T::checks, check_outputs(), "the index of the life, against `reliability.target`")
          .list("warnings[]", &T::warnings, warning_outputs(), "what may be wrong")
          .key("wave", inner(&T::answer, &ReliabilityAnswer::wave), "", "name of the wave of an occasion")
          .key("years", table(&ReliabilityTable::years), "years", "life")
          .key("occasions_per_year", table(&ReliabilityTable::occasions_per_year), "1/year",
               "occasions, taken as independent of each other")
          .key("seed", table(&ReliabilityTable::seed), "", "of all samples")
          .key("system", inner(&T::answer, &ReliabilityAnswer::system), "",
               "name of the mode that stands for the whole")
          .named("modes.NAME", inner(&T::answer, &ReliabilityAnswer::modes), &ModeAnswer::name, mode_outputs(),
                 "each limit state, then each gate of the fault tree")
          .list("codes[]", inner(&T::answer, &ReliabilityAnswer::codes), code_outputs(),
                "demands of codes, side by side")
          .versions();
  return schema;
}

}  // namespace

std::vector<OutputRow> rows_of_reliability() {
  return reliability_outputs().rows();
}

Json to_json(const Design& design, const ReliabilityAnswer& answer) {
  ToldReliability told{&design, &answer, checks_of(design, answer), warnings_of(design, answer), {}};
  told.verdict = verdict_of(told.checks, told.warnings);
  return reliability_outputs().to_json(told);
}

}  // namespace upbead
