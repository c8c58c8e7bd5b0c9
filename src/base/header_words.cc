#include "base/header_words.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "base/units.h"

namespace upbead {

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

namespace {

/// The unit as it is written, or where a whole end of a name is in capitals or small letters, as its only other way of
/// writing: KN/M, kpa. Not with a first m, which may be milli or mega.
std::optional<std::string> unit_in_any_letters(std::string text) {
  for (const char* per : {"_per_", " per ", "_p_"})
    if (const std::size_t at = text.find(per); at != std::string::npos)
      text.replace(at, std::string_view(per).size(), "/");
  std::replace(text.begin(), text.end(), '_', '/');
  const std::string small = lower(text);
  const bool one_case =
      small == text || std::none_of(text.begin(), text.end(), [](unsigned char c) { return std::islower(c) != 0; });
  for (const char* known :
       {"kPa", "Pa", "hPa", "kN/m", "N/m", "kN/m2", "N/m2", "kN", "N/mm2", "psi", "bar", "cm/s2", "cm", "cm/s"})
    if (one_case && lower(known) == small) return known;
  if (unit_of(text)) return text;
  return {};
}

}  // namespace

namespace {

/// Whether the letter that ends here is a Chinese, Japanese or Korean one (U+3000 to U+D7FF), and one of ASCII follows.
bool ends_a_wide_letter(const std::string& name, std::size_t at) {
  const auto byte = [&name](std::size_t i) { return static_cast<unsigned char>(name[i]); };
  return at >= 2 && byte(at) >= 0x80U && byte(at - 2) >= 0xE3U && byte(at - 2) <= 0xEDU && byte(at + 1) < 0x80U;
}

}  // namespace

std::optional<UnitAtEnd> unit_at_end(const std::string& name) {
  constexpr std::size_t longest_end = 20;
  for (std::size_t at = name.size() > longest_end ? name.size() - longest_end : 1; at + 1 < name.size(); ++at) {
    if (std::string_view("_ .-").find(name[at]) == std::string_view::npos && !ends_a_wide_letter(name, at)) continue;
    const auto unit = unit_in_any_letters(name.substr(at + 1));
    if (!unit || unit_of(*unit)->si == "1") continue;
    const std::size_t last = name.find_last_not_of("_ .-", at);
    if (last == std::string::npos) continue;
    const std::size_t word = name.find_last_of(" _", last);  // "at 300 Hz" is a value, no unit of a column
    if (name.find_first_not_of("0123456789.,", word == std::string::npos ? 0 : word + 1) > last) continue;
    return UnitAtEnd{name.substr(0, last + 1), *unit, *unit_of(*unit)};
  }
  return {};
}

namespace {

/// Whether a number stands before this place: "at 50 kPa" is a value, no unit of a column.
bool follows_a_number(const std::string& name, std::size_t at) {
  const std::size_t last = at == 0 ? std::string::npos : name.find_last_not_of(" _", at - 1);
  return last != std::string::npos && last + 1 < at && std::isdigit(static_cast<unsigned char>(name[last])) != 0;
}

/// Whether a number follows that is none of an exponent: MN1 and KN-2 are names of gauges.
bool has_a_number(const std::string& name, std::size_t end) {
  const std::size_t at = end < name.size() && name[end] == '-' ? end + 1 : end;
  return at < name.size() && std::isdigit(static_cast<unsigned char>(name[at])) != 0;
}

}  // namespace

std::string unread_unit(const std::string& name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto is_small = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
  for (const std::string_view unit : {"kN", "KN", "MN", "kNm", "KNm", "MNm", "kPa", "KPa", "KPA", "kpa", "MPa", "MPA",
                                      "mbar", "hPa", "HPA", "kgf", "mWS"})
    for (std::size_t at = name.find(unit); at != std::string::npos; at = name.find(unit, at + 1)) {
      const bool begins = at == 0 || !is_letter(name[at - 1]) || (is_small(name[at - 1]) && !is_small(unit.front()));
      const std::size_t end = at + unit.size();
      if (begins && (end == name.size() || !is_letter(name[end])) && !has_a_number(name, end) &&
          !follows_a_number(name, at))
        return std::string(unit);
    }
  for (const char* unit : {"pascal", "newton", "millibar"})
    if (lower(name).find(unit) != std::string::npos) return unit;
  return "";
}

bool may_be_a_name(const std::string& unit) {
  static const Set names{"s", "m", "h", "g", "G", "min", "sec", "deg", "rad", "bar", "gal", "Gal"};
  return names.count(unit) != 0;
}

}  // namespace upbead
