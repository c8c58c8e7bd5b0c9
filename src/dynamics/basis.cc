#include "dynamics/basis.h"

#include <algorithm>
#include <numeric>

#include "dynamics/slip_basis.h"
#include "dynamics/state_space.h"

namespace upbead {

namespace {

/// The fewest vectors per independent load from one look to the next, where a quarter of the present number is added if
/// that is more: a look takes the eigenvalues of a matrix four times as large as there are vectors.
constexpr int vectors_between_looks = 6;

int vectors_at_first(const ReduceOptions& options) {
  return std::min(options.first_vectors, options.max_vectors);
}

/// The coordinates that are kept as readings of their own, besides those of the system; -1 stands for one that stays
/// 0.
struct KeptCoordinates {
  std::vector<int> position, velocity, acceleration;

  Eigen::Index count() const {
    return static_cast<Eigen::Index>(position.size() + velocity.size() + acceleration.size());
  }
};

KeptCoordinates kept_coordinates(Kept kept, const ReducedSystem& system) {
  std::vector<int> all(static_cast<std::size_t>(system.size())), phi;
  std::iota(all.begin(), all.end(), 0);
  std::copy_if(all.begin(), all.end(), std::back_inserter(phi), [&](int i) { return system.is_phi[i]; });
  if (kept == Kept::none) return {};
  if (kept == Kept::pressures) return {{}, phi, {}};
  std::vector<int> moving = all;  // x'' of phi is never used, and x'' of a prescribed x' is in no model
  for (const int i : phi) moving[i] = -1;
  return {all, all, moving};
}

/// The system with the kept coordinates as its last readings.
ReducedSystem with_coordinates(ReducedSystem system, const KeptCoordinates& kept) {
  Eigen::Index row = system.velocity.rows();
  const Eigen::Index n = row + kept.count();
  for (Eigen::MatrixXd* rows : {&system.position, &system.velocity, &system.acceleration, &system.feedthrough})
    rows->conservativeResizeLike(Eigen::MatrixXd::Zero(n, rows->cols()));
  for (const auto& [rows, coordinates] : {std::pair{&system.position, &kept.position},
                                          {&system.velocity, &kept.velocity},
                                          {&system.acceleration, &kept.acceleration}})
    for (const int i : *coordinates) {
      if (i >= 0) (*rows)(row, i) = 1.;
      ++row;
    }
  system.reading_label.resize(static_cast<std::size_t>(n));
  return system;
}

/// Splits off the last n readings as a model of their own.
Modes split_last(ModalModel model, Eigen::Index n) {
  ModalModel last = model;
  const Eigen::Index rest = model.reading.rows() - n;
  const auto split = [rest, n](auto& from, auto& to) {
    to = from.bottomRows(n).eval();
    from.conservativeResize(rest, Eigen::NoChange);
  };
  split(model.reading, last.reading);
  split(model.feedthrough, last.feedthrough);
  split(model.impulse, last.impulse);
  last.reading_label.assign(static_cast<std::size_t>(n), {});
  model.reading_label.resize(static_cast<std::size_t>(rest));
  return {std::move(model), std::move(last)};
}

FieldBasis first_directions(const FieldBasis& basis, Eigen::Index n) {
  return {basis.unknown,
          basis.unit,
          basis.vectors.leftCols(n),
          {basis.coordinate.begin(), basis.coordinate.begin() + n},
          basis.layout};
}

}  // namespace

Kept kept_by(const ReduceOptions& options) {
  return options.keep_states ? Kept::states : options.keep_pressures ? Kept::pressures : Kept::none;
}

GrowingBasis::GrowingBasis(const System& system, const ReduceOptions& options)
    : first_(vectors_at_first(options)),
      exact_(options.exact),
      kept_(options.kept),
      krylov_(system, options.shift, options.exact, options.kept),
      projection_(system, krylov_) {}

bool GrowingBasis::serves(const ReduceOptions& options) const {
  return !broken_ && options.shift == krylov_.shift() && options.exact == exact_ && options.kept == kept_ &&
         vectors_at_first(options) == first_;
}

bool GrowingBasis::is_about(double shift, const std::vector<int>& exact) const {
  return !broken_ && shift == krylov_.shift() && exact == exact_ && kept_.empty();
}

void GrowingBasis::grow(const std::function<void(int)>& progress) {
  const int target = made_.empty() ? first_ * n_independent_loads() : made_.back().look.next;
  Look look;
  while (krylov_.n_vectors() < target && !look.exhausted) {
    look.exhausted = !krylov_.extend();
    if (progress) progress(krylov_.n_vectors());
  }
  projection_.extend();
  look.n_vectors = krylov_.n_vectors();
  look.n_solves = krylov_.n_solves();
  look.next = target + std::max(vectors_between_looks * n_independent_loads(), target / 4);
  look.n_displacements = krylov_.displacements().n();
  look.n_phi = krylov_.phi().n();
  look.system = projection_.reduced();
  made_.push_back({std::move(look), {}});
}

const Look& GrowingBasis::look(std::size_t number, const std::function<void(int)>& progress) {
  while (made_.size() <= number) {
    broken_ = true;  // until the look is whole
    grow(progress);
    broken_ = false;
  }
  return made_[number].look;
}

const Look& GrowingBasis::reach(int n_vectors, const std::function<void(int)>& progress) {
  for (std::size_t number = 0;; ++number)
    if (const Look& made = look(number, progress); made.n_vectors >= n_vectors || made.exhausted) return made;
}

const Modes& GrowingBasis::modes(std::size_t number, Kept kept) {
  Made& made = made_.at(number);
  std::optional<Modes>& modes = made.modes[static_cast<std::size_t>(kept)];
  if (modes) return *modes;
  const KeptCoordinates coordinates = kept_coordinates(kept, made.look.system);
  const ReducedSystem& system = made.look.system;
  const ReducedSystem with_kept = coordinates.count() > 0 ? with_coordinates(system, coordinates) : system;
  return modes.emplace(split_last(modal_model(state_space(with_kept), with_kept), coordinates.count()));
}

FieldBasis GrowingBasis::displacements(const Look& look) const {
  return first_directions(krylov_.displacements(), look.n_displacements);
}

FieldBasis GrowingBasis::phi(const Look& look) const {
  return first_directions(krylov_.phi(), look.n_phi);
}

std::shared_ptr<GrowingBasis> BasisRoom::basis(const System& system, const ReduceOptions& options) {
  if (basis_ && basis_->serves(options)) return basis_;
  slip_.reset();
  basis_.reset();  // before the new one takes its memory
  return basis_ = std::make_shared<GrowingBasis>(system, options);
}

std::shared_ptr<GrowingBasis> BasisRoom::basis_about(double shift, const std::vector<int>& exact) const {
  return basis_ && basis_->is_about(shift, exact) ? basis_ : nullptr;
}

void BasisRoom::keep(const std::shared_ptr<SlipBasis>& slip) {
  if (slip && slip->bonded() == basis_) slip_ = slip;
}

}  // namespace upbead
