// What the readers of CSV and HDF5 waves share.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/csv.h"
#include "respond/wave_files.h"
#include "upbead/base/error.h"

namespace upbead::detail {

using Names = std::vector<std::string>;

/// Index of a name; the size of the list where it is not in it.
std::size_t find(const Names& names, const std::string& name);

/// `what`: "column" or "dataset".
void add_unknown_load(const Place& place, const std::string& what, const std::string& name, const Names& loads,
                      Diagnostics& mistakes);

/// Two times or more, from 0 on, ascending. `place`: of the time with that index.
void check_times(const std::vector<double>& time, const std::function<Place(std::size_t)>& place,
                 Diagnostics& mistakes);

/// The waves of one HDF5 file, without a name; throws InputError.
WaveFile read_hdf5_waves(const std::string& path, const Names& loads, const Names& units);

/// What a unit makes of 1 of it, in that of load `k`; of a load whose unit is not known, force or pressure. Throws
/// InputError where it is a unit of another quantity; `who`: has it.
double factor_to_load(const std::string& unit, std::size_t k, const Names& units, const Place& place,
                      const std::string& who);

/// A column in the unit of load `k`.
std::vector<double> in_unit_of_load(const CsvTable& table, std::size_t column, std::size_t k, const Names& units);

}  // namespace upbead::detail
