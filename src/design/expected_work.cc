#include "design/expected_report.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <mutex>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "design/expected_laws.h"
#include "design/lives.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int curve_points = 240;

StateAnswer answer_of(const DesignTables& tables, const SeaState& state) {
  const SeaBefore before = sea_before(tables.section, tables.water, state);
  const HighestWave& highest = tables.highest();
  const double limit = highest.breaking ? before.heights.breaker : RayleighHeights::no_cut;
  return {state, RayleighHeights(state.significant_height, highest.cut, limit), before, {}};
}

/// Number of waves of all sea states above a height.
double waves_above(const std::vector<StateAnswer>& states, double height) {
  double sum = 0.;
  for (const StateAnswer& s : states) sum += s.state.waves * s.heights.exceedance(height);
  return sum;
}

/// The height that this number of waves exceeds; 0 where there are fewer waves.
double height_of(const std::vector<StateAnswer>& states, double number) {
  const auto excess = [&](double height) { return waves_above(states, height) - number; };
  if (excess(0.) <= 0.) return 0.;
  double high = 1.;
  while (excess(high) > 0.) high *= 2.;
  boost::uintmax_t most = 100;
  return boost::math::tools::toms748_solve(excess, 0., high, boost::math::tools::eps_tolerance<double>(50), most).first;
}

QuadratureChoice choice_of(Law law) {
  return law == Law::dynamic || law == Law::combined ? QuadratureChoice{1e-5, 8} : QuadratureChoice{};
}

/// The base under the height that one wave of a sea state exceeds.
HighestOnBase highest_on_base(const Laws& laws, const StateAnswer& state) {
  const double height = state.heights.height(1. / std::max(state.state.waves, 1.));
  const DrawnWave wave{state.state, height, {}};
  HighestOnBase base{height, *laws.base(Law::exact, wave), {}, laws.why_no_dynamic_base()};
  if (base.why_not_dynamic.empty()) base.dynamic = laws.base(Law::dynamic, wave);
  return base;
}

HighestOnBase worst_base(const std::vector<StateAnswer>& states) {
  HighestOnBase worst = states.front().base;
  for (const StateAnswer& state : states) {
    if (state.base.goda.heel_pressure > worst.goda.heel_pressure) worst.height = state.base.height;
    worst.goda = worst_of(worst.goda, state.base.goda);
    if (worst.dynamic) worst.dynamic = worst_of(*worst.dynamic, *state.base.dynamic);
  }
  return worst;
}

void integrate_states(const Laws& laws, std::vector<StateAnswer>& states) {
  in_parallel(states.size(), "integrating", [&](std::size_t i) {
    StateAnswer& answer = states[i];
    for (const Law law : laws.known())
      answer.by_law[law] =
          expected_distance(*laws.make(law, answer.state), answer.heights, answer.state.waves, choice_of(law));
    answer.base = highest_on_base(laws, answer);
  });
}

std::map<Law, Expectation> total_of(const std::vector<StateAnswer>& states) {
  std::map<Law, Expectation> total;
  for (const StateAnswer& state : states)
    for (const auto& [law, part] : state.by_law) {
      Expectation& sum = total.try_emplace(law, Expectation{0., 0., 0., 0., HUGE_VAL}).first->second;
      sum.distance += part.distance;
      sum.broken += part.broken;
      sum.error += part.error;
      sum.sliding_waves += part.sliding_waves;
      sum.threshold = std::min(sum.threshold, part.threshold);
    }
  for (const auto& [law, sum] : total)
    if (!std::isfinite(sum.distance))
      throw NumericsError(std::string("the expected distance by the law '") + word(law) + "' is not finite");
  return total;
}

void add_peaks(const DynamicLaw& law, HeightCurves& curves) {
  for (const double height : curves.height) {
    const DynamicWave wave = law.wave(height);
    curves.peak_force.push_back(*std::max_element(wave.force.begin(), wave.force.end()));
    curves.peak_shear.push_back(*std::max_element(wave.shear.begin(), wave.shear.end()));
  }
}

