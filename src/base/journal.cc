#include "base/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/fingerprint.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

/// Of a line without its check, of the journal of one work: a line that is torn, or made of two, has another one.
std::string check_of(const Json& json, std::uint64_t work) {
  Fingerprint fingerprint;
  fingerprint.add(std::to_string(work));
  fingerprint.add(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  return std::to_string(fingerprint.value());
}

std::string line_of(Json json, std::uint64_t work) {
  json["check"] = check_of(json, work);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Whether the line, parsed to `json`, is one of the work to the last byte.
bool is_whole_line(const std::string& line, Json json, std::uint64_t work) {
  if (!json.is_object() || json.erase("check") == 0) return false;
  return line_of(json, work) == line + "\n";
}

/// Whether the line begins the journal of other work, whole; `is_old`: of a program whose lines had no check.
bool begins_another(const std::string& line, const Json& json, std::uint64_t work, bool is_old) {
  if (!json.is_object() || !json.contains("study") || !json["study"].is_number_unsigned()) return false;
  const auto other = json["study"].get<std::uint64_t>();
  return other != work && (is_old || is_whole_line(line, json, other));
}

/// Returns the number of lines that are not whole.
int read_journal(const fs::path& path, const JournalsOf& journals, const std::function<void(const Json&)>& take) {
  int torn = 0;
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const bool is_old = text.find("\"check\"") == std::string::npos;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const Json json = Json::parse(line, nullptr, false);
    if (begins_another(line, json, journals.fingerprint, is_old))
      throw InputError({journals.output_folder}, "the results there are of " + journals.what, journals.cure);
    if (!is_whole_line(line, json, journals.fingerprint))
      ++torn;
    else
      take(json);
  }
  return torn;
}

[[noreturn]] void cannot_write(const fs::path& path) {
  throw InputError({path.string()}, "cannot be written",
                   "make room on the disk, or choose another folder with --out DIR");
}

}  // namespace

fs::path journal_folder(const std::string& output_folder) {
  return fs::path(output_folder) / "journal";
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> list;
  std::error_code code;  // where there is no folder there is no file
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
    if (entry->path().extension() == ending) list.push_back(entry->path());
  std::sort(list.begin(), list.end());
  return list;
}

int read_lines(const JournalsOf& journals, const std::string& torn_of, const std::function<void(const Json&)>& take) {
  int torn = 0;
  for (const fs::path& path : files_in(journal_folder(journals.output_folder), journal_ending)) {
    const int in_file = read_journal(path, journals, take);
    if (path.filename().string().find(torn_of) != std::string::npos) torn += in_file;
  }
  return torn;
}

JournalFile::JournalFile(const std::string& output_folder, std::uint64_t fingerprint, const std::string& name)
    : fingerprint_(fingerprint) {
  std::error_code code;
  fs::create_directories(journal_folder(output_folder), code);
  for (int session = 0; descriptor_ < 0; ++session) {
    path_ = (journal_folder(output_folder) / (std::to_string(session) + "-" + name + journal_ending)).string();
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) cannot_write(path_);
  }
  write(Json{{"study", fingerprint}});
}

JournalFile::~JournalFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

void JournalFile::write(const Json& json) {
  const std::string line = line_of(json, fingerprint_);
  std::size_t written = 0;
  do {
    const ssize_t n = descriptor_ < 0 ? -1 : ::write(descriptor_, line.data() + written, line.size() - written);
    if (n < 0) cannot_write(path_);
    written += static_cast<std::size_t>(n);
  } while (written < line.size());
}

}  // namespace upbead
