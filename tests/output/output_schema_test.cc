// Claim: exactly the keys that a schema declares are written and described; JSON never holds a number that is not
// finite, and the message names its key.

#include "output/output_schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "case/case_findings.h"
#include "upbead/base/error.h"

namespace upbead {
namespace output_schema_test {

struct Point {
  std::string name;
  double x = 0.;
};

struct Track {
  int n = 2;
  std::optional<double> length;
  std::string why;
  Point start{"A", 1.5};
  std::optional<Point> end;
  std::vector<Point> points{{"B", 2.}};
};

OutputSchema<Track> track_outputs() {
  const auto point = OutputSchema<Point>().key("x", &Point::x, "m", "abscissa: landward");
  return OutputSchema<Track>()
      .key("n", &Track::n, "", "how many")
      .key("length", &Track::length, "m", "of it; null where |it| is open")
      .reason("why", &Track::why, "why it is open")
      .keys_of(&Track::start, OutputSchema<Point>().key("from", &Point::name, "", "its start"))
      .object("end", &Track::end, point, "where it ends")
      .list("points[]", &Track::points, point, "each")
      .named("by_name.NAME", &Track::points, &Point::name, point, "each")
      .key("first", inner(&Track::start, &Point::x), "m", "of the start")
      .key("second", &Track::length, "m", "absent where it is not told")
      .or_left_out();
}

TEST(OutputSchema, WritesInOrderAndNullWhereThereIsNothing) {
  EXPECT_EQ(track_outputs().to_json({}).dump(),
            R"({"n":2,"length":null,"why":null,"from":"A","end":null,"points":[{"x":2.0}],"by_name":{"B":{"x":2.0}},)"
            R"("first":1.5})");
  Track whole;
  whole.length = 3.;
  whole.why = "no reason";
  whole.end = Point{"C", 4.};
  EXPECT_EQ(track_outputs().to_json(whole).dump(),
            R"({"n":2,"length":3.0,"why":"no reason","from":"A","end":{"x":4.0},"points":[{"x":2.0}],)"
            R"("by_name":{"B":{"x":2.0}},"first":1.5,"second":3.0})");
}

TEST(OutputSchema, DescribesEveryKey) {
  std::string paths;
  for (const OutputRow& row : track_outputs().rows())
    paths += row.path + (row.unit.empty() ? "" : " (" + row.unit + ")") + (row.is_number ? " = number\n" : "\n");
  EXPECT_EQ(paths,
            "n = number\nlength (m) = number\nwhy\nfrom\nend\nend.x (m) = number\npoints[]\npoints[].x (m) = number\n"
            "by_name.NAME\nby_name.NAME.x (m) = number\nfirst (m) = number\nsecond (m) = number\n");
}

TEST(OutputSchema, GivesWhatHasManyKeysATableOfItsOwn) {
  OutputSchema<Point> many;
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) many.key(name, &Point::x, "m", "|x|");
  const auto rows = OutputSchema<Track>()
                        .key("n", &Track::n, "", "how many")
                        .object("start", &Track::start, many, "where it starts")
                        .object("end", &Track::end, OutputSchema<Point>().key("x", &Point::x, "m", "there"), "its end")
                        .rows();
  const std::string table = "| key | unit | |\n|---|---|---|\n";
  std::string six;
  for (const std::string name : {"a", "b", "c", "d", "e", "f"}) six += "| `" + name + "` | m | \\|x\\| |\n";
  EXPECT_EQ(markdown(rows), table + "| `n` | | how many |\n| `end` | | its end |\n| `end.x` | m | there |\n" +
                                "\n### `start`\n\nWhere it starts.\n\n" + table + six);
}

/// A summary with every part.
Summary full_summary() {
  Summary s;
  s.response.emplace();
  s.loads.push_back({"wave"});
  s.gauges.emplace_back().name = "wall";
  s.waves.emplace_back().name = "storm";
  s.flows.emplace_back().name = "bore";
  s.measured.push_back({"record", "force", "N/m", {}});
  s.energy.emplace();
  s.reduction.emplace().inexact = {{"probes/A/pressure", 0.1}};
  s.error.emplace();
  s.history_error.emplace();
  SlidingSummary& sliding = s.sliding.emplace();
  sliding.history.by_history.slips = {{}};
  sliding.history.own.emplace();
  sliding.history.table = {{}};
  sliding.coupled.emplace().slip.slips = {{}};
  sliding.pulse.emplace();
  sliding.courses.emplace();
  s.base.emplace();
  s.harbour.emplace();
  s.verdict.emplace();
  s.waves.back().standing.answer.emplace(StandingAnswer{0., 0., {}, {}, {}, StandingWave({8., 1., 10.}, {})});
  s.waves.back().standing.bound.emplace();
  s.waves.back().impact.emplace();
  s.periods = {{}};
  s.checks = {{}};
  s.checks.back().balance.emplace();
  s.checks.back().probability = 0.1;
  s.checks.back().at_least = true;
  s.circles.emplace().block.emplace();
  CyclesSummary& cycles = s.cycles.emplace();
  cycles.regions = {{}};
  cycles.by_compaction.emplace();
  cycles.by_drainage.emplace();
  s.circles->at_rest = s.circles->still = s.circles->computed = s.circles->governs = SlipCircleFound();
  s.circles->static_design = SlipCircleFound();
  s.peak_safety.emplace();
  s.liquefaction.emplace().places = {{}};
  sliding.equal_impulse.emplace();
  s.contact.emplace().solved.emplace().ground.emplace();
  s.soil.emplace();
  s.nonlinear.emplace().bounds = {{}};
  s.nonlinear->bounds.front().residual.pore_pressure.emplace();
  s.nonlinear->rest.emplace();
  s.nonlinear->regions = {{}};
  s.densification = {{}};
  s.safety.emplace();
  s.construction.emplace().caisson.emplace();
  s.construction->stages = {{}};
  s.construction->stages.front().caisson.emplace();
  s.construction->stages.front().settlement = s.construction->stages.front().mobilised = 0.;
  s.residual.emplace().pore_pressure.emplace();
  s.strength = {{}};
  s.warnings = {{}};
  s.ladder = {{}};
  s.skipped = {{}};
  return s;
}

/// Paths of all values in `json`, as in descriptions; `known` holds the paths whose names are free.
void collect(const Json& json, const std::string& path, const std::set<std::string>& known,
             std::set<std::string>& found) {
  if (known.count(path + "[]") > 0 && json.is_array())
    return collect(json.empty() ? Json() : json[0], path + "[]", known, found);
  if (!path.empty() && known.count(path + ".NAME") == 0) found.insert(path);
  if (json.is_object())
    for (const auto& [key, value] : json.items()) {
      const bool free = known.count(path + ".NAME") > 0;
      collect(value, path.empty() ? key : path + "." + (free ? "NAME" : key), known, found);
    }
}

TEST(OutputSchema, DescribesAllThatASummaryHoldsAndNothingElse) {
  std::set<std::string> known, found;
  for (const OutputRow& row : summary_outputs().rows()) {
    EXPECT_TRUE(known.insert(row.path).second) << row.path << " is declared twice";
    EXPECT_FALSE(row.meaning.empty()) << row.path;
  }
  collect(summary_outputs().to_json(full_summary()), "", known, found);
  std::vector<std::string> differ;
  std::set_symmetric_difference(found.begin(), found.end(), known.begin(), known.end(), std::back_inserter(differ));
  EXPECT_TRUE(differ.empty()) << ::testing::PrintToString(differ);
}

TEST(OutputSchema, SummaryWithNothingIsNullThere) {
  const Json json = summary_outputs().to_json({});
  for (const char* key : {"response", "energy", "reduction", "sliding", "contact", "soil"})
    EXPECT_TRUE(json.at(key).is_null()) << key;
  for (const char* key : {"strength", "warnings", "ladder", "skipped"}) EXPECT_EQ(json.at(key), Json::array()) << key;
  for (const char* key : {"loads", "gauges", "wave_loads", "measured"}) EXPECT_EQ(json.at(key), Json::object()) << key;
}

TEST(JsonText, KeepsTheOrderAndEndsWithANewline) {
  EXPECT_EQ(json_text({{"b", 1.5}, {"a", {{"c", nullptr}}}}),
            "{\n  \"b\": 1.5,\n  \"a\": {\n    \"c\": null\n  }\n}\n");
}

TEST(JsonText, RefusesWhatIsNotFinite) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) try {
      json_text({{"waves", {{"list", {1., bad}}}}});
      ADD_FAILURE() << bad << " was written";
    } catch (const NumericsError& error) {
      EXPECT_STREQ(error.what(), "'/waves/list/1' of the summary is not finite; nothing was written");
    }
}

}  // namespace output_schema_test
}  // namespace upbead
