#include "expected/wave_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/progress.h"

namespace upbead {

namespace {

constexpr std::uint32_t of_no_storm = 0xffffffff, for_draw = 32;  // beside the purposes of a life

/// A law whose waves are drawn from the lower threshold that it has under the loose friction.
class LooseLaw : public SlidingLaw {
 public:
  explicit LooseLaw(std::unique_ptr<const SlidingLaw> law) : law_(std::move(law)) {}
  double distance(double height, const WaveFactors& factors) const override { return law_->distance(height, factors); }
  bool may_slide(double height, const WaveFactors& factors) const override {
    return law_->may_slide(height, loose(factors));
  }
  double threshold(const WaveFactors& factors) const override { return law_->threshold(loose(factors)); }

  static WaveFactors loose(WaveFactors factors) {
    factors.friction *= WaveSample::loose_friction;
    return factors;
  }

 private:
  std::unique_ptr<const SlidingLaw> law_;
};

/// S of equal waves, by the law and under the loose friction.
struct Slid {
  double block = 0., near = 0., waves = 0.;
};

/// A place on the axis of a life's summed S.
struct Point {
  double at;
  bool near;
};

struct Met {
  SampledWave wave;
  double near, number;  ///< S under the loose friction (m); of equal waves
  bool drawn_as_near;
};

/// Calls see() with each wave of a life that slides under the loose friction.
template <class See>
void each_wave(const LifeSimulation& lives, std::size_t life, const See& see) {
  lives.life(static_cast<std::uint32_t>(life), [&see](const SlidingLaw& law, const DrawnWave& wave, double number) {
    const double near = law.distance(wave.height, LooseLaw::loose(wave.factors));
    if (near > 0.) see(Met{{wave, law.distance(wave.height, wave.factors)}, near, number, false});
  });
}

std::vector<Slid> slid_of_lives(const LifeSimulation& simulation, int lives) {
  std::vector<Slid> slid(static_cast<std::size_t>(lives));
  in_parallel(slid.size(), "looking for waves", [&](std::size_t i) {
    each_wave(simulation, i, [&one = slid[i]](const Met& met) {
      one.block += met.number * met.wave.block;
      one.near += met.number * met.near;
      one.waves += 1.;
    });
  });
  return slid;
}

/// Relative standard error of the sum over lives.
double error_of_lives(const std::vector<Slid>& slid, double Slid::*member) {
  std::vector<double> values;
  for (const Slid& one : slid) values.push_back(one.*member);
  const LifeStatistics s = statistics(values, {});
  return s.mean > 0. ? s.standard_error / s.mean : 0.;
}

/// Places at random on the axis of all lives, each within its life.
void deal_points(const std::vector<Slid>& slid, double Slid::*member, const Stream& stream, int n,
                 std::vector<std::vector<Point>>& of_life) {
  const bool near = member == &Slid::near;
  std::vector<double> until{0.};
  for (const Slid& one : slid) until.push_back(until.back() + one.*member);
  for (int i = 0; i < n; ++i) {
    const double at = until.back() * stream.uniform({static_cast<std::uint32_t>(i), near, of_no_storm, for_draw});
    const auto after = std::upper_bound(until.begin() + 1, until.end() - 1, at);
    const auto life = static_cast<std::size_t>(after - until.begin()) - 1;
    of_life[life].push_back({std::min(at - until[life], std::nextafter(slid[life].*member, 0.)), near});
  }
}

/// The waves of a life at these places; all of them where `all`.
std::vector<Met> met_at(const LifeSimulation& simulation, std::size_t life, std::vector<Point> points, bool all) {
  std::vector<Met> found;
  Slid until;
  each_wave(simulation, life, [&](Met met) {
    until.block += met.number * met.wave.block;
    until.near += met.number * met.near;
    if (all) found.push_back(met);
    const auto passed = [&](const Point& p) { return p.at < (p.near ? until.near : until.block); };
    for (const Point& p : points)
      if (passed(p)) {
        met.drawn_as_near = p.near;
        found.push_back(met);
      }
    points.erase(std::remove_if(points.begin(), points.end(), passed), points.end());
  });
  return found;
}

/// Each wave once.
class Distinct {
 public:
  explicit Distinct(WaveSample& sample) : sample_(sample) {}
  void add(const Met& met, double weight) {
    const DrawnWave& w = met.wave.wave;
    const WaveFactors& f = w.factors;
    const std::array<double, 10> all{w.sea.significant_height,
                                     w.sea.period,
                                     w.sea.angle,
                                     w.sea.water_level,
                                     w.height,
                                     f.force,
                                     f.uplift,
                                     f.friction,
                                     f.weight};
    const auto [place, is_new] = index_.try_emplace(all, sample_.waves.size());
    if (is_new) sample_.waves.push_back(met.wave);
    sample_.draws.push_back({place->second, weight, met.drawn_as_near});
  }

