// Linked into programs built with sanitizers only. MPI and HDF5 keep memory until the process ends; that is no leak of
// ours, and would hide those that are behind a wall of reports.

extern "C" const char* __asan_default_options() {
  return "detect_leaks=0";
}
