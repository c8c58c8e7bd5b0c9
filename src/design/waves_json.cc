#include "output/checks.h"
#include "output/limits.h"
#include "output/section_outputs.h"
#include "waves_report.h"

namespace upbead {

namespace {

struct ToldWaves {
  const DesignTables* design;
  const std::vector<WaveAnswer>* waves;
  Checks checks;
  NumberedWarnings warnings;
  Verdict verdict;
};

OutputSchema<Section> section_outputs() {
  using S = Section;
  return OutputSchema<S>()
      .key("water_depth", &S::water_depth, "m", "h, at the wall")
      .key("foundation_depth", &S::foundation_depth, "m", "h', still water to the caisson's bottom")
      .key("berm_depth", &S::berm_depth, "m", "d, still water to the top of the mound's armour")
      .key("crest", &S::crest, "m", "h_c, above still water")
      .key("width", &S::width, "m", "B of the caisson")
      .key("berm_width", &S::berm_width, "m", "B_M")
      .key("bed_slope", &S::bed_slope, "", "tan(theta)")
      .key("weight", &S::weight, "N/m", "W")
      .key("submerged_weight", &S::submerged_weight, "N/m", "W'")
      .key("buoyant_weight", &S::submerged_weight, "N/m", "the same, by its older name")
      .key(
          "centroid", [](const S& s) { return s.centroid.value_or(0.5 * s.width); }, "m",
          "t, from the landward heel to the line of W'")
      .key("friction", &S::friction, "", "mu")
      .key("harbour_level", &S::harbour_level, "m", "of still water behind the caisson above that of the sea")
      .key("facing", &S::facing, "degrees", "where the wall looks at, from north; null where it is not given")
      .key("blocks", &S::dissipating_blocks, "", "whether wave-dissipating blocks cover the wall");
}

OutputSchema<WavePressure> coefficients_outputs() {
  using P = WavePressure;
  return OutputSchema<P>()
      .key("alpha_1", &P::alpha_1, "", "of Goda's formula")
      .key("alpha_2", &P::alpha_2, "", "of Goda's formula")
      .key("alpha_3", &P::alpha_3, "", "of Goda's formula")
      .key("alpha_I", &P::alpha_I, "", "as its formula says, negative or not")
      .key("alpha_star", &P::alpha_star, "", "alpha*")
      .key("lambda_1", &P::lambda_1, "", "factor of p_1")
      .key("lambda_2", &P::lambda_2, "", "factor of the part of p_1 beside alpha_1")
      .key("lambda_3", &P::lambda_3, "", "factor of p_u")
      .key("eta_star", &P::eta_star, "m", "eta*");
}

OutputSchema<WavePressure> forces_outputs() {
  using P = WavePressure;
  return OutputSchema<P>()
      .key("p1", &P::p1, "Pa", "p_1, with alpha_I")
      .key("p3", &P::p3, "Pa", "p_3, with alpha_I")
      .key("p4", &P::p4, "Pa", "p_4, with alpha_I")
      .key("pu", &P::pu, "Pa", "p_u")
      .key("force", &P::force, "N/m", "P, with alpha_I")
      .key("uplift", &P::uplift, "N/m", "U")
      .key("force_moment", &P::force_moment, "N m/m", "of P about the bottom's level")
      .key("uplift_moment", &P::uplift_moment, "N m/m", "of U about the heel");
}

OutputSchema<WavePressure> without_outputs() {
  using P = WavePressure;
  return OutputSchema<P>()
      .key("p1", &P::p1, "Pa", "p_1")
      .key("p3", &P::p3, "Pa", "p_3")
      .key("p4", &P::p4, "Pa", "p_4")
      .key("force", &P::force, "N/m", "P")
      .key("uplift", &P::uplift, "N/m", "U");
}

OutputSchema<ElasticSliding> elastic_outputs() {
  using E = ElasticSliding;
  return OutputSchema<E>()
      .key("peak_shear", &E::peak_shear, "N/m", "largest abs(F_T)")
      .key("peak_displacement", &E::peak_displacement, "m", "of the caisson")
      .key("sliding", inner(&E::slip, &Sliding::residual), "m", "S");
}

OutputSchema<WaveAnswer> sliding_outputs() {
  using A = WaveAnswer;
  const auto parts = [](const A& a) { return Json{a.sliding.paper_parts.accelerating, a.sliding.paper_parts.braking}; };
  return OutputSchema<A>()
      .key("tau_0F", &A::tau_0F, "s", "eq. (11)")
      .key("k", &A::k, "", "k(alpha*)")
      .key("tau_0", inner(&A::pulse, &TriangularPulse::duration), "s", "k tau_0F")
      .key("shear_force", &A::force, "N/m", "F_T that slides")
      .key(
          "shear_force_from", [](const A& a) { return a.measured ? "measured" : "goda"; }, "", "`goda` or `measured`")
      .key("sliding_force", inner(&A::pulse, &TriangularPulse::peak), "N/m", "F_Smax")
      .key("ratio", &A::ratio, "", "r; not 1/S.F. unless U = 0")
      .key("sliding_paper", inner(&A::sliding, &SlidingDistances::paper), "m", "S by eq. (7)")
      .key("sliding_paper_parts[]", parts, "m", "its parts S_1, S_2")
      .key("sliding_exact", inner(&A::sliding, &SlidingDistances::exact), "m", "S by eqs. (4), (6)")
      .key("sliding_combined", inner(&A::sliding, &SlidingDistances::combined), "m", "S with the standing wave, too")
      .object("elastic", &A::elastic, elastic_outputs(),
              "on the swaying ground; null without `[ground]` and `pulse_duration`")
      .keys_of(&A::standing, standing_outputs())
      .object("impact", &A::impact, impact_outputs(),
              "by PROVERBS, if the wave breaks on the wall; null unless `impact.force = \"proverbs\"`")
      .list("warnings[]", &A::warnings, warning_outputs(), "[of that wave](waves.md#warnings); may be empty");
}

/// The keys of a wave at one level of still water.
OutputSchema<WaveAnswer> answer_outputs() {
  using A = WaveAnswer;
  using D = DesignWave;
  const auto heights = OutputSchema<D>()
                           .key("height", &D::height, "m", "H")
                           .key("significant_height", &D::significant_height, "m", "H_1/3")
                           .key("period", &D::period, "s", "T");
  return OutputSchema<A>()
      .keys_of(&A::wave, heights)
      .key("angle", &A::angle, "degrees", "beta")
      .key("direction", &A::direction, "degrees", "from which it comes, from north; null where `angle` is given")
      .key("wavelength", &A::wavelength, "m", "L")
      .keys_of(&A::pressure, coefficients_outputs())
      .key(
          "overtopped", [](const A& a) { return a.pressure.eta_star > a.section.crest; }, "",
          "whether eta* is above h_c")
      .keys_of(&A::pressure, forces_outputs())
      .object("without_alpha_I", &A::without_alpha_I, without_outputs(), "by alpha_2 alone")
      .keys_of(&A::stability, stability_outputs())
      .keys_of([](const A& a) -> const A& { return a; }, sliding_outputs());
}

OutputSchema<WaveAnswer> wave_outputs() {
  using A = WaveAnswer;
  const auto level = OutputSchema<A>()
                         .key("rise", &A::rise, "m", "above the section's still water")
                         .object("section", &A::section, section_outputs(), "as it stands at that level")
                         .keys_of([](const A& a) -> const A& { return a; }, answer_outputs());
  return answer_outputs()
      .named("levels.LEVEL", &A::levels, &A::level, level,
             "the wave at each level of `[levels]`, and at that of the section as `section`")
      .or_left_out()
      .object("governing", &A::governing, governing_outputs(), "which of these levels is the worst for each check")
      .or_left_out();
}

const OutputSchema<ToldWaves>& waves_outputs() {
  using W = ToldWaves;
  using D = DesignTables;
  const auto fluid = OutputSchema<Water>().key("density", &Water::density, "kg/m3", "rho");
  const auto factor = OutputSchema<DurationFactor>()
                          .key("a", &DurationFactor::a, "", "of k(alpha*)")
                          .key("b", &DurationFactor::b, "", "of k(alpha*)");
  static const auto schema = OutputSchema<W>()
                                 .key("title", inner(&W::design, &D::title), "", "that of the design")
                                 .program()
                                 .object("verdict", &W::verdict, verdict_outputs(), "what all checks say together")
                                 .list("checks[]", &W::checks, check_outputs(),
                                       "of each wave, at the level of still water at which it is worst")
                                 .list("warnings[]", &W::warnings, warning_outputs(),
                                       "[what may be wrong](waves.md#warnings), of all waves and levels")
                                 .key("gravity", inner(&W::design, &D::water, &Water::gravity), "m/s2", "g")
                                 .object("fluid", inner(&W::design, &D::water), fluid, "as used")
                                 .object("section", inner(&W::design, &D::section), section_outputs(), "as used")
                                 .object("duration", inner(&W::design, &D::duration), factor, "as used")
                                 .named(
                                     "waves.NAME", [](const W& w) -> const auto& { return *w.waves; },
                                     &WaveAnswer::name, wave_outputs(), "each wave of the design")
                                 .versions();
  return schema;
}

}  // namespace

std::vector<OutputRow> rows_of_waves() {
  return waves_outputs().rows();
}

Json to_json(const Design& design, const std::vector<WaveAnswer>& answers) {
  const DesignTables& tables = design.tables;
  ToldWaves told{&tables, &answers, checks_of(tables, answers), warnings_of(design, answers), {}};
  append(told.checks, unjudged_limits(tables.limits, told.checks, false));
  told.verdict = verdict_of(told.checks, told.warnings);
  return waves_outputs().to_json(told);
}

}  // namespace upbead
