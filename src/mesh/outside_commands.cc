#include "outside_commands.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "base/text.h"

namespace upbead {

namespace {

namespace fs = std::filesystem;

enum class TokenKind { word, text, symbol };

struct Token {
  TokenKind kind;
  std::string text;  ///< without quotation marks
  int line, column;
};

/// Splits a script into tokens; comments are left out.
class Tokens {
 public:
  explicit Tokens(const std::string& text) : text_(text) {
    while (at_ < text_.size()) {
      if (text_.compare(at_, 2, "//") == 0)
        skip(std::min(text_.find('\n', at_), text_.size()));
      else if (text_.compare(at_, 2, "/*") == 0)
        skip(behind("*/", at_ + 2));
      else
        take();
    }
  }

  std::vector<Token> list;

 private:
  void take() {
    const char c = text_[at_];
    const int line = line_, column = static_cast<int>(at_ - line_begin_) + 1;
    std::size_t end = at_ + 1;
    if (c == '"' || c == '\'') {
      end = behind(std::string(1, c), end);
      const bool closed = end > at_ + 1 && text_[end - 1] == c;
      list.push_back({TokenKind::text, text_.substr(at_ + 1, end - at_ - (closed ? 2 : 1)), line, column});
    } else if (is_word_character(c)) {
      while (end < text_.size() && is_word_character(text_[end])) ++end;
      list.push_back({TokenKind::word, text_.substr(at_, end - at_), line, column});
    } else if (!std::isspace(static_cast<unsigned char>(c)) && c != '\0') {
      list.push_back({TokenKind::symbol, std::string(1, c), line, column});
    }
    skip(end);
  }

  std::size_t behind(const std::string& what, std::size_t from) const {
    const auto found = text_.find(what, from);
    return found == std::string::npos ? text_.size() : found + what.size();
  }

  void skip(std::size_t end) {
    for (; at_ < end; ++at_)
      if (text_[at_] == '\n') {
        ++line_;
        line_begin_ = at_ + 1;
      }
  }

  const std::string& text_;
  std::size_t at_ = 0, line_begin_ = 0;
  int line_ = 1;
};

/// Commands with a text behind them; anywhere else these are names like any other.
const std::map<std::string, std::string> commands{
    {"SystemCall", "start a program"}, {"NonBlockingSystemCall", "start a program"},
    {"System", "start a program"},     {"OnelabRun", "start a program"},
    {"Print", "write a file"},         {"Save", "write a file"},
    {"CreateDir", "make a folder"},    {"SendToServer", "open a connection"},
};

/// Looks at each token with those around it.
class Search {
 public:
  Search(const fs::path& file, const std::vector<Token>& tokens) : file_(file), tokens_(tokens) {
    for (std::size_t i = 0; i < tokens.size(); ++i)
      if (tokens[i].kind == TokenKind::word && !is(i - 1, ".")) look_at(i);
  }

  std::vector<OutsideCommand> found;
  std::vector<fs::path> scripts;  ///< that it includes or merges

 private:
  void look_at(std::size_t i) {
    const std::string& word = tokens_[i].text;
    const auto command = commands.find(word);
    if (command != commands.end() && has_text(i))
      add(i, command->second);
    else if (word == "OnelabRun")
      add(i, "start a program");
    else if (word == "Exit")
      add(i, "end the program");
    else if (word == "ExternalProcess" && is(i - 1, "="))
      add(i, "start a program");
    else if (word == "Printf" && is(behind_brackets(i + 1), ">"))
      add(i, "write a file");
    else if (i + 1 < tokens_.size() && tokens_[i + 1].kind == TokenKind::text)
      follow(word, tokens_[i + 1].text);
  }

  /// Whether a text follows, or a function that makes one, or a View.
  bool has_text(std::size_t i) const {
    if (is(i - 1, "Macro") || is(i - 1, "Function") || is(i - 1, "Call") || i + 1 >= tokens_.size()) return false;
    return tokens_[i + 1].kind != TokenKind::symbol && tokens_[i + 1].text != "In";
  }

  std::size_t behind_brackets(std::size_t i) const {
    if (!is(i, "(")) return i;
    int depth = 0;
    for (; i < tokens_.size(); ++i) {
      if (is(i, "(")) ++depth;
      if (is(i, ")") && --depth == 0) break;
    }
    return i + 1;
  }

  void follow(const std::string& word, const std::string& name) {
    const fs::path path = file_.parent_path() / name;
    static const std::set<std::string> script_endings{"", ".geo", ".geo_unrolled", ".opt", ".txt", ".inc"};
    const bool merges = word == "Merge" || word == "MergeWithBoundingBox";
    if (word == "Include" || (merges && script_endings.count(path.extension().string()) > 0)) scripts.push_back(path);
  }

  /// Of no token, too.
  bool is(std::size_t i, const char* text) const {
    return i < tokens_.size() && tokens_[i].kind != TokenKind::text && tokens_[i].text == text;
  }

  void add(std::size_t i, const std::string& would) {
    found.push_back({{file_.string(), tokens_[i].line, tokens_[i].column}, tokens_[i].text, would});
  }

  const fs::path file_;
  const std::vector<Token>& tokens_;
};

void collect(const fs::path& file, std::set<std::string>& seen, std::vector<OutsideCommand>& list) {
  std::error_code error;  // of a name that no file can have
  if (!fs::is_regular_file(file, error) || !seen.insert(fs::weakly_canonical(file, error).string()).second) return;
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string script = text.str();
  const Search search(file, Tokens(script).list);
  list.insert(list.end(), search.found.begin(), search.found.end());
  for (const fs::path& path : search.scripts) collect(path, seen, list);
}

}  // namespace

std::vector<OutsideCommand> outside_commands(const std::string& file) {
  std::set<std::string> seen;
  std::vector<OutsideCommand> list;
  collect(file, seen, list);
  return list;
}

}  // namespace upbead
