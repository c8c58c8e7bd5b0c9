// Claims: what the terminal prints follows from the declarations of keys: units, why a number is null, tables of a few
// items and the ranges of many.
#include "output/output_text.h"

#include <gtest/gtest.h>

#include <optional>

namespace upbead {

namespace output_text_test {

struct Wave {
  std::string name;
  double height = 0.;
  std::optional<double> sliding;
};

struct Answer {
  std::vector<Wave> waves;
  std::optional<double> pressure;
};

OutputSchema<Answer> answer_outputs() {
  const auto wave = OutputSchema<Wave>()
                        .key("height", &Wave::height, "m", "H")
                        .key("sliding", &Wave::sliding, "m", "S; null where it sticks");
  return OutputSchema<Answer>()
      .key("pressure", &Answer::pressure, "Pa", "of the heel; null where the resultant leaves the base")
      .named("waves.NAME", &Answer::waves, &Wave::name, wave, "each wave");
}

std::string table(const std::vector<Wave>& waves, std::size_t most) {
  const std::vector<TextColumn> columns{{"H", "height"}, {"S", "sliding"}};
  const Json json = answer_outputs().to_json({waves, {}});
  return table_of(json["waves"], answer_outputs().rows(), "waves.NAME", columns, "wave", most);
}

TEST(OutputText, OfChosenKeysSaysWhyANumberIsNull) {
  const auto text = [](const Answer& answer, const std::vector<std::string>& keys) {
    return text_of(answer_outputs().to_json(answer), answer_outputs().rows(), keys);
  };
  EXPECT_EQ(text({{}, {}}, {"pressure"}), "pressure                      none where the resultant leaves the base\n");
  EXPECT_EQ(text({{}, 4e5}, {"pressure", "waves"}), "pressure                      400 kPa         of the heel\n");
  EXPECT_EQ(text({{{"a", 5., {}}}, {}}, {"waves.a.height", "no_such_key"}),
            "waves\n  a\n    height                    5 m             H\n");
}

TEST(OutputText, PutsNoPrefixBeforeAreasRatesAndYears) {
  struct Life {
    double area = 2000., rate = 2.5e6, often = 1., years = 2000., pressure = 2e6;
  };
  const auto schema = OutputSchema<Life>()
                          .key("area", &Life::area, "m2", "A")
                          .key("rate", &Life::rate, "1/s", "waves")
                          .key("often", &Life::often, "1/year", "occasions")
                          .key("years", &Life::years, "years", "life")
                          .key("pressure", &Life::pressure, "Pa", "p");
  EXPECT_EQ(text_of(schema.to_json(Life()), schema.rows()),
            "area                          2000 m2         A\n"
            "rate                          2.5e+06 per s   waves\n"
            "often                         1 per year      occasions\n"
            "years                         2000 years      life\n"
            "pressure                      2 MPa           p\n");
}

TEST(OutputText, TakesWhateverAUserHasCalledAnItem) {
  const std::string text =
      text_of(answer_outputs().to_json({{{"a~/b", 5., {}}}, {}}), answer_outputs().rows(), {"waves.a~/b.height"});
  EXPECT_EQ(text, "waves\n  a~/b\n    height                    5 m             H\n");
}

TEST(OutputText, HasUnitsOfKeysBelowNamesThatAUserGave) {
  const std::string text = text_of(answer_outputs().to_json({{{"a", 5., 0.02}}, {}}), answer_outputs().rows());
  EXPECT_EQ(
      text,
      "waves\n  a\n    height                    5 m             H\n    sliding                   20 mm           S\n");
}

TEST(OutputText, TableLeavesOutColumnsWithoutAnyValue) {
  EXPECT_EQ(table({{"a", 5., {}}, {"longer", 10., {}}}, 9), "wave       H\na        5 m\nlonger  10 m\n");
  EXPECT_EQ(table({{"a", 5., {}}, {"b", 10., 0.5}}, 9), "wave     H      S\na      5 m      -\nb     10 m  0.5 m\n");
}

TEST(OutputText, OfManyItemsHasTheRangeOfEachNumber) {
  const std::vector<Wave> waves{{"a", 5., 0.}, {"b", 10., 0.5}, {"c", 7., {}}};
  EXPECT_EQ(table(waves, 2),
            "of 3  least  in  largest  in  not 0 in\nH       5 m   a     10 m   b         3\nS       0 m   a    0.5 m  "
            " b         1\n");
}

TEST(OutputText, WideTablesGoOnBelow) {
  const std::string cell(45, 'x');
  const std::string text = aligned({{"name", cell, cell, cell}, {"a", "1", "2", "3"}});
  EXPECT_EQ(text.find("\n\nname"), 2 * (4 + 2 * 47) + 1);
}

}  // namespace output_text_test

}  // namespace upbead
