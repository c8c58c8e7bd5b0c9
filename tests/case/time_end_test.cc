// Claim: what still acts when a run ends is told, whatever brings it (pulse, history, transducers, uplift, motion,
// wave), louder where its largest value comes later; a case without time.end ends after its loads and their echo.
#include "case/time_end.h"

#include "case/case_run.h"
#include "case/case_schema.h"
#include "good_case.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {

class TimeEndTest : public InFolder {
 protected:
  TimeEndTest() {
    static const PetscSession petsc;  // MPI starts once in a process
    unsetenv("UPBEAD_MESHES");
    write("late.csv", "time (s),force (N/m)\n5,1e5\n5.1,2e5\n5.2,0\n");
    write("jump.csv", "time (s),force (N/m)\n0,0\n1,0\n1,1e6\n2,1e6\n2,0\n");
    write("rows.csv", "time (s),a (kPa),b (kPa)\n0,0,0\n1,1,2\n2,10,20\n3,0,0\n");
  }
  static Case with(const std::string& load, const std::string& end = "end = 0.6",
                   const std::vector<std::string>& overrides = {}) {
    write("case.toml",
          section_case({{"pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }", load}, {"end = 0.6", end}}));
    return read_case("case.toml", overrides);
  }
  static NumberedWarnings told(const std::string& load, double end) {
    return end_warnings(actions_of(with(load, "end = " + std::to_string(end))), end);
  }
  static std::string names(const NumberedWarnings& list) {
    std::string text;
    for (const NumberedWarning& warning : list) text += warning.name + " ";
    return text;
  }
};

TEST_F(TimeEndTest, ALoadThatBeginsWithAJumpIsZeroUntilThen) {
  for (const double end : {3.9, 4.5, 5.}) {
    const NumberedWarnings list = told("history = \"late.csv\"", end);
    EXPECT_EQ(names(list), "load_zero ") << end;
    EXPECT_EQ(list.front().value, 5.);
  }
  EXPECT_EQ(names(told("history = \"late.csv\"", 5.05)), "load_cut ");
  EXPECT_EQ(names(told("history = \"late.csv\"", 5.2)), "");
  EXPECT_EQ(names(told("history = \"jump.csv\"", 1.)), "load_zero ");
  EXPECT_EQ(names(told("history = \"jump.csv\"", 1.5)), "load_cut ");
}

TEST_F(TimeEndTest, RecordStartBringsAHistoryForward) {
  const Case input = with("history = \"late.csv\"\nrecord_start = 4.9", "end = 0.6");
  EXPECT_EQ(names(end_warnings(actions_of(input), 0.6)), "");
  const TimeFunction& f = input.scene.loads.at("impulse").history;
  EXPECT_NEAR(f(0.2), 2e5, 1.);
  EXPECT_EQ(f(0.05), 0.);
  const Case within = with("history = \"late.csv\"\nrecord_start = 5.05", "end = 0.6");
  EXPECT_NEAR(within.scene.loads.at("impulse").history(0.), 1.5e5, 1e-6) << "between two samples";
  EXPECT_EQ(within.tables->load_tables.at("impulse").record_start, 5.05);
  const std::string again = effective_case(input, ".");
  write("again.toml", again);
  EXPECT_EQ(effective_case(read_case("again.toml"), "."), again);
  EXPECT_THROW(with("history = \"late.csv\"\nrecord_start = 9.", "end = 0.6"), InputError);
}

TEST_F(TimeEndTest, WhatStillActsIsTold) {
  const std::string triangle = "pulse = { shape = \"triangle\", peak = 1e6, duration = 3 }";
  NumberedWarnings list = told(triangle, 1.);
  ASSERT_EQ(names(list), "load_cut ");
  EXPECT_EQ(list.front().value, 3.);
  EXPECT_EQ(list.front().limit, 1.);
  EXPECT_NE(list.front().text().find("ITS LARGEST VALUE, which comes at 1.5 s"), std::string::npos)
      << list.front().text();
  EXPECT_NE(list.front().text().find("67 % of that"), std::string::npos) << list.front().text();
  list = told(triangle, 2.);
  ASSERT_EQ(names(list), "load_cut ");
  EXPECT_EQ(list.front().text().find("LARGEST"), std::string::npos) << list.front().text();
  EXPECT_EQ(names(told(triangle, 2.98)), "") << "a few percent are left";
  EXPECT_EQ(names(told("pulse = { shape = \"step\", peak = 1e6, rise = 2 }", 1.)), "load_cut ");
  EXPECT_EQ(names(told("pulse = { shape = \"step\", peak = 1e6, rise = 2 }", 2.)), "") << "it has come to stay";
  EXPECT_EQ(names(told("pulse = { shape = \"harmonic\", peak = 1e6, frequency = 1 }", 2.3)), "") << "it never ends";
  EXPECT_EQ(names(told("pulse = { shape = \"half_sine\", peak = 1e6, duration = 3, start = 1 }", 2.)), "load_cut ");
  EXPECT_EQ(names(told("pulse = { shape = \"half_sine\", peak = 1e6, duration = 3, start = 1 }", 1.)), "load_zero ");
}

