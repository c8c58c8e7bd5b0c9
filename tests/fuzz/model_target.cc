// The parts of an accepted reduced model are consistent and finite.
#include "hdf5_changes.h"
#include "output/sample_model.h"
#include "output/sample_soils.h"
#include "respond/wave_files.h"
#include "soils/soil_answers.h"
#include "target.h"

namespace upbead::fuzz {

namespace {

ReducedModelFile slipping_model() {
  ReducedModelFile model = test::oscillator();
  model.sliding = ModelSliding{0.6, 4e6, 0., "in_phase", 0.2, 0.01};
  model.slip = test::slipping_oscillator();
  model.circles = test::circles_under_an_oscillator();
  return model;
}

template <class Matrix>
void require_matrix(const Matrix& matrix, std::size_t rows, std::size_t columns) {
  require(static_cast<std::size_t>(matrix.rows()) == rows && static_cast<std::size_t>(matrix.cols()) == columns,
          "the matrices of a model fit together");
  require(matrix.allFinite(), "the matrices of a model are finite");
}

void check(const ModalModel& modes) {
  const auto m = static_cast<std::size_t>(modes.n_modes());
  const std::size_t k = modes.load_name.size(), i = modes.reading_label.size();
  require_matrix(modes.load, m, k);
  require_matrix(modes.reading, i, m);
  require_matrix(modes.feedthrough, i, k);
  require_matrix(modes.impulse, i, k);
  require(modes.pole.allFinite() && (m == 0 || modes.pole.real().maxCoeff() <= 0.), "no mode grows");
}

void check(const ReducedSystem& system) {
  const auto r = static_cast<std::size_t>(system.size());
  const std::size_t k = system.load_name.size(), i = system.reading_label.size();
  for (const Eigen::MatrixXd* matrix : {&system.M, &system.C, &system.K}) require_matrix(*matrix, r, r);
  for (const Eigen::MatrixXd* matrix : {&system.position, &system.velocity, &system.acceleration})
    require_matrix(*matrix, i, r);
  require_matrix(system.load, r, k);
  require_matrix(system.feedthrough, i, k);
  require(system.is_phi.size() == r && system.prescribed.size() == k, "the lists of a slip fit together");
  for (const int p : system.prescribed) require(p >= -1 && p < system.size(), "prescribed coordinates exist");
}

void read(const std::string& image) {
  const std::string path = memory_file("model.h5", image);
  read_or_refuse([&] {
    const ReducedModelFile model = read_model_file(path);
    check(model.modes);
    require(model.loads.size() == model.modes.load_name.size(), "every load of a model is known");
    if (model.slip) check(model.slip->system);
    if (!model.circles) return;
    check(model.circles->pressures);
    require(model.circles->family.n_readings() == static_cast<std::size_t>(model.circles->pressures.n_readings()),
            "every slice of a circle has its reading");
  });
}

}  // namespace

void try_model(std::string_view bytes) {
  static const std::string sound = model_file(slipping_model());
  read(changed_hdf5(sound, bytes));
}

void try_soil_model(std::string_view bytes) {
  static const std::string sound = soil_model_file(test::two_soils());
  const std::string path = memory_file("soils.h5", changed_hdf5(sound, bytes));
  read_or_refuse([&] {
    const SoilAnswers answers(read_soil_model_file(path), path);
    const SoilFamilyFile& family = answers.file().family;
    check(family.reduced.fixed);
    require(family.reduced.parts.size() == family.terms.size(), "every part has its coefficient");
    const ReducedSystem member = family.reduced.bonded(answers.factors(answers.whole({})));
    check(member);
    require(member.size() == family.reduced.fixed.size() - (family.reduced.slips() ? 1 : 0), "a slip is held");
  });
}

void try_model_bytes(std::string_view bytes) {
  read(std::string(bytes));
}

void try_wave_file(std::string_view bytes) {
  static const std::string sound = sample_waves();
  const std::string path = memory_file("waves.h5", changed_hdf5(sound, bytes));
  read_or_refuse([&] {
    const WaveFile file = read_wave_files({path}, {"impact", "slow"}).front();
    require(file.value.allFinite(), "waves are finite");
    require(file.value.cols() == static_cast<Eigen::Index>(file.time.size()), "waves are as long as their times");
    require(file.value.rows() % file.n_loads == 0, "every wave has all loads");
  });
}

}  // namespace upbead::fuzz
