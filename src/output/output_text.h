// Summaries for the terminal, made from the declaration of their keys: units, labels and why a value is null.
#pragma once

#include <string>
#include <vector>

#include "output/output_schema.h"

namespace upbead {

/// A line for each key, with value, unit and label. Objects and lists get a heading, and what is inside is indented.
/// Nothing of what is null or empty.
std::string text_of(const Json& summary, const std::vector<OutputRow>& rows);

/// The same of these keys alone, as "model" or "expected.base"; of numbers that are null it says why.
std::string text_of(const Json& summary, const std::vector<OutputRow>& rows, const std::vector<std::string>& keys);

using TextRow = std::vector<std::string>;

/// Columns as wide as needed, the first aligned to the left, all others to the right. Those that do not fit in 100
/// characters follow below, after the first one again.
std::string aligned(const std::vector<TextRow>& rows);

/// A column of a table, with the key of an item that it shows, as "life.index".
struct TextColumn {
  std::string head, key;
};

/// A row for each item of a list, or of an object with its items by name, whose names are a first column below `name`.
/// `path`: of an item, as "waves.NAME". Columns in which no item has a value are left out. Of more than `most` items,
/// the least and the largest of each number.
std::string table_of(const Json& items, const std::vector<OutputRow>& rows, const std::string& path,
                     const std::vector<TextColumn>& columns, const std::string& name = "", std::size_t most = 100);

}  // namespace upbead
