#include "upbead/expected/stream.h"

#include <Random123/philox.h>

namespace upbead {

Stream::Stream(std::uint64_t seed) : seed_(seed) {}

std::array<std::uint32_t, 4> Stream::words(const StreamPlace& place) const {
  const r123::Philox4x32::ctr_type counter{{place[0], place[1], place[2], place[3]}};
  const r123::Philox4x32::key_type key{{static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)}};
  const r123::Philox4x32::ctr_type out = r123::Philox4x32()(counter, key);
  return {out[0], out[1], out[2], out[3]};
}

double Stream::uniform(const StreamPlace& place) const {
  const std::array<std::uint32_t, 4> w = words(place);
  const std::uint64_t bits = (static_cast<std::uint64_t>(w[0]) << 20) | (w[1] >> 12);
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;  // 53 bits: exact
}

}  // namespace upbead
