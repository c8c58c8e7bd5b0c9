// Claim: a line that tells a soil is answered with what the reduced model of that soil answers, with the histories that
// are asked for; a line that cannot be answered gets the reason, and does not disturb the next one.
#include "respond/soil_server.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../output/sample_soils.h"
#include "dynamics/state_space.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead::test {

namespace soil_server_test {

using Json = nlohmann::json;

constexpr const char* G = "regions.sand.shear_modulus";
constexpr const char* k = "regions.sand.hydraulic_conductivity";

WaveFile impact() {
  WaveFile file{"impact", {0., 0.075, 0.15, 1.}, WaveSamples::Zero(2, 4), 2, {}};
  file.value(0, 1) = 1.6e6;
  return file;
}

SoilServer server(const std::vector<std::string>& histories = {}) {
  RespondOptions options;
  options.histories.names = histories;
  return {{two_soils(), "soils.h5"}, {impact()}, options};
}

Json asked(const std::string& line, const std::vector<std::string>& histories = {}) {
  const std::string answer = server(histories).answer(line);
  EXPECT_EQ(answer.find('\n'), answer.size() - 1) << "one line";
  return Json::parse(answer);
}

std::string why(const std::string& line) {
  const Json answer = asked(line);
  EXPECT_EQ(answer.size(), 2U);
  return answer.value("why", "");
}

TEST(SoilServer, AnswersAsTheReducedModelOfTheSoil) {
  const Json answer = asked(R"({"regions.sand.shear_modulus": 5e7})");
  const SoilAnswers model(two_soils(), "soils.h5");
  const Soil soil = model.whole({{G, 5e7}});
  const ReducedModelFile reduced = model.at(soil);
  const WaveResponse wave = respond_to_waves(reduced, {impact()}, {}).front().waves.front();
  EXPECT_EQ(answer["soil"], (Json{{G, 5e7}, {k, 0.2}})) << "with the case's value of what is not given";
  EXPECT_EQ(answer["error"], reduced.error);
  EXPECT_EQ(answer["warnings"], Json::array());
  Json expected = Json::parse(to_json(wave));
  expected["name"] = "impact";
  EXPECT_EQ(answer["waves"], Json::array({expected}));
}

TEST(SoilServer, WritesEachLineAsAJsonObjectOrAsPairs) {
  const Json exact = asked(R"({"regions.sand.shear_modulus": 5e7, "regions.sand.hydraulic_conductivity": 0.5})");
  EXPECT_EQ(asked(std::string(" ") + k + "=0.5\t" + G + "=5e7\r"), exact);
  EXPECT_EQ(asked(""), asked("{}"));
  EXPECT_EQ(asked("")["soil"][G], 3e7) << "the case's own soil";
}

TEST(SoilServer, TellsHistoriesAtTheTimesOfTheAnswer) {
  const Json wave = asked("{}", {"shear_force", "probes/A/pressure"})["waves"][0];
  const SoilAnswers model(two_soils(), "soils.h5");
  const ReducedModelFile reduced = model.at(model.whole({}));
  const WaveResponses found = respond_to_waves(reduced, {impact()}, {}).front();
  ASSERT_EQ(wave["time"], Json(found.time));
  const SampledLoads loads = sample({piecewise_linear({0., 0.075, 0.15}, {0., 1.6e6, 0.}), TimeFunction()}, found.time);
  const Eigen::MatrixXd exact = respond(reduced.modes, loads).reading;
  for (const char* name : {"shear_force", "probes/A/pressure"}) {
    const std::vector<double> values = wave["histories"][name];
    const Eigen::RowVectorXd row = exact.row(reduced.modes.index(name));
    ASSERT_EQ(values.size(), found.time.size()) << name;
    for (std::size_t n = 0; n < values.size(); ++n)
      EXPECT_NEAR(values[n], row[static_cast<Eigen::Index>(n)], 1e-9 * row.cwiseAbs().maxCoeff()) << name;
  }
}

/// A caisson at one end of 150 masses on springs and dashpots; the pressure stands for the acceleration of the last
/// one.
SoilModelFile long_chain() {
  constexpr int n = 150;
  SoilModelFile model = two_soils();
  ReducedSystem fixed = model.family.reduced.fixed;
  for (Eigen::MatrixXd* A : {&fixed.M, &fixed.C, &fixed.K}) A->setZero(n, n);
  for (Eigen::MatrixXd* rows : {&fixed.position, &fixed.velocity, &fixed.acceleration}) rows->setZero(3, n);
  fixed.M.diagonal().setConstant(1e3);
  fixed.load.setZero(n, 2);
  fixed.load.row(0).setOnes();
  fixed.acceleration(1, n - 1) = 1.;
  fixed.acceleration(0, 0) = -1e3;
  fixed.is_phi.assign(n, false);
  ReducedSystem spring = fixed;
  for (Eigen::MatrixXd* A : {&spring.M, &spring.load, &spring.position, &spring.acceleration, &spring.feedthrough})
    A->setZero();
  ReducedSystem dashpot = spring;
  for (int i = 0; i < n; ++i) {
    spring.K(i, i) = i > 0 ? 2. : 1.;
    if (i > 0) spring.K(i, i - 1) = spring.K(i - 1, i) = -1.;
    dashpot.C(i, i) = 1e9;
  }
  model.family.reduced.fixed = fixed;
  model.family.reduced.parts = {spring, dashpot};
  return model;
}

TEST(SoilServer, HistoriesThatAreAskedForMeetTheToleranceOfFT) {
  const SoilAnswers model(long_chain(), "soils.h5");
  const Soil soil = model.whole({});
  const SoilModelFile& file = model.file();
  const ReducedSystem member = file.family.reduced.at(model.factors(soil));
  const ModalModel exact = modal_model(state_space(member), member);
  const auto error = [&](const ModalModel& modes) {
    const auto end = [&](const ModalModel& one) {
      return respond(one, file.family.training).reading.row(one.index("probes/A/pressure")).eval();
    };
    return (end(modes) - end(exact)).cwiseAbs().maxCoeff() / end(exact).cwiseAbs().maxCoeff();
  };
  EXPECT_GT(error(model.at(soil).modes), 10. * file.family.tolerance) << "not asked for";
  EXPECT_LT(error(model.member(soil, {"probes/A/pressure"}).model.modes), file.family.tolerance);
}

TEST(SoilServer, EstimatesTheErrorsOfHistories) {
  RespondOptions options;
  options.histories.names = {"shear_force", "probes/A/pressure"};
  const SoilServer chain({long_chain(), "soils.h5"}, {impact()}, options);
  const Json wave = Json::parse(chain.answer(""))["waves"][0];
  const double of_shear = wave["history_errors"]["shear_force"], of_end = wave["history_errors"]["probes/A/pressure"];
  EXPECT_GE(wave["error_estimate"].get<double>(), 0.5 * of_shear) << "of the same nested members";
  EXPECT_GT(of_end, 0.5) << "half of the masses do not reach the end";
}

TEST(SoilServer, GivesTheReasonOfWhatCannotBeAnswered) {
  EXPECT_NE(why("{\"regions.sand.shear_modulus\": 1e9}").find("lies outside the box"), std::string::npos);
  EXPECT_NE(why("regions.sand.porosity=0.3").find("is no key that the model varies"), std::string::npos);
  EXPECT_NE(why("regions.sand.shear_modulus=a").find("no KEY=NUMBER"), std::string::npos);
  EXPECT_NE(why("{\"regions.sand.shear_modulus\": ").find("not JSON"), std::string::npos);
  EXPECT_NE(why("{\"regions.sand.shear_modulus\": NaN}").find("not JSON"), std::string::npos);
  EXPECT_NE(why("{\"regions.sand.shear_modulus\": \"5e7\"}").find("no number"), std::string::npos);
  EXPECT_NE(why("{\"regions.sand.shear_modulus\": 5e7, \"regions.sand.shear_modulus\": 6e7}").find("given twice"),
            std::string::npos);
  EXPECT_NE(why("regions.sand.shear_modulus=5e7 regions.\"sand\".shear_modulus=6e7").find("given twice"),
            std::string::npos);
  EXPECT_NE(why("\xff\xfe").find("no KEY=NUMBER"), std::string::npos) << "bytes that are no text";
  EXPECT_EQ(asked("regions.sand.shear_modulus=1e9")["soil"], (Json{{G, 1e9}}));
  EXPECT_TRUE(asked("[1]")["soil"].is_null());
}

TEST(SoilServer, NamesTheReadingsWhereOneIsUnknown) {
  try {
    server({"shear_force", "probes/B/pressure", "shear_force"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("it has shear_force, probes/A/pressure, force"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("asked for twice"), std::string::npos);
  }
}

TEST(SoilServer, SaysThatTheSlipAsAWholeIsNotThere) {
  SoilModelFile file = two_soils();
  EXPECT_EQ(why_no_slip(file), "");
  file.family.reduced.slip_loads = 1;
  EXPECT_NE(why_no_slip(file).find("sticks"), std::string::npos);
}

}  // namespace soil_server_test
}  // namespace upbead::test
