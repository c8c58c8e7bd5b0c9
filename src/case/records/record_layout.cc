#include "case/records/record_layout.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <vector>

#include "base/text.h"
#include "base/units.h"
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
  const HeaderSays found = header_says(table.names[c], table.units[c]);
  return found == HeaderSays::counter && !counts(table.columns[c]) ? HeaderSays::nothing : found;
}

Place header_of(const CsvTable& table) {
  return {table.path, 1, 1};
}

std::vector<double> in_seconds(const CsvTable& table, std::size_t column) {
  return in_si(table, column, "s", unit_of_time(table.names[column], table.units[column]));
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

RecordLayout layout_of(const CsvTable& table) {
  RecordLayout layout;
  std::vector<HeaderSays> said;
  for (std::size_t c = 0; c < table.names.size(); ++c) said.push_back(says(table, c));
  layout.time = named_time(table, said);
  if (!layout.time && !said.empty() && said.front() != HeaderSays::counter) layout.time = 0;
  for (std::size_t c = 0; c < said.size(); ++c) {
    if (c == layout.time) continue;
    if (said[c] == HeaderSays::counter || (said[c] >= HeaderSays::another_clock && counts(table.columns[c], true)))
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
  for (const std::size_t c : layout.clocks) notes.left_out.push_back({column_text(table, c), "another time" + time});
  if (!layout.time || table.n_rows() < many) return;
  const std::vector<double>& t = table.columns[*layout.time];
  if (!unit_of_time(table.names[*layout.time], table.units[*layout.time]).empty() || !counts(t, true)) return;
  notes.warnings.push_back(
      {"time_counts", static_cast<double>(t.size()), static_cast<double>(many), "1",
       "the times of " + column_text(table, *layout.time) + ", " + significant(t[0], 7) + ", " + significant(t[1], 7) +
           ", " + significant(t[2], 7) +
           " ... s, are whole numbers that ascend by one and have no unit: if they count the samples, "
           "the record is read wrongly; write the unit into the header, 'time (s)', or give times"});
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

namespace {

using HeaderWords = std::vector<std::string>;
using Set = std::set<std::string>;

constexpr std::size_t longest_header = 200;

const Set times{"time", "times", "zeit", "zeiten",  "messzeit", "temps",   "tiempo", "tempo",
                "tijd", "tid",   "aika", "czas",    "vreme",    "vrijeme", "zaman",  "ido",
                "idő",  "čas",   "cas",  "χρόνος",  "время",    "時間",    "時刻",   "时间",
                "시간", "sec",   "secs", "seconds", "sekunden", "elapsed", "msec",   "milliseconds"};
const Set counters{"part",  "particle", "step",   "steps",  "schritt", "zeitschritt", "timestep",  "no",     "nr",
                   "num",   "number",   "nummer", "numero", "numéro",  "lfd",         "laufnr",    "index",  "idx",
                   "i",     "n",        "id",     "sample", "samples", "scan",        "scans",     "row",    "rows",
                   "line",  "zeile",    "ligne",  "record", "rec",     "count",       "counter",   "zähler", "zaehler",
                   "point", "pt",       "punkt",  "frame",  "frames",  "iter",        "iteration", "cycle",  "pas",
                   "paso",  "passo",    "n°",     "nº",     "№",       "番号",        "序号",      "unnamed"};
/// With one of these beside a word of time, the column holds the number of a time, or a length of time.
const Set lengths{"step",  "steps", "dt",   "delta",  "interval", "increment", "lag",    "delay",
                  "shift", "rise",  "fall", "period", "duration", "constant",  "schritt"};
const Set clocks{"real",     "cpu",   "wall", "clock", "system", "date",  "day",
                 "absolute", "local", "utc",  "gmt",   "run",    "stamp", "computing"};
const Set stamps{"timestamp", "zeitstempel", "runtime", "clock"};
/// Beside a word of time only these make the column a counter: "time step", "time no."; "sample time" is a time.
const Set of_a_time{"step", "steps",  "schritt", "index", "idx", "no", "nr",
                    "num",  "number", "nummer",  "n°",    "nº",  "id"};
/// Units too short to be recognised without brackets: s may be slip, min minimum, h height.
const Set no_units{"s", "min", "h"};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The words of a header, in small letters, without numbers: TimeStep_2 is time, step.
HeaderWords words_of(const std::string& name) {
  HeaderWords words(1);
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80U; };
  char before = ' ';
  for (const char c : name.substr(0, longest_header)) {
    const bool hump =
        std::isupper(static_cast<unsigned char>(c)) != 0 && std::islower(static_cast<unsigned char>(before)) != 0;
    if (!is_letter(static_cast<unsigned char>(c)) || hump) words.emplace_back();
    if (is_letter(static_cast<unsigned char>(c))) words.back() += c;
    before = c;
  }
  words.erase(std::remove(words.begin(), words.end(), ""), words.end());
  for (std::string& word : words) word = lower(word);
  return words;
}

bool any(const HeaderWords& words, const Set& set) {
  return std::any_of(words.begin(), words.end(), [&set](const std::string& word) { return set.count(word) != 0; });
}

bool all(const HeaderWords& words, const Set& set) {
  return std::all_of(words.begin(), words.end(), [&set](const std::string& word) { return set.count(word) != 0; });
}

bool is_of_time(const std::string& unit) {
  const auto known = unit_of(unit);
  return known && known->si == "s";
}

bool is_counter(const HeaderWords& words, const std::string& name, const std::string& unit) {
  if (!unit.empty() && unit != "1" && unit != "-" && unit != "#") return false;
  if (words.empty()) return name.empty() || name == "#";
  HeaderWords others = words;
  others.erase(std::remove_if(others.begin(), others.end(), [](const auto& word) { return times.count(word) != 0; }),
               others.end());
  return !others.empty() && all(others, others.size() < words.size() ? of_a_time : counters);
}

}  // namespace

std::string unit_of_time(const std::string& name, const std::string& unit) {
  for (const std::string& text : {unit, lower(unit)})
    if (is_of_time(text)) return text;
  if (!unit.empty()) return "";
  if (name.size() > 2 && (name.front() == '[' || name.front() == '(') && is_of_time(name.substr(1, name.size() - 2)))
    return name.substr(1, name.size() - 2);
  const HeaderWords words = words_of(name);
  if (words.size() == 1 && words.front().size() == name.size() && no_units.count(words.front()) == 0)
    return is_of_time(words.front()) ? words.front() : "";
  const bool names_a_time = words.size() > 1 && (times.count(words.front()) != 0 || words.front() == "t");
  return names_a_time && is_of_time(words.back()) ? words.back() : "";
}

HeaderSays header_says(const std::string& name, const std::string& unit) {
  HeaderWords words = words_of(name);
  const std::string of_time = unit_of_time(name, unit);
  if (of_time.empty() && is_counter(words, name, unit)) return HeaderSays::counter;
  if (any(words, lengths)) return HeaderSays::nothing;
  if (!unit.empty() && of_time.empty()) return HeaderSays::nothing;
  if (words.size() > 1 && words.back() == of_time) words.pop_back();
  if (any(words, stamps) || (any(words, clocks) && any(words, times))) return HeaderSays::another_clock;
  if (words.size() == 1 && times.count(words.front()) != 0) return HeaderSays::time;
  if (any(words, times)) return HeaderSays::kind_of_time;
  if (words == HeaderWords{"t"} && name.find_first_of("0123456789") == std::string::npos)
    return name.front() == 'T' ? HeaderSays::capital : HeaderSays::letter;
  return of_time.empty() ? HeaderSays::nothing : HeaderSays::unit_of_time;
}

}  // namespace upbead
