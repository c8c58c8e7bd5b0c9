// Answers soils that come line by line, for programs that ask for many.
#pragma once

#include <string>
#include <vector>

#include "respond/respond_waves.h"
#include "soils/soil_answers.h"

namespace upbead {

/// A soil as one line: a JSON object of numbers by key, or KEY=NUMBER between blanks; of an empty line no key. Throws
/// InputError.
Soil soil_of_line(const std::string& line);

/// Why a model of soils does not tell how far the caisson slips as a whole; "" where its case does not slide, so that
/// no model would.
std::string why_no_slip(const SoilModelFile& file);

class SoilServer {
 public:
  /// Throws InputError where the model lacks a reading whose history is asked for.
  SoilServer(SoilAnswers model, std::vector<WaveFile> waves, RespondOptions options);

  /// The answer, one line of JSON with its end: docs/soils.md. A soil that cannot be answered gets the reason.
  std::string answer(const std::string& line) const;

 private:
  std::string answer_soil(const Soil& whole) const;

  SoilAnswers model_;
  std::vector<WaveFile> waves_;
  RespondOptions options_;
};

}  // namespace upbead
