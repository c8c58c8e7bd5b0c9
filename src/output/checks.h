// How checks are made, compared, told and written.
#pragma once

#include "output/output_schema.h"
#include "upbead/output/check.h"

namespace upbead {

Check check_of(FailureMode mode, const std::string& name, const std::string& unit, const std::optional<double>& demand,
               const std::string& measure, const std::string& assumption);

/// Completes a check whose demand must not exceed a capacity.
Check at_most(Check check, const std::optional<double>& capacity);

/// Completes a check whose demand must not fall below a capacity.
Check at_least_as(Check check, const std::optional<double>& capacity);

/// The same without demand and result: it was not checked.
Check not_checked(Check check, const std::string& why);

/// A check that holds, but not for sure: it was not checked. One that fails, or has no limit, stays; as all do where
/// there is no reason.
Check in_doubt(const Check& check, const std::string& why);

/// Whether `a` is the worse of two: it fails, has no bound, has less margin, or, without limits, demands more.
bool is_worse(const Check& a, const Check& b);

/// Of each check the worst, in the order of the first list; an item of `several` has the checks of one level or time.
Checks worst_of_each(const std::vector<Checks>& several);

/// The way to fail in words: "sliding landward".
std::string mode_of(const Check& check);

/// "heel pressure p_e, wave design at low".
std::string name_of(const Check& check);

/// A margin with three digits, or as many as tell it from 1.
std::string margin_text(double margin);

/// "heel pressure p_e, wave design at low: 562 kPa against 600 kPa: holds, margin 1.07". Demand and capacity that
/// differ are written with as many digits as show it.
std::string text_of(const Check& check);

Verdict verdict_of(const Checks& checks, const NumberedWarnings& warnings);

/// Verdict and checks for the terminal; of more than `most` checks those that hold are only counted.
std::string verdict_text(const Verdict& verdict, const Checks& checks, std::size_t most = 24);

/// The keys of a check and of a verdict, the same in every summary.
OutputSchema<Check> check_outputs();
OutputSchema<Verdict> verdict_outputs();

}  // namespace upbead
