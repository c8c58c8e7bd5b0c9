#include "geo_script.h"

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

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

/// The words between quotation marks that follow `label` in `text`.
std::string quoted_after(const std::string& text, const std::string& label) {
  const auto at = text.find(label);
  const auto begin = at == std::string::npos ? at : text.find('"', at);
  const auto end = begin == std::string::npos ? begin : text.find('"', begin + 1);
  return end == std::string::npos ? "" : text.substr(begin + 1, end - begin - 1);
}

/// Reads "name = value" or "name = {value, Name "label", ...}"; the name is empty if the value is no number.
GeoParameter parsed(const std::string& item) {
  GeoParameter parameter;
  const auto equals = item.find('=');
  parameter.name = trimmed(item.substr(0, equals));
  std::string value = equals == std::string::npos ? "0" : trimmed(item.substr(equals + 1));
  if (!value.empty() && value.front() == '{') {
    parameter.description = quoted_after(value, "Name");
    value = trimmed(value.substr(1, value.find_first_of(",}") - 1));
  }
  parameter.default_value = value;
  if (value.empty() || value.front() == '"' || value.rfind("Str", 0) == 0) parameter.name.clear();
  return parameter;
}

enum class TokenKind { word, text, symbol, comment, block_comment };

struct Token {
  TokenKind kind;
  std::string text;  ///< without quotation marks, or the slashes of a comment
  int line, column;
  std::size_t begin, end;  ///< position in the script
};

bool is_comment(const Token& token) {
  return token.kind == TokenKind::comment || token.kind == TokenKind::block_comment;
}

/// Splits a script into tokens.
class Tokens {
 public:
  explicit Tokens(const std::string& text) : text_(text) {
    while (at_ < text_.size()) {
      if (text_.compare(at_, 2, "//") == 0) {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        add(TokenKind::comment, at_ + 2, end, end);
      } else if (text_.compare(at_, 2, "/*") == 0) {
        add(TokenKind::block_comment, at_, at_, behind("*/", at_ + 2));
      } else {
        take();
      }
    }
  }
  std::vector<Token> list;

 private:
  void take() {
    const char c = text_[at_];
    std::size_t end = at_ + 1;
    if (c == '"' || c == '\'') {
      end = behind(std::string(1, c), end);
      const bool closed = end > at_ + 1 && text_[end - 1] == c;
      add(TokenKind::text, at_ + 1, closed ? end - 1 : end, end);
    } else if (is_word_character(c)) {
      while (end < text_.size() && is_word_character(text_[end])) ++end;
      add(TokenKind::word, at_, end, end);
    } else if (!std::isspace(static_cast<unsigned char>(c)) && c != '\0') {
      add(TokenKind::symbol, at_, end, end);
    } else {
      skip(end);
    }
  }

