#include "dynamics/ground_model.h"

#include "algebra/dense.h"

namespace upbead {

namespace {

/// How many of the first coordinates M couples with no other.
Eigen::Index n_uncoupled(const Eigen::MatrixXd& M) {
  Eigen::Index n = 0;
  while (n < M.cols() && M.col(n).head(n).isZero(0.) && M.col(n).tail(M.rows() - n - 1).isZero(0.)) ++n;
  return n;
}

}  // namespace

MarchedGround marched(const GroundModel& model, const GroundLevel& level) {
  const Eigen::Index r = level.n_free(), m = level.U.rows();
  const auto coupling = [&](const Eigen::MatrixXd& along) { return product(along, level.U.transpose()); };
  MarchedGround out{{},
                    {{level.M, level.C, level.K.col(0).asDiagonal()},
                     {coupling(level.M_f), coupling(level.C_f), coupling(level.K_f)},
                     model.of_interface,
                     level.U,
                     n_uncoupled(level.M),
                     model.shift}};
  System& system = out.system;
  system.M = system.C = system.K = SparseMatrix(r + m, r + m);
  system.field.assign(static_cast<std::size_t>(r + m), Field::displacement);
  for (std::size_t i = 0; i < level.is_phi.size(); ++i)
    if (level.is_phi[i]) system.field[i] = Field::pressure_impulse;
  for (Eigen::Index k = 0; k < level.load.cols(); ++k)
    system.loads.push_back({model.demand.load_name[static_cast<std::size_t>(k)], level.load.col(k), {}});
  system.n_prescribed = static_cast<int>(m);
  system.interface = model.interface;
  return out;
}

}  // namespace upbead