/// Curves up to the height that a thousandth of a wave exceeds, or to the limit.
HeightCurves curves_of(const Laws& laws, const std::vector<StateAnswer>& states) {
  const auto most = std::max_element(states.begin(), states.end(), [](const StateAnswer& a, const StateAnswer& b) {
    return a.by_law.at(Law::exact).distance < b.by_law.at(Law::exact).distance;
  });
  HeightCurves curves;
  curves.state = most->state;
  const double top = height_of(states, 1e-3);
  for (int i = 1; i <= curve_points; ++i) curves.height.push_back(top * i / curve_points);
  for (const double height : curves.height) {
    double sum = 0.;
    for (const StateAnswer& s : states) sum += s.state.waves * s.heights.density(height);
    curves.waves.push_back(sum);
  }
  for (const Law law : laws.known()) {
    const auto of = laws.make(law, curves.state);
    for (const double height : curves.height) {
      const double distance = of->distance(height);
      curves.distance[law].push_back(distance);
      curves.contribution[law].push_back(curves.state.waves * most->heights.density(height) * distance);
    }
  }
  if (laws.model()) add_peaks(*laws.dynamic(curves.state), curves);
  for (const double height : curves.height)
    curves.heel_pressure.push_back(laws.base(Law::exact, {curves.state, height, {}})->heel_pressure);
  return curves;
}

StormSource source_of(const Design& design) {
  const StormClimate climate = climate_of(*design.tables.storms);
  return {[climate, years = design.tables.life->years](double u) { return number_of_storms(climate, years, u); },
          [climate, section = design.tables.section, water = design.tables.water](double u_height, double u_tide) {
            return storm_on(section, water, climate, u_height, u_tide);
          }};
}

/// `side` = -1: values below the limit are beyond it.
template <class Value>
WorstOfLives worst_of_lives(const std::vector<LifeNumbers>& lives, const Value& value,
                            const std::optional<double>& limit, double side = 1.) {
  WorstOfLives out;
  std::vector<double> turned;
  for (const LifeNumbers& life : lives) {
    out.values.push_back(value(life));
    turned.push_back(side * value(life));
  }
  out.statistics = statistics(out.values, {});
  if (limit) {
    out.beyond = statistics(turned, {side * *limit}).exceeded.front();
    out.beyond->limit = *limit;
  }
  return out;
}

BaseOfLives base_of_lives(const Limits& limits, Law law, const std::vector<LifeNumbers>& lives) {
  const auto of = [](double WorstBase::*member) {
    return [member](const LifeNumbers& life) { return life.base.*member; };
  };
  const auto& pressure = law == Law::dynamic ? limits.dynamic_base_pressure : limits.base_pressure;
  return {worst_of_lives(lives, of(&WorstBase::heel_pressure), pressure),
          worst_of_lives(lives, of(&WorstBase::toe_pressure), pressure),
          worst_of_lives(lives, of(&WorstBase::eccentricity), {}),
          worst_of_lives(lives, of(&WorstBase::overturning_margin), limits.overturning, -1.)};
}

/// Every way to fail in a life: under the worst wave of each storm by Goda's formulas; of very many storms under those
/// of the worst.
WaysToFail ways_of_life(const Laws& laws, std::vector<DrawnWave> storms, const WaysToFail& at_rest, double& answered) {
  constexpr std::size_t most = 200;
  std::sort(storms.begin(), storms.end(), [](const DrawnWave& a, const DrawnWave& b) {
    return a.heel_pressure != b.heel_pressure ? a.heel_pressure > b.heel_pressure : a.height > b.height;
  });
  storms.resize(std::min(storms.size(), most));
  WaysToFail worst = at_rest;
  for (const DrawnWave& wave : storms) worst = worst_of(worst, laws.ways(wave));
  answered = static_cast<double>(storms.size());
  return worst;
}

/// The largest share by which a lower wave of these seas is less safe than the highest that may come.
double lower_worse(const Laws& laws, const DesignTables& tables, const std::vector<SeaState>& seas) {
  constexpr int n_heights = 24;
  constexpr std::size_t most_seas = 12;
  std::vector<double> share(std::min(seas.size(), most_seas), 0.);
  in_parallel(share.size(), "looking at lower waves", [&](std::size_t i) {
    const StateAnswer sea = answer_of(tables, seas[i * seas.size() / share.size()]);
    const double highest = sea.heights.height(0.1 / std::max(sea.state.waves, 1.));
    std::vector<WaysToFail> ways;
    for (int n = 1; n <= n_heights; ++n) ways.push_back(laws.ways({sea.state, highest * n / n_heights, {}}));
    for (const WaysToFail& lower : ways)
      for (double WaysToFail::*factor : {&WaysToFail::circles, &WaysToFail::sliding, &WaysToFail::overturning})
        if (lower.*factor < ways.back().*factor && lower.*factor > 0. && std::isfinite(ways.back().*factor))
          share[i] = std::max(share[i], ways.back().*factor / lower.*factor - 1.);
  });
  return share.empty() ? 0. : *std::max_element(share.begin(), share.end());
}

