#include "sample_soils.h"

#include "sample_model.h"

namespace upbead::test {

namespace {

const char* const sand = R"(gravity = 10.0

[fluid]
density = 1000.0

[regions.sand]
kind = "porous"
shear_modulus = 3e7
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 2e-1
flow = "darcy"
)";

/// Coordinates: x of the caisson, u of the sand, phi, whose rows are multiplied by -1.
ReducedFamily family() {
  ReducedFamily family;
  ReducedSystem& fixed = family.fixed;
  fixed.M = Eigen::Vector3d(6e5, 1e5, -1e-9).asDiagonal();
  fixed.C = Eigen::Matrix3d::Zero();
  fixed.C.topLeftCorner(2, 2) << 2e6, -1e6, -1e6, 3e6;
  fixed.C(1, 2) = fixed.C(2, 1) = 1.;
  fixed.K = Eigen::Matrix3d::Zero();
  fixed.load.setZero(3, 2);
  fixed.load.row(0).setOnes();
  fixed.prescribed = {-1, -1};
  fixed.is_phi = {false, false, true};
  fixed.shift = 50.;
  fixed.load_name = {"impact", "slow"};
  fixed.reading_label = {{"shear_force", "N/m", "F_T"}, {"probes/A/pressure", "Pa", "p"}, {"force", "N/m", "P"}};
  fixed.position.setZero(3, 3);
  fixed.velocity.setZero(3, 3);
  fixed.velocity(1, 2) = 1.;
  fixed.acceleration.setZero(3, 3);
  fixed.acceleration(0, 0) = -6e5;
  fixed.feedthrough.setZero(3, 2);
  fixed.feedthrough.row(0).setOnes();
  fixed.feedthrough.row(2).setOnes();
  ReducedSystem part = fixed;
  for (Eigen::MatrixXd* A :
       {&part.M, &part.C, &part.K, &part.load, &part.position, &part.velocity, &part.acceleration, &part.feedthrough})
    A->setZero();
  family.parts = {part, part};
  family.parts[0].K.topLeftCorner(2, 2) << 5., -5., -5., 8.;
  family.parts[1].C(2, 2) = -0.5;
  family.n_kept = 1;
  return family;
}

}  // namespace

SoilModelFile two_soils() {
  SoilModelFile model;
  model.frame = oscillator();
  model.box = {{"regions.sand.shear_modulus", 1e7, 1e8, true}, {"regions.sand.hydraulic_conductivity", 1e-2, 1., true}};
  model.regions_text = sand;
  SoilFamilyFile& f = model.family;
  f.terms = {{"sand", Coefficient::G}, {"sand", Coefficient::mobility}};
  f.reduced = family();
  f.names = {"shear_force", {"probes", std::string("A"), "pressure"}, "force"};
  f.training.time = {0., 0.075, 0.15, 4.};
  f.training.begin.setZero(2, 3);
  f.training.end.setZero(2, 3);
  f.training.end(0, 0) = f.training.begin(0, 1) = 1.6e6;
  f.training.end(1, 1) = f.training.begin(1, 2) = 4e5;
  f.tolerance = 1e-4;
  model.points = Eigen::RowVector2d(3e7, 2e-1);
  f.factors = Eigen::RowVector2d(3e7, 2e-5);
  f.estimates = {1e-3};
  return model;
}

}  // namespace upbead::test
