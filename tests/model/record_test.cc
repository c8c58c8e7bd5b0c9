// Claims: a sound record causes no warning, be it smooth, rough or with a long rest; each fault causes its own
// warning and no other, with the number by which the record was falsified; the corners of an idealised history are
// not treated as a record; two exchanged transducers are named.
#include "model/record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace upbead {
namespace record_test {

constexpr double interval = 1e-3;  // s

Record sampled(const std::function<double(double)>& f, double end = 1., double every = interval) {
  Record record{"force", {}, {}};
  for (int i = 0; i * every <= end; ++i) {
    record.time.push_back(i * every);
    record.value.push_back(f(i * every));
  }
  return record;
}

/// Rises in 0.1 s from 0.2 s on, and falls in 0.3 s.
double pulse(double t) {
  if (t < 0.2 || t > 0.6) return 0.;
  return t < 0.3 ? 5e5 * (1. - std::cos(M_PI * (t - 0.2) / 0.1)) : 5e5 * (1. + std::cos(M_PI * (t - 0.3) / 0.3));
}

/// A repeatable noise in [-1, 1].
double noise(double t) {
  return std::sin(1e4 * t) * std::sin(3.7e3 * t + 1.);
}

std::vector<std::string> names(const NumberedWarnings& list) {
  std::vector<std::string> names;
  for (const NumberedWarning& warning : list) names.push_back(warning.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(Records, SoundOnesBringNoWarning) {
  EXPECT_EQ(names(record_warnings(sampled(pulse))), Names());
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return -pulse(t); }))), Names());
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return pulse(t) + 1e4 * noise(t); }))), Names());
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return pulse(t) + 0.5 * pulse(t - 0.3); }))), Names());
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return 1e6 * std::sin(20. * t); }))), Names());
}

/// 1 - cos over T.
double smooth(double t, double T) {
  return t < T ? 5e5 * (1. - std::cos(2. * M_PI * t / T)) : 0.;
}

TEST(Records, TheFootOfASmoothRiseIsNoDrift) {
  for (const double T : {0.5, 1., 2.})  // with 25 samples or more in the rise
    for (const double every : {1e-3, 1e-2}) {
      SCOPED_TRACE(T);
      EXPECT_EQ(names(record_warnings(sampled([T](double t) { return smooth(t, T); }, T, every))), Names());
      EXPECT_EQ(names(record_warnings(sampled([T](double t) { return smooth(t, T); }, 0.98 * T, every))), Names());
      EXPECT_EQ(names(record_warnings(sampled([T](double t) { return -smooth(t, T); }, 2. * T, every))), Names());
    }
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return 1e6 * std::min(t, 1. - t); }))), Names());
}

TEST(Records, ALoadThatIsCutDoesNotDrift) {
  const NumberedWarnings list = record_warnings(sampled([](double t) { return smooth(t, 0.5); }, 0.4705));
  ASSERT_EQ(names(list), Names{"record_cut"});
  EXPECT_NEAR(list[0].value, 0.5 * (1. - std::cos(2. * M_PI * 0.47 / 0.5)), 1e-3);
}

TEST(Records, ALoadThatStopsWhereTheRunGoesOnIsCut) {
  const auto rise = [](double t) { return 1e6 * std::sin(0.5 * M_PI * t); };
  for (const auto& [end, cut] : {std::pair(1., false), std::pair(2., true)}) {
    Record record = sampled(rise);
    record.end = end;
    const NumberedWarnings list = record_warnings(record);
    EXPECT_EQ(names(list), cut ? Names{"record_cut"} : Names()) << end;
    if (cut) {
      EXPECT_TRUE(list[0].voids);
    }
  }
  EXPECT_EQ(names(record_warnings(sampled(rise))), Names()) << "of no run";
  Record falls = sampled([](double t) { return smooth(t, 0.5); }, 0.4705);
  falls.end = 0.4;
  EXPECT_FALSE(record_warnings(falls).at(0).voids) << "what is cut comes after the run";
}

