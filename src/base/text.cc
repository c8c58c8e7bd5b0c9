#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "base/table_text.h"

namespace upbead {

std::string significant(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::string place_text(double x, double y, int digits) {
  const auto coordinate = [digits](double value) {
    const double size = std::abs(value);
    return significant(value, size < 1e3 ? digits : std::max(digits, 3 + static_cast<int>(std::log10(size))));
  };
  return "(" + coordinate(x) + ", " + coordinate(y) + ") m";
}

double without_round_off(double value, double peak) {
  return std::abs(value) < 1e-9 * std::abs(peak) ? 0. : value;
}

std::string with_unit(double value, const std::string& unit, double peak, int digits) {
  value = without_round_off(value, peak);
  if (unit.empty()) return significant(value, digits);
  const double size = std::abs(value);
  if (size >= 1e6) return significant(value / 1e6, digits) + " M" + unit;
  if (size >= 1e3) return significant(value / 1e3, digits) + " k" + unit;
  if (unit == "m" && size > 0. && size < 0.1) return significant(value * 1e3, digits) + " m" + unit;
  return significant(value, digits) + " " + unit;
}

int digits_apart(double a, double b, int least) {
  constexpr int most = 12;
  int digits = least;
  while (a != b && digits < most && significant(a, digits) == significant(b, digits)) ++digits;
  return digits;
}

std::string percent(double share) {
  return significant(100. * share) + " %";
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

namespace {

/// In UTF-8, bytes 10xxxxxx continue a character.
bool goes_on(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

std::string excerpt(std::string_view text, std::size_t most) {
  constexpr std::string_view gap = " ... ";
  std::string line(text.substr(0, most));
  if (text.size() > most) {
    const std::size_t kept = most - gap.size();
    std::size_t head = kept - kept / 3, tail = text.size() - kept / 3;
    while (head > 0 && goes_on(text[head])) --head;
    while (tail < text.size() && goes_on(text[tail])) ++tail;
    line = std::string(text.substr(0, head)).append(gap).append(text.substr(tail));
  }
  for (std::size_t at = 0; (at = end_of_utf8(line)) < line.size();) line.replace(at, 1, "?");  // never raw bytes
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }, ' ');
  return line;
}

std::string in_quotes(std::string_view text, std::size_t most) {
  return "'" + excerpt(text, most) + "'";
}

std::string quoted_path(std::string_view path) {
  return in_quotes(path, path.size() > longest_path ? longest_quote : longest_path);
}

namespace {

/// A person takes words with the same folded form as equal.
std::string folded(const std::string& word) {
  std::string text = word;
  for (char& c : text) c = c == '-' || c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

// longer words are not compared: the work grows with the square of the length
constexpr std::size_t longest_word = 200;
constexpr std::size_t n_suggested = 40;  // number of words that a person reads through

std::string list_of(const std::vector<std::string>& words) {
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < words.size() && i < n_suggested; ++i) shown.push_back(excerpt(words[i]));
  const std::string more = " and " + std::to_string(words.size() - shown.size()) + " more";
  return join(shown) + (words.size() > n_suggested ? more : "");
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = 0;
  if (word.size() > longest_word) return best;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest_word) continue;
    const std::size_t d = distance(folded(word), folded(candidate));
    if (d > std::max(word.size(), candidate.size()) / 3 || (!best.empty() && d >= least)) continue;
    best = candidate;
    least = d;
  }
  return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& candidates, const std::string& kind) {
  const std::string near = nearest(word, candidates);
  if (!near.empty()) return "did you mean " + in_quotes(near) + "?";
  return candidates.empty() ? "there are no " + kind : "known " + kind + ": " + list_of(candidates);
}

bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

}  // namespace upbead
