// Claim: Sobol indices of a study are those of functions whose indices are known, with intervals that hold them; points
// with a run that failed are left out and told, and so are numbers that no key moves and studies with another sample.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "expected/sobol_sample.h"
#include "good_case.h"
#include "output/result_file.h"
#include "reliability/indices.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace indices_test {

using Function = std::function<double(const std::vector<double>&)>;

/// Ishigami and Homma (1990): sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1, each x uniform in (-pi, pi).
double ishigami(const std::vector<double>& u) {
  const auto x = [&u](std::size_t k) { return M_PI * (2. * u[k] - 1.); };
  return std::sin(x(0)) + 7. * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

/// Index k of a sum of independent uniform terms is c_k^2 / sum c^2.
double linear(const std::vector<double>& u) {
  return 1e6 + u[0] + 2. * u[1] + 0.3 * u[2];
}

class Indices : public InFolder {
 protected:
  /// What a study over three keys writes, where a run gives `function` of its probabilities; `failed`: runs.
  static void write_study(int n, const Function& function, const std::vector<std::size_t>& failed = {},
                          std::uint64_t seed = 1) {
    const SobolSample sample(n, 3, seed);
    const std::vector<std::string> matrices{"A", "B", "x", "y", "z"};
    TableColumn done{"runs/done", "", "", {}, {}}, point{"runs/point", "", "", {}, {}};
    TableColumn file{"runs/case", "", "", {}, {}}, matrix{"runs/matrix", "", "", {}, {}};
    TableColumn run{"read/f/run", "", "", {}, {}}, value{"read/f/value", "", "", {}, {}};
    for (int i = 0; i < sample.n_rows(); ++i) {
      const bool fails = std::find(failed.begin(), failed.end(), static_cast<std::size_t>(i)) != failed.end();
      done.numbers.push_back(fails ? 0. : 1.);
      point.numbers.push_back(sample.point(i));
      file.texts.push_back("case.toml");
      matrix.texts.push_back(matrices[static_cast<std::size_t>(sample.matrix(i))]);
      if (fails) continue;
      run.numbers.push_back(i);
      value.numbers.push_back(function({sample.probability(i, 0), sample.probability(i, 1), sample.probability(i, 2)}));
    }
    std::filesystem::create_directories("study");
    write("study/study.h5", table_file("planted", {done, point, file, matrix, run, value}));
    write("study/summary.json", R"({"read": ["f"]})");
  }

  static NumberIndices found(int n, const Function& function, const std::vector<std::size_t>& failed = {},
                             std::uint64_t seed = 1) {
    write_study(n, function, failed, seed);
    const StudyIndices all = find_indices(read_sobol_study("study", {}));
    EXPECT_EQ(all.title, "planted");
    EXPECT_EQ(all.numbers.size(), 1U);
    return all.numbers.front();
  }

  static const KeyIndices& of(const NumberIndices& all, const std::string& key) {
    for (const KeyIndices& one : all.keys)
      if (one.key == key) return one;
    throw std::logic_error("no key " + key);
  }

  static void expect(const NumberIndices& all, const std::string& key, double first, double total, double within) {
    const KeyIndices& one = of(all, key);
    for (const auto& [estimate, exact] : {std::pair(one.first, first), std::pair(one.total, total)}) {
      EXPECT_NEAR(estimate.value, exact, within) << key;
      EXPECT_LE(estimate.low, exact) << key;
      EXPECT_GE(estimate.high, exact) << key;
    }
  }
};

TEST_F(Indices, OfIshigamisFunctionAreTheExactOnes) {
  const double a = std::pow(1. + 0.1 * std::pow(M_PI, 4) / 5., 2) / 2., b = 49. / 8.,
               c = 0.01 * std::pow(M_PI, 8) / 2. * (1. / 9. - 1. / 25.), all = a + b + c;
  const NumberIndices indices = found(4096, ishigami);
  expect(indices, "x", a / all, (a + c) / all, 0.015);
  expect(indices, "y", b / all, b / all, 0.015);
  expect(indices, "z", 0., c / all, 0.015);
  EXPECT_EQ(indices.keys.front().key, "x");
  EXPECT_NEAR(*indices.mean, 3.5, 0.05);
  EXPECT_NEAR(*indices.deviation, std::sqrt(all), 0.03);
  EXPECT_EQ(indices.points, 4096);
}

TEST_F(Indices, OfALinearFunctionAreItsSquaresWhereverItsMeanLies) {
  const NumberIndices indices = found(256, linear);
  const double all = 1. + 4. + 0.09;
  for (const auto& [key, square] : {std::pair("x", 1.), std::pair("y", 4.), std::pair("z", 0.09)})
    expect(indices, key, square / all, square / all, 0.01);
}

TEST_F(Indices, HaveIntervalsThatShrinkByTheRootOfN) {
  const auto width = [](int n) {
    const Estimate total = of(found(n, ishigami), "x").total;
    return total.high - total.low;
  };
  EXPECT_NEAR(width(256) / width(1024), 2., 0.2);
}

TEST_F(Indices, LeaveOutPointsWithARunThatIsVoid) {
  write_study(256, linear);
  write("study/summary.json", R"({"read": ["f"], "void": [{"runs": [0, 7], "why": "answer_cut"}]})");
  EXPECT_EQ(find_indices(read_sobol_study("study", {})).numbers.front().points, 254);
}

TEST_F(Indices, LeaveOutPointsWithARunThatFailed) {
  const NumberIndices indices = found(256, linear, {0, 7, 8, 23});  // points 0, 1 twice, 4
  EXPECT_EQ(indices.points, 253);
  EXPECT_EQ(indices.left_out, 3);
  EXPECT_EQ(indices.failed, 4);
  expect(indices, "y", 4. / 5.09, 4. / 5.09, 0.02);
  const NumberedWarnings warnings = warnings_of({"", {indices}});
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.front().name, "indices_left_out");
  EXPECT_NE(warnings.front().what.find("3 of 256 points are left out, as 4 runs failed"), std::string::npos);
}

