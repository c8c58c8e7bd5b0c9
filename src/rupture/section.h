// A vertical section of the ground: soils between lines, and still water.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// A soil of Mohr-Coulomb strength; undrained clay has friction 0 and cohesion c_u.
struct GroundSoil {
  std::string name;
  double weight = 0.;     ///< above still water (N/m3)
  double submerged = 0.;  ///< below it: minus that of water (N/m3)
  double cohesion = 0.;   ///< c' or c_u (Pa)
  double friction = 0.;   ///< tan phi'
  bool may_fail = true;   ///< false: its strength is not known, and no figure cuts it
};

/// A straight line from x[0] to x[1] (m), x[0] < x[1], and what stands below it: an index of the soils, or `no_soil`.
struct GroundLine {
  std::array<double, 2> x{}, y{};
  int below = 0;
};
constexpr int no_soil = -1;

/// One vertical of the section.
struct GroundColumn {
  struct Layer {
    double top = 0.;  ///< m
    int soil = no_soil;
  };
  std::vector<Layer> layers;  ///< from the surface downwards; the last ends where `soil` is no_soil, or never
  bool is_whole = true;       ///< false: between its soils there is something that is none

  double surface() const { return layers.front().top; }
};

class GroundSection {
 public:
  /// Lines on one vertical at the same height stand in their order, the first on top. Without water_level the ground is
  /// dry.
  GroundSection(std::vector<GroundSoil> soils, std::vector<GroundLine> lines,
                std::optional<double> water_level = std::nullopt);

  const std::vector<GroundSoil>& soils() const { return soils_; }
  double left() const { return left_; }    ///< m
  double right() const { return right_; }  ///< m
  /// None where no soil is at x.
  std::optional<GroundColumn> column(double x) const;
  std::optional<double> surface(double x) const;

  /// What stands above y in a column: its weight (N/m2), and the moment of that about y = 0 (N/m).
  struct Weight {
    double force = 0., moment = 0.;
  };
  Weight weight_above(const GroundColumn& column, double y) const;
  /// The soil at y; null above the surface and where there is none.
  const GroundSoil* soil_at(const GroundColumn& column, double y) const;

 private:
  std::vector<GroundSoil> soils_;
  std::vector<GroundLine> lines_;
  std::vector<std::vector<int>> strips_;  ///< lines that touch each of equal strips of x, in their order
  std::optional<double> water_level_;
  double left_ = 0., right_ = 0.;
};

}  // namespace upbead
