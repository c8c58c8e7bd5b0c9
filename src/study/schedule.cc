#include "study/parts.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>

#include "base/text.h"

namespace upbead {

namespace {

/// What runs can share: those with equal lists up to `mesh` share a mesh, and so on, up to `basis` a basis, up to
/// `solved` a solution. Only the order of runs follows from it: Runner looks at what the keys make.
struct Likeness {
  int case_index;
  std::vector<Setting> mesh, system, basis, solved;
  int run;

  auto of_basis() const { return std::tie(case_index, mesh, system, basis); }
  auto of_solution() const { return std::tie(case_index, mesh, system, basis, solved); }
  bool operator<(const Likeness& other) const {
    return std::tuple_cat(of_solution(), std::tie(run)) < std::tuple_cat(other.of_solution(), std::tie(other.run));
  }
};

bool ends_with(const std::string& text, const std::string& part) {
  return text.size() >= part.size() && text.compare(text.size() - part.size(), part.size(), part) == 0;
}

/// The list of the last stage that most likely stays where the key changes; none: what is only told.
std::vector<Setting> Likeness::*list_of(const std::string& key) {
  if (starts_with(key, "mesh")) return &Likeness::mesh;
  if (starts_with(key, "sliding") || starts_with(key, "limits")) return nullptr;
  if (starts_with(key, "loads"))
    return ends_with(key, "peak") || ends_with(key, "factor") ? &Likeness::solved : &Likeness::basis;
  for (const char* course : {"time", "accuracy", "output"})
    if (starts_with(key, course)) return &Likeness::basis;
  return &Likeness::system;
}

Likeness likeness_of(const StudyRun& run, int number) {
  Likeness likeness{run.case_index, {}, {}, {}, {}, number};
  for (const Setting& setting : run.settings)
    if (const auto list = list_of(setting.first)) (likeness.*list).push_back(setting);
  return likeness;
}

/// All runs, in an order in which each often takes over much of the one before.
std::vector<Likeness> in_order(const Study& study) {
  std::vector<Likeness> places;
  for (std::size_t i = 0; i < study.runs.size(); ++i) places.push_back(likeness_of(study.runs[i], static_cast<int>(i)));
  std::sort(places.begin(), places.end());
  return places;
}

/// Runs that share a basis, or some of them where they are many.
struct Bundle {
  Pieces pieces;
  std::size_t runs = 0;
};

/// Adds a piece to the last bundle, or to a new one: where that would have more than `most` runs, or where the piece
/// begins another basis. A piece of more runs is cut.
void add(const std::vector<int>& piece, bool begins_basis, std::size_t most, std::vector<Bundle>& bundles) {
  const std::size_t cuts = (piece.size() + most - 1) / most;
  for (std::size_t c = 0; c < cuts; ++c) {
    const auto from = static_cast<std::ptrdiff_t>(piece.size() * c / cuts),
               to = static_cast<std::ptrdiff_t>(piece.size() * (c + 1) / cuts);
    const auto n = static_cast<std::size_t>(to - from);
    if ((begins_basis && c == 0) || bundles.back().runs + n > most) bundles.emplace_back();
    bundles.back().pieces.emplace_back(piece.begin() + from, piece.begin() + to);
    bundles.back().runs += n;
  }
}

std::vector<Bundle> bundles_of(const std::vector<Likeness>& places, std::size_t most) {
  std::vector<Bundle> bundles;
  for (std::size_t i = 0, end = 0; i < places.size(); i = end) {
    std::vector<int> piece;
    for (end = i; end < places.size() && places[end].of_solution() == places[i].of_solution(); ++end)
      piece.push_back(places[end].run);
    add(piece, i == 0 || places[i].of_basis() != places[i - 1].of_basis(), most, bundles);
  }
  return bundles;
}

}  // namespace

Pieces schedule(const Study& study, const Results& results) {
  Pieces pieces;
  for (const Bundle& bundle : bundles_of(in_order(study), study.runs.size()))
    pieces.insert(pieces.end(), bundle.pieces.begin(), bundle.pieces.end());
  return without_done(pieces, results);
}

Pieces without_done(const Pieces& pieces, const Results& results) {
  Pieces left;
  for (const std::vector<int>& piece : pieces) {
    std::vector<int> runs;
    std::copy_if(piece.begin(), piece.end(), std::back_inserter(runs),
                 [&results](int run) { return !results[static_cast<std::size_t>(run)]; });
    if (!runs.empty()) left.push_back(runs);
  }
  return left;
}

std::vector<Pieces> deal(const Study& study, int parts) {
  const auto n = static_cast<std::size_t>(parts);
  const std::size_t fair = (study.runs.size() + n - 1) / n;
  // half a share: parts differ by no more, and few bases are made twice
  const std::vector<Bundle> bundles = bundles_of(in_order(study), std::max<std::size_t>(1, fair / 2));
  std::vector<std::size_t> by_size(bundles.size());
  std::iota(by_size.begin(), by_size.end(), 0);
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&bundles](std::size_t a, std::size_t b) { return bundles[a].runs > bundles[b].runs; });
  std::set<std::pair<std::size_t, std::size_t>> loads;  // runs of a part, its number
  for (std::size_t k = 0; k < n; ++k) loads.emplace(0, k);
  std::vector<std::size_t> part_of(bundles.size());
  for (const std::size_t b : by_size) {  // the largest first, to the part that has least
    const auto [load, k] = *loads.begin();
    loads.erase(loads.begin());
    loads.emplace(load + bundles[b].runs, k);
    part_of[b] = k;
  }
  std::vector<Pieces> dealt(n);
  for (std::size_t b = 0; b < bundles.size(); ++b)
    dealt[part_of[b]].insert(dealt[part_of[b]].end(), bundles[b].pieces.begin(), bundles[b].pieces.end());
  return dealt;
}

}  // namespace upbead
