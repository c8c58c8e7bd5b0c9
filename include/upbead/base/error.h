// Three kinds of errors: the input is wrong (the user corrects it), the numerics failed (the message says why), or the
// program has a bug (any other exception). Diagnostics of the input are collected and reported all at once.
#pragma once

#include <initializer_list>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace upbead {

/// A place in a file that a person wrote. Line and column start at 1; 0 means "the whole file".
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  std::string key = {};  ///< "time.step"; the only place where a scene was not read from a file
};

/// The place of a key: dotted for a scene, the name alone for a part of a scene. `place`: where the key stands in a
/// file, if known.
inline Place at_key(std::string key, Place place = {}) {
  place.key = std::move(key);
  return place;
}

/// One mistake of the user: where it is, what is wrong, how to correct it.
struct Diagnostic {
  Place place;
  std::string what;
  std::string cure;
};

/// "file:line:column: what; cure", leaving out what is not known.
std::string to_string(const Diagnostic& diagnostic);

/// Collects diagnostics, so that a person sees all of them at once. Knows which keys have none: a check that compares
/// several keys uses only these, so that no mistake is reported twice.
class Diagnostics {
 public:
  Diagnostics() = default;
  Diagnostics(std::initializer_list<Diagnostic> list);
  void add(Diagnostic diagnostic);
  void add(Place place, std::string what, std::string cure = "");
  void add(const Diagnostics& more);
  /// Adds the mistakes found while the value of a key was read.
  void add_at(const std::string& key, const Diagnostics& more);
  /// Adds a remark that is no mistake but that the user should know.
  void note(Place place, std::string what) { notes_.push_back({std::move(place), std::move(what), ""}); }
  const std::vector<Diagnostic>& notes() const { return notes_; }
  bool empty() const { return list_.empty(); }
  const std::vector<Diagnostic>& list() const { return list_; }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  /// Nothing is wrong at or below a dotted key ("" for everything).
  bool sound(const std::string& key) const;
  /// Throws InputError if there is any diagnostic.
  void throw_if_any() const;
  /// Likewise. Diagnostics of that file come first, in the order of its lines; those of other files follow in the order
  /// in which they were found.
  void throw_if_any(const std::string& file) const;

 private:
  std::vector<Diagnostic> list_, notes_;
  std::set<std::string> keys_;
};

/// The input is wrong (exit code 1). Holds all diagnostics.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Diagnostics diagnostics);
  InputError(Place place, std::string what, std::string cure);
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Diagnostics diagnostics_;
};

/// The numerics failed (exit code 2): a singular matrix, a number that is not finite.
class NumericsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace upbead
