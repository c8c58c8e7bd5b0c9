#include "upbead/expected/life.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/extreme_value.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/numbers.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {

namespace {

constexpr std::uint32_t no_storm = 0xffffffff, no_wave = 0xffffffff;
constexpr double most_waves = 4e9;

/// The purpose of a random number at a place; a quantity's own purpose is its index in quantities().
enum Purpose : std::uint32_t {
  for_height = 16,
  for_number = 17,
  for_last_wave = 18,
  for_storms = 19,
  for_sea = 20,
  for_tide = 21,
  for_cut = 22
};

using Quantity = std::optional<Distribution> Uncertainties::*;

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> list{&Uncertainties::significant_height,
                                          &Uncertainties::wave,
                                          &Uncertainties::period,
                                          &Uncertainties::force,
                                          &Uncertainties::uplift,
                                          &Uncertainties::friction,
                                          &Uncertainties::weight,
                                          &Uncertainties::water_level};
  return list;
}

bool scatters(const Uncertainties& uncertain, Quantity quantity, Per per) {
  return (uncertain.*quantity) && (uncertain.*quantity)->per() == per;
}

/// Whether sea states differ from those of the record.
bool changes_states(const Uncertainties& u) {
  return u.significant_height || u.period || u.water_level;
}

/// The least k with P(K <= k) >= u for K binomial.
double binomial_quantile(double n, double p, double u) {
  if (n <= 0. || p <= 0. || u <= std::exp(n * std::log1p(-p))) return 0.;
  if (p >= 1.) return n;
  using Up =
      boost::math::policies::policy<boost::math::policies::discrete_quantile<boost::math::policies::integer_round_up>>;
  return quantile(boost::math::binomial_distribution<double, Up>(n, p), u);
}

/// Whether a wave cannot tilt the caisson more than another wave of its storm: P, U and their moments grow with the
/// height, and so do heel pressure and eccentricity.
bool no_worse(double height, const WaveFactors& factors, const DrawnWave& than) {
  return height <= than.height && factors.force <= than.factors.force && factors.uplift <= than.factors.uplift &&
         factors.weight == than.factors.weight;
}

/// Notes the pressures on the base in a wave. `of_storm`: the wave of the storm with the largest heel pressure so far.
void add_base(const SeaState& sea, const SlidingLaw& law, double height, const WaveFactors& factors, Life& life,
              DrawnWave& of_storm) {
  const WaveForces* forces = law.forces();
  if (!forces) return;
  const WorstBase base = forces->base(height, factors);
  if (!life.base || base.heel_pressure > life.base->heel_pressure)
    life.most_tilting = {sea, height, factors, base.heel_pressure};
  const bool as_high = base.heel_pressure == of_storm.heel_pressure;  // both without bound
  if (of_storm.height == 0. || base.heel_pressure > of_storm.heel_pressure ||
      (as_high && height * factors.force > of_storm.height * of_storm.factors.force))
    of_storm = {sea, height, factors, base.heel_pressure};
  life.base = life.base ? worst_of(*life.base, base) : base;
}

}  // namespace

/// All values that have been drawn for a wave so far.
struct LifeSimulation::Drawn {
  double significant_height = 1., wave = 1., period = 1., water_level = 0.;
  WaveFactors factors;
};

struct LifeSimulation::Storm {
  std::uint32_t life, index;
  SeaState sea;  ///< as drawn
  Drawn drawn;
  double waves;  ///< number, a whole one
  const WaveWatch& watch;
  double limit = RayleighHeights::no_cut;  ///< height at which waves break (m)

  /// Adds `number` equal waves.
  void add_waves(double number, const SlidingLaw& law, double height, const WaveFactors& factors, Life& to) const {
    to.sliding += number * law.distance(height, factors);
    to.answered += number;
    to.highest = std::max(to.highest, height);
    if (watch) watch(law, {sea, height, factors, 0.}, number);
  }
};

LifeSimulation::LifeSimulation(LifeSetup setup) : setup_(std::move(setup)), stream_(setup_.seed) {
  for (const Quantity quantity :
       {&Uncertainties::significant_height, &Uncertainties::period, &Uncertainties::water_level})
    if (scatters(setup_.uncertain, quantity, Per::wave))
      throw std::invalid_argument("significant height, period and water level belong to a storm, not to a wave");
  for (const SeaState& state : setup_.states)
    if (!(state.waves < most_waves)) throw std::invalid_argument("a storm of more than 4e9 waves");
  by_wave_ = false;
  for (const Quantity quantity : quantities()) by_wave_ = by_wave_ || scatters(setup_.uncertain, quantity, Per::wave);
  const double repetitions = std::ceil(setup_.life_years / setup_.record_years * (1. - 1e-12));
  if (!(repetitions * static_cast<double>(setup_.states.size()) < no_storm))
    throw std::invalid_argument("a life of more than 4e9 storms");
  storms_ = setup_.states.size() * static_cast<std::size_t>(repetitions);
  if (!changes_states(setup_.uncertain) && !setup_.source)
    for (const SeaState& state : setup_.states) {
      laws_.push_back(setup_.law(state));
      limits_.push_back(setup_.limit ? setup_.limit(state) : RayleighHeights::no_cut);
    }
}

