// The soils of a scene as text, from which their coefficients follow without mesh or other files.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "fem/coefficients.h"
#include "upbead/input/document.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Values of keys of the case, by dotted key.
using Soil = std::map<std::string, double>;

/// gravity, [fluid] and [regions] of a scene whose choices are made, as TOML; with the bulk modulus of pore water that
/// contains air, which the case does not tell.
std::string soil_text(const Scene& scene);

/// Reads such a text.
class SoilText {
 public:
  /// `path`: the file that it stands in, for messages. Throws InputError with all that is wrong.
  SoilText(std::string text, std::string path);
  /// The number at a dotted key; none where there is none.
  std::optional<double> number(const std::string& key) const;
  /// The unit of that number; "" where it has none.
  std::string unit(const std::string& key) const;
  bool has_region(const std::string& name) const { return nominal_.count(name) > 0; }
  /// By region, with those keys set. Throws InputError where a value is beyond its key's range.
  std::map<std::string, Coefficients> coefficients(const Soil& soil) const;

 private:
  std::string text_, path_;
  Document document_;
  std::map<std::string, Coefficients> nominal_;
};

/// Whether two dotted keys are the same, whatever is quoted in them.
bool is_same_key(const std::string& a, const std::string& b);

}  // namespace upbead
