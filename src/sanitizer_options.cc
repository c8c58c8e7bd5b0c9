// Linked into programs built with sanitizers only. MPI and HDF5 keep memory until the process ends. That is no leak
// of upbead, and its many reports would hide real leaks.

extern "C" const char* __asan_default_options() {
  return "detect_leaks=0";
}
