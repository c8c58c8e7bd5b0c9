// Numbers in sentences.
#pragma once

#include <string>

namespace upbead {

/// A number with at most that many significant digits: "0.05", "1e-05".
std::string significant(double value, int digits = 3);

/// 0 where a number is below 1e-9 of `peak`, which is round-off.
double without_round_off(double value, double peak);

/// A number with its unit, in the prefix that reads best: "3.01 kN/m"; milli for metres only, for mN reads as MN. What
/// is round-off of `peak` prints as 0.
std::string with_unit(double value, const std::string& unit, double peak = 0.);

/// A letter, a digit or _.
bool is_word_character(char c);

}  // namespace upbead
