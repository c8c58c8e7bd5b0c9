// Claim, source and limits as in dynamic_stiffness_test.cc: the other seven soils.

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>

#include "dynamic_stiffness.h"

namespace upbead::test {

/// For the names of tests: "layerH15bnu03".
void PrintTo(const ElasticSoil& soil, std::ostream* out) {
  for (const char c : name_of(soil))
    if (std::isalnum(static_cast<unsigned char>(c))) *out << c;
}

namespace dynamic_stiffness_long_test {

class DynamicStiffnessOf : public ::testing::TestWithParam<ElasticSoil> {};

TEST_P(DynamicStiffnessOf, Soil) {
  compare_dynamic_stiffness(GetParam(), false);
}

INSTANTIATE_TEST_SUITE_P(HalfPlanes, DynamicStiffnessOf, ::testing::Values(ElasticSoil{0.}, ElasticSoil{0.45}),
                         ::testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Layers, DynamicStiffnessOf,
                         ::testing::Values(ElasticSoil{0., 1.5}, ElasticSoil{0.45, 1.5}, ElasticSoil{0., 3.},
                                           ElasticSoil{0.3, 3.}, ElasticSoil{0.45, 3.}),
                         ::testing::PrintToStringParamName());

}  // namespace dynamic_stiffness_long_test
}  // namespace upbead::test
