// Whether two cases, both as effective_case() writes them, are of one scene.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// The names of the tables of mesh, water, soils and sides in which two cases differ; the path of the mesh does not
/// count.
std::vector<std::string> tables_that_differ(const std::string& case_text, const std::string& other_text);

}  // namespace upbead
