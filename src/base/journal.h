// Journals of long work: lines of JSON that stay whatever ends the process that wrote them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace upbead {

/// The folder of journals, within that of the results.
std::filesystem::path journal_folder(const std::string& output_folder);

/// Whose journals they are.
struct JournalsOf {
  std::string output_folder;
  std::uint64_t fingerprint = 0;  ///< of all that the results rest on
  std::string what, cure;         ///< "another study, ...", and what to do, where a journal is of that
};

/// Passes on each line that is what was written, as its check shows; returns how many are not, as a full disk, a killed
/// process or a power cut leave them, in journals with `torn_of` in their names: others may be about to be written.
/// Throws InputError where one has another fingerprint.
int read_lines(const JournalsOf& journals, const std::string& torn_of,
               const std::function<void(const nlohmann::ordered_json&)>& take);

/// The journal of one process, which no other process writes to. Each line is passed to the system at once and whole,
/// so that it survives the end of the process.
class JournalFile {
 public:
  /// Makes a file; `name`: its end, after a number that makes it new. Throws InputError where the folder cannot be
  /// written to.
  JournalFile(const std::string& output_folder, std::uint64_t fingerprint, const std::string& name);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;
  /// Throws InputError where the disk is full.
  void write(const nlohmann::ordered_json& line);

 private:
  std::uint64_t fingerprint_;
  std::string path_;
  int descriptor_ = -1;
};

constexpr const char* journal_ending = ".jsonl";

/// The files of a folder with that ending, sorted; none where there is no folder.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, const std::string& ending);

}  // namespace upbead
