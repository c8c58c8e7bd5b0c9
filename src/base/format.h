// Sentences with numbers in the format of printf.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace upbead {

__attribute__((format(printf, 1, 2))) inline std::string format(const char* pattern, ...) {
  char buffer[400];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
  va_end(arguments);
  return buffer;
}

}  // namespace upbead