LifeSimulation::Drawn LifeSimulation::drawn(Per per, const StreamPlace& place, const Drawn& before) const {
  Drawn all = before;
  double* const values[] = {&all.significant_height, &all.wave,           &all.period,
                            &all.factors.force,      &all.factors.uplift, &all.factors.friction,
                            &all.factors.weight,     &all.water_level};
  for (std::uint32_t i = 0; i < quantities().size(); ++i)
    if (scatters(setup_.uncertain, quantities()[i], per))
      *values[i] = (setup_.uncertain.*quantities()[i])->quantile(stream_.uniform({place[0], place[1], place[2], i}));
  return all;
}

/// The sea of a storm, with the number of its waves that fall within the life.
SeaState LifeSimulation::sea_of(std::uint32_t life, std::uint32_t storm) const {
  if (setup_.source)
    return setup_.source->storm(stream_.uniform({life, storm, no_wave, for_sea}),
                                stream_.uniform({life, storm, no_wave, for_tide}));
  SeaState sea = setup_.states[storm % setup_.states.size()];
  const std::size_t records_before = storm / setup_.states.size();
  sea.waves *= std::min(1., setup_.life_years / setup_.record_years - static_cast<double>(records_before));
  return sea;
}

Life LifeSimulation::life(std::uint32_t index, const WaveWatch& watch) const {
  Life life;
  const Drawn of_life = drawn(Per::life, {index, no_storm, no_wave, 0}, {});
  const auto n =
      setup_.source
          ? static_cast<std::size_t>(setup_.source->number(stream_.uniform({index, no_storm, no_wave, for_storms})))
          : storms_;
  for (std::uint32_t s = 0; s < n; ++s) {
    Storm storm{index, s, sea_of(index, s), drawn(Per::storm, {index, s, no_wave, 0}, of_life), 0., watch};
    storm.sea.significant_height *= storm.drawn.significant_height;
    storm.sea.period *= storm.drawn.period;
    storm.sea.water_level += storm.drawn.water_level;
    storm.waves = std::floor(storm.sea.waves);
    if (stream_.uniform({index, s, no_wave, for_last_wave}) < storm.sea.waves - storm.waves) storm.waves += 1.;
    add_storm(storm, life);
  }
  return life;
}

void LifeSimulation::add_storm(Storm& storm, Life& life) const {
  life.waves += storm.waves;
  std::unique_ptr<const SlidingLaw> own;
  if (laws_.empty()) own = setup_.law(storm.sea);
  const SlidingLaw& law = own ? *own : *laws_[storm.index % laws_.size()];
  if (!own)
    storm.limit = limits_[storm.index % limits_.size()];
  else if (setup_.limit)
    storm.limit = setup_.limit(storm.sea);
  DrawnWave worst;
  if (by_wave_ || setup_.every_wave)
    add_every_wave(storm, law, life, worst);
  else if (const auto highest = add_sliding_waves(storm, law, life))
    add_base(storm.sea, law, *highest, storm.drawn.factors, life, worst);
  if (setup_.worst_of_storms && worst.height > 0.) life.worst_of_storms.push_back(worst);
}

void LifeSimulation::add_every_wave(const Storm& storm, const SlidingLaw& law, Life& life, DrawnWave& most) const {
  const RayleighHeights heights(storm.sea.significant_height, setup_.cut);
  const auto n = static_cast<std::uint32_t>(storm.waves);
  DrawnWave worst;
  for (std::uint32_t w = 0; w < n; ++w) {
    const double share = stream_.uniform({storm.life, storm.index, w, for_height});  // of all waves that are higher
    if (share < heights.taken()) {
      life.taken += 1.;
      continue;
    }
    const Drawn all = by_wave_ ? drawn(Per::wave, {storm.life, storm.index, w, 0}, storm.drawn) : storm.drawn;
    const double unbroken = all.wave * heights.height(share - heights.taken());
    const double height = std::min(unbroken, storm.limit);
    if (unbroken > storm.limit) life.taken += 1.;
    storm.add_waves(1., law, height, all.factors, life);
    if (no_worse(height, all.factors, worst)) continue;
    add_base(storm.sea, law, height, all.factors, life, most);
    if (height * all.factors.force > worst.height * worst.factors.force) worst = {storm.sea, height, all.factors, 0.};
  }
}

