// What came of reading a document by a schema: the mistakes, and which tables are free of them.
#pragma once

#include <set>
#include <string>

#include "upbead/base/error.h"
#include "upbead/input/node.h"

namespace upbead {

/// Later checks across keys look at sound tables only, so that one slip is not reported twice.
class InputReport {
 public:
  /// `path`: dotted path of the key (or table) that is wrong; all tables around it become unsound.
  void add(const std::string& path, const Mistake& mistake);
  void add(const std::string& path, Place place, std::string what, std::string cure);
  /// Nothing is wrong at or below `path` ("" for the whole document).
  bool sound(const std::string& path) const { return unsound_.count(path) == 0; }
  /// Throws InputError with every mistake, in the order of the file `path`; those of other files follow.
  void throw_if_any(const std::string& path) const;

 private:
  std::vector<Mistake> list_;
  std::set<std::string> unsound_;
};

}  // namespace upbead
