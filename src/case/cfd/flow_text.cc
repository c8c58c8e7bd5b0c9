#include "case/cfd/flow_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "base/numbers.h"
#include "base/text.h"
#include "base/text_file.h"

namespace upbead {

namespace {

constexpr std::uintmax_t most_bytes_of_flow = 1'000'000'000;

bool is_blank_of_flow(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

bool all_blank(std::string_view text) {
  return std::all_of(text.begin(), text.end(), is_blank_of_flow);
}

}  // namespace

FlowLines::FlowLines(std::string path, const Place& place)
    : path_(std::move(path)), text_(read_text(path_, most_bytes_of_flow, place)), rest_(text_) {
  if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
}

bool FlowLines::next(FlowNotes& notes) {
  if (again_) {
    again_ = false;
    return true;
  }
  while (!rest_.empty()) {
    ++number_;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    while (!line_.empty() && is_blank_of_flow(line_.back())) line_.remove_suffix(1);
    if (all_blank(line_)) continue;
    if (end != std::string_view::npos) return true;
    notes.push_back("the last line of " + excerpt(path_) + " has no end and may be cut within a number: left out");
  }
  return false;
}

std::size_t FlowLines::rows_left() const {
  return static_cast<std::size_t>(std::count(rest_.begin(), rest_.end(), '\n')) + 1;
}

bool read_number(std::string_view word, double& number) {
  const char *begin = word.data(), *end = begin + word.size();
  if (word.size() > 1 && *begin == '+' && begin[1] != '-') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (stop != end || begin == end) return false;
  if (error == std::errc()) return true;
  if (error != std::errc::result_out_of_range) return false;
  number = std::strtod(std::string(begin, end).c_str(), nullptr);
  return std::abs(number) < 1.;  // a number too small for a double counts as zero; a number too large is refused
}

void read_line(const FlowLines& lines, FlowLine& line) {
  line.shape.clear();
  line.numbers.clear();
  const std::string_view text = lines.line();
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (is_blank_of_flow(c)) {
      ++at;
    } else if (c == '(' || c == ')') {
      line.shape += c;
      ++at;
    } else {
      std::size_t end = at;
      while (end < text.size() && !is_blank_of_flow(text[end]) && text[end] != '(' && text[end] != ')') ++end;
      double number = 0.;
      if (!read_number(text.substr(at, end - at), number))
        throw InputError(lines.place(static_cast<int>(at) + 1),
                         in_quotes(text.substr(at, end - at)) + " is not a number",
                         "numbers have a decimal point and stand between blanks, such as 1.5e3");
      line.shape += 'n';
      line.numbers.push_back(number);
      at = end;
    }
  }
}

void require_quantities(const FlowLines& lines, const FlowLine& line) {
  if (const std::string objection = objection_to(line.numbers); !objection.empty())
    throw InputError(lines.place(), "a number of this row " + objection, "did the run fail there? cut the file before");
}

std::vector<std::string> words_of(std::string_view text, std::string_view marks) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(marks, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(marks, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

}  // namespace upbead
