// "Did you mean ...?": the word that a person probably meant.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// The candidate nearest to `word` by Damerau-Levenshtein distance (insert, delete, replace, swap neighbours), capitals
/// and hyphens set aside; "" where none differs by at most a third of its letters.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

/// "did you mean 'porosity'?" where something is near, else "known KIND: a, b, c" ("there are no KIND" without any).
/// `kind` is a plural: "keys", "boundaries".
std::string suggestion(const std::string& word, const std::vector<std::string>& candidates, const std::string& kind);

/// "a, b, c".
std::string join(const std::vector<std::string>& words, const std::string& separator = ", ");

}  // namespace upbead
