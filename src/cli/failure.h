// How the program ends where something went wrong.
#pragma once

namespace upbead {

/// Says on stderr what the exception that is being handled has to say, and returns the exit code that goes with it: 1
/// the input is wrong, 2 the numerics failed, 3 a bug, 128 + signal interrupted. Call it in a catch block only.
int tell_failure();

}  // namespace upbead
