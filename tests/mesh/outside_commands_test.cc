// Claim: every command of gmsh's scripts that reads or writes other files or starts programs is found with its place
// before gmsh runs, despite comments, strings, line breaks, macros and included files; names that only look like such
// commands are not reported.
#include "mesh/geo_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace outside_commands_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// "file:line:column word", of each.
std::vector<std::string> found_in(const std::string& file) {
  std::vector<std::string> list;
  for (const OutsideCommand& command : outside_commands(file))
    list.push_back(std::filesystem::path(command.place.file).filename().string() + ":" +
                   std::to_string(command.place.line) + ":" + std::to_string(command.place.column) + " " +
                   command.word + ", " + command.would);
  return list;
}

std::vector<std::string> found(const std::string& script) {
  const TemporaryFolder folder;
  return found_in(folder.write("a.geo", script));
}

TEST(OutsideCommands, Each) {
  const std::map<std::string, std::string> commands{
      {"SystemCall \"touch x\";", "a.geo:1:1 SystemCall, start a program"},
      {"NonBlockingSystemCall 'touch x';", "a.geo:1:1 NonBlockingSystemCall, start a program"},
      {"System Str(\"touch x\");", "a.geo:1:1 System, start a program"},
      {"OnelabRun(\"a\", \"touch x\");", "a.geo:1:1 OnelabRun, start a program"},
      {"OnelabRun \"a\";", "a.geo:1:1 OnelabRun, start a program"},
      {"Save \"x.msh\";", "a.geo:1:1 Save, write a file"},
      {"Save View[0] \"x.pos\";", "a.geo:1:1 Save, write a file"},
      {"SendToServer View[0] \"x\";", "a.geo:1:1 SendToServer, open a connection"},
      {"Print \"x.png\";", "a.geo:1:1 Print, write a file"},
      {"Printf(\"a\") > \"x\";", "a.geo:1:1 Printf, write a file"},
      {"Printf(\"a %g\", (1 + 2) * 3) >> \"x\";", "a.geo:1:1 Printf, write a file"},
      {"CreateDir StrCat(\"x\", \"y\");", "a.geo:1:1 CreateDir, make a folder"},
      {"Field[1] = ExternalProcess;", "a.geo:1:12 ExternalProcess, start a program"},
      {"Exit;", "a.geo:1:1 Exit, end the program"},
  };
  for (const auto& [script, expected] : commands) EXPECT_THAT(found(script + "\n"), ElementsAre(expected)) << script;
}

TEST(OutsideCommands, AllOfAScript) {
  EXPECT_THAT(found("Point(1) = {0, 0, 0}; System \"a\";\n\n  Exit;\nMacro Foo\r\n\tSystemCall\n\"b\";\nReturn\n"),
              ElementsAre("a.geo:1:23 System, start a program", "a.geo:3:3 Exit, end the program",
                          "a.geo:5:2 SystemCall, start a program"));
}

TEST(OutsideCommands, BehindCommentsAndStrings) {
  EXPECT_THAT(found("a = \"// \"; /* ' */ Exit;\nb = '\"'; Exit;// \"\n/* // */Exit;\n"),
              ElementsAre("a.geo:1:20 Exit, end the program", "a.geo:2:10 Exit, end the program",
                          "a.geo:3:9 Exit, end the program"));
  EXPECT_THAT(found("SystemCall /* so */ // or\r\n \"a\";\n"), ElementsAre("a.geo:1:1 SystemCall, start a program"));
}

TEST(OutsideCommands, NotWithinCommentsAndStrings) {
  EXPECT_THAT(found("// Exit; \\\n/* SystemCall \"a\"; \n Exit; */ a = \"Exit; ' \"; b = 'Save \"x\"';\n// Exit;"),
              IsEmpty());
}

TEST(OutsideCommands, NotOtherThingsOfThatName) {
  EXPECT_THAT(
      found("Mesh.SaveAll = 1; Print.Background = 0; Save = 3; System = Save + 1; x = {System, Print};\n"
            "Macro Save\nPoint(1) = {0, 0, 0};\nReturn\nCall Save;\nFor System In {1:3}\nEndFor\n"
            "Printf(\"a\"); If(Save > 2) EndIf Printf(\"%g\", 3 > 2);\nSystemCaller = 2; Exits = 3; a.Exit = 2;\n"
            "Physical Surface(\"System\") = {1};"),
      IsEmpty());
}

TEST(OutsideCommands, OfOtherScripts) {
  const TemporaryFolder folder;
  folder.write("b.geo", "Include \"a.geo\";\n\nExit;\n");
  folder.write("c.geo", "System 'x';\n");
  folder.write("c.msh", "$MeshFormat\nExit;\n");
  EXPECT_THAT(
      found_in(folder.write("a.geo", "Include 'b.geo';\nMerge \"c.geo\"; Merge \"c.msh\"; Merge \"none.geo\";\n")),
      ElementsAre("b.geo:3:1 Exit, end the program", "c.geo:1:1 System, start a program"));
}

TEST(OutsideCommands, NoneInOurOwn) {
  for (const char* name : {"column", "composite", "caisson"})
    EXPECT_THAT(found_in(std::string(UPBEAD_MESHES) + "/" + name + ".geo"), IsEmpty());
}

TEST(OutsideCommands, OfNoFile) {
  EXPECT_THAT(outside_commands("/no/where.geo"), IsEmpty());
}

}  // namespace outside_commands_test
}  // namespace upbead::test
