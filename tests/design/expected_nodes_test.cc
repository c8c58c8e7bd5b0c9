// Claim: where lives slide farther with slip and lift node by node than as a block, nodes govern and a warning says so.
#include <gtest/gtest.h>

#include <algorithm>

#include "../expected/caissons.h"
#include "design/expected_report.h"

namespace upbead::test {

namespace expected_nodes_test {

/// Lives of 0.10 m as a block and 0.08 m by formulas; a limit of 0.15 m.
struct Lives {
  Design design;
  ExpectedAnswer answer;

  explicit Lives(double mean, double standard_error = 0.01, bool of_lives = true) {
    design.tables.section = medium_caisson().section;
    design.tables.limits.sliding = 0.15;
    for (auto* lives : {&answer.monte_carlo, &answer.formula_lives}) {
      const double S = lives == &answer.monte_carlo ? 0.1 : 0.08;
      MonteCarlo& one = lives->emplace();
      one.law = lives == &answer.monte_carlo ? Law::dynamic : Law::exact;
      one.sliding = {S, S};
      one.statistics = statistics(one.sliding, {});
    }
    NodeSliding& nodes = answer.nodes.emplace();
    nodes.mean = mean;
    nodes.draw_error = nodes.standard_error = standard_error;
    nodes.interval = {mean - 2. * standard_error, mean + 2. * standard_error};
    nodes.block = 0.1;
    nodes.waves = 20;
    nodes.of_lives = of_lives;
  }
  bool warns(const std::string& name) const {
    const NumberedWarnings list = warnings_of(design, answer);
    return std::any_of(list.begin(), list.end(), [&](const NumberedWarning& w) { return w.name == name; });
  }
};

TEST(ExpectedNodes, TheLargerGoverns) {
  const Lives more(0.2), less(0.05), of_record(0.2, 0.01, false);
  EXPECT_EQ(headline_of_life(more.answer).value, 0.2);
  EXPECT_NE(headline_of_life(more.answer).why.find("0.1 m"), std::string::npos);
  EXPECT_FALSE(checks_of(more.design, more.answer).front().holds.value());
  EXPECT_TRUE(more.warns("nodes_slide_farther"));
  EXPECT_EQ(headline_of_life(less.answer).value, 0.1);
  EXPECT_TRUE(checks_of(less.design, less.answer).front().holds.value());
  EXPECT_FALSE(less.warns("nodes_slide_farther"));
  EXPECT_EQ(headline_of_life(of_record.answer).value, 0.1) << "nodes of the record are not those of a life";
}

TEST(ExpectedNodes, TellsWhatIsDoubtful) {
  EXPECT_TRUE(Lives(0.09, 0.04).warns("few_node_waves"));
  EXPECT_FALSE(Lives(0.09, 0.004).warns("few_node_waves"));
  EXPECT_FALSE(Lives(0.02, 0.01).warns("few_node_waves")) << "the block governs whatever they say";
  Lives lacks(0.09);
  EXPECT_FALSE(lacks.warns("no_contact"));
  lacks.answer.nodes->unanswered = 1;
  EXPECT_TRUE(lacks.warns("no_contact"));
  lacks.answer.nodes.reset();
  lacks.answer.why_no_nodes = "they diverge";
  EXPECT_TRUE(lacks.warns("no_contact"));
}

}  // namespace expected_nodes_test

}  // namespace upbead::test
