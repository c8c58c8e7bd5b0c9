#include "mesh/geo_parameters.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace upbead {

namespace {

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

/// "name = value" or "name = {value, Name "label", ...}"; an empty name where it is no number.
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

/// Walks through a script once, aware of comments and strings.
class Scanner {
 public:
  explicit Scanner(std::string text) : text_(std::move(text)) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (text_.compare(at_, 2, "//") == 0) {
        comment();
      } else if (text_.compare(at_, 2, "/*") == 0) {
        const auto end = text_.find("*/", at_ + 2);
        at_ = end == std::string::npos ? text_.size() : end + 2;
      } else if (c == '"') {
        string();
      } else if (depth_ == 0 && (std::isalpha(static_cast<unsigned char>(c)) || c == '_')) {
        word();
      } else {
        symbol(c);
      }
    }
  }

  std::vector<GeoParameter> parameters;
  std::vector<std::string> includes;

 private:
  void comment() {
    const auto end = std::min(text_.find('\n', at_), text_.size());
    const std::string words = trimmed(text_.substr(at_ + 2, end - at_ - 2));
    if (!trimmed(item_).empty()) pending_ = words;  // the last one of a list has no comma before its comment
    if (on_line_ && trimmed(item_).empty()) parameters.back().description = words;
    at_ = end;
  }

  void string() {
    const auto end = std::min(text_.find('"', at_ + 1), text_.size() - 1);
    const std::string words = text_.substr(at_, end - at_ + 1);
    if (depth_ > 0) item_ += words;
    if (depth_ == 0 && word_ == "Include") includes.push_back(words.substr(1, words.size() - 2));
    word_.clear();
    at_ = end + 1;
  }

  void word() {
    const auto begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) ++at_;
    word_ = text_.substr(begin, at_ - begin);
  }

  /// Inside DefineConstant[...] depth_ counts the open brackets, and item_ holds what has been read of a parameter.
  void symbol(char c) {
    ++at_;
    if (c == '\n') on_line_ = false;
    if (depth_ == 0) {
      if (c == '[' && word_ == "DefineConstant") depth_ = 1;
      if (!std::isspace(static_cast<unsigned char>(c))) word_.clear();
      return;
    }
    if (c == '[' || c == '{' || c == '(') ++depth_;
    if (c == ']' || c == '}' || c == ')') --depth_;
    if (depth_ == 0 || (depth_ == 1 && c == ','))
      finish_item();
    else
      item_ += c;
  }

  void finish_item() {
    GeoParameter parameter = parsed(item_);
    if (!pending_.empty()) parameter.description = pending_;
    if (!parameter.name.empty()) {
      parameters.push_back(parameter);
      on_line_ = true;
    }
    item_.clear();
    pending_.clear();
  }

  std::string text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string word_;
  std::string item_;
  std::string pending_;   ///< comment behind an item that is not finished
  bool on_line_ = false;  ///< a parameter was finished on this line: a comment would be about it
};

void collect(const std::filesystem::path& file, std::set<std::string>& seen, std::vector<GeoParameter>& parameters) {
  std::error_code error;  // of a name that no file can have
  if (!seen.insert(std::filesystem::weakly_canonical(file, error).string()).second || error) return;
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  Scanner scanner(text.str());
  scanner.run();
  parameters.insert(parameters.end(), scanner.parameters.begin(), scanner.parameters.end());
  for (const std::string& include : scanner.includes) collect(file.parent_path() / include, seen, parameters);
}

}  // namespace

std::vector<GeoParameter> geo_parameters(const std::string& file) {
  std::set<std::string> seen;
  std::vector<GeoParameter> parameters;
  collect(file, seen, parameters);
  return parameters;
}

}  // namespace upbead
