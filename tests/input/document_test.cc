// Claim: a document knows the place at which each value was written, also for overrides.
#include "upbead/input/document.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace upbead {
namespace document_test {

class DocumentTest : public testing::Test {
 protected:
  DocumentTest()
      : path_((std::filesystem::temp_directory_path() / ("upbead-" + std::to_string(getpid()) + ".toml")).string()) {}
  ~DocumentTest() override { std::filesystem::remove(path_); }

  Document read(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    std::ofstream(path_, std::ios::binary) << text;
    return Document(path_, overrides);
  }

  std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    try {
      read(text, overrides);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  static std::string line(const Place& place) {
    return std::to_string(place.line) + ":" + std::to_string(place.column);
  }

  std::string path_;
};

TEST_F(DocumentTest, KnowsPlaces) {
  const Document document =
      read("title = \"x\"\n[regions.sand]\nkind = \"p\"\n  at = [1, 2]\npulse = { peak = 1 }\na.b = 2\n");
  EXPECT_EQ(line(document.place("title")), "1:1");
  EXPECT_EQ(line(document.place("regions.sand")), "2:10");
  EXPECT_EQ(line(document.place("regions.sand.at")), "4:3");
  EXPECT_EQ(line(document.place("regions.sand.pulse.peak")), "5:11");
  EXPECT_EQ(line(document.place("regions.sand.a.b")), "6:3");
  EXPECT_EQ(line(document.place("regions.sand.absent.key")), "2:10");
  EXPECT_EQ(line(document.place("absent")), "0:0");
  EXPECT_EQ(document.place("absent").file, path_);
  EXPECT_EQ(line(document.find("regions.sand.at")->array()->at(1).place), "4:12");
  EXPECT_EQ(document.find("regions.clay"), nullptr);
}

TEST_F(DocumentTest, TakesEveryKindOfOverride) {
  const Document document =
      read("a = 1\n[t]\nb = 2\nc = { d = 3, e = 4 }\n",
           {"a=2.5", "t.b=word", "t.c.d=5", "new.key=[1, 2]", "t.\"x y\"= \"quoted\"", "t.path=../f.csv", "a=7"});
  EXPECT_EQ(std::get<std::int64_t>(document.find("a")->value), 7);
  EXPECT_EQ(*document.find("t.b")->text(), "word");
  EXPECT_EQ(std::get<std::int64_t>(document.find("t.c.d")->value), 5);
  EXPECT_EQ(std::get<std::int64_t>(document.find("t.c.e")->value), 4);
  EXPECT_EQ(document.find("new.key")->array()->size(), 2u);
  EXPECT_EQ(*document.find("t.\"x y\"")->text(), "quoted");
  EXPECT_EQ(*document.find("t.path")->text(), "../f.csv");
  EXPECT_EQ(to_string({document.place("t.b"), "here", ""}), "--set t.b=word: here");
  EXPECT_EQ(line(document.place("t.c.e")), "4:14");
}

TEST_F(DocumentTest, ReplacesAWholeTable) {
  const Document document = read("t = { d = 3, e = 4 }\n", {"t={ d = 1 }"});
  EXPECT_EQ(std::get<std::int64_t>(document.find("t.d")->value), 1);
  EXPECT_EQ(document.find("t.e"), nullptr);
}

TEST_F(DocumentTest, RefusesWrongOverrides) {
  const std::string cure = "; write --set KEY=VALUE, such as --set time.end=2.0";
  EXPECT_EQ(refusal("a = 1\n", {"a"}), "--set a: no '=' between key and value" + cure);
  EXPECT_EQ(refusal("a = 1\n", {"a= "}), "--set a= : no value after '='" + cure);
  EXPECT_EQ(refusal("a = 1\n", {"a=[1, 2"}), "--set a=[1, 2: the value is not TOML" + cure);
  EXPECT_EQ(refusal("a = 1\n", {"a b=1"}), "--set a b=1: the key is not TOML" + cure);
  EXPECT_EQ(refusal("a = 1\n", {"a=1\nb=2"}), "--set a=1 b=2: more than one line" + cure);
  EXPECT_EQ(refusal("a = 1\n", {"a.b=2", "x"}),
            "--set a.b=2: 'b' is set within the number 1; see the keys of the case\n"
            "--set x: no '=' between key and value" +
                cure);
}

TEST_F(DocumentTest, RefusesKeysWithoutEnd) {
  std::string key = "a", quoted = "\"=\"", numbers = "\nb = [";
  for (int i = 0; i < 100000; ++i) {
    key += ".a";
    quoted += ".\"=\"";
    numbers += "1.0, ";
  }
  const std::string told = ": a key of more than 1000 parts; write keys such as regions.sand.porosity";
  EXPECT_EQ(refusal("\n" + key + " = 1\n").substr(path_.size()), ":2:1" + told);
  EXPECT_EQ(refusal("[" + key + "]\n").substr(path_.size()), ":1:1" + told);
  EXPECT_EQ(refusal("b = { " + quoted + " = 1 }\n").substr(path_.size()), ":1:1" + told);
  EXPECT_EQ(refusal("a = \"'\" # don't" + numbers + "]\n"), "");
}

TEST_F(DocumentTest, ReadsUtf16ThatAByteOrderMarkTells) {
  std::string text("\xFF\xFE");
  for (const char c : std::string("a = 1\r\nb = = 2\r\n")) text += std::string{c, '\0'};
  EXPECT_EQ(refusal(text).substr(path_.size(), 14), ":2:5: not TOML");
}

TEST_F(DocumentTest, TellsWhereTomlBreaks) {
  EXPECT_EQ(refusal("a = 1\nb = = 2\n").substr(path_.size(), 14), ":2:5: not TOML");
  EXPECT_EQ(refusal("a = 1\na = 2\n").substr(path_.size(), 5), ":2:5:");
  EXPECT_EQ(refusal("a = \"\xFF\"\n").substr(path_.size(), 3), ":1:");
  EXPECT_EQ(refusal(""), "");
}

}  // namespace document_test
}  // namespace upbead
