#include "record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace upbead::test {

namespace {

/// Name of the running test as a file name.
std::string test_name() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  for (char& c : name)
    if (c == '/') c = '-';
  return name;
}

}  // namespace

Record::Record(const std::string& problem) {
  json_ = {{"problem", problem},
           {"test", test_name()},
           {"checks", nlohmann::json::array()},
           {"curves", nlohmann::json::array()}};
}

Record::~Record() {
  const char* folder = std::getenv("UPBEAD_VERIFICATION_RESULTS");
  if (!folder) return;
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  std::ofstream(std::filesystem::path(folder) / (test_name() + ".json")) << json_.dump(1) << '\n';
}

void Record::at_most(const std::string& what, double error, double limit) {
  EXPECT_LE(error, limit) << what;
  json_["checks"].push_back({{"what", what}, {"value", error}, {"limit", limit}, {"kind", "at_most"}});
}

void Record::at_least(const std::string& what, double value, double limit) {
  EXPECT_GE(value, limit) << what;
  json_["checks"].push_back({{"what", what}, {"value", value}, {"limit", limit}, {"kind", "at_least"}});
}

void Record::measured(const std::string& what, double value) {
  json_["checks"].push_back({{"what", what}, {"value", value}, {"limit", nullptr}, {"kind", "measured"}});
}

void Record::curve(const Curve& curve) {
  json_["curves"].push_back({{"panel", curve.panel},
                             {"x", curve.x},
                             {"y", curve.y},
                             {"label", curve.label},
                             {"abscissa", curve.abscissa},
                             {"exact", curve.exact},
                             {"computed", curve.computed}});
}

double order(const std::vector<double>& h, const std::vector<double>& error) {
  const double n = static_cast<double>(h.size());
  double x = 0., y = 0., xx = 0., xy = 0.;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double a = std::log(h[i]), b = std::log(error[i]);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace upbead::test