TEST_F(TimeEndTest, SoItIsOfTransducersUpliftsAndMotions) {
  const std::string row =
      "gauges = \"rows.csv\"\nheights = { a = 8, b = 12 }\nto_base = \"constant\"\n"
      "to_crest = \"none\"\nfactor = -1.5";
  const std::string text = section_case({{"kind = \"force\"", "kind = \"pressures\""},
                                         {"pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }", row}});
  write("row.toml", text);
  const NumberedWarnings list = end_warnings(actions_of(read_case("row.toml", {"time.end=1.5"})), 1.5);
  ASSERT_EQ(names(list), "load_cut ");
  EXPECT_NE(list.front().text().find("comes at 2 s"), std::string::npos) << list.front().text();
  EXPECT_EQ(names(end_warnings(actions_of(read_case("row.toml", {"time.end=3"})), 3.)), "");
  EXPECT_EQ(names(end_warnings(
                actions_of(with("pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }\n[sliding]\n"
                                "submerged_weight = 4e6\nuplift = { kind = \"prescribed\", history = \"late.csv\" }")),
                5.05)),
            "load_cut ");
  const std::string base =
      section_case({{"boundary = \"front\"", "boundary = \"base\""},
                    {"kind = \"force\"", "kind = \"acceleration\""},
                    {"pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }", "history = \"quake.csv\""}});
  write("quake.csv", "t (s),a (m/s2)\n0,0\n1,1\n2,0\n3,-1\n4,0\n");
  write("base.toml", base);
  EXPECT_EQ(names(end_warnings(actions_of(read_case("base.toml")), 1.5)), "load_cut ");
  EXPECT_EQ(names(end_warnings(actions_of(read_case("base.toml")), 4.)), "");
}

TEST_F(TimeEndTest, WithoutOneTheLoadsAndTheirEchoAreCovered) {
  for (const auto& [load, over] : std::vector<std::pair<std::string, double>>{
           {"pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }", 0.15},
           {"pulse = { shape = \"triangle\", peak = 1e6, duration = 3 }", 3.},
           {"pulse = { shape = \"step\", peak = 1e6, rise = 2 }", 2.},
           {"history = \"late.csv\"", 5.2}}) {
    const Case input = with(load, "");
    EXPECT_TRUE(end_is_open(input));
    EXPECT_NEAR(end_of_actions(input), over, 0.01 * over);
    const double end = simulation_of(input).given().time.end;
    EXPECT_GT(end, over + 0.5);
    EXPECT_LT(end, over + 6.);
    EXPECT_EQ(names(end_warnings(actions_of(input), end)), "");
    Case settled = input;
    settle_end(settled);
    EXPECT_EQ(settled.scene.time.end, end) << "the same for the run and for the case that it writes";
  }
  EXPECT_FALSE(end_is_open(with("pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }")));
  const Case slow = with("pulse = { shape = \"step\", peak = 1e6 }", "inertia = false");
  EXPECT_GT(simulation_of(slow).given().time.end, 10.) << "consolidation takes H^2/c_v";
  EXPECT_EQ(simulation_of(with("pulse = { shape = \"step\", peak = 1e6 }", "", {"output.times=[0.1, 40.0]"}))
                .given()
                .time.end,
            40.);
}

TEST_F(TimeEndTest, TwoSamplesAtOneTimeAreAJump) {
  const TimeFunction f = with("history = \"jump.csv\"", "end = 3").scene.loads.at("impulse").history;
  EXPECT_EQ(f(0.9), 0.);
  EXPECT_EQ(f(1., 0.9), 0.);
  EXPECT_EQ(f(1.), 1e6);
  EXPECT_EQ(f(2.), 0.);
  EXPECT_EQ(shortest_duration(with("history = \"jump.csv\"", "end = 3").scene), 0.);
}

}  // namespace upbead::test
