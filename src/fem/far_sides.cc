#include "fem/far_sides.h"

#include "outline.h"
#include "upbead/model/scene.h"

namespace upbead {

std::map<std::string, std::set<std::string>> far_sides(const Mesh& mesh) {
  std::map<std::string, std::set<std::string>> sides;
  for (const auto& [name, curve] : outline_of(mesh).outer) {
    const Extent& extent = curve.extent;
    const bool upright = extent.right - extent.left < 1e-6 * (extent.highest - extent.lowest);
    if (upright && curve.surfaces.count(caisson_name) == 0) sides[name] = curve.surfaces;
  }
  return sides;
}

}  // namespace upbead
