// indices.json, the table for the terminal, and warnings.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "output/output_text.h"
#include "reliability/indices.h"

namespace upbead {

namespace {

constexpr double most_half = 0.1;       // half an interval; beyond it an index says little
constexpr double least_told = 0.05;     // the order of smaller total indices matters to nobody
constexpr double largest_sample = 1e5;  // points that a study can have

struct ToldIndices {
  const StudyIndices* indices;
  NumberedWarnings warnings;
};

OutputSchema<Estimate> estimate_outputs() {
  return OutputSchema<Estimate>()
      .key("value", &Estimate::value, "", "estimate; by chance it may lie a little below 0 or above 1")
      .key("low", &Estimate::low, "", "end of the interval of 95 %")
      .key("high", &Estimate::high, "", "end of the interval of 95 %");
}

OutputSchema<KeyIndices> key_outputs() {
  return OutputSchema<KeyIndices>()
      .object("first", &KeyIndices::first, estimate_outputs(), "share of the variance by the key alone")
      .object("total", &KeyIndices::total, estimate_outputs(), "share by the key, alone and together with others");
}

OutputSchema<NumberIndices> number_outputs() {
  using N = NumberIndices;
  return OutputSchema<N>()
      .key("case", &N::case_file, "", "its case")
      .key("number", &N::number, "", "path in the summary of a run")
      .key("points", &N::points, "", "of the sample, with the number in all their runs")
      .key("left_out", &N::left_out, "", "points of which a run failed, is void or has no such number")
      .key("failed", &N::failed, "", "runs that failed, or are void")
      .key("lacking", &N::lacking, "", "runs that have no such number")
      .key("mean", &N::mean, "SI", "of the draws (rows of A and B)")
      .key("deviation", &N::deviation, "SI", "standard deviation of the draws")
      .reason("why_not", &N::why_not, "why there are no indices")
      .named("keys.KEY", &N::keys, &KeyIndices::key, key_outputs(),
             "indices of each key, the largest total first; empty where there are none");
}

const OutputSchema<ToldIndices>& indices_outputs() {
  using T = ToldIndices;
  static const auto schema =
      OutputSchema<T>()
          .key("title", inner(&T::indices, &StudyIndices::title), "", "that of the study")
          .program()
          .list("warnings[]", &T::warnings, warning_outputs(), "what may be wrong")
          .list("numbers[]", inner(&T::indices, &StudyIndices::numbers), number_outputs(), "each number of each case")
          .versions();
  return schema;
}

bool has_several_cases(const StudyIndices& indices) {
  for (const NumberIndices& found : indices.numbers)
    if (found.case_file != indices.numbers.front().case_file) return true;
  return false;
}

std::string name_of(const StudyIndices& indices, const NumberIndices& found) {
  return found.number + (has_several_cases(indices) ? " of " + found.case_file : "");
}

std::string interval(const Estimate& found) {
  return significant(found.low, 2) + " to " + significant(found.high, 2);
}

double half(const Estimate& found) {
  return (found.high - found.low) / 2.;
}

NumberedWarnings points_left_out(const std::string& name, const NumberIndices& found) {
  if (found.left_out == 0) return {};
  return {{"indices_left_out", static_cast<double>(found.left_out), 0., "1",
           name + ": " + std::to_string(found.left_out) + " of " + std::to_string(found.points + found.left_out) +
               " points are left out, as " + std::to_string(found.failed) + " runs failed or are void and " +
               std::to_string(found.lacking) +
               " have no such number: the indices are of what is left, whose distributions are others",
           "narrow the distributions to where runs end well, see failed and void in summary.json"}};
}

/// Neighbours in the order of their totals whose intervals hold the value of each other.
NumberedWarnings open_order(const std::string& name, const NumberIndices& found) {
  std::vector<std::string> pairs;
  for (std::size_t k = 0; k + 1 < found.keys.size(); ++k) {
    const Estimate &more = found.keys[k].total, &less = found.keys[k + 1].total;
    if (more.value < least_told) break;
    if (more.low <= less.value && less.high >= more.value)
      pairs.push_back(found.keys[k].key + " and " + found.keys[k + 1].key);
  }
  if (pairs.empty()) return {};
  return {{"indices_order_open", static_cast<double>(pairs.size()), 0., "1",
           name + ": the intervals of " + join(pairs, "; of ") + " overlap so far that their order is open",
           "take more points (n of the study)"}};
}

NumberedWarnings wide_intervals(const std::string& name, const NumberIndices& found) {
  double worst = 0.;
  std::string which;
  for (const KeyIndices& key : found.keys)
    for (const auto& [index, what] : {std::pair(&key.first, "first"), std::pair(&key.total, "total")})
      if (half(*index) > worst) {
        worst = half(*index);
        which = std::string(what) + " index of " + key.key;
      }
  if (worst <= most_half) return {};
  const double n = std::exp2(std::ceil(std::log2(found.points * std::pow(worst / most_half, 2))));
  return {{"indices_uncertain", worst, most_half, "1",
           name + ": the " + which + " is known to +-" + significant(worst, 2),
           "take n = " + significant(std::min(n, largest_sample), 6) + ", as intervals shrink by the root of n"}};
}

NumberedWarnings no_indices(const std::string& name, const NumberIndices& found) {
  if (found.why_not.empty()) return {};
  return {{"no_indices", static_cast<double>(found.points), 0., "", name + " has no indices: " + found.why_not,
           "look at study.csv, or choose another number with --of"}};
}

std::string table_of(const StudyIndices& indices, const NumberIndices& found) {
  std::string text = name_of(indices, found);
  if (found.mean)
    text += ": mean " + significant(*found.mean) + ", standard deviation " + significant(*found.deviation) + ", " +
            std::to_string(found.points) + " points";
  if (!found.why_not.empty()) return text + "\nno indices: " + found.why_not + "\n";
  std::vector<TextRow> rows{{"  key", "first", "95 %", "total", "95 %"}};
  double alone = 0.;
  for (const KeyIndices& key : found.keys) {
    rows.push_back({"  " + key.key, significant(key.first.value, 2), interval(key.first),
                    significant(key.total.value, 2), interval(key.total)});
    alone += key.first.value;
  }
  return text + "\n" + aligned(rows) + "  all first ones together " + significant(alone, 2) +
         ", the rest of 1 is by keys together\n";
}

}  // namespace

NumberedWarnings warnings_of(const StudyIndices& indices) {
  NumberedWarnings list;
  for (const NumberIndices& found : indices.numbers)
    for (const auto& warnings : {points_left_out, no_indices, open_order, wide_intervals})
      append(list, warnings(name_of(indices, found), found));
  return list;
}

std::string describe(const StudyIndices& indices) {
  std::string text = indices.title.empty() ? "" : indices.title + "\n";
  for (const NumberIndices& found : indices.numbers) text += table_of(indices, found);
  return text;
}

std::vector<OutputRow> rows_of_indices() {
  return indices_outputs().rows();
}

std::string to_json(const StudyIndices& indices) {
  return indices_outputs().text({&indices, warnings_of(indices)});
}

}  // namespace upbead