 private:
  WaveSample& sample_;
  std::map<std::array<double, 10>, std::size_t> index_;
};

}  // namespace

WaveSample sample_waves(LifeSetup setup, int lives, int most) {
  setup.law = [law = std::move(setup.law)](const SeaState& sea) { return std::make_unique<LooseLaw>(law(sea)); };
  const LifeSimulation simulation(setup);
  const std::vector<Slid> slid = slid_of_lives(simulation, lives);
  Slid total;
  for (const Slid& one : slid) {
    total.block += one.block;
    total.near += one.near;
    total.waves += one.waves;
  }
  WaveSample sample;
  sample.block = total.block;
  sample.lives = error_of_lives(slid, total.block > 0. ? &Slid::block : &Slid::near);
  sample.is_whole = total.waves <= most;
  const int by_block = total.block > 0. ? most / 2 : 0, by_near = most - by_block;
  std::vector<std::vector<Point>> points(slid.size());
  if (!sample.is_whole) {
    const Stream stream(setup.seed);
    deal_points(slid, &Slid::block, stream, by_block, points);
    deal_points(slid, &Slid::near, stream, by_near, points);
  }
  std::vector<std::vector<Met>> met(slid.size());
  in_parallel(slid.size(), "drawing waves", [&](std::size_t i) {
    if (sample.is_whole ? slid[i].waves > 0. : !points[i].empty())
      met[i] = met_at(simulation, i, points[i], sample.is_whole);
  });
  Distinct distinct(sample);
  for (const std::vector<Met>& of_life : met)
    for (const Met& one : of_life) {
      // the mean number of draws of one wave, by either way to draw it (Veach and Guibas 1995)
      const double by_its_block = by_block > 0 ? by_block * one.wave.block / total.block : 0.;
      distinct.add(one, sample.is_whole ? one.number : 1. / (by_its_block + by_near * one.near / total.near));
    }
  return sample;
}

namespace {

/// Gives waves without an answer the largest ratio of all others, and at least that of the block.
void fill(const WaveSample& sample, std::vector<DearSlip>& slips, DearSum& out) {
  double ratio = 1.;
  for (std::size_t i = 0; i < slips.size(); ++i)
    if (slips[i].why_not.empty() && sample.waves[i].block > 0.)
      ratio = std::max(ratio, slips[i].sliding / sample.waves[i].block);
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (slips[i].why_not.empty()) continue;
    slips[i].sliding = ratio * sample.waves[i].block;
    ++out.unanswered;
  }
}

/// Of one way to draw: sums of what its draws say (y) and of the control variate (x), and of their squares about the
/// mean.
struct Spread {
  double n = 0., x = 0., y = 0., xx = 0., xy = 0., yy = 0.;
};

Spread spread_of(const WaveSample& sample, const std::vector<DearSlip>& slips, bool near) {
  Spread s;
  const auto each = [&](const auto& see) {
    for (const WaveDraw& draw : sample.draws)
      if (draw.near == near) see(draw.weight * sample.waves[draw.wave].block, draw.weight * slips[draw.wave].sliding);
  };
  each([&s](double x, double y) {
    s.n += 1.;
    s.x += x;
    s.y += y;
  });
  each([&s](double x, double y) {
    x -= s.x / s.n;
    y -= s.y / s.n;
    s.xx += x * x;
    s.xy += x * y;
    s.yy += y * y;
  });
  return s;
}

}  // namespace

DearSum estimate(const WaveSample& sample, std::vector<DearSlip> slips) {
  DearSum out;
  const auto lacks = std::count_if(sample.draws.begin(), sample.draws.end(),
                                   [&slips](const WaveDraw& draw) { return !slips[draw.wave].why_not.empty(); });
  if (10 * lacks > static_cast<std::ptrdiff_t>(sample.draws.size())) {
    const auto first = std::find_if(slips.begin(), slips.end(), [](const DearSlip& s) { return !s.why_not.empty(); });
    out.why_not = std::to_string(lacks) + " of " + std::to_string(sample.draws.size()) +
                  " waves that were drawn have no answer, one of them as " + first->why_not;
    return out;
  }
  fill(sample, slips, out);
  for (const WaveDraw& draw : sample.draws) out.measure_error += draw.weight * slips[draw.wave].error;
  const Spread block = spread_of(sample, slips, false), near = spread_of(sample, slips, true);
  out.sum = block.y + near.y;
  if (sample.is_whole) return out;
  // sums of draws have the variance n times that of one draw, which is the sum of squares over n - 1
  const auto of_draws = [](const Spread& s, double Spread::*member) {
    return s.n > 1. ? s.*member * s.n / (s.n - 1.) : 0.;
  };
  const auto both = [&](double Spread::*member) { return of_draws(block, member) + of_draws(near, member); };
  const double xx = both(&Spread::xx), slope = xx > 0. ? both(&Spread::xy) / xx : 0.;
  out.sum += slope * (sample.block - block.x - near.x);
  out.freedom = static_cast<int>(block.n + near.n) - 3;
  const double left = both(&Spread::yy) - slope * both(&Spread::xy);
  out.standard_error = std::sqrt(std::max(left, 0.) * (out.freedom + 1.) / std::max(out.freedom, 1));
  return out;
}

}  // namespace upbead