std::optional<double> LifeSimulation::add_sliding_waves(const Storm& storm, const SlidingLaw& law, Life& life) const {
  const RayleighHeights heights(storm.sea.significant_height, setup_.cut);
  if (heights.taken() > 0.)
    life.taken +=
        binomial_quantile(storm.waves, heights.taken(), stream_.uniform({storm.life, storm.index, no_wave, for_cut}));
  const double u = stream_.uniform({storm.life, storm.index, no_wave, for_number});
  // No wave is higher than h if u <= (1 - p)^N, p the share of waves above h; that is, if h is above the height that
  // a share 1 - u^(1/N) exceeds. Most storms end here, without the threshold.
  const double rare = storm.waves > 0. ? -std::expm1(std::log(u) / storm.waves) : 1.;
  if (rare >= heights.exceedance(0.)) return std::nullopt;
  const double highest = storm.drawn.wave * heights.height(rare);
  const bool slide = law.may_slide(std::min(highest, storm.limit), storm.drawn.factors);
  if (!slide && highest <= storm.limit) return highest;
  // The waves that slide the caisson or, where none does, those that break.
  const double from = slide ? law.threshold(storm.drawn.factors) : storm.limit;
  const double share = heights.exceedance(from / storm.drawn.wave);
  const double number = binomial_quantile(storm.waves, share, u);
  double broken = slide ? 0. : number, drawn = 0.;
  for (std::uint32_t w = 0; slide && w < static_cast<std::uint32_t>(number); ++w) {
    const double part = stream_.uniform({storm.life, storm.index, w, for_height});
    const double height = storm.drawn.wave * heights.height(part * share);
    if (height > storm.limit)
      broken += 1.;
    else
      storm.add_waves(1., law, height, storm.drawn.factors, life);
    drawn = std::max(drawn, std::min(height, storm.limit));
  }
  life.taken += broken;
  if (slide && broken > 0.) storm.add_waves(broken, law, storm.limit, storm.drawn.factors, life);
  return drawn > 0. ? drawn : std::min(highest, storm.limit);
}

namespace {
constexpr double least_height = 0.01;  // m; a calm year is allowed
}  // namespace

double deep_water_height(const StormClimate& c, double u) {
  const double height = c.kind == ExtremeKind::weibull
                            ? c.location + quantile(boost::math::weibull(c.shape, c.scale), u)
                            : quantile(boost::math::extreme_value(c.location, c.scale), u);
  return std::max(height, least_height);
}

double tide_level(const StormClimate& c, double u) {
  const double part = c.tide == TideKind::uniform ? u : 0.5 * (1. - std::cos(pi * u));
  return c.tide_low + part * (c.tide_high - c.tide_low);
}

double number_of_storms(const StormClimate& c, double years, double u) {
  const double mean = c.per_year * years;
  if (!c.poisson) return std::floor(mean) + (u < mean - std::floor(mean) ? 1. : 0.);
  using Up =
      boost::math::policies::policy<boost::math::policies::discrete_quantile<boost::math::policies::integer_round_up>>;
  return quantile(boost::math::poisson_distribution<double, Up>(mean), u);
}

SeaState storm_on(const Section& section, const Water& water, const StormClimate& c, double u_height, double u_tide) {
  SeaState sea;
  const double deep = deep_water_height(c, u_height);
  sea.water_level = tide_level(c, u_tide);
  sea.period = c.period ? *c.period : std::sqrt(2. * pi * deep / (water.gravity * c.steepness.value()));
  sea.angle = c.angle;
  sea.waves = c.duration / sea.period;
  sea.significant_height =
      design_heights({deep, sea.period, section.water_depth + sea.water_level, section.bed_slope}, water.gravity)
          .significant;
  return sea;
}

namespace {

constexpr double beside = 0.025;  // probability on either side of an interval of 95 %

Exceeded exceeded(const std::vector<double>& sorted, double limit) {
  const auto n = static_cast<double>(sorted.size());
  const auto above = static_cast<double>(sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), limit));
  using Binomial = boost::math::binomial;
  return {limit,
          above / n,
          {above > 0. ? Binomial::find_lower_bound_on_p(n, above, beside) : 0.,
           above < n ? Binomial::find_upper_bound_on_p(n, above, beside) : 1.}};
}

double quantile_of(const std::vector<double>& sorted, double probability) {
  const double rank = std::ceil(probability * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.)) - 1];
}

}  // namespace

LifeStatistics statistics(const std::vector<double>& sliding, const std::vector<double>& limits) {
  if (sliding.size() < 2) throw std::invalid_argument("statistics need at least two lives");
  const auto n = static_cast<double>(sliding.size());
  LifeStatistics out;
  out.mean = std::accumulate(sliding.begin(), sliding.end(), 0.) / n;
  double squares = 0.;
  for (const double S : sliding) squares += (S - out.mean) * (S - out.mean);
  out.standard_error = std::sqrt(squares / (n - 1.) / n);
  const double half = quantile(complement(boost::math::students_t(n - 1.), beside)) * out.standard_error;
  out.interval = {out.mean - half, out.mean + half};
  std::vector<double> sorted = sliding;
  std::sort(sorted.begin(), sorted.end());
  for (const double p : {0.05, 0.5, 0.95, 0.99}) out.quantiles.push_back({p, quantile_of(sorted, p)});
  for (const double limit : limits) out.exceeded.push_back(exceeded(sorted, limit));
  out.sliding_lives = static_cast<int>(std::lround(exceeded(sorted, 0.).probability * n));
  return out;
}

}  // namespace upbead
