// What can go wrong, in three kinds: the input is wrong (the user mends it), the numerics failed (we say why), a bug
// (any other exception). Mistakes in the input are collected and reported all at once.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace upbead {

/// A place in a file that a person wrote. Line and column start at 1; 0 means "the whole file".
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  std::string key = {};  ///< of a scene that was not read from a file, or not yet: "time.step"
};

/// The place of a key, for whoever knows no file.
inline Place at_key(std::string key) {
  return {"", 0, 0, std::move(key)};
}

/// One mistake of the user: where it is, what is wrong, how to mend it.
struct Mistake {
  Place place;
  std::string what;
  std::string cure;
};

/// "file:line:column: what; cure", leaving out what is not known.
std::string to_string(const Mistake& mistake);

/// The input is wrong (exit code 1). Carries every mistake that was found, in the order of the file.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Mistake> mistakes);
  explicit InputError(Mistake mistake) : InputError(std::vector<Mistake>{std::move(mistake)}) {}
  /// One mistake.
  InputError(Place place, std::string what, std::string cure);
  const std::vector<Mistake>& mistakes() const { return mistakes_; }

 private:
  std::vector<Mistake> mistakes_;
};

/// The numerics failed (exit code 2): a singular matrix, a number that is not finite.
class NumericsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Collects mistakes, so that a person sees all of them in one go.
class Mistakes {
 public:
  void add(Place place, std::string what, std::string cure = "");
  void add(const InputError& error);
  bool empty() const { return list_.empty(); }
  /// Throws InputError if there is any mistake.
  void throw_if_any() const;

 private:
  std::vector<Mistake> list_;
};

}  // namespace upbead
