// Claim: slip and transmitted force of a block on an elastic base are those of event-exact references
// (tests/reference/ref7_sliding.json, parts B and C); on a stiff base it moves as on rigid ground.

#include "sliding/elastic_block.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "upbead/sliding/pulse.h"

namespace upbead {
namespace elastic_block_test {

using Json = nlohmann::json;

Json reference() {
  return Json::parse(std::ifstream(REFERENCE_FILE));
}

void compare(const ElasticSliding& found, const Json& row, double residual) {
  // without slip the references contain round-off up to 4e-18 m
  EXPECT_NEAR(found.slip.residual, residual, 1e-8 * std::abs(residual) + 1e-17);
  const Json& events = row["events"];
  ASSERT_EQ(2 * found.slip.slips.size(), events.size());
  for (std::size_t i = 0; i < found.slip.slips.size(); ++i) {
    EXPECT_NEAR(found.slip.slips[i].start, events[2 * i][0].get<double>(), 1e-9);
    EXPECT_NEAR(found.slip.slips[i].stop, events[2 * i + 1][0].get<double>(), 1e-9);
  }
  const double peak = row["max_FT"];
  EXPECT_NEAR(found.peak_shear, peak, 2e-3 * peak) << "looked at 60 times a period";
}

TEST(ElasticBlock, OnABareSpringIsTheReference) {
  const Json tables = reference();  // a temporary would not outlive the loop's first step
  for (const Json& row : tables["slider"]) {
    SCOPED_TRACE(row["td"].dump() + " s, " + row["Pm"].dump() + " N/m");
    const ElasticSliding found = slide_on_base(row["m"], {0., row["k"], 0.}, history({row["Pm"], row["td"]}), row["R"]);
    compare(found, row, row["residual_slip"]);
    EXPECT_NEAR(found.peak_displacement, row["max_x"].get<double>(), 2e-3 * row["max_x"].get<double>());
  }
}

TEST(ElasticBlock, OnAMassWithSpringAndDashpotIsTheReference) {
  const Json tables = reference();
  for (const Json& row : tables["stickslip"]) {
    SCOPED_TRACE(row["td"].dump() + " s, " + row["Pm"].dump() + " N/m");
    const ElasticSliding found =
        slide_on_base(row["m"], {row["mb"], row["kb"], row["cb"]}, history({row["Pm"], row["td"]}), row["R"]);
    compare(found, row, row["residual_relative_slip"]);
  }
}

TEST(ElasticBlock, OnAStiffBaseIsTheBlockOnRigidGround) {
  const double mass = 6e5, R = 1.94e6;
  const TriangularPulse pulse{4e6, 0.3};
  const double rigid = sliding_distance_exact(mass, R, pulse);
  const auto error = [&](double stiffness) {
    return std::abs(slide_on_base(mass, {0., stiffness, 0.}, history(pulse), R).slip.residual - rigid);
  };
  EXPECT_LT(error(1e13), 5e-5 * rigid);
  EXPECT_LT(error(1e15), 0.2 * error(1e13)) << "it vanishes as the base gets stiffer";
}

TEST(ElasticBlock, MirrorsWithTheForce) {
  const ElasticBase base{2e5, 6e8, 4e6};
  const ElasticSliding a = slide_on_base(6e5, base, history({3.88e6, 0.3}), 1.94e6);
  const ElasticSliding b = slide_on_base(6e5, base, history({-3.88e6, 0.3}), 1.94e6);
  EXPECT_EQ(a.slip.residual, -b.slip.residual);
  EXPECT_GT(a.slip.residual, 0.01);
  ASSERT_EQ(a.slip.slips.size(), b.slip.slips.size());
  for (std::size_t i = 0; i < a.slip.slips.size(); ++i)
    EXPECT_EQ(a.slip.slips[i].peak_velocity, -b.slip.slips[i].peak_velocity);
  EXPECT_GT(a.slip.slips[0].peak_velocity, 0.1);
}

TEST(ElasticBlock, RefusesADashpotWithoutAMass) {
  EXPECT_THROW(slide_on_base(6e5, {0., 6e8, 1e6}, history({3e6, 0.1}), 1e6), std::invalid_argument);
  EXPECT_THROW(slide_on_base(6e5, {0., 0., 0.}, history({3e6, 0.1}), 1e6), std::invalid_argument);
}

}  // namespace elastic_block_test
}  // namespace upbead
