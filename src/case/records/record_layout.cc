#include "case/records/record_layout.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/text.h"
#include "case/records/record_table.h"

namespace upbead {

namespace {

/// Whether the values are whole numbers that ascend from row to row; `by_one`: by one, as 4, 5, 6 ...
bool counts(const std::vector<double>& values, bool by_one = false) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != std::floor(values[i])) return false;
    if (i > 0 && !(by_one ? values[i] == values[i - 1] + 1. : values[i] > values[i - 1])) return false;
  }
  return true;
}

HeaderSays says(const CsvTable& table, std::size_t c) {
  if (table.is_text(c)) return HeaderSays::nothing;
  const HeaderSays found = header_says(table.names[c], table.units[c]);
  return found == HeaderSays::counter && !counts(table.columns[c]) ? HeaderSays::nothing : found;
}

Place header_of(const CsvTable& table) {
  return {table.path, 1, 1};
}

std::vector<double> in_seconds(const CsvTable& table, std::size_t column) {
  return converted(table, column,
                   unit_of_column(table, column, "s", unit_of_time(table.names[column], table.units[column])));
}

void require_alike(const CsvTable& table, std::size_t a, std::size_t b) {
  const std::vector<double> first = in_seconds(table, a), second = in_seconds(table, b);
  for (std::size_t row = 0; row < first.size(); ++row)
    if (std::abs(first[row] - second[row]) > 1e-6 * (std::abs(first[row]) + std::abs(second[row])))
      throw InputError(table.place(row),
                       "the columns " + in_quotes(table.names[a]) + " and " + in_quotes(table.names[b]) +
                           " both are times, and differ: " + significant(first[row], 6) + " s and " +
                           significant(second[row], 6) + " s",
                       "keep the time that is meant, or call it 'time' and the other one otherwise");
}

/// The column that is the time by its header, if any.
std::optional<std::size_t> named_time(const CsvTable& table, const std::vector<HeaderSays>& said) {
  const auto best = std::max_element(said.begin(), said.end());
  if (best == said.end() || *best < HeaderSays::another_clock) return std::nullopt;
  const auto time = static_cast<std::size_t>(best - said.begin());
  for (std::size_t c = time + 1; c < said.size(); ++c)
    if (said[c] == *best) require_alike(table, time, c);
  if (*best == HeaderSays::unit_of_time && time > 0 && said.front() == HeaderSays::nothing &&
      table.units.front().empty())
    throw InputError(header_of(table),
                     "is the time the first column, " + in_quotes(table.names.front()) + ", or " +
                         in_quotes(table.names[time]) + ", which has a unit of time?",
                     "call it 'time (s)'");
  return time;
}

}  // namespace

void append(RecordNotes& notes, const RecordNotes& more) {
  append(notes.read, more.read);
  append(notes.left_out, more.left_out);
  append(notes.warnings, more.warnings);
}

std::string note_lines(const RecordNotes& notes) {
  std::string text;
  for (const Skipped& part : notes.left_out) text += "note: " + part.what + ": " + part.why + "\n";
  return text;
}

RecordLayout layout_of(const CsvTable& table) {
  RecordLayout layout;
  std::vector<HeaderSays> said;
  for (std::size_t c = 0; c < table.names.size(); ++c) said.push_back(says(table, c));
  layout.time = named_time(table, said);
  for (std::size_t c = 0; c < said.size() && !layout.time; ++c)  // a time in words, 10:30:00, is told where it is used
    if (table.is_text(c) && header_says(table.names[c], table.units[c]) > HeaderSays::another_clock) layout.time = c;
  if (!layout.time && !said.empty() && said.front() != HeaderSays::counter) layout.time = 0;
  for (std::size_t c = 0; c < said.size(); ++c) {
    if (c == layout.time) continue;
    if (table.is_text(c))
      layout.words.push_back(c);
    else if (said[c] == HeaderSays::counter || (said[c] >= HeaderSays::another_clock && counts(table.columns[c], true)))
      layout.counters.push_back(c);
    else if (said[c] >= HeaderSays::another_clock && said[c] != HeaderSays::capital)
      layout.clocks.push_back(c);
    else
      layout.values.push_back(c);
  }
  return layout;
}

void note_layout(const CsvTable& table, const RecordLayout& layout, RecordNotes& notes) {
  constexpr std::size_t many = 10;
  const std::string time = layout.time ? "; the time is " + in_quotes(table.names[*layout.time]) : "";
  for (const std::size_t c : layout.counters) notes.left_out.push_back({column_text(table, c), "a counter" + time});
  for (const std::size_t c : layout.words) notes.left_out.push_back({column_text(table, c), "it holds no numbers"});
  for (const std::size_t c : layout.clocks) notes.left_out.push_back({column_text(table, c), "another time" + time});
  if (!layout.time || table.n_rows() < many) return;
  const std::vector<double>& t = table.columns[*layout.time];
  if (!unit_of_time(table.names[*layout.time], table.units[*layout.time]).empty() || !counts(t, true)) return;
  notes.warnings.push_back(
      {"time_counts", static_cast<double>(t.size()), static_cast<double>(many), "1",
       "the times of " + column_text(table, *layout.time) + ", " + significant(t[0], 7) + ", " + significant(t[1], 7) +
           ", " + significant(t[2], 7) +
           " ... s, are whole numbers that ascend by one and have no unit: if they count the samples, "
           "the record is read wrongly",
       "write the unit into the header, 'time (s)', or give times"});
}

std::vector<double> times_of(const CsvTable& table, const RecordLayout& layout) {
  if (!layout.time)
    throw InputError(
        header_of(table),
        "no column says that it is the time, and the first one, " + in_quotes(table.names.front()) + ", is a counter",
        "call the column of times 'time (s)'; a load by transducers may have sampling_rate in its place");
  return in_seconds(table, *layout.time);
}

std::string column_text(const CsvTable& table, std::size_t column) {
  return "column " + in_quotes(table.names[column]) + " of " +
         excerpt(std::filesystem::path(table.path).filename().string());
}

}  // namespace upbead
