// The texts that every schema shares, whatever it fills.
#pragma once

#include <string>
#include <vector>

#include "input/entry.h"

namespace upbead {

/// "in [regions.sand]", or "at the top of the file" for the root.
std::string where_text(const std::string& path);

/// Refuses what is no table; true where `node` is one.
bool check_is_table(const Node& node, const std::string& path, Diagnostics& report);

/// Refuses every key of the table `node` that is not among `known`.
void check_known(const Node& node, const std::string& path, const std::vector<std::string>& known, Diagnostics& report);

/// Reports a required key as missing from the table `node`; `type`: what it takes, "" for a table.
void report_missing(const KeyInfo& key, const std::string& type, const Node& node, const std::string& path,
                    Diagnostics&);

/// Reports a key that stands where its condition does not hold.
void report_misplaced(const KeyInfo& key, const Node& node, const std::string& path, Diagnostics& report);

/// "name = value  # unit"; a comment with the fallback where there is no value.
std::string echo_line(const KeyInfo& key, const std::string& value);

/// The lines under their header; nothing where there are none.
std::string echo_block(const std::string& path, const std::string& lines);

/// The row of a key in the reference; `standard`: its default as TOML, "" where there is none.
KeyRow key_row(const KeyInfo& key, const std::string& type, const std::string& standard);

/// What the reference says about a table below its header.
std::string table_doc(const KeyInfo& key);

std::string markdown(const std::vector<TableDoc>& docs);

}  // namespace upbead