TEST(Records, ADropAtTheEndIsToldOnce) {
  const Record corners{"corners", {0., 0.1, 0.2}, {0., 1., -0.95}, 1.};
  ASSERT_EQ(names(drop_warnings(corners, {})), Names{"load_drops"});
  EXPECT_EQ(drop_warnings(corners, {})[0].value, 0.95);
  EXPECT_TRUE(drop_warnings(corners, {})[0].voids);
  EXPECT_EQ(names(drop_warnings({"until the end", {0., 0.1, 1.}, {0., 1., 1.}, 1.}, {})), Names());
  EXPECT_EQ(names(drop_warnings({"of no run", {0., 0.1, 0.2}, {0., 1., 1.}}, {})), Names());
  Record rise = sampled([](double t) { return 1e6 * std::sin(0.5 * M_PI * t); });
  rise.end = 2.;
  EXPECT_EQ(names(drop_warnings(rise, record_warnings(rise))), Names()) << "record_cut tells it";
}

TEST(Records, StepIsNoFault) {
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return 1e6 * std::min(1., std::max(0., (t - 0.2) / 0.1)); }))),
            Names());
}

TEST(Records, CornersAreNoRecord) {
  EXPECT_FALSE(is_measured({"corners", {0., 0.075, 0.15}, {0., 1e6, 0.}}));
  EXPECT_EQ(names(record_warnings({"corners", {0., 0.02, 0.15, 1.}, {1e6, 1e6, 1e6, 1e6}})), Names());
  EXPECT_TRUE(is_measured(sampled(pulse)));
}

TEST(Records, Dead) {
  const NumberedWarnings list = record_warnings(sampled([](double) { return 3e4; }));
  ASSERT_EQ(names(list), Names{"record_dead"});
  EXPECT_EQ(list[0].value, 0.);
}

TEST(Records, Saturated) {
  const Record record = sampled([](double t) { return std::min(pulse(t), 8e5); });
  const NumberedWarnings list = record_warnings(record);
  ASSERT_EQ(names(list), Names{"record_saturated"});
  EXPECT_TRUE(list[0].voids) << "the largest load is not in it";
  EXPECT_EQ(list[0].value, std::count(record.value.begin(), record.value.end(), 8e5));
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return -std::min(pulse(t), 8e5); }))),
            Names{"record_saturated"});
}

TEST(Records, Drifting) {
  const NumberedWarnings list =
      record_warnings(sampled([](double t) { return pulse(t) + 1e5 * std::max(0., t - 0.2); }));
  ASSERT_EQ(names(list), Names{"record_drifting"});
  EXPECT_NEAR(list[0].value, 0.0778, 0.002);  // 77.5 kN at the middle of the last twentieth, over the peak of 1.01 MN

  const NumberedWarnings before =
      record_warnings(sampled([](double t) { return pulse(t) + 4e5 * std::min(t, 0.2) * (t < 0.4); }));
  ASSERT_EQ(names(before), Names{"record_drifting"});
  EXPECT_NEAR(before[0].value, 0.04, 0.005);
}

TEST(Records, TooCoarse) {
  const NumberedWarnings list = record_warnings(sampled(pulse, 1., 0.01));
  ASSERT_EQ(names(list), Names{"record_too_coarse"});
  EXPECT_EQ(list[0].value, 8.);  // samples from the last one below a tenth of the peak, at 0.22 s, to the peak at 0.3 s
}

TEST(Records, Spikes) {
  Record record = sampled(pulse);
  record.value[700] = 4e5;
  record.value[800] = -4e5;
  const NumberedWarnings list = record_warnings(record);
  ASSERT_EQ(names(list), Names{"record_spikes"});
  EXPECT_EQ(list[0].value, 2.);
}

/// The record without the samples of (from, to).
Record without(const Record& record, double from, double to) {
  Record left{record.name, {}, {}};
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    if (record.time[i] > from && record.time[i] < to) continue;
    left.time.push_back(record.time[i]);
    left.value.push_back(record.value[i]);
  }
  return left;
}

