#include "mesh/geo_script.h"

#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace geo_parameters_test {

/// "name|default|description"
std::vector<std::string> lines_of(const std::string& file) {
  std::vector<std::string> lines;
  for (const GeoParameter& p : geo_parameters(file))
    lines.push_back(p.name + "|" + p.default_value + "|" + p.description);
  return lines;
}

TEST(GeoParameters, WaysToWriteThem) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.geo",
                                        "// DefineConstant[ no = 1 ];\n"
                                        "Printf(\"DefineConstant[ no = 1 ];\"); /* DefineConstant[ no = 1 ]; */\n"
                                        "DefineConstant[ a = 1 ];  // m: first\n"
                                        "DefineConstant [\n"
                                        "  // what follows\n"
                                        "  b = 2 * a,  // m: second\n"
                                        "  c = {3, Min 1, Max 5, Name \"Section/third\"},\n"
                                        "  word = \"text\",  // no number\n"
                                        "  d = Max(a, 4)  // last\n"
                                        "];\n"
                                        "e = 5;  // no parameter\n"
                                        "DefineConstant[ f, g = -1e-3 ];\n");
  const std::vector<std::string> expected = {
      "a|1|m: first", "b|2 * a|m: second", "c|3|Section/third", "d|Max(a, 4)|last", "f|0|", "g|-1e-3|"};
  EXPECT_EQ(lines_of(file), expected);
}

TEST(GeoParameters, OfIncludedScripts) {
  const TemporaryFolder folder;
  folder.write("b.geo", "DefineConstant[ width = 2 ];\nInclude \"a.geo\";\n");
  const std::string file = folder.write("a.geo", "DefineConstant[ height = 1 ];\nInclude \"b.geo\";\n");
  EXPECT_EQ(lines_of(file), (std::vector<std::string>{"height|1|", "width|2|"}));
}

TEST(GeoParameters, NoneOfAnIncludeThatNoFileCanHave) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("a.geo", "DefineConstant[ a = 1 ];\nInclude \"" + std::string(5000, 'x') + "\";\n");
  EXPECT_EQ(lines_of(file), std::vector<std::string>{"a|1|"});
}

TEST(GeoParameters, NoneWithoutFile) {
  EXPECT_TRUE(geo_parameters("/no/where.geo").empty());
}

TEST(GeoParameters, TheProgramsOwnAreAllDescribed) {
  for (const char* name : {"composite", "column", "caisson"}) {
    const auto parameters = geo_parameters(std::string(UPBEAD_MESHES) + "/" + name + ".geo");
    EXPECT_GE(parameters.size(), 5u);
    for (const GeoParameter& parameter : parameters) {
      EXPECT_FALSE(parameter.description.empty()) << parameter.name;
      EXPECT_NO_THROW(std::stod(parameter.default_value)) << parameter.name;
    }
  }
}

}  // namespace geo_parameters_test
}  // namespace upbead::test
