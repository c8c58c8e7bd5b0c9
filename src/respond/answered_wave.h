// A wave that was answered, with its name among those of all files.
#pragma once

#include <string>
#include <vector>

#include "output/wave_response.h"

namespace upbead {

struct AnsweredWave {
  std::string name;
  const WaveResponse* wave;
};

inline std::vector<AnsweredWave> all_waves(const std::vector<WaveResponses>& files) {
  std::vector<AnsweredWave> list;
  for (const WaveResponses& file : files)
    for (std::size_t w = 0; w < file.waves.size(); ++w) list.push_back({file.wave_name(w), &file.waves[w]});
  return list;
}

}  // namespace upbead
