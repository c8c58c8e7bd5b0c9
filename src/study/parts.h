// Parts of a study, which processes without contact compute.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/results.h"

namespace upbead {

/// One of so many parts.
struct Part {
  int number = 1, of = 1;

  std::string text() const;  ///< "3/100", as --part takes it
  std::string name() const;  ///< "part-3-of-100": of its journals
  std::string lock() const { return name() + ".lock"; }
};

/// Reads "3/100". Throws InputError.
Part read_part(const std::string& text);

/// Runs that form a piece stay in one process: those that differ only in [sliding], as one solution serves all of them.
using Pieces = std::vector<std::vector<int>>;

/// The runs that have no result yet. The pieces are ordered by case and mesh, so that a process can often reuse its
/// mesh.
Pieces schedule(const Study& study, const Results& results);

/// Those of the pieces.
Pieces without_done(const Pieces& pieces, const Results& results);

/// The runs of each part: those that share a basis stay together as far as parts stay balanced. It depends on the study
/// and the number of parts alone, so that parts need no talk.
std::vector<Pieces> deal(const Study& study, int parts);

/// The largest number of parts of which the folder has a journal; none where it has none of a part.
std::optional<int> parts_begun(const std::string& output_folder);

/// The parts that have runs without a result, without their commands.
std::vector<MissingRuns> missing_parts(const std::string& output_folder, const Study& study, const Results& results,
                                       int parts);

}  // namespace upbead
