#include "run/accuracy/side_by_side.h"

#include <algorithm>
#include <string>
#include <utility>

#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Share of the difference by which it may change from one look to the next.
constexpr double settled_part = 0.05;

double largest_of(const Eigen::VectorXd& values) {
  return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.;
}

/// Whether in each list the difference of both models has changed little since the last look.
bool is_settled(const SideBySide& last, const SideBySide& now, double enough) {
  for (std::size_t i = 0; i < now.coarse.size(); ++i) {
    const Eigen::VectorXd before = last.finer[i] - last.coarse[i], after = now.finer[i] - now.coarse[i];
    const double most = std::max(settled_part * largest_of(after), enough * largest_of(now.finer[i]));
    if (!(largest_of(after - before) <= most)) return false;
  }
  return true;
}

/// What a process does for itself: where it fails on one, all throw.
bool grown_by_itself(GrowingModel& model, const Layout& among) {
  bool grew = false;
  std::string failed;
  try {
    grew = model.grow();
  } catch (const NumericsError& error) {
    failed = error.what();
  }
  if (among.largest(failed.empty() ? 0. : 1.) > 0.)
    throw NumericsError(failed.empty() ? "another process could not enlarge its model" : failed);
  return grew;
}

}  // namespace

std::optional<SideBySide> grow_side_by_side(GrowingModel& coarse, GrowingModel& finer, const ReadModel& read,
                                            double enough, const Layout& among) {
  std::optional<SideBySide> last;
  for (;;) {
    const bool coarse_grew = coarse.grow(), finer_grew = grown_by_itself(finer, among);
    if (!among.first_says(coarse_grew || finer_grew)) break;
    std::optional<SideBySide> now;
    try {
      now = SideBySide{read(coarse), read(finer)};
    } catch (const NumericsError&) {
      // too few vectors to evaluate the model
    }
    if (among.largest(now ? 0. : 1.) > 0.) now.reset();
    const bool known = coarse.reduction().converged && finer.reduction().converged;
    if (among.first_says(now && (known || (last && is_settled(*last, *now, enough))))) return now;
    last = std::move(now);
  }
  return std::nullopt;
}

void grow_to_its_end(GrowingModel& model, const Layout& among) {
  while (!among.first_says(model.reduction().converged) && model.grow()) {
  }
}

}  // namespace upbead