WaysOfLives ways_of_lives(const Limits& limits, const std::vector<LifeNumbers>& lives) {
  using W = WaysToFail;
  constexpr double stands = 1.;
  const auto of = [](double W::*member) { return [member](const LifeNumbers& life) { return life.ways.*member; }; };
  double answered = 0.;
  for (const LifeNumbers& life : lives) answered += life.answered_for_ways;
  return {worst_of_lives(lives, of(&W::sliding), stands, -1.),
          worst_of_lives(lives, of(&W::sliding_seaward), stands, -1.),
          worst_of_lives(lives, of(&W::overturning), limits.overturning.value_or(stands), -1.),
          worst_of_lives(lives, of(&W::heel_pressure), limits.dynamic_base_pressure),
          worst_of_lives(lives, of(&W::toe_pressure), limits.dynamic_base_pressure),
          worst_of_lives(lives, of(&W::circles), limits.circles.value_or(stands), -1.),
          answered,
          0.};
}

LifeSetup life_setup(const Design& design, const Laws& laws, const std::vector<SeaState>& record, Law law) {
  const DesignTables& tables = design.tables;
  LifeSetup setup;
  if (tables.storms) {
    setup.source = source_of(design);
  } else {
    setup.states = record;
    setup.record_years = tables.sea->years;
  }
  setup.life_years = tables.life->years;
  setup.cut = tables.highest().cut;
  if (tables.highest().breaking)
    setup.limit = [&tables](const SeaState& state) {
      return sea_before(tables.section, tables.water, state).heights.breaker;
    };
  setup.uncertain = uncertainties(tables.scatter);
  setup.law = [&laws, law](const SeaState& state) { return laws.make(law, state); };
  setup.seed = static_cast<std::uint64_t>(tables.life->seed);
  return setup;
}

/// The lives by one law.
class LivesOfLaw {
 public:
  LivesOfLaw(const Design& design, const Laws& laws, const std::vector<SeaState>& record, Law law)
      : laws_(laws),
        law_(law),
        why_no_base_(law == Law::dynamic ? laws.why_no_dynamic_base() : ""),
        knows_ways_(law == Law::dynamic && laws.knows_ways()),
        at_rest_(knows_ways_ ? laws.ways_at_rest() : WaysToFail()),
        simulation_(setup(design, record)) {}

  /// May be called by several threads.
  LifeNumbers numbers(int index) const {
    Life life = simulation_.life(static_cast<std::uint32_t>(index));
    LifeNumbers found{life.sliding, life.waves, life.answered, life.taken, life.highest, {}, {}, 0.};
    if (why_no_base_.empty()) found.base = base_of(life);
    if (knows_ways_)
      found.ways = ways_of_life(laws_, std::move(life.worst_of_storms), at_rest_, found.answered_for_ways);
    return found;
  }
  const std::string& why_no_base() const { return why_no_base_; }
  bool knows_ways() const { return knows_ways_; }

 private:
  LifeSetup setup(const Design& design, const std::vector<SeaState>& record) const {
    LifeSetup setup = life_setup(design, laws_, record, law_);
    setup.worst_of_storms = knows_ways_;
    return setup;
  }
  /// With the law dynamic the base by own dynamics in the life's wave of the largest heel pressure by Goda's formulas.
  WorstBase base_of(const Life& life) const {
    if (!life.base) return *laws_.base(Law::exact, {SeaState{1., 10., 1., 0., 0.}, 0., {}});  // at rest
    return law_ == Law::dynamic ? *laws_.base(Law::dynamic, life.most_tilting) : *life.base;
  }

  const Laws& laws_;
  Law law_;
  std::string why_no_base_;
  bool knows_ways_;
  WaysToFail at_rest_;
  LifeSimulation simulation_;
};

void add_sums(const std::vector<LifeNumbers>& lives, MonteCarlo& out) {
  for (const LifeNumbers& life : lives) {
    if (!std::isfinite(life.sliding)) throw NumericsError("the sliding distance of a life is not finite");
    out.sliding.push_back(life.sliding);
    out.waves += life.waves;
    out.answered += life.answered;
    out.taken += life.taken;
    out.highest = std::max(out.highest, life.highest);
  }
}

