// Whether two cases, both as effective_case() writes them, are of one scene.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// The names of the tables of mesh, water, soils and sides in which two cases differ; the path of the mesh does not
/// count.
std::vector<std::string> tables_that_differ(const std::string& case_text, const std::string& other_text);

/// What else of another case a model of the first does not answer: the loads of both that act elsewhere or otherwise,
/// whatever their histories, friction, W' and drag of [sliding], levels of still water and gravity.
std::vector<std::string> actions_that_differ(const std::string& case_text, const std::string& other_text);

}  // namespace upbead
