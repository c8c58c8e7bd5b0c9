#include "cli/march_output.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "base/fingerprint.h"
#include "base/interrupt.h"
#include "base/text.h"
#include "base/version.h"
#include "case/case_schema.h"
#include "case/input_files.h"
#include "fem/compile.h"
#include "model/exclusions.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

bool is_field_time(double time, const Scene& scene) {
  const double ratio = time / *scene.fields_every, near = 1e-6 * *scene.fields_every;
  const std::vector<double>& chosen = scene.output_times;
  return std::abs(ratio - std::round(ratio)) < 1e-6 ||
         std::any_of(chosen.begin(), chosen.end(), [&](double at) { return std::abs(time - at) < near; });
}

/// Places a file by a hard link, or by a copy where the file system has no links.
void lay(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::create_directories(to.parent_path(), code);
  fs::create_hard_link(from, to, code);
  if (code) fs::copy_file(from, to, fs::copy_options::overwrite_existing, code);
  if (code) throw InputError({}, "cannot write '" + to.string() + "': " + code.message(), "make room on the disk");
}

const char* const file_name = "state.h5";

/// Of all that the march so far depends on: neither its end nor words.
std::uint64_t fingerprint_of(const Case& input) {
  CaseTables marched = effective_tables(input, ".");
  marched.time.end = TimeChoice().end;
  marched.title.clear();
  marched.report = {};
  Fingerprint fingerprint;
  fingerprint.add(program_version());
  fingerprint.add(case_schema().echo(marched));
  for (const InputFile& file : input_files(input))
    if (file.path != input.document.path()) fingerprint.add_file(file.path);
  return fingerprint.value();
}

/// Writes a file so that, whatever happens, either the new file is there whole or the old one.
void write_whole(const fs::path& path, const std::string& bytes) {
  const fs::path partial = path.string() + ".partial";
  errno = 0;
  std::ofstream stream(partial, std::ios::binary);
  stream << bytes;
  stream.close();
  std::error_code code(errno, std::generic_category());
  if (stream) fs::rename(partial, path, code);
  if (!stream || code)
    throw InputError({}, "cannot write '" + path.string() + "': " + code.message(), "make room on the disk");
}

/// Throws InputError at the keys of a case for which a run cannot keep checkpoints.
void check_checkpoints(const Case& input) {
  Diagnostics mistakes;
  for (const Exclusion& reason : excluded(input.scene, Treatment::checkpoints))
    mistakes.add(input.place(reason.key), "no checkpoints: " + reason.why, "leave out --checkpoint and --resume");
  mistakes.throw_if_any();
}

}  // namespace

MarchObserver* FieldOutput::begin(const Simulation& simulation) {
  if (!scene_.fields_every) return nullptr;
  marched_ = &simulation;
  if (folder_ != nullptr) {
    writer_.emplace(simulation.mesh(), simulation.space(), simulation.unknowns(), simulation.scene().time.inertia,
                    [folder = folder_](const std::string& file) { return folder->path(file); });
    writer_->take_over(taken_over_);
  }
  return this;
}

void FieldOutput::follow(YieldingSoil& soil) {
  soil_ = &soil;
  if (writer_) writer_->follow(soil);
}

bool FieldOutput::wants(double time) const {
  return is_field_time(time, scene_);
}

void FieldOutput::see(const State& state, int, int) {
  if (!wants(state.time)) return;
  const Stopwatch watch;
  const System& system = marched_->system();
  write(system.is_divided() ? joined(system, state) : state);
  seconds_ += watch.seconds();
}

void FieldOutput::write(const State& state) {
  if (!writer_ && soil_) soil_->borne();  // the first process asks for the stresses, and all have a part of them
  if (!writer_) return;
  if (state.time == 0.) writer_->take_over({});  // the march begins anew, as the one before was rejected
  writer_->write(state);
}

void FieldOutput::finish() const {
  if (writer_) writer_->finish();
}

