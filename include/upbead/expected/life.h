// Lives of a breakwater by Monte Carlo: a life repeats the sea states of a record, or draws storms of a climate, and
// draws everything uncertain. The statistics of the sliding distances of many lives.
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
  uniform,     ///< any level between tide_low and tide_high, all equally likely
};

struct StormClimate {
  ExtremeKind kind = ExtremeKind::weibull;  ///< of H_0', the equivalent deep-water significant height of a storm
  double location = 0.;                     ///< m
  double scale = 0.;                        ///< m
  double shape = 1.;                        ///< of weibull
  double per_year = 1.;                     ///< storms
  bool poisson = false;                     ///< whether their number per life is random; else it is always the same
  double duration = 7200.;                  ///< s
  std::optional<double> period;             ///< T (s); none: from steepness
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

/// The uncertain quantities; one that is not given is certain. All but water_level are factors.
struct Uncertainties {
  std::optional<Distribution> significant_height;
  std::optional<Distribution> wave;  ///< of the height of single waves
  std::optional<Distribution> period;
  std::optional<Distribution> force, uplift, friction, weight;
  std::optional<Distribution> water_level;  ///< added (m)
};

using LawMaker = std::function<std::unique_ptr<SlidingLaw>(const SeaState&)>;
/// The limit (m) of the wave height in a sea state: higher waves break and arrive with this height.
using WaveLimit = std::function<double(const SeaState&)>;

/// Storms that are drawn instead of taken from a record. Each u is a number in (0, 1).
struct StormSource {
  std::function<double(double u)> number;  ///< of storms in a life
  std::function<SeaState(double u_height, double u_tide)> storm;
};

struct LifeSetup {
  std::vector<SeaState> states;       ///< of the record
  std::optional<StormSource> source;  ///< or storms that are drawn
  double record_years = 1.;           ///< years that the record covers
  double life_years = 50.;
  double cut = RayleighHeights::no_cut;  ///< largest height that is not set aside, over H_1/3
  WaveLimit limit;                       ///< for a sea state as drawn; none: waves do not break
  Uncertainties uncertain;
  LawMaker law;  ///< for a sea state as drawn
  std::uint64_t seed = 1;
  bool every_wave = false;       ///< draw also the waves that cannot slide: much slower, for tests
  bool worst_of_storms = false;  ///< keep Life::worst_of_storms
};

/// A wave with everything that was drawn for it.
struct DrawnWave {
  SeaState sea;
  double height = 0.;  ///< m
  WaveFactors factors;
  double heel_pressure = 0.;  ///< by Goda's formulas, where it was computed (Pa)
};

struct Life {
  double sliding = 0.;   ///< sum of all S (m)
  double waves = 0.;     ///< number of waves
  double answered = 0.;  ///< waves whose S was computed, because they might slide
  double taken = 0.;     ///< waves that broke at the limit or lay beyond the cut
  double highest = 0.;   ///< of the waves whose S was computed, the highest (m)
  /// By Goda's formulas, from all waves; none where the law gives no moment, or the life has no wave.
  std::optional<WorstBase> base;
  DrawnWave most_tilting;  ///< the wave with the largest heel pressure
  /// Of each storm the wave with the largest heel pressure by Goda's formulas, in their order, where asked for.
  std::vector<DrawnWave> worst_of_storms;
};

/// Sees each wave of a life whose S was computed: by which law, how many equal ones.
using WaveWatch = std::function<void(const SlidingLaw& law, const DrawnWave& wave, double number)>;

/// A life repeats the record, the last time with a part of its waves, or takes its storms from a source. In a record, a
/// storm is one sea state of one repetition. Each random number depends only on its life, storm and wave: lives can be
/// simulated in any order, by any number of threads.
///
/// Where nothing scatters from wave to wave, only waves that may slide the caisson are drawn: first their number, which
/// is binomial, then their heights, given that they exceed the threshold of S or the limit. The distribution of S is
/// the same as with every wave drawn. A limit applies to the height after its factor. The worst pressures on the base
/// are then those of each storm's highest wave: by Goda's formulas P, U and their moments grow with the height, and so
/// do heel pressure and eccentricity.
class LifeSimulation {
 public:
  /// Throws std::invalid_argument where significant height, period or water level scatter from wave to wave, or a storm
  /// has more than 4e9 waves.
  explicit LifeSimulation(LifeSetup setup);
  /// May be called for different lives by different threads at the same time.
  Life life(std::uint32_t index, const WaveWatch& watch = nullptr) const;
  /// Number of storms, the same in every life; 0 with a source, where each life has its own number.
  std::size_t storms() const { return storms_; }

 private:
  struct Storm;
  struct Drawn;
  void add_storm(Storm& storm, Life& life) const;
  void add_every_wave(const Storm& storm, const SlidingLaw& law, Life& life, DrawnWave& most) const;
  /// Returns the height of the highest wave (m); none where all waves were set aside.
  std::optional<double> add_sliding_waves(const Storm& storm, const SlidingLaw& law, Life& life) const;
  SeaState sea_of(std::uint32_t life, std::uint32_t storm) const;
  Drawn drawn(Per per, const StreamPlace& place, const Drawn& before) const;

  LifeSetup setup_;
  Stream stream_;
  std::size_t storms_;
  bool by_wave_;                                         ///< whether something scatters from wave to wave
  std::vector<std::unique_ptr<const SlidingLaw>> laws_;  ///< of the states, where no draw changes them
  std::vector<double> limits_;                           ///< and their limits (m)
};

using Interval = std::array<double, 2>;

struct Quantile {
  double probability = 0.;
  double value = 0.;
};

/// P(S > limit), and its interval of 95 % confidence by Clopper and Pearson (1934).
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

/// `sliding`: S of each life (m), at least two. Sums are taken in the order given, so that they do not depend on which
/// thread computed which life. A quantile is the least S that this share of the lives does not exceed.
LifeStatistics statistics(const std::vector<double>& sliding, const std::vector<double>& limits = {0.1, 0.3, 1.});

}  // namespace upbead
