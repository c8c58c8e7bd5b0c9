// The parts of an accepted checkpoint are consistent.
#include "hdf5_changes.h"
#include "output/checkpoint_file.h"
#include "target.h"

namespace upbead::fuzz {

namespace {

State state_of(double value) {
  return {0.2, Vector::Constant(3, value), Vector::Constant(3, 2. * value), Vector::Constant(3, 3. * value)};
}

Series two_times() {
  return {{0., 0.2}, Eigen::MatrixXd::Ones(4, 2), Eigen::MatrixXd::Ones(2, 2)};
}

std::string sample() {
  CheckpointFile file;
  file.fingerprint = 0x123456789abcdef0U;
  file.march.so_far.ends = file.march.so_far.balanced = two_times();
  file.march.so_far.energy.resize(2);
  file.march.so_far.final_state = state_of(1.);
  file.march.memory = {{state_of(2.), {1., 2.}}, {1., 2.}, {3., 4.}, 0.1, {}};
  file.march.observed = {0., 0.2};
  file.fields = {{0., "fields/fields_0.vtu"}, {0.2, "fields/fields_1.vtu"}};
  return checkpoint_file("sample", file);
}

void check(const State& state) {
  require(state.v.size() == state.x.size() && state.a.size() == state.x.size(), "x, v and a of a state fit");
}

void check(const Series& series) {
  const auto n = static_cast<Eigen::Index>(series.time.size());
  require(series.reading.cols() == n && series.load.cols() == n, "a series is as long as its times");
}

}  // namespace

void try_checkpoint(std::string_view bytes) {
  static const std::string sound = sample();
  const std::string path = memory_file("checkpoint.h5", changed_hdf5(sound, bytes));
  read_or_refuse([&] {
    const CheckpointFile file = read_checkpoint(path);
    const Response& so_far = file.march.so_far;
    check(so_far.ends);
    check(so_far.balanced);
    require(so_far.n_steps >= 0, "there is a first time");
    check(so_far.final_state);
    check(file.march.memory.balanced.state);
    require(file.march.memory.balanced.state.x.size() == so_far.final_state.x.size(), "both states fit");
  });
}

}  // namespace upbead::fuzz
