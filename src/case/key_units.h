// Numbers of a case or of a design that are judged by their key alone: in what unit were they given?
#pragma once

#include <functional>

#include "input/values.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/input/document.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// Warnings implausible of the keys that are given in the file. `visit`: passes all numbers of the tables to a visitor.
/// What a mesh must judge is left out: findings/plausibility.cc.
NumberedWarnings implausible_keys(const Document& document, const std::function<void(const NumberVisitor&)>& visit);

/// Likewise of the weights of a cross-section beside its size, and of gravity.
NumberedWarnings implausible_section(const Section& section, const Water& water);

}  // namespace upbead