TEST(Records, RowsThatAreMissingAreTold) {
  const NumberedWarnings list = record_warnings(without(sampled(pulse), 0.25, 0.37));
  ASSERT_EQ(names(list), Names{"record_gap"});
  EXPECT_NEAR(list[0].value, 0.12, 1e-9);
  EXPECT_TRUE(list[0].voids);
  EXPECT_EQ(names(record_warnings(without(sampled(pulse), 0.7, 0.9))), Names()) << "exact rest may be left out";
  const NumberedWarnings noisy =
      record_warnings(without(sampled([](double t) { return pulse(t) + 1e4 * noise(t); }), 0.7, 0.9));
  ASSERT_EQ(names(noisy), Names{"record_gap"});
  EXPECT_FALSE(noisy[0].voids);
  const Record few = sampled([](double t) { return std::sin(M_PI * t); }, 1., 0.04);
  EXPECT_EQ(names(record_warnings(few)), Names{"record_too_coarse"});
  EXPECT_EQ(names(record_warnings(without(few, 0.3, 0.61))), Names{"record_gap"}) << "26 samples";
  Record adaptive{"force", {0.}, {0.}};  // steps that shrink a hundred times in the event, as of CFD programs
  while (adaptive.time.back() < 1.) {
    const double t = adaptive.time.back();
    adaptive.time.push_back(t + (t > 0.2 && t < 0.6 ? 2e-4 : 2e-2));
    adaptive.value.push_back(pulse(adaptive.time.back()));
  }
  EXPECT_EQ(names(record_warnings(adaptive)), Names());
}

/// The record with `value` from `from` until `to`; none: the value there.
Record dropped(Record record, double from, double to, std::optional<double> value) {
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    if (record.time[i] < from || record.time[i] > to) continue;
    if (!value) value = record.value[i];
    record.value[i] = *value;
  }
  return record;
}

TEST(Records, RowsThatAreMissingBesideAnEndAreTold) {
  const Record whole = sampled([](double t) { return 1e6 * std::exp(-3. * t) * std::sin(8. * t); });
  for (const double left : {0.0025, 0.0035}) {
    const NumberedWarnings list = record_warnings(without(whole, left, left + 0.058));
    ASSERT_FALSE(list.empty()) << left;
    EXPECT_EQ(list.back().name, "record_gap");
    EXPECT_TRUE(list.back().voids);
  }
  Record last = sampled(pulse);
  last.time.push_back(2.);
  last.value.push_back(1e3);
  EXPECT_EQ(names(record_warnings(last)), Names()) << "a last row at rest";
}

TEST(Records, ALostSignalIsTold) {
  const NumberedWarnings list = record_warnings(dropped(sampled(pulse), 0.28, 0.4005, 0.));
  ASSERT_EQ(names(list), Names{"record_dropout"});
  EXPECT_EQ(list[0].value, 121.);
  EXPECT_TRUE(list[0].voids);
  const auto double_pulse = [](double t) { return 0.6 * pulse(t + 0.1) + pulse(t - 0.35); };
  EXPECT_EQ(names(record_warnings(dropped(sampled(double_pulse, 1.2), 0.7, 0.8, 1e5))), Names{"record_dropout"});
  EXPECT_EQ(names(record_warnings(dropped(sampled(double_pulse, 1.2), 0.6, 0.64, {}))), Names{"record_dropout"});
  EXPECT_EQ(names(record_warnings(dropped(sampled(pulse), 0.45, 2., 0.))), Names{"record_dropout"}) << "to its end";
}

TEST(Records, ADrawnBoxAndAJumpLoseNothing) {
  const auto box = [](double t) { return std::fmod(t, 0.3) > 0.15 ? 1e6 : 0.; };
  for (const NumberedWarning& told : record_warnings(sampled(box))) EXPECT_NE(told.name, "record_dropout");
  Record jump = sampled([](double t) { return t < 0.2 ? 0. : 1e6 * std::exp(-2. * (t - 0.2)); });
  jump.time.insert(jump.time.begin() + 700, jump.time[700]);
  jump.value.insert(jump.value.begin() + 700, jump.value[700]);
  std::fill(jump.value.begin() + 701, jump.value.end(), 0.);
  for (const NumberedWarning& told : record_warnings(jump)) EXPECT_NE(told.name, "record_dropout") << told.text();
}

