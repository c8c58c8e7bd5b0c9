#include "case/cfd/flow_rows.h"

#include <algorithm>

#include "base/text.h"
#include "case/cfd/flow_text.h"

namespace upbead {

std::vector<double> FlowRows::column(std::size_t c) const {
  std::vector<double> list(count());
  for (std::size_t row = 0; row < list.size(); ++row) list[row] = at(row, c);
  return list;
}

namespace {

/// Puts the mean of the rows [from, to) into row `into`.
void put_mean(FlowRows& rows, std::size_t from, std::size_t to, std::size_t into) {
  rows.time[into] = rows.time[from];
  for (std::size_t c = 0; c < rows.width; ++c) {
    double sum = 0.;
    for (std::size_t row = from; row < to; ++row) sum += rows.at(row, c);
    rows.value[into * rows.width + c] = from + 1 == to ? rows.at(from, c) : sum / static_cast<double>(to - from);
  }
}

void resize(FlowRows& rows, std::size_t count) {
  rows.time.resize(count);
  rows.value.resize(count * rows.width);
}

/// Whether `all` holds every row of `some` unchanged.
bool holds(const FlowRows& all, const FlowRows& some) {
  for (std::size_t row = 0; row < some.count(); ++row) {
    const auto at = std::lower_bound(all.time.begin(), all.time.end(), some.time[row]);
    if (at == all.time.end() || *at != some.time[row]) return false;
    const auto same = static_cast<std::size_t>(at - all.time.begin());
    for (std::size_t c = 0; c < all.width; ++c)
      if (all.at(same, c) != some.at(row, c)) return false;
  }
  return true;
}

}  // namespace

void settle(FlowRows& rows, const Place& place, FlowNotes& notes) {
  if (rows.count() == 0) throw InputError(place, "no row of numbers", "is the run over? name a file with rows");
  std::size_t kept = 0;
  for (std::size_t from = 0, to = 0; from < rows.count(); from = to) {
    for (to = from + 1; to < rows.count() && rows.time[to] == rows.time[from];) ++to;
    if (to < rows.count() && rows.time[to] < rows.time[from])
      throw InputError(place,
                       "t = " + significant(rows.time[to], 8) +
                           " s comes after t = " + significant(rows.time[from], 8) + " s: the times descend",
                       "let them ascend; runs that start anew have a folder each");
    put_mean(rows, from, to, kept++);
  }
  if (const std::size_t repeated = rows.count() - kept; repeated > 0)
    notes.push_back(std::to_string(repeated) + " of " + std::to_string(rows.count()) +
                    " rows repeat the time of the row before, in " + excerpt(place.file) + ": their mean is taken");
  resize(rows, kept);
}

void begin_piece(const FlowLines& lines, std::size_t width, std::vector<FlowPiece>& pieces) {
  FlowPiece piece{"the run from line " + std::to_string(lines.place().line) + " on", {width, {}, {}}};
  piece.rows.time.reserve(lines.rows_left());
  piece.rows.value.reserve(lines.rows_left() * width);
  pieces.push_back(std::move(piece));
}

FlowRows joined(std::vector<FlowPiece> pieces, FlowNotes& notes) {
  FlowRows all = std::move(pieces.front().rows);
  for (std::size_t p = 1; p < pieces.size(); ++p) {
    const FlowRows& next = pieces[p].rows;
    const auto first = std::lower_bound(all.time.begin(), all.time.end(), next.time.front());
    const auto kept = static_cast<std::size_t>(first - all.time.begin());
    const std::size_t lost = all.count() - kept;
    const double gap = kept > 0 ? next.time.front() - all.time[kept - 1] : 0.;
    const double step = kept > 1 ? (all.time[kept - 1] - all.time[0]) / static_cast<double>(kept - 1) : gap;
    resize(all, kept);
    all.time.insert(all.time.end(), next.time.begin(), next.time.end());
    all.value.insert(all.value.end(), next.value.begin(), next.value.end());
    notes.push_back(pieces[p].name + " goes on from t = " + significant(next.time.front(), 6) + " s" +
                    (lost > 0 ? ", in place of " + std::to_string(lost) + " rows of the run before" : ""));
    if (gap > 5. * step)
      notes.push_back("there is no row between the runs, for " + significant(gap) + " s; it is straight there");
  }
  return all;
}

std::vector<FlowPiece> without_repetitions(std::vector<FlowPiece> pieces, const Place& place, FlowNotes& notes) {
  std::vector<FlowPiece> kept;
  for (FlowPiece& next : pieces) {
    if (kept.empty() || !next.start || kept.back().rows.time.front() < *next.start) {
      kept.push_back(std::move(next));
      continue;
    }
    FlowPiece& last = kept.back();
    const bool last_holds = holds(last.rows, next.rows);
    if (!last_holds && !holds(next.rows, last.rows))
      throw InputError(place, last.name + " and " + next.name + " have the same start, and differ",
                       "remove the one that does not count");
    notes.push_back(next.name + " is a second one from " + significant(*next.start, 6) +
                    " s and says the same; the longer one is taken");
    if (!last_holds) last = std::move(next);
  }
  return kept;
}

FlowRows rows_of_file(std::vector<FlowPiece> runs, const Place& place, FlowNotes& notes) {
  if (runs.empty()) runs.emplace_back();  // settle() reports that there is none
  for (FlowPiece& run : runs) {
    settle(run.rows, place, notes);
    run.start = run.rows.time.front();
  }
  for (std::size_t r = 1; r < runs.size(); ++r)
    if (*runs[r].start < *runs[r - 1].start)
      throw InputError(place,
                       "a second head: " + runs[r].name + " begins at t = " + significant(*runs[r].start, 8) +
                           " s, before the run above it, at t = " + significant(*runs[r - 1].start, 8) + " s",
                       "give each run a folder of its own, named after the time of its start");
  return joined(without_repetitions(std::move(runs), place, notes), notes);
}

}  // namespace upbead
