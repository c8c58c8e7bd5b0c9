// Records as laboratories hand them over.
#pragma once

#include <string>
#include <vector>

#include "base/csv.h"

namespace upbead {

/// A table from CSV (base/csv.h) or, by the endings .h5 and .hdf5, from the one-dimensional datasets below the root of
/// an HDF5 file, all of one length, with their attributes `unit`; `time` comes first. Throws InputError.
CsvTable read_record_table(const std::string& path, const Place& place);

/// The first rows of it that a megabyte holds; of HDF5 all. Throws InputError as above.
CsvTable read_record_head(const std::string& path);

/// A column in SI units: by `unit` where it is given, else by the header, else as it is. Throws InputError where the
/// unit is not known, or not one of the quantity whose SI unit is `si`.
std::vector<double> in_si(const CsvTable& table, std::size_t column, const std::string& si,
                          const std::string& unit = "");

}  // namespace upbead
