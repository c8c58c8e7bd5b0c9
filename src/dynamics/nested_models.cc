#include "upbead/dynamics/nested_models.h"

#include "dynamics/projection.h"
#include "dynamics/state_space.h"
#include "orthogonalise.h"
#include "upbead/dynamics/krylov.h"

namespace upbead {

namespace {

/// Further shifts, as multiples of s_0.
constexpr double low_shift = 1. / 8., high_shift = 8.;
/// Numbers of vectors, as multiples of the model's: all about s_0, and those about each further shift; for `middle`
/// and for `reference`.
constexpr double middle_share = 1.25, reference_share = 1.6, middle_aside = 0.35, reference_aside = 0.7;

/// Several spaces joined into one; the coordinates of the first one stay as they are.
class JoinedSpace {
 public:
  explicit JoinedSpace(const SecondOrderKrylov& first) : u_(first.displacements()), phi_(first.phi()) {}

  /// Adds the directions of another space that are new.
  void add(const SecondOrderKrylov& other) {
    add(u_, other.displacements());
    add(phi_, other.phi());
  }
  const FieldBasis& displacements() const { return u_; }
  const FieldBasis& phi() const { return phi_; }

 private:
  void add(FieldBasis& basis, const FieldBasis& other) {
    const Vector units = other.unit.cwiseQuotient(basis.unit);
    for (Eigen::Index j = 0; j < other.n(); ++j) {
      Vector y = units.cwiseProduct(other.vectors.col(j));
      const double length = basis.layout.norm(y);
      detail::orthogonalise(basis.columns(), y, basis.layout);
      if (basis.layout.norm(y) > detail::round_off * length)
        detail::add_column(basis, basis.layout.normalised(y), static_cast<int>(u_.n() + phi_.n()));
    }
  }

  FieldBasis u_, phi_;
};

/// The model with only those readings.
ModalModel with_readings(const ModalModel& all, const std::vector<int>& readings) {
  ModalModel model = all;
  model.reading = all.reading(readings, Eigen::all);
  model.feedthrough = all.feedthrough(readings, Eigen::all);
  model.impulse = all.impulse(readings, Eigen::all);
  model.reading_label.clear();
  for (const int i : readings) model.reading_label.push_back(all.reading_label[i]);
  return model;
}

void grow(SecondOrderKrylov& krylov, double vectors, const std::function<void(double)>& progress) {
  constexpr double nearly_done = 0.97;  // progress shown, as the model itself has been made
  while (krylov.n_vectors() < vectors && krylov.extend())
    if (progress) progress(nearly_done);
}

}  // namespace

NestedModels nested_models(const System& system, const NestedSpace& space, const std::vector<int>& readings,
                           const std::function<void(double)>& progress) {
  SecondOrderKrylov same(system, space.shift, space.exact), low(system, low_shift * space.shift, space.exact),
      high(system, high_shift * space.shift, space.exact);
  grow(same, space.vectors, progress);
  JoinedSpace joined(same);
  Projection projection(system, joined.displacements(), joined.phi(), space.shift);
  const auto model = [&](double share, double aside) {
    grow(same, share * space.vectors, progress);
    grow(low, aside * space.vectors, progress);
    grow(high, aside * space.vectors, progress);
    for (const SecondOrderKrylov* krylov : {&same, &low, &high}) joined.add(*krylov);
    projection.extend();
    return with_readings(modal_model(state_space(projection.reduced()), projection.reduced()), readings);
  };
  NestedModels models;
  models.middle = model(middle_share, middle_aside);
  models.reference = model(reference_share, reference_aside);
  models.solves = same.n_solves() + low.n_solves() + high.n_solves();
  models.factorisations = 3;
  return models;
}

}  // namespace upbead
