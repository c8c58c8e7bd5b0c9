#include "field_output.h"

#include <cmath>
#include <filesystem>

#include "base/stopwatch.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

bool is_field_time(double time, double every) {
  return std::abs(time / every - std::round(time / every)) < 1e-6;
}

/// By a link, or a copy where the file system has none.
void lay(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::create_directories(to.parent_path(), code);
  fs::create_hard_link(from, to, code);
  if (code) fs::copy_file(from, to, fs::copy_options::overwrite_existing, code);
  if (code) throw InputError({}, "cannot write '" + to.string() + "': " + code.message(), "make room on the disk");
}

}  // namespace

MarchObserver* FieldOutput::begin(const Simulation& simulation) {
  if (!every_) return nullptr;
  writer_.emplace(*simulation.space, *simulation.unknowns, simulation.scene,
                  [folder = folder_](const std::string& file) { return folder->path(file); });
  writer_->take_over(taken_over_);
  return this;
}

void FieldOutput::see(const State& state, int, int) {
  if (!is_field_time(state.time, *every_)) return;
  const Stopwatch watch;
  if (state.time == 0.) writer_->take_over({});  // another march, as the one before was refused
  writer_->write(state);
  seconds_ += watch.seconds();
}

void FieldOutput::finish() const {
  if (writer_) writer_->finish();
}

std::vector<std::pair<double, std::string>> FieldOutput::written() const {
  return writer_ ? writer_->written() : taken_over_;
}

void FieldOutput::take_over(const std::string& from, const std::vector<std::pair<double, std::string>>& written) {
  for (const auto& [time, name] : written) lay(fs::path(from) / name, folder_->path(name));
  taken_over_ = written;
}

void FieldOutput::lay_into(const std::string& other) const {
  for (const auto& [time, name] : written())
    if (const fs::path to = fs::path(other) / name; !fs::exists(to)) lay(folder_->path(name), to);
}

}  // namespace upbead
