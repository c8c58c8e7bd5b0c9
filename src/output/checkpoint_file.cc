#include "output/checkpoint_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hdf5_image.h"
#include "output/hdf5_reader.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using detail::Hdf5Image;
using Numbers = std::vector<double>;

constexpr std::array energy_terms = {&EnergyAccount::work,     &EnergyAccount::kinetic, &EnergyAccount::strain,
                                     &EnergyAccount::fluid,    &EnergyAccount::lifted,  &EnergyAccount::drag,
                                     &EnergyAccount::damping,  &EnergyAccount::scheme,  &EnergyAccount::radiated,
                                     &EnergyAccount::friction, &EnergyAccount::plastic, &EnergyAccount::largest_work};

Numbers packed(const std::vector<EnergyAccount>& accounts) {
  Numbers values;
  for (const EnergyAccount& account : accounts)
    for (const auto term : energy_terms) values.push_back(account.*term);
  return values;
}

std::vector<EnergyAccount> unpacked(const Numbers& values) {
  std::vector<EnergyAccount> accounts(values.size() / energy_terms.size());
  auto next = values.begin();
  for (EnergyAccount& account : accounts)
    for (const auto term : energy_terms) account.*term = *next++;
  return accounts;
}

/// The two halves of 32 bits each, as numbers that a double holds exactly.
Numbers halves(std::uint64_t value) {
  return {static_cast<double>(value >> 32U), static_cast<double>(value & 0xffffffffU)};
}

class Writer {
 public:
  explicit Writer(const std::string& title) : image_(title) {}
  void add(const std::string& path, const Numbers& values) { add(path, {values.size()}, values.data()); }
  void add(const std::string& path, const Vector& values) {
    add(path, {static_cast<hsize_t>(values.size())}, values.data());
  }
  /// Adds a matrix column by column, so that each row of the dataset belongs to one time.
  void add(const std::string& path, const Eigen::MatrixXd& values) {
    add(path, {static_cast<hsize_t>(values.cols()), static_cast<hsize_t>(values.rows())}, values.data());
  }
  void add(const std::string& path, const State& state) {
    add(path + "/time", Numbers{state.time});
    add(path + "/x", state.x);
    add(path + "/v", state.v);
    add(path + "/a", state.a);
  }
  void add(const std::string& path, const Series& series) {
    add(path + "/time", series.time);
    add(path + "/reading", series.reading);
    add(path + "/load", series.load);
  }
  Hdf5Image& image() { return image_; }

 private:
  void add(const std::string& path, const std::vector<hsize_t>& shape, const double* values) {
    image_.numbers(path, shape, values, {"", ""});
  }
  Hdf5Image image_;
};

/// Reads a checkpoint; refuses a file that lacks any part.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), file_(path, "a checkpoint of 'upbead run --checkpoint'") {}

  NumberArray array(const std::string& path, std::size_t rank) const {
    std::optional<NumberArray> found = file_.numbers(path);
    if (!found || found->shape.size() != rank) damaged(path);
    return std::move(*found);
  }
  Numbers numbers(const std::string& path) const { return array(path, 1).values; }
  double number(const std::string& path) const {
    const Numbers values = numbers(path);
    if (values.size() != 1) damaged(path);
    return values.front();
  }
  /// A list of n whole numbers, each from 0 to `most`.
  std::vector<std::uint64_t> whole_numbers(const std::string& path, std::size_t n, double most) const {
    const Numbers values = numbers(path);
    const auto is_whole = [most](double value) { return value >= 0. && value <= most && value == std::floor(value); };
    if (values.size() != n || !std::all_of(values.begin(), values.end(), is_whole)) damaged(path);
    return {values.begin(), values.end()};
  }
  Vector vector(const std::string& path) const {
    const Numbers values = numbers(path);
    return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
  Eigen::MatrixXd matrix(const std::string& path) const {
    const NumberArray found = array(path, 2);
    // an empty matrix may claim any number of rows or columns
    for (const std::size_t size : found.shape)
      if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) damaged(path);
    return Eigen::Map<const Eigen::MatrixXd>(found.values.data(), static_cast<Eigen::Index>(found.shape[1]),
                                             static_cast<Eigen::Index>(found.shape[0]));
  }
  State state(const std::string& path) const {
    State found{number(path + "/time"), vector(path + "/x"), vector(path + "/v"), vector(path + "/a")};
    if (found.v.size() != found.x.size() || found.a.size() != found.x.size()) damaged(path);
    return found;
  }
  /// A series whose matrices have as many columns as there are times.
  Series series(const std::string& path) const {
    Series found{numbers(path + "/time"), matrix(path + "/reading"), matrix(path + "/load")};
    const auto n = static_cast<Eigen::Index>(found.time.size());
    if (found.reading.cols() != n || found.load.cols() != n) damaged(path);
    return found;
  }
  std::vector<std::string> texts(const std::string& path) const {
    return file_.texts(path).value_or(std::vector<std::string>());
  }
  bool is_as_written() const { return file_.checksum_holds().value_or(true); }
  [[noreturn]] void damaged(const std::string& path) const {
    throw InputError({path_}, "the checkpoint is damaged at " + path, "remove its folder and begin from the start");
  }

 private:
  std::string path_;
  Hdf5Reader file_;
};

}  // namespace

