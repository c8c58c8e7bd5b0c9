#include "base/parts.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "base/journal.h"
#include "base/launch.h"
#include "base/work_lock.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

constexpr int most_parts = 100000;

/// Reads a whole number at `at`, and moves on behind it; 0 where there is none.
int number_at(const std::string& text, std::size_t& at) {
  const std::size_t begin = at;
  while (at < text.size() && at < begin + 9 && text[at] >= '0' && text[at] <= '9') ++at;
  return at == begin ? 0 : std::atoi(text.substr(begin, at - begin).c_str());
}

}  // namespace

std::string Part::text() const {
  return std::to_string(number) + "/" + std::to_string(of);
}

std::string Part::name() const {
  return "part-" + std::to_string(number) + "-of-" + std::to_string(of);
}

Part read_part(const std::string& text) {
  Part part;
  std::size_t at = 0;
  part.number = number_at(text, at);
  const bool has_bar = at < text.size() && text[at] == '/';
  part.of = number_at(text, ++at);
  if (!has_bar || at != text.size() || part.number < 1 || part.number > part.of || part.of > most_parts)
    throw InputError({"--part " + text}, "is no part",
                     "write K/N with K from 1 to N, and N at most " + std::to_string(most_parts) + ", as in 3/100");
  return part;
}

Part part_of_launch() {
  const std::optional<Launch> launch = launch_of_environment();
  const Launch mine = launch && launch->size > 1 ? *launch : launch_of_array();
  return {mine.rank + 1, mine.size};
}

std::vector<Pieces> dealt_in_stretches(int n, int parts) {
  std::vector<Pieces> dealt;
  const auto end = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(n) * k / parts); };
  for (int k = 0; k < parts; ++k) {
    std::vector<int> stretch;
    for (int i = end(k); i < end(k + 1); ++i) stretch.push_back(i);
    dealt.push_back({stretch});
  }
  return dealt;
}

std::optional<int> parts_begun(const std::string& output_folder) {
  std::optional<int> most;
  std::error_code code;  // without the folder no part has begun
  for (fs::directory_iterator entry(journal_folder(output_folder), code), end; !code && entry != end;
       entry.increment(code)) {
    const std::string file = entry->path().filename().string(), mark = "-of-";
    std::size_t at = file.find(mark);
    if (file.find("part-") == std::string::npos || at == std::string::npos) continue;
    at += mark.size();
    if (const int of = number_at(file, at); of > most.value_or(0)) most = of;
  }
  return most;
}

std::vector<MissingRuns> missing_parts(const std::string& output_folder, const std::vector<Pieces>& dealt,
                                       const std::function<bool(int)>& has_result) {
  std::vector<MissingRuns> list;
  for (std::size_t k = 0; k < dealt.size(); ++k) {
    const Part part{static_cast<int>(k) + 1, static_cast<int>(dealt.size())};
    MissingRuns missing{part.text(), {}, holder_of(output_folder, part.lock()), ""};
    for (const std::vector<int>& piece : dealt[k])
      for (const int run : piece)
        if (!has_result(run)) missing.runs.push_back(run);
    if (missing.runs.empty()) continue;
    std::sort(missing.runs.begin(), missing.runs.end());
    list.push_back(missing);
  }
  return list;
}

}  // namespace upbead
