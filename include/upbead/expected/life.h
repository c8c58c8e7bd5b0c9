// Lives of a breakwater by Monte Carlo: the sea states of a record over and over, or storms of a climate, and
// everything uncertain drawn; what the sliding distances of many lives tell.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "upbead/expected/distribution.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/waves/goda.h"

namespace upbead {

enum class ExtremeKind {
  weibull,  ///< F(x) = 1 - exp(-((x - location)/scale)^shape)
  gumbel,   ///< F(x) = exp(-exp(-(x - location)/scale))
};

enum class TideKind {
  sinusoidal,  ///< a storm meets any phase of a sinusoidal tide
  uniform,     ///< any level between the two
};

struct StormClimate {
  ExtremeKind kind = ExtremeKind::weibull;  ///< of H_0', the equivalent deep-water significant height of a storm
  double location = 0.;                     ///< m
  double scale = 0.;                        ///< m
  double shape = 1.;                        ///< of weibull
  double per_year = 1.;                     ///< storms
  bool poisson = false;                     ///< their number is random; else always the same
  double duration = 7200.;                  ///< s
  std::optional<double> period;             ///< T (s); or from steepness
  std::optional<double> steepness;          ///< H_0'/L_0, which makes T = sqrt(2 pi H_0' / (g steepness))
  double angle = 0.;                        ///< beta (rad)
  double tide_low = 0., tide_high = 0.;     ///< still water above that of the section (m)
  TideKind tide = TideKind::sinusoidal;
};

/// H_0' (m) that a share u of the storms stays below; at least 1 cm.
double deep_water_height(const StormClimate& climate, double u);
/// The level (m) that a share u of the storms stays below.
double tide_level(const StormClimate& climate, double u);
/// The least n such that a share u of all lives has at most n storms.
double number_of_storms(const StormClimate& climate, double years, double u);

/// A storm on the section: H_1/3 by random breaking [Goda 2000] in the depth h that the tide makes, duration/T waves.
SeaState storm_on(const Section& section, const Water& water, const StormClimate& climate, double u_height,
                  double u_tide);

/// What is uncertain; what is not given is certain. All but water_level are factors.
struct Uncertainties {
  std::optional<Distribution> significant_height;
  std::optional<Distribution> wave;  ///< of the height of single waves
  std::optional<Distribution> period;
  std::optional<Distribution> force, uplift, friction, weight;
  std::optional<Distribution> water_level;  ///< added (m)
};

using LawMaker = std::function<std::unique_ptr<SlidingLaw>(const SeaState&)>;
/// The height (m) to which higher waves of a sea state break.
using WaveLimit = std::function<double(const SeaState&)>;

/// Storms that are drawn and do not come from a record. Both take numbers in (0, 1).
struct StormSource {
  std::function<double(double u)> number;  ///< of storms in a life
  std::function<SeaState(double u_height, double u_tide)> storm;
};

struct LifeSetup {
  std::vector<SeaState> states;       ///< of the record
  std::optional<StormSource> source;  ///< or this
  double record_years = 1.;           ///< that it covers
  double life_years = 50.;
  double cut = RayleighHeights::no_cut;  ///< of the heights, over H_1/3
  WaveLimit limit;                       ///< of a sea state as drawn; none: waves do not break
  Uncertainties uncertain;
  LawMaker law;  ///< of a sea state as drawn
  std::uint64_t seed = 1;
  bool every_wave = false;  ///< draw also the waves that cannot slide: much slower, for tests
};

/// A wave with everything that was drawn for it.
struct DrawnWave {
  SeaState sea;
  double height = 0.;  ///< m
  WaveFactors factors;
};

struct Life {
  double sliding = 0.;   ///< sum of all S (m)
  double waves = 0.;     ///< that came
  double answered = 0.;  ///< waves whose S was computed, because they might slide
  double taken = 0.;     ///< waves that broke to the limit or were beyond the cut
  double highest = 0.;   ///< of the waves whose S was computed, the highest (m)
  /// By Goda's formulas, with all waves; none where the law knows no moment, or no wave came.
  std::optional<WorstBase> base;
  DrawnWave most_tilting;  ///< that with the largest pressure of the heel
};

/// A life is the record, repeated, the last time with part of its waves, or storms of a source. A storm is one sea
/// state of one repetition.
/// Every number belongs to its life, storm and wave: lives can be simulated in any order, by any number of threads.
///
/// Where nothing scatters from wave to wave, only waves that may slide are drawn: their number, binomial, then their
/// heights given that they exceed the threshold of S or the limit. The distribution of S is the same as with every wave
/// drawn. A limit holds for the height with its factor. What presses on the base is then that of each storm's highest
/// wave: by Goda's formulas P, U and their moments grow with the height, and so do heel pressure and eccentricity.
class LifeSimulation {
 public:
  /// Throws std::invalid_argument where significant height, period or water level scatter from wave to wave, or a storm
  /// has more than 4e9 waves.
  explicit LifeSimulation(LifeSetup setup);
  /// Safe for different lives at the same time.
  Life life(std::uint32_t index) const;
  /// In every life; of a source 0, as each life has its own.
  std::size_t storms() const { return storms_; }

 private:
  struct Storm;
  struct Drawn;
  void add_storm(Storm& storm, Life& life) const;
  void add_every_wave(const Storm& storm, const SlidingLaw& law, Life& life) const;
  /// Returns the highest wave that came (m); none where all were set aside.
  std::optional<double> add_sliding_waves(const Storm& storm, const SlidingLaw& law, Life& life) const;
  SeaState sea_of(std::uint32_t life, std::uint32_t storm) const;
  Drawn drawn(Per per, const StreamPlace& place, const Drawn& before) const;

  LifeSetup setup_;
  Stream stream_;
  std::size_t storms_;
  bool by_wave_;                                         ///< something scatters from wave to wave
  std::vector<std::unique_ptr<const SlidingLaw>> laws_;  ///< of the states, where no draw changes them
  std::vector<double> limits_;                           ///< and their limits (m)
};

using Interval = std::array<double, 2>;

struct Quantile {
  double probability = 0.;
  double value = 0.;
};

/// P(S > limit), and where it lies with 95 % confidence, by Clopper and Pearson (1934).
struct Exceeded {
  double limit = 0.;
  double probability = 0.;
  Interval interval{};
};

struct LifeStatistics {
  double mean = 0.;
  double standard_error = 0.;  ///< of the mean
  Interval interval{};         ///< of the mean, 95 %, Student's t: too narrow where few lives bring most of the sum
  std::vector<Quantile> quantiles;
  std::vector<Exceeded> exceeded;
  int sliding_lives = 0;  ///< lives with S > 0
};

/// `sliding`: S of each life (m), at least two. Sums are taken in the order given, so that they do not depend on who
/// computed them. Quantiles: the least S that such a share of the lives does not exceed.
LifeStatistics statistics(const std::vector<double>& sliding, const std::vector<double>& limits = {0.1, 0.3, 1.});

}  // namespace upbead
