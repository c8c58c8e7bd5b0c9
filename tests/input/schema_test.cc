// Claim: one declaration reads, checks, echoes and documents a table.
#include "input/schema.h"

#include <gtest/gtest.h>

namespace upbead {

namespace schema_test {

enum class Colour { red, green };

struct Base {
  double width = 2.;
};

struct Part {
  int count = 1;
};

struct Thing : Base {
  Colour colour = Colour::green;
  std::optional<Colour> edge;
  std::optional<double> step;
  bool hollow = false;
  std::string name;
  std::vector<Pair> points;
  Part part;
  std::optional<Part> spare;
  std::map<std::string, Part> parts;
};

TableSchema<Part> part_schema() {
  TableSchema<Part> table;
  table.key("count", &Part::count).range(from_to(0., 5.)).doc("number of pieces");
  return table;
}

TableSchema<Thing> thing_schema() {
  const std::vector<std::pair<std::string, Colour>> words{{"red", Colour::red}, {"green", Colour::green}};
  TableSchema<Thing> table;
  table.choice("colour", &Thing::colour, words).doc("colour").formerly_word("scarlet", "red");
  table.choice("edge", &Thing::edge, words).doc("colour of the edge");
  table.key("width", &Thing::width).unit("m").range(above(0.)).doc("width; of all");
  table.key("step", &Thing::step).unit("s").or_word("auto").doc("step");
  table.key("hollow", &Thing::hollow)
      .doc("whether there is room inside")
      .when(
          "colour", [](const Thing& thing) { return thing.colour == Colour::red; }, "of red things");
  table.key("name", &Thing::name).doc("name").fallback("nameless").formerly("label");
  table.key("points", &Thing::points).doc("points");
  table.table("part", &Thing::part, part_schema()).doc("The part.");
  table.table("spare", &Thing::spare, part_schema());
  table.tables("parts", &Thing::parts, part_schema());
  return table;
}

Node number(std::int64_t value) {
  return {value, {"f", 2, 3}};
}
Node text(const std::string& value) {
  return {value, {"f", 1, 1}};
}

std::string refusal(const NodeTable& entries) {
  Thing thing;
  Diagnostics report;
  thing_schema().read({entries, {"f"}}, "", thing, report);
  try {
    report.throw_if_any("f");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Schema, ReadsWhatItEchoes) {
  Thing thing;
  thing.colour = Colour::red;
  thing.edge = Colour::red;
  thing.width = 3.5;
  thing.step = 0.25;
  thing.hollow = true;
  thing.name = "a \"b\"";
  thing.points = {{1., 2.}, {3., 4.}};
  thing.spare = Part{3};
  thing.parts["x y"].count = 4;
  EXPECT_EQ(thing_schema().echo(thing), R"(colour = "red"
edge = "red"
width = 3.5  # m
step = 0.25  # s
hollow = true
name = "a \"b\""
points = [[1.0, 2.0], [3.0, 4.0]]

[part]
count = 1

[spare]
count = 3

[parts."x y"]
count = 4
)");
}

TEST(Schema, EchoesDefaultsAndFallbacks) {
  EXPECT_EQ(thing_schema().echo(Thing{}),
            "colour = \"green\"\nwidth = 2.0  # m\nstep = \"auto\"\n# name: nameless\n"
            "\n[part]\ncount = 1\n");
}

TEST(Schema, ReadsIntoMembers) {
  Thing thing;
  thing.step = 1.;
  Diagnostics report;
  const Node parts{NodeTable{{"a", {NodeTable{{"count", number(2)}}, {}}}}, {}};
  thing_schema().read({NodeTable{{"colour", text("red")},
                                 {"width", number(4)},
                                 {"step", text("auto")},
                                 {"edge", text("green")},
                                 {"parts", parts}},
                       {}},
                      "", thing, report);
  EXPECT_TRUE(report.sound(""));
  EXPECT_EQ(thing.colour, Colour::red);
  EXPECT_EQ(thing.edge, Colour::green);
  EXPECT_EQ(thing.width, 4.);
  EXPECT_FALSE(thing.step);
  EXPECT_EQ(thing.parts.at("a").count, 2);
}

TEST(Schema, UnderstandsAnOlderNameWithANote) {
  Thing thing;
  Diagnostics report;
  thing_schema().read({NodeTable{{"label", text("old")}}, {}}, "", thing, report);
  EXPECT_TRUE(report.empty());
  EXPECT_EQ(thing.name, "old");
  ASSERT_EQ(report.notes().size(), 1U);
  EXPECT_EQ(to_string(report.notes().front()), "f:1:1: 'label' is called 'name' now");
  EXPECT_NE(thing_schema().echo(thing).find("name = \"old\""), std::string::npos);
  EXPECT_EQ(refusal({{"label", text("old")}, {"name", text("new")}}),
            "f:1:1: 'label' is the older name of 'name', and both are given; remove it");
  // the value of the command line takes precedence, whichever of the two names it has
  const Node by_override{std::string("set"), {"--set label=set"}};
  EXPECT_EQ(refusal({{"label", by_override}, {"name", text("file")}}), "");
  thing_schema().read({NodeTable{{"label", by_override}, {"name", text("file")}}, {}}, "", thing, report);
  EXPECT_EQ(thing.name, "set");
  thing_schema().read({NodeTable{{"name", by_override}, {"label", text("file")}}, {}}, "", thing, report);
  EXPECT_EQ(thing.name, "set");
  EXPECT_EQ(refusal({{"label", number(1)}}), "f:2:3: name: expected a string, found the number 1; give the name");
}

TEST(Schema, UnderstandsAnOlderWordWithANote) {
  Thing thing;
  Diagnostics report;
  thing_schema().read({NodeTable{{"colour", text("scarlet")}}, {}}, "", thing, report);
  EXPECT_TRUE(report.empty());
  EXPECT_EQ(thing.colour, Colour::red);
  ASSERT_EQ(report.notes().size(), 1U);
  EXPECT_EQ(to_string(report.notes().front()), "f:1:1: 'scarlet' is called 'red' now");
}

TEST(Schema, TellsMistakesInTheOrderOfTheFile) {
  EXPECT_EQ(refusal({{"width", number(-1)}, {"colour", text("rde")}, {"part", text("x")}}),
            "f:1:1: colour = \"rde\" is none of red, green; did you mean 'red'?\n"
            "f:1:1: part: expected a table, found a string; write [part] and its keys\n"
            "f:2:3: width = -1 is outside (0, inf); give the width (m)");
}

TEST(Schema, JudgesAConditionOnceItsKeyIsSound) {
  const Node truth{true, {"f", 3, 1}};
  EXPECT_EQ(refusal({{"hollow", truth}}),
            "f:3:1: 'hollow' does not belong at the top of the file (only of red things); remove it");
  EXPECT_EQ(refusal({{"colour", text("blue")}, {"hollow", truth}}),
            "f:1:1: colour = \"blue\" is none of red, green; choose one of them");
  EXPECT_EQ(refusal({{"colour", text("red")}, {"hollow", truth}}), "");
}

TEST(Schema, RefusesWhatNoQuantityCanBe) {
  const auto refusal_of_width = [](double value) { return refusal({{"width", {value, {"f", 2, 3}}}}); };
  EXPECT_EQ(refusal_of_width(1e60), "f:2:3: width = 1e60 is larger than any quantity in SI units; give the width (m)");
  EXPECT_EQ(refusal_of_width(1e-320),
            "f:2:3: width = 1e-320 is smaller than any quantity in SI units; give the width (m)");
  EXPECT_EQ(refusal_of_width(1e50), "");
  EXPECT_EQ(refusal_of_width(1e-50), "");
}

TEST(Schema, RefusesWholeNumbersThatDoNotFit) {
  TableSchema<Part> table;
  table.key("count", &Part::count).range(at_least(0.)).doc("number of pieces");
  Part part;
  Diagnostics report;
  table.read({NodeTable{{"count", number(4294967297)}}, {"f"}}, "", part, report);
  try {
    report.throw_if_any("f");
    FAIL() << "read as " << part.count;
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "f:2:3: count = 4294967297 is beyond the range of whole numbers here; give the number of pieces");
  }
}

TEST(Schema, KnowsWhichTablesAreSound) {
  Thing thing;
  Diagnostics report;
  const Node parts{NodeTable{{"a", {NodeTable{{"count", number(9)}}, {}}}, {"b", {NodeTable{}, {}}}}, {}};
  thing_schema().read({NodeTable{{"parts", parts}}, {}}, "", thing, report);
  EXPECT_FALSE(report.sound(""));
  EXPECT_FALSE(report.sound("parts"));
  EXPECT_FALSE(report.sound("parts.a"));
  EXPECT_TRUE(report.sound("parts.b"));
  EXPECT_TRUE(report.sound("part"));
}

TEST(Schema, PrintsItsReference) {
  const std::string expected = R"(## top of the file

| key | type | range | default | meaning |
|---|---|---|---|---|
| `colour` | one of red, green |   | `"green"` | colour |
| `edge` | one of red, green |   |   | colour of the edge |
| `width` | a number (m) | (0, inf) | `2.0` | width; of all |
| `step` | a number (s) or "auto" |   | `"auto"` | step |
| `hollow` | true or false |   | `false` | whether there is room inside (only of red things) |
| `name` | a string |   | nameless | name |
| `points` | a list of pairs |   |   | points |

## `[part]`

The part.

| key | type | range | default | meaning |
|---|---|---|---|---|
| `count` | a whole number |)";
  EXPECT_EQ(reference(thing_schema()).substr(0, expected.size()), expected);
}

}  // namespace schema_test
}  // namespace upbead