/// `known`: the lives where they have been computed; else null.
MonteCarlo simulate(const Design& design, const Laws& laws, const std::vector<SeaState>& record,
                    const ExpectedAnswer& answer, Law law, const std::vector<LifeNumbers>* known) {
  const DesignTables& tables = design.tables;
  MonteCarlo out;
  out.law = law;
  if (!tables.storms) out.without_scatter = answer.total.at(law).distance * tables.life->years / tables.sea->years;
  const LivesOfLaw of_law(design, laws, record, law);
  const Stopwatch watch;
  std::vector<LifeNumbers> computed(known ? 0 : static_cast<std::size_t>(tables.life->lives));
  in_parallel(computed.size(), "simulating lives",
              [&](std::size_t i) { computed[i] = of_law.numbers(static_cast<int>(i)); });
  const std::vector<LifeNumbers>& lives = known ? *known : computed;
  if (of_law.knows_ways()) {
    out.ways = ways_of_lives(tables.limits, lives);
    out.ways->lower_worse = lower_worse(laws, tables, tables.storms ? typical_storms(design) : record);
  }
  out.why_no_base = of_law.why_no_base();
  if (out.why_no_base.empty()) out.base = base_of_lives(tables.limits, law, lives);
  out.seconds = known ? 0. : watch.seconds();
  add_sums(lives, out);
  std::vector<double> limits{0.1, 0.3, 1.};
  if (tables.limits.sliding && std::find(limits.begin(), limits.end(), *tables.limits.sliding) == limits.end())
    limits.push_back(*tables.limits.sliding);
  out.statistics = statistics(out.sliding, limits);
  return out;
}

/// The law of the lives and, beside own dynamics, formulas.
std::vector<Law> laws_of_lives(const Design& design, const Laws& laws) {
  const Law law = design.tables.life->sliding.value_or(laws.best());
  return law == Law::dynamic ? std::vector{law, Law::exact} : std::vector{law};
}

/// Lives of the record, in place of those of a design that has none.
LifeTable lives_of_record(const Design& design) {
  constexpr int lives = 200;
  return {design.tables.sea->years, lives, 1, Law::dynamic};
}

/// S node by node of all waves, from some of them; `block`: that of the law dynamic.
NodeSliding nodes_of(const WaveSample& sample, const DearSum& found, int lives, double block) {
  NodeSliding nodes;
  nodes.block = block;
  const double each = sample.block > 0. ? block / sample.block : 1. / lives;
  nodes.mean = std::max(0., each * found.sum);
  if (sample.block > 0.) nodes.ratio = std::max(0., found.sum) / sample.block;
  nodes.draw_error = each * found.standard_error;
  nodes.standard_error = std::hypot(nodes.draw_error, sample.lives * nodes.mean);
  const double quantile =
      found.freedom > 0 ? boost::math::quantile(boost::math::students_t(found.freedom), 0.975) : 1.96;
  nodes.interval = {std::max(0., nodes.mean - quantile * nodes.standard_error),
                    nodes.mean + quantile * nodes.standard_error};
  nodes.ground_error = each * found.measure_error;
  nodes.waves = static_cast<int>(sample.waves.size()) - found.unanswered;
  nodes.unanswered = found.unanswered;
  nodes.is_whole = sample.is_whole;
  return nodes;
}

/// Slip and lift node by node of some of the waves of the lives, or of the record where there are none.
void slide_nodes(Design design, const Laws& laws, const std::vector<SeaState>& record, const NodeAnswer& nodes,
                 ExpectedAnswer& answer) {
  const bool of_lives = answer.monte_carlo.has_value();
  if (of_lives && answer.monte_carlo->law != Law::dynamic) {
    answer.why_no_nodes = std::string("the lives are by the law ") + word(answer.monte_carlo->law);
    return;
  }
  const Stopwatch watch;
  if (!of_lives) {
    design.tables.life = lives_of_record(design);
    design.tables.scatter = {};
  }
  const int lives = design.tables.life->lives;
  const double block = of_lives ? answer.monte_carlo->statistics.mean : answer.total.at(Law::dynamic).distance;
  const WaveSample sample =
      sample_waves(life_setup(design, laws, record, Law::dynamic), lives, design.tables.dynamics->node_waves);
  const DearSum found = estimate(sample, laws.slips(nodes, sample.waves));
  answer.why_no_nodes = found.why_not;
  if (found.why_not.empty()) answer.nodes = nodes_of(sample, found, lives, block);
  if (answer.nodes) answer.nodes->of_lives = of_lives;
  answer.nodes_seconds = watch.seconds();
}