std::vector<std::pair<double, std::string>> FieldOutput::written() const {
  return writer_ ? writer_->written() : taken_over_;
}

void FieldOutput::take_over(const std::string& from, const std::vector<std::pair<double, std::string>>& written) {
  if (folder_ == nullptr) return;
  for (const auto& [time, name] : written) lay(fs::path(from) / name, folder_->path(name));
  taken_over_ = written;
}

void FieldOutput::lay_into(const std::string& other) const {
  for (const auto& [time, name] : written())
    if (const fs::path to = fs::path(other) / name; !fs::exists(to)) lay(folder_->path(name), to);
}

Checkpoints::Checkpoints(const Case& input, const std::string& results, const CheckpointWish& wish)
    : title_(input.scene.title),
      folder_(fs::absolute(results + "/.").lexically_normal().parent_path().string() + ".checkpoint"),
      wish_(wish) {
  if (wish.every > 0. || wish.resume) {
    check_checkpoints(input);
    fingerprint_ = fingerprint_of(input);
  }
  const fs::path file = fs::path(folder_) / file_name;
  if (!wish.resume || !fs::exists(file)) return;
  found_ = read_checkpoint(file.string());
  if (found_->fingerprint != fingerprint_)
    throw InputError({file.string()}, "a checkpoint of another case, mesh, history or version of upbead",
                     "begin from the start, without --resume");
  const double reached = found_->march.so_far.final_state.time;
  if (reached > input.scene.time.end)
    throw InputError(input.place("time.end"),
                     "the checkpoint is at t = " + significant(reached) +
                         " s, after time.end = " + significant(input.scene.time.end) + " s",
                     "give a later end, or begin from the start, without --resume");
}

void Checkpoints::require_fit(const Case& input, const Simulation& simulation) const {
  if (!found_ || found_->march.so_far.final_state.x.size() == whole_size(simulation.system())) return;
  throw InputError(
      input.place("time.end"),
      "with this end the scene has other unknowns than the run that was interrupted: cells that no wave "
      "reaches, and flow = \"auto\" of pore water, follow from the end",
      "give the former end, or begin from the start, with mesh.full_domain = true and flow of every region "
      "where another end is to be taken up");
}

/// Keeps a checkpoint; where it cannot be written, the run goes on.
void Checkpoints::keep(const MarchCheckpoint& march, const FieldOutput& fields) {
  try {
    fs::create_directories(folder_);
    fields.lay_into(folder_);
    write_whole(fs::path(folder_) / file_name, checkpoint_file(title_, {fingerprint_, march, fields.written()}));
    if (interrupt_noted())
      std::cerr << "upbead: kept at t = " << significant(march.so_far.final_state.time) << " s in " << folder_
                << "; go on with --resume\n";
  } catch (const std::exception& error) {
    std::cerr << "warning: no checkpoint was kept, the run goes on: " << error.what() << "\n";
  }
  since_last_ = Stopwatch();
}

Checkpointing Checkpoints::begin(FieldOutput& fields, bool writes) {
  Checkpointing options;
  if (wish_.every > 0.) {
    options.due = [this, writes] { return interrupt_noted() || (writes && since_last_.seconds() > wish_.every); };
    if (writes) options.keep = [this, &fields](const MarchCheckpoint& march) { keep(march, fields); };
  }
  if (found_) {
    fields.take_over(folder_, found_->fields);
    options.resume_from = std::make_shared<const MarchCheckpoint>(found_->march);
  }
  return options;
}

std::string Checkpoints::account() const {
  if (!wish_.resume) return "";
  if (!found_) return "resumed     from the start: there is no checkpoint in " + folder_ + "\n";
  return "resumed     at t = " + significant(found_->march.so_far.final_state.time) + " s, after " +
         std::to_string(found_->march.so_far.n_steps) + " steps\n";
}

void Checkpoints::remove() const {
  std::error_code ignored;  // results are written, so a leftover does no harm
  if (wish_.every > 0. || wish_.resume) fs::remove_all(folder_, ignored);
}

}  // namespace upbead
