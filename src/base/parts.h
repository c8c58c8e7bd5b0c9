// Parts of long work, such as the runs of a study or the lives of a design, which processes without contact compute.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// The part of a process that mpirun, srun or a Slurm array has started among others. Throws InputError where none has.
Part part_of_launch();

/// Numbers of runs or lives; those that form a piece stay in one process.
using Pieces = std::vector<std::vector<int>>;

/// Parts of `n` numbers from 0 on: each a stretch of them.
std::vector<Pieces> dealt_in_stretches(int n, int parts);

/// The largest number of parts of which the folder has a journal; none where it has none of a part.
std::optional<int> parts_begun(const std::string& output_folder);

/// Runs or lives that have no result yet.
struct MissingRuns {
  std::string part;  ///< "3/100"; "" where no part has begun
  std::vector<int> runs;
  std::string holder;   ///< "process 71 on node3" that works on the part, or may; "" where none does
  std::string command;  ///< that does them
};

/// The parts that lack a result, without their commands. `dealt`: all parts.
std::vector<MissingRuns> missing_parts(const std::string& output_folder, const std::vector<Pieces>& dealt,
                                       const std::function<bool(int)>& has_result);

}  // namespace upbead
