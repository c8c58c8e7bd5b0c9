// upbead-reliability: the commands that need the library OpenTURNS, which no other program loads.

#include "cli/command.h"

int main(int argc, char** argv) {
  return upbead::run_program(argc, argv, {upbead::reliability_command(), upbead::indices_command()});
}
