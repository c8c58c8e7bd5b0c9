// Claim: a script from an unknown source can only draw and mesh: none of its commands leaves a trace, each such
// command is reported, and no other file beside the script or in the user's home is read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace strangers_file_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string mesh_of_it = "Transfinite Curve{1:4} = 3; Transfinite Surface{1}; Recombine Surface{1};\n";

class StrangersFile : public testing::Test {
 protected:
  /// The messages for the script of a valid rectangle with `more` added.
  std::vector<std::string> complaints_with(const std::string& more) const {
    return complaints(request_for(folder_.write("a.geo", rectangle_script(mesh_of_it + more))));
  }
  bool was_made() const {
    const auto exists = [this](const char* ending) { return std::filesystem::exists(made_ + ending); };
    return exists("") || exists(".msh") || exists(".geo_unrolled");
  }

  const TemporaryFolder folder_;
  const std::string made_ = folder_.path("made"), touch_ = "\"touch " + made_ + "\"";
};

TEST_F(StrangersFile, IsReadWhereItDoesNothingElse) {
  EXPECT_THAT(complaints_with(""), IsEmpty());
  EXPECT_THAT(complaints_with("Printf(\"told\"); Mesh 2;"), IsEmpty());
}

TEST_F(StrangersFile, CommandsAreToldByNameAndLineAndNotDone) {
  const std::map<std::string, std::string> commands{
      {"SystemCall " + touch_ + ";", "'SystemCall' would start a program"},
      {"NonBlockingSystemCall " + touch_ + ";", "'NonBlockingSystemCall' would start a program"},
      {"System " + touch_ + ";", "'System' would start a program"},
      {"OnelabRun(\"a\", " + touch_ + ");", "'OnelabRun' would start a program"},
      {"Save \"" + made_ + "\";", "'Save' would write a file"},
      {"Print \"" + made_ + ".geo_unrolled\";", "'Print' would write a file"},
      {"Printf(\"a\") > \"" + made_ + "\";", "'Printf' would write a file"},
      {"Printf(\"a %g\", 1) >> \"" + made_ + "\";", "'Printf' would write a file"},
      {"CreateDir \"" + made_ + "\";", "'CreateDir' would make a folder"},
      {"Exit;", "'Exit' would end the program"},
  };
  for (const auto& [command, told] : commands) {
    EXPECT_THAT(complaints_with(command), ElementsAre(folder_.path("a.geo") + ":7:1: " + told +
                                                      "; remove it: a script may draw and mesh, and nothing else"))
        << command;
    EXPECT_FALSE(was_made()) << command;
  }
}

/// A word that no search in the text finds, as the script composes it at run time.
std::string spelt(const std::string& word) {
  return "StringToName[StrCat(\"" + word.substr(0, 2) + "\", \"" + word.substr(2) + "\")] ";
}

TEST_F(StrangersFile, WhatEscapesTheReadingIsRefusedAndTold) {
  const std::map<std::string, std::string> commands{
      {spelt("SystemCall") + touch_ + ";", "it tries to start a program"},
      {spelt("NonBlockingSystemCall") + touch_ + ";", "it tries to start a program"},
      {spelt("Save") + "\"" + made_ + ".msh\";", "it tries to write the file '" + made_ + ".msh'"},
      {spelt("Print") + "\"" + made_ + ".geo_unrolled\";", "it tries to write the file '" + made_ + ".geo_unrolled'"},
      {spelt("CreateDir") + "\"" + made_ + "\";", "it tries to make the folder '" + made_ + "'"},
      {"Mesh.Algorithm = 6; General.LogFileName = \"" + made_ + "\";", "gmsh says: "},
  };
  for (const auto& [command, told] : commands) {
    EXPECT_THAT(complaints_with(command), testing::Contains(HasSubstr(told))) << command;
    EXPECT_FALSE(was_made()) << command;
  }
}

TEST_F(StrangersFile, OtherScriptsOfItAreConfinedToo) {
  folder_.write("b.geo", "SystemCall " + touch_ + ";\n");
  EXPECT_THAT(complaints_with("Merge \"b.geo\";"), ElementsAre(HasSubstr("b.geo:1:1: 'SystemCall' would start")));
  EXPECT_THAT(complaints_with("Merge StrCat(\"b.\", \"geo\");"), ElementsAre(HasSubstr("it tries to start a program")));
  EXPECT_THAT(complaints_with("Include StrCat(\"b.\", \"geo\");"),
              ElementsAre(HasSubstr("it tries to start a program")));
  folder_.write("b.geo", "Exit;\n");
  EXPECT_THAT(complaints_with("Merge StrCat(\"b.\", \"geo\");"), ElementsAre(HasSubstr("gmsh ends the program on it")));
  EXPECT_FALSE(was_made());
}

