// Numbers, names and foreign text in messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace upbead {

constexpr std::size_t longest_quote = 60;   ///< characters (bytes) that suffice to recognise a text
constexpr std::size_t longest_path = 4096;  ///< PATH_MAX of Linux: no file has a longer path

/// The text on one line, at most `most` characters long: a longer one is cut to its beginning and its end, with " ...
/// " between. UTF-8 is not cut within a character; control characters become blanks.
std::string excerpt(std::string_view text, std::size_t most = longest_quote);

/// The same in single quotes: 'porosity'.
std::string in_quotes(std::string_view text, std::size_t most = longest_quote);

/// The whole path in quotes, so that the file can be found.
std::string quoted_path(std::string_view path);

/// The candidate nearest to `word` by Damerau-Levenshtein distance (insert, delete, replace, swap neighbours),
/// without regard to capitals and hyphens; "" where each differs by more than a third of its letters.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

/// "did you mean 'porosity'?" where a candidate is near, else "known KIND: a, b, c" ("there are no KIND" without
/// any).
/// `kind` is a plural: "keys", "boundaries".
std::string suggestion(const std::string& word, const std::vector<std::string>& candidates, const std::string& kind);

bool starts_with(std::string_view text, std::string_view beginning);

/// "a, b, c".
std::string join(const std::vector<std::string>& words, const std::string& separator = ", ");

/// A number with at most `digits` significant digits: "0.05", "1e-05".
std::string significant(double value, int digits = 3);

/// "(1.5, -12.3) m": with at most that many significant digits, but to the centimetre where these are less than that in
/// the coordinates of a survey.
std::string place_text(double x, double y, int digits = 3);
template <class Point>
std::string place_text(const Point& at, int digits = 3) {
  return place_text(at[0], at[1], digits);
}

/// `value`, or 0 where it is below 1e-9 of `peak`, which is round-off.
double without_round_off(double value, double peak);

/// A number with its unit and the prefix that reads best: "3.01 kN/m"; milli for metres only, as mN looks like MN.
/// Round-off relative to `peak` prints as 0. Without a unit, the number alone.
std::string with_unit(double value, const std::string& unit, double peak = 0., int digits = 4);

/// `least` digits, or as many as tell two numbers that differ apart: what fails by little must not look like its limit.
int digits_apart(double a, double b, int least);

/// "12.5 %" of a share of 0.125.
std::string percent(double share);

/// A letter, a digit or _.
bool is_word_character(char c);

}  // namespace upbead