void integrate(const Design& design, const Laws& laws, const std::vector<SeaState>& record, ExpectedAnswer& answer) {
  for (const SeaState& state : record) {
    answer.states.push_back(answer_of(design.tables, state));
    answer.taken += state.waves * answer.states.back().heights.taken();
    answer.all += state.waves;
  }
  integrate_states(laws, answer.states);
  answer.total = total_of(answer.states);
  answer.base = worst_base(answer.states);
  const auto highest = std::max_element(answer.states.begin(), answer.states.end(),
                                        [](const auto& a, const auto& b) { return a.base.height < b.base.height; });
  if (answer.model && highest != answer.states.end())
    append(answer.model->warnings, laws.error_warnings(highest->state, highest->base.height));
  answer.waves = waves_above(answer.states, 0.);
  answer.highest = height_of(answer.states, 1.);
  for (const auto& [name, height] : design.tables.sea->heights)
    answer.exceedance.push_back({name, height, waves_above(answer.states, height)});
  answer.curves = curves_of(laws, answer.states);
}

}  // namespace

namespace {

/// A significant height above the depth at the site is no sea's: waves of half of it break there (Goda's highest
/// breaker).
NumberedWarnings heights_above_depth(const std::vector<SeaState>& record, double depth) {
  std::size_t first = record.size(), n = 0;
  for (std::size_t i = 0; i < record.size(); ++i)
    if (record[i].significant_height > depth + record[i].water_level && n++ == 0) first = i;
  if (n == 0) return {};
  const SeaState& state = record[first];
  const double water = depth + state.water_level;
  return {{"height_above_depth", state.significant_height, water, "m",
           std::to_string(n) + " of " + std::to_string(record.size()) +
               " sea states have an H_1/3 above the depth, the first, row " + std::to_string(first + 1) + ", " +
               significant(state.significant_height, 4) + " m in " + significant(water, 4) +
               " m of water: a mark for a missing value, or another unit",
           "look at significant_height and water_depth", true}};
}

}  // namespace

ExpectedAnswer find_expected(const Design& design, const LivesByLaw* known, const NodeAnswer& nodes) {
  std::vector<SeaState> record;
  RecordNotes notes;
  if (design.tables.sea)
    record = read_sea_states(design.resolve(design.tables.sea->states), design.document.place("sea.states"), notes);
  append(notes.warnings, heights_above_depth(record, design.tables.section.water_depth));
  const Stopwatch watch;
  const Laws laws(design, design.tables.storms ? typical_storms(design) : record);
  ExpectedAnswer answer;
  answer.notes = std::move(notes);
  answer.model = laws.model();
  if (design.tables.sea) integrate(design, laws, record, answer);
  answer.quadrature_seconds = watch.seconds();
  if (design.tables.life)
    for (const Law law : laws_of_lives(design, laws)) {
      std::optional<MonteCarlo>& found = answer.monte_carlo ? answer.formula_lives : answer.monte_carlo;
      found = simulate(design, laws, record, answer, law, known ? &known->at(law) : nullptr);
    }
  if (nodes && laws.knows_nodes() && design.tables.dynamics->node_waves > 0)
    slide_nodes(design, laws, record, nodes, answer);
  return answer;
}

void compute_lives(const Design& design, const std::vector<int>& lives,
                   const std::function<void(int life, const LifeByLaw& found)>& take) {
  std::vector<SeaState> record;
  RecordNotes notes;
  if (design.tables.sea)
    record = read_sea_states(design.resolve(design.tables.sea->states), design.document.place("sea.states"), notes);
  const Laws laws(design, design.tables.storms ? typical_storms(design) : record);
  std::map<Law, LivesOfLaw> by_law;
  for (const Law law : laws_of_lives(design, laws)) by_law.try_emplace(law, design, laws, record, law);
  std::mutex one_at_a_time;
  in_parallel(lives.size(), "simulating lives", [&](std::size_t i) {
    LifeByLaw found;
    for (const auto& [law, of_law] : by_law) found[law] = of_law.numbers(lives[i]);
    const std::lock_guard lock(one_at_a_time);
    take(lives[i], found);
  });
}

}  // namespace upbead