  /// Adds a token from the present position to `end`, with its text in [first, last).
  void add(TokenKind kind, std::size_t first, std::size_t last, std::size_t end) {
    const int column = static_cast<int>(at_ - line_begin_) + 1;
    list.push_back({kind, text_.substr(first, last - first), line_, column, at_, end});
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

/// The parameters that a script defines, and the scripts that it includes.
class Definitions {
 public:
  explicit Definitions(const std::string& text) : text_(text) {
    std::string before;  // the word before a token
    const std::vector<Token> tokens = Tokens(text).list;
    for (const Token& token : tokens) {
      if (is_comment(token)) {
        if (token.kind == TokenKind::comment) comment(token);
        end_ = token.end;
        continue;
      }
      if (depth_ > 0)
        inside(token);
      else if (before == "DefineConstant" && token.text == "[" && token.kind == TokenKind::symbol)
        depth_ = 1;
      else if (before == "Include" && token.kind == TokenKind::text)
        includes.push_back(token.text);
      before = depth_ == 0 && token.kind == TokenKind::word ? token.text : "";
      end_ = token.end;
    }
  }

  std::vector<GeoParameter> parameters;
  std::vector<std::string> includes;

 private:
  void comment(const Token& token) {
    if (!trimmed(item_).empty())
      pending_ = trimmed(token.text);  // the last parameter of a list has no comma before its comment
    else if (token.line == line_)
      parameters.back().description = trimmed(token.text);
  }

  /// Inside DefineConstant[...] depth_ counts the open brackets; item_ is the part read so far of a parameter.
  void inside(const Token& token) {
    const bool is_symbol = token.kind == TokenKind::symbol;
    if (is_symbol && std::string("[{(").find(token.text) != std::string::npos) ++depth_;
    if (is_symbol && std::string("]})").find(token.text) != std::string::npos) --depth_;
    if (depth_ == 0 || (depth_ == 1 && is_symbol && token.text == ","))
      finish_item(token.line);
    else
      item_ += text_.substr(end_, token.end - end_);
  }

  void finish_item(int line) {
    GeoParameter parameter = parsed(item_);
    if (!pending_.empty()) parameter.description = pending_;
    if (!parameter.name.empty()) {
      parameters.push_back(parameter);
      line_ = line;
    }
    item_.clear();
    pending_.clear();
  }

  const std::string& text_;
  int depth_ = 0;
  std::size_t end_ = 0;  ///< end of the last token
  std::string item_;
  std::string pending_;  ///< comment behind an item that is not finished
  int line_ = 0;         ///< line on which the last parameter was finished: a comment there describes it
};

/// Commands if a text follows; otherwise ordinary names.
const std::map<std::string, std::string> commands{
    {"SystemCall", "start a program"}, {"NonBlockingSystemCall", "start a program"},
    {"System", "start a program"},     {"OnelabRun", "start a program"},
    {"Print", "write a file"},         {"Save", "write a file"},
    {"CreateDir", "make a folder"},    {"SendToServer", "open a connection"},
};

/// Whether what is merged is a script.
bool is_script(const fs::path& file) {
  static const std::set<std::string> endings{"", ".geo", ".geo_unrolled", ".opt", ".txt", ".inc"};
  return endings.count(file.extension().string()) > 0;
}

/// Examines each token together with its neighbours.
class Search {
 public:
  Search(const fs::path& file, const std::string& text) : file_(file), tokens_(Tokens(text).list) {
    tokens_.erase(std::remove_if(tokens_.begin(), tokens_.end(), is_comment), tokens_.end());
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (tokens_[i].kind == TokenKind::word && !is(i - 1, ".")) look_at(i);
  }

  std::vector<OutsideCommand> found;
  std::vector<std::string> scripts;  ///< scripts that this one includes or merges

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

  /// Whether the next token is a text, a function that makes one, or a View.
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
    const bool merges = word == "Merge" || word == "MergeWithBoundingBox";
    if (word == "Include" || (merges && is_script(name))) scripts.push_back(name);
  }

  /// False also where there is no token i.
  bool is(std::size_t i, const char* text) const {
    return i < tokens_.size() && tokens_[i].kind != TokenKind::text && tokens_[i].text == text;
  }

  void add(std::size_t i, const std::string& would) {
    found.push_back({{file_.string(), tokens_[i].line, tokens_[i].column}, tokens_[i].text, would});
  }

  const fs::path file_;
  std::vector<Token> tokens_;
};

/// Calls visit(file, its text) for a script and for the scripts named in the list that visit returns, each once.
/// Scripts that cannot be read are left out.
template <class Visit>
void for_each_script(const fs::path& file, std::set<std::string>& seen, const Visit& visit) {
  std::error_code error;  // set for a name that no file can have
  if (!fs::is_regular_file(file, error) || !seen.insert(fs::weakly_canonical(file, error).string()).second) return;
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  for (const std::string& name : visit(file, text.str())) for_each_script(file.parent_path() / name, seen, visit);
}

}  // namespace

std::vector<GeoParameter> geo_parameters(const std::string& file) {
  std::set<std::string> seen;
  std::vector<GeoParameter> list;
  for_each_script(file, seen, [&](const fs::path&, const std::string& text) {
    const Definitions found(text);
    list.insert(list.end(), found.parameters.begin(), found.parameters.end());
    return found.includes;
  });
  return list;
}

std::vector<std::string> files_of_mesh(const std::string& file) {
  std::set<std::string> seen;
  std::vector<std::string> list;
  for_each_script(file, seen, [&](const fs::path& path, const std::string& text) {
    list.push_back(path.string());
    std::vector<std::string> names;
    if (!is_script(path)) return names;
    for (const Token& token : Tokens(text).list)
      if (token.kind == TokenKind::text) names.push_back(token.text);
    return names;
  });
  return list;
}

std::vector<OutsideCommand> outside_commands(const std::string& file) {
  std::set<std::string> seen;
  std::vector<OutsideCommand> list;
  for_each_script(file, seen, [&](const fs::path& script, const std::string& text) {
    const Search search(script, text);
    list.insert(list.end(), search.found.begin(), search.found.end());
    return search.scripts;
  });
  return list;
}

}  // namespace upbead