TEST_F(Indices, OfANumberThatNoKeyMovesAreNone) {
  const NumberIndices indices = found(16, [](const std::vector<double>&) { return 2.5; });
  EXPECT_TRUE(indices.keys.empty());
  EXPECT_NE(indices.why_not.find("the same in all runs"), std::string::npos);
  EXPECT_EQ(warnings_of({"", {indices}}).front().name, "no_indices");
  EXPECT_NE(describe(StudyIndices{"", {indices}}).find("no indices: the number is the same"), std::string::npos);
  const NumberIndices few = found(4, linear);
  EXPECT_NE(few.why_not.find("4 points"), std::string::npos);
}

TEST_F(Indices, TellWhereTheirOrderIsOpenAndHowManyPointsAreNeeded) {
  const auto equal = [](const std::vector<double>& u) { return u[0] + u[1] + u[2] * 1e-3; };
  const NumberIndices indices = found(16, equal);
  std::vector<std::string> names;
  for (const NumberedWarning& warning : warnings_of({"", {indices}})) names.push_back(warning.name);
  EXPECT_EQ(names, (std::vector<std::string>{"indices_order_open", "indices_uncertain"}));
  const NumberedWarning wide = warnings_of({"", {indices}}).back();
  const double n = 16. * std::pow(wide.value / 0.1, 2), power = std::exp2(std::ceil(std::log2(n)));
  EXPECT_NE(wide.cure.find("n = " + std::to_string(static_cast<int>(power)) + ","), std::string::npos) << wide.cure;
  EXPECT_TRUE(warnings_of({"", {found(static_cast<int>(power), linear)}}).empty());
}

TEST_F(Indices, AreWrittenWithTheirIntervals) {
  const StudyIndices indices{"t", {found(64, linear)}};
  const auto json = nlohmann::json::parse(to_json(indices));
  const Estimate& total = of(indices.numbers[0], "y").total;
  EXPECT_EQ(json["numbers"][0]["keys"]["y"]["total"]["value"], total.value);
  EXPECT_EQ(json["numbers"][0]["keys"]["y"]["total"]["high"], total.high);
  EXPECT_EQ(json["numbers"][0]["points"], 64);
  const std::string text = describe(indices);
  EXPECT_LT(text.find("  y "), text.find("  x "));
  EXPECT_NE(text.find("f: mean 1e+06, standard deviation"), std::string::npos) << text;
}

TEST_F(Indices, AreRefusedWhereTheStudyIsAnother) {
  const auto message = [](const std::vector<std::string>& of) -> std::string {
    try {
      read_sobol_study("study", of);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({}).find("study/study.h5"), std::string::npos);
  write_study(8, linear);
  EXPECT_EQ(message({}), "");
  EXPECT_NE(message({"g"}).find("the study has not read 'g'"), std::string::npos);
  const TableColumn done{"runs/done", "", "", {1., 1.}, {}}, file{"runs/case", "", "", {}, {"a", "a"}};
  write("study/study.h5", table_file("", {done, file}));
  EXPECT_NE(message({}).find("its sample is not \"sobol\"; write sample = \"sobol\""), std::string::npos);
  const TableColumn point{"runs/point", "", "", {0., 0.}, {}}, matrix{"runs/matrix", "", "", {}, {"A", "B"}};
  write("study/study.h5", table_file("", {done, file, point, matrix}));
  EXPECT_NE(message({}).find("not in the order of a Sobol sample"), std::string::npos);
}

}  // namespace indices_test
}  // namespace upbead::test
