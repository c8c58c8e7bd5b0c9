#include "expected/wave_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

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

  static WaveFactors loose(WaveFactors factors, double share = WaveSample::loose_friction) {
    factors.friction *= share;
    return factors;
  }

 private:
  std::unique_ptr<const SlidingLaw> law_;
};

/// By what a wave is drawn: S, S under the loose friction and under that between, and 1.
using Measures = std::array<double, WaveSample::ways>;

/// Sums over a life, and its waves without those that are equal.
struct Slid {
  Measures sum{};
  double waves = 0.;
};

/// A place on the axis of a life's sum of one measure.
struct Point {
  double at;
  std::size_t way;
};

struct Met {
  SampledWave wave;
  Measures by;
  double number;  ///< of equal waves
  std::size_t way;
};

void add(const Met& met, Measures& sum) {
  for (std::size_t w = 0; w < sum.size(); ++w) sum[w] += met.number * met.by[w];
}

/// Calls see() with each wave of a life that slides under the loose friction.
template <class See>
void each_wave(const LifeSimulation& lives, std::size_t life, const See& see) {
  lives.life(static_cast<std::uint32_t>(life), [&see](const SlidingLaw& law, const DrawnWave& wave, double number) {
    const double loose = law.distance(wave.height, LooseLaw::loose(wave.factors));
    if (!(loose > 0.)) return;
    const double block = law.distance(wave.height, wave.factors),
                 less = law.distance(wave.height, LooseLaw::loose(wave.factors, WaveSample::between));
    see(Met{{wave, block}, {block, loose, less, 1.}, number, 0});
  });
}

std::vector<Slid> slid_of_lives(const LifeSimulation& simulation, int lives) {
  std::vector<Slid> slid(static_cast<std::size_t>(lives));
  in_parallel(slid.size(), "looking for waves", [&](std::size_t i) {
    each_wave(simulation, i, [&one = slid[i]](const Met& met) {
      add(met, one.sum);
      one.waves += 1.;
    });
  });
  return slid;
}

/// Relative standard error of the sum over lives.
double error_of_lives(const std::vector<Slid>& slid, std::size_t way) {
  std::vector<double> values;
  for (const Slid& one : slid) values.push_back(one.sum[way]);
  const LifeStatistics s = statistics(values, {});
  return s.mean > 0. ? s.standard_error / s.mean : 0.;
}

/// Places at random on the axis of all lives, each within its life.
void deal_points(const std::vector<Slid>& slid, std::size_t way, const Stream& stream, int n,
                 std::vector<std::vector<Point>>& of_life) {
  std::vector<double> until{0.};
  for (const Slid& one : slid) until.push_back(until.back() + one.sum[way]);
  for (int i = 0; i < n; ++i) {
    const StreamPlace place{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(way), of_no_storm, for_draw};
    const double at = until.back() * stream.uniform(place);
    const auto after = std::upper_bound(until.begin() + 1, until.end() - 1, at);
    const auto life = static_cast<std::size_t>(after - until.begin()) - 1;
    of_life[life].push_back({std::min(at - until[life], std::nextafter(slid[life].sum[way], 0.)), way});
  }
}

/// The waves of a life at these places; all of them where `all`.
std::vector<Met> met_at(const LifeSimulation& simulation, std::size_t life, std::vector<Point> points, bool all) {
  std::vector<Met> found;
  Measures until{};
  each_wave(simulation, life, [&](Met met) {
    add(met, until);
    if (all) found.push_back(met);
    const auto passed = [&](const Point& p) { return p.at < until[p.way]; };
    for (const Point& p : points)
      if (passed(p)) {
        met.way = p.way;
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
    sample_.draws.push_back({place->second, weight, met.way});
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
    for (std::size_t w = 0; w < total.sum.size(); ++w) total.sum[w] += one.sum[w];
    total.waves += one.waves;
  }
  WaveSample sample;
  sample.block = total.sum[0];
  sample.lives = error_of_lives(slid, sample.block > 0. ? 0 : 1);
  sample.is_whole = total.waves <= most;
  std::array<int, WaveSample::ways> n{};
  for (std::size_t w = 0; w + 1 < n.size(); ++w)
    if (total.sum[w] > 0.) n[w] = (w == 0 ? 2 : 1) * most / 5;
  n.back() = most - std::accumulate(n.begin(), n.end() - 1, 0);
  std::vector<std::vector<Point>> points(slid.size());
  const Stream stream(setup.seed);
  for (std::size_t w = 0; w < n.size() && !sample.is_whole; ++w) deal_points(slid, w, stream, n[w], points);
  std::vector<std::vector<Met>> met(slid.size());
  in_parallel(slid.size(), "drawing waves", [&](std::size_t i) {
    if (sample.is_whole ? slid[i].waves > 0. : !points[i].empty())
      met[i] = met_at(simulation, i, points[i], sample.is_whole);
  });
  Distinct distinct(sample);
  for (const std::vector<Met>& of_life : met)
    for (const Met& one : of_life) {
      double drawn = 0.;  // mean number of draws of one wave, by any way (Veach and Guibas 1995)
      for (std::size_t w = 0; w < n.size(); ++w)
        if (n[w] > 0) drawn += n[w] * one.by[w] / total.sum[w];
      distinct.add(one, sample.is_whole ? one.number : 1. / drawn);
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

Spread spread_of(const WaveSample& sample, const std::vector<DearSlip>& slips, std::size_t way) {
  Spread s;
  const auto each = [&](const auto& see) {
    for (const WaveDraw& draw : sample.draws)
      if (draw.way == way) see(draw.weight * sample.waves[draw.wave].block, draw.weight * slips[draw.wave].sliding);
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
  Spread all;
  int ways = 0;
  for (std::size_t w = 0; w < WaveSample::ways; ++w) {
    const Spread s = spread_of(sample, slips, w);
    // sums of n draws have n times the variance of one, which is the sum of squares over n - 1
    const double of_draws = s.n > 1. ? s.n / (s.n - 1.) : 0.;
    ways += s.n > 0. ? 1 : 0;
    all.n += s.n;
    all.x += s.x;
    all.y += s.y;
    all.xx += of_draws * s.xx;
    all.xy += of_draws * s.xy;
    all.yy += of_draws * s.yy;
  }
  out.sum = all.y;
  if (sample.is_whole) return out;
  const double slope = all.xx > 0. ? all.xy / all.xx : 0.;
  out.sum += slope * (sample.block - all.x);
  out.freedom = static_cast<int>(all.n) - ways - 1;
  const double left = std::max(all.yy - slope * all.xy, 0.);
  out.standard_error = std::sqrt(left * (out.freedom + 1.) / out.freedom);
  return out;
}

}  // namespace upbead