TEST_F(StrangersFile, ExternalProcessIsNotStarted) {
  const std::string field =
      "Field[1] = " + std::string("ExternalProcess; Field[1].CommandLine = ") + touch_ + "; Background Field = 1;";
  const std::string script = rectangle_script("Mesh.RecombineAll = 1;\n" + field);
  EXPECT_THAT(complaints(request_for(folder_.write("a.geo", script))),
              ElementsAre(HasSubstr("'ExternalProcess' would start a program")));
  folder_.write("b.txt", field + "\n");
  EXPECT_THAT(complaints(request_for(
                  folder_.write("a.geo", rectangle_script("Mesh.RecombineAll = 1; Merge StrCat(\"b.\", \"txt\");")))),
              ElementsAre(HasSubstr("it tries to start a program")));
  EXPECT_FALSE(was_made());
}

TEST_F(StrangersFile, OptionsBesideItAreIgnored) {
  // gmsh reads X.opt together with X: it may start a program or change the mesh silently
  const std::string settings = "SystemCall " + touch_ + "; Exit; Mesh.ElementOrder = 2; Error(\"seen\");\n";
  for (const char* name : {"a.geo.opt", "a.msh.opt", "b.geo.opt", "b.msh.opt"}) folder_.write(name, settings);
  EXPECT_THAT(complaints_with(""), IsEmpty());
  EXPECT_THAT(complaints(request_for(folder_.write("a.msh", unit_cell().text()))), IsEmpty());
  folder_.write("b.geo", "x = 1;\n");
  folder_.write("b.msh", unit_cell().text());
  EXPECT_THAT(complaints_with("Merge \"b.geo\";"), IsEmpty());
  const std::string merging = "Merge \"b.msh\";\n";
  EXPECT_THAT(complaints(request_for(folder_.write("a.geo", merging))), IsEmpty());
  EXPECT_FALSE(was_made());
}

TEST_F(StrangersFile, SettingsOfTheUserAreIgnored) {
  const std::string home = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
  setenv("HOME", folder_.path("").c_str(), 1);
  for (const char* name : {".gmshrc", ".gmsh-options"}) folder_.write(name, "Mesh.ElementOrder = 2; Exit;\n");
  EXPECT_THAT(complaints_with(""), IsEmpty());
  setenv("HOME", home.c_str(), 1);
}

TEST_F(StrangersFile, ScriptThatSaysItIsAMeshIsNone) {
  EXPECT_THAT(complaints(request_for(folder_.write("a.msh", "SystemCall " + touch_ + ";\n// $MeshFormat\n"))),
              ElementsAre(HasSubstr("it has no $MeshFormat at its beginning")));
  EXPECT_FALSE(was_made());
}

TEST_F(StrangersFile, PathMayHaveAnyLetters) {
  for (const std::string name : {"it's.geo", "\"so\" it's.geo", "\xc3\xa4 b\\c.geo", "'.geo"}) {
    folder_.write("part.geo", "x = CurrentDirectory;\n");
    EXPECT_THAT(complaints(request_for(folder_.write(name, rectangle_script(mesh_of_it)))), IsEmpty()) << name;
  }
}

TEST_F(StrangersFile, MayAbort) {
  EXPECT_THAT(complaints_with("Abort;\nSave \n= 3;\n"), IsEmpty());
  MeshRequest request = request_for(folder_.write("a.geo", rectangle_script(mesh_of_it + "Abort;\n+++\n")));
  request.parameters["width"] = 3;
  EXPECT_THAT(complaints(request), IsEmpty());
}

TEST_F(StrangersFile, IsFoundFromAnyFolder) {
  folder_.write("part.geo", mesh_of_it);
  folder_.write("a.geo", rectangle_script("Include \"part.geo\";"));
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path(""));
  EXPECT_THAT(complaints(request_for("a.geo")), IsEmpty());
  std::filesystem::current_path(before);
}

TEST_F(StrangersFile, LargeMeshComesBack) {
  MeshRequest request = geometry("column", {{"cells", 2000}, {"cells_across", 60}});
  EXPECT_EQ(read_mesh(request)->triangulation.n_active_cells(), 120000U);
}

TEST_F(StrangersFile, SeveralThreadsMayRead) {
  std::vector<std::thread> threads;
  std::vector<unsigned int> cells(4);
  for (unsigned int i = 0; i < cells.size(); ++i)
    threads.emplace_back([i, &cells] {
      cells[i] =
          read_mesh(geometry("column", {{"cells", 5. + i}, {"cells_across", 2}}))->triangulation.n_active_cells();
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(cells, ElementsAre(10, 12, 14, 16));
}

}  // namespace strangers_file_test
}  // namespace upbead::test
