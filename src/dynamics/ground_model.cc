#include "dynamics/ground_model.h"

#include "algebra/dense.h"

namespace upbead {

MarchedGround marched(const GroundModel& model, const GroundLevel& level) {
  const Eigen::Index r = level.n_free(), m = level.U.rows();
  const auto coupling = [&](const Eigen::MatrixXd& along) { return product(along, level.U.transpose()); };
  MarchedGround out{{},
                    {{level.M, level.C, level.K.col(0).asDiagonal()},
                     {coupling(level.M_f), coupling(level.C_f), coupling(level.K_f)},
                     model.of_interface,
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