TEST(Records, ThatBeginInTheMiddleAreTold) {
  const NumberedWarnings list = record_warnings(without(sampled(pulse), -1., 0.275));
  ASSERT_EQ(names(list), Names{"record_begun"});
  EXPECT_NEAR(list[0].value, pulse(0.275) / 1e6, 1e-3);
  EXPECT_TRUE(list[0].voids);
  const auto held = [](double t) { return t < 0.7 ? 8e5 : 8e5 * std::max(0., 1. - 5. * (t - 0.7)); };
  EXPECT_EQ(names(record_warnings(sampled(held)))[0], "record_begun") << "as an uplift that has risen before";
}

TEST(Records, ThatDoNotRestAtZeroAreTold) {
  for (const double offset : {1e5, -4e5, -7e5}) {
    const NumberedWarnings list = record_warnings(sampled([offset](double t) { return offset + pulse(t); }));
    ASSERT_EQ(names(list), Names{"record_offset"}) << offset;
    EXPECT_NEAR(list[0].value, std::abs(offset) / std::max(std::abs(offset), std::abs(offset + 1e6)), 0.02);
    EXPECT_TRUE(list[0].voids);
  }
  EXPECT_EQ(names(record_warnings(sampled([](double t) { return 3e4 + pulse(t); }))), Names());
}

TEST(Records, SwappedTransducersAreNamed) {
  std::vector<RecordAtHeight> wall;
  for (int i = 0; i < 6; ++i) {
    const double y = 2. * i, share = 1. - 0.008 * (y - 4.) * (y - 4.);
    wall.push_back({y, sampled([share, y](double t) { return share * pulse(t - 2e-3 * y); })});
    wall.back().record.name = "p" + std::to_string(i);
  }
  EXPECT_EQ(names(swapped_records(wall)), Names());
  std::swap(wall[1].record, wall[4].record);
  const NumberedWarnings list = swapped_records(wall);
  ASSERT_EQ(names(list), Names{"records_swapped"});
  EXPECT_NE(list[0].text().find("'p4' and 'p1'"), std::string::npos) << list[0].text();
  EXPECT_LT(list[0].value, list[0].limit);
}

/// A pulse of shape f over a second, with `lead` and `trail` seconds of rest, of n samples a second.
Record alone(const std::function<double(double)>& f, int n, double lead, double trail) {
  return sampled([&](double t) { return t < lead || t > lead + 1. ? 0. : f(t - lead); }, lead + 1. + trail, 1. / n);
}

TEST(Records, APulseFromZeroToZeroNeitherDriftsNorIsCutNorSaturated) {
  const std::vector<std::function<double(double)>> shapes{
      [](double x) { return std::sin(M_PI * x); }, [](double x) { return x < 0.3 ? x / 0.3 : (1. - x) / 0.7; },
      [](double x) { return std::sin(2. * M_PI * x); }, [](double x) { return -std::pow(std::sin(M_PI * x), 2); }};
  for (const auto& shape : shapes)
    for (const int n : {40, 98, 104, 242, 1000, 4650})
      for (const double lead : {0., 0.01, 0.05, 0.2, 1.})
        for (const double trail : {0., 0.01, 0.05, 0.2, 3.})
          for (const NumberedWarning& told : record_warnings(alone(shape, n, lead, trail)))
            EXPECT_EQ(told.name, "record_too_coarse") << n << " " << lead << " " << trail << ": " << told.text();
}

TEST(Records, ADriftOfSuchAPulseIsTold) {
  for (const int n : {98, 1000, 4650}) {
    Record record = alone([](double x) { return std::sin(M_PI * x); }, n, 0.2, 0.5);
    for (std::size_t i = 0; i < record.value.size(); ++i) record.value[i] += record.time[i] > 1. ? 0.1 : 0.;
    EXPECT_EQ(names(record_warnings(record)), Names{"record_drifting"}) << n;
    for (double& value : record.value) value = std::min(value, 0.8);
    const Names found = names(record_warnings(record));
    EXPECT_NE(std::find(found.begin(), found.end(), "record_saturated"), found.end()) << n;
  }
}

}  // namespace record_test
}  // namespace upbead
