#include "mode_sum.h"

#include <cstring>

// Six multiplications a mode and sample: registers of AVX2 and AVX-512 and their fused operations do 1.4 and 3.4 times
// as many of them as those that every x86-64 has. GCC compiles the loop for all three and picks one when the program
// starts. Not with the address sanitizer, whose checks are not up yet when that choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define UPBEAD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define UPBEAD_CLONES
#endif

namespace upbead::detail {

namespace {

constexpr int lanes = ModeTable::lanes;

/// As many doubles as the widest registers hold; the compiler splits them where registers are narrower.
using Lanes __attribute__((vector_size(lanes * sizeof(double)))) = double;

void load(const double* from, Lanes& to) {
  std::memcpy(&to, from, sizeof to);
}

void store(const Lanes& from, double* to) {
  std::memcpy(to, &from, sizeof from);
}

struct BlockPointers {
  const double *E_re, *E_im, *reading_re, *reading_im, *f;
  double *w_re, *w_im, *y;
};

/// One block of samples for all modes. What a mode adds to a sample waits for nothing but the mode's last value, so
/// that the processor works on several modes at once.
UPBEAD_CLONES void add_block(Eigen::Index n_modes, const BlockPointers& p) {
  Lanes sum[samples_at_a_time] = {};
  for (Eigen::Index m = 0; m < n_modes; m += lanes) {
    Lanes E_re, E_im, c_re, c_im, re, im;
    load(p.E_re + m, E_re);
    load(p.E_im + m, E_im);
    load(p.reading_re + m, c_re);
    load(p.reading_im + m, c_im);
    load(p.w_re + m, re);
    load(p.w_im + m, im);
    for (int n = 0; n < samples_at_a_time; ++n) {
      sum[n] += c_re * re;
      sum[n] -= c_im * im;
      const Lanes next = p.f[n] + E_re * re - E_im * im;
      im = E_re * im + E_im * re;
      re = next;
    }
    store(re, p.w_re + m);
    store(im, p.w_im + m);
  }
  for (int n = 0; n < samples_at_a_time; ++n)
    for (int lane = 0; lane < lanes; ++lane) p.y[n] += sum[n][lane];
}

/// Left alone, modes would decay to denormal numbers, which are very slow, and stay there.
void drop_what_is_gone(Eigen::ArrayXd& w) {
  constexpr double gone = 1e-250;
  w = (w.abs() < gone).select(0., w);  // which keeps what is no number
}

}  // namespace

void add_mode_sum(const SplitArray& E, const SplitArray& reading, const double* f, Eigen::Index n_samples,
                  SplitArray& w, double* y) {
  constexpr int blocks_between_drops = 8;
  for (Eigen::Index n = 0; n < n_samples; n += samples_at_a_time) {
    if (n % (blocks_between_drops * samples_at_a_time) == 0) {
      drop_what_is_gone(w.re);
      drop_what_is_gone(w.im);
    }
    add_block(E.re.size(),
              {E.re.data(), E.im.data(), reading.re.data(), reading.im.data(), f + n, w.re.data(), w.im.data(), y + n});
  }
}

}  // namespace upbead::detail