std::string checkpoint_file(const std::string& title, const CheckpointFile& checkpoint) {
  const Response& so_far = checkpoint.march.so_far;
  const SchemeMemory& memory = checkpoint.march.memory;
  Writer out(title);
  out.add("/fingerprint", halves(checkpoint.fingerprint));
  out.add("/ends", so_far.ends);
  out.add("/balanced", so_far.balanced);
  out.add("/inside", so_far.inside);
  out.add("/energy", packed(so_far.energy));
  out.add("/state", so_far.final_state);
  out.add("/solves", Numbers{static_cast<double>(so_far.n_solves)});
  out.add("/memory/balanced", memory.balanced.state);
  out.add("/memory/balanced/load", memory.balanced.load);
  out.add("/memory/end_load", memory.end_load);
  out.add("/memory/history", memory.history);
  out.add("/memory/last_step", Numbers{memory.last_step});
  out.add("/memory/energy", packed({memory.energy}));
  out.add("/observed", checkpoint.march.observed);
  Numbers time;
  std::vector<std::string> names;
  for (const auto& [t, name] : checkpoint.fields) {
    time.push_back(t);
    names.push_back(name);
  }
  out.add("/fields/time", time);
  out.image().texts("/fields/name", names);
  out.image().seal();
  return out.image().bytes();
}

CheckpointFile read_checkpoint(const std::string& path) {
  const Reader in(path);
  CheckpointFile file;
  const std::vector<std::uint64_t> print = in.whole_numbers("/fingerprint", 2, 0xffffffffU);
  file.fingerprint = (print[0] << 32U) | print[1];
  Response& so_far = file.march.so_far;
  so_far.ends = in.series("/ends");
  so_far.balanced = in.series("/balanced");
  so_far.inside = in.series("/inside");
  so_far.energy = unpacked(in.numbers("/energy"));
  so_far.final_state = in.state("/state");
  so_far.n_steps = static_cast<int>(so_far.ends.time.size()) - 1;
  so_far.n_solves = static_cast<int>(in.whole_numbers("/solves", 1, std::numeric_limits<int>::max()).front());
  if (so_far.ends.time.empty()) in.damaged("/ends/time");
  const Numbers energy = in.numbers("/memory/energy");
  if (energy.size() != energy_terms.size()) in.damaged("/memory/energy");
  file.march.memory = {{in.state("/memory/balanced"), in.numbers("/memory/balanced/load")},
                       in.numbers("/memory/end_load"),
                       in.numbers("/memory/history"),
                       in.number("/memory/last_step"),
                       unpacked(energy).front()};
  if (file.march.memory.balanced.state.x.size() != so_far.final_state.x.size()) in.damaged("/memory/balanced");
  file.march.observed = in.numbers("/observed");
  const Numbers time = in.numbers("/fields/time");
  const std::vector<std::string> names = in.texts("/fields/name");
  if (time.size() != names.size()) in.damaged("/fields");
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (names[i].rfind("fields/", 0) != 0 || names[i].find("..") != std::string::npos) in.damaged("/fields/name");
    file.fields.emplace_back(time[i], names[i]);
  }
  if (!in.is_as_written()) in.damaged("its checksum");
  return file;
}

}  // namespace upbead
