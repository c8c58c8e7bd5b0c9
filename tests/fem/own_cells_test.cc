// Claim: the parts of several processes have equally many unknowns, also where soil and water, whose cells have
// different numbers of them, fall to different processes.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "algebra/shared_matrix.h"
#include "fem/assembly.h"
#include "scenes.h"

namespace upbead::test {
namespace own_cells_test {

/// One of four processes, of which only its number is asked.
struct OneOfFour : Processes {
  explicit OneOfFour(int number) : number_(number) {}
  int rank() const override { return number_; }
  int count() const override { return 4; }
  void sum(double*, int) const override { throw std::logic_error("asked for sums"); }
  std::unique_ptr<detail::SharedMatrix> shared_matrix(const Sharing&) const override { return nullptr; }
  [[noreturn]] void end_all(int) const override { std::abort(); }
  int number_;
};

TEST(OwnCells, HaveEquallyManyUnknowns) {
  Scene scene = breakwater(triangle(1e6, 0.2));
  add_sea(scene);
  const auto mesh = breakwater_mesh(0.7, with_sea());
  const Compiled compiled(scene, *mesh);
  std::vector<double> sizes;
  std::size_t cells = 0;
  for (int rank = 0; rank < 4; ++rank) {
    const std::vector<bool> own = own_cells(compiled.space, OneOfFour(rank));
    std::set<int> held;
    for (const auto& cell : compiled.space.dofs().active_cell_iterators()) {
      if (!own[cell->active_cell_index()]) continue;
      ++cells;
      if (!compiled.space.has_matrices(cell)) continue;
      for (const auto dof : dofs_of(cell))
        for (const auto& [unknown, share] : compiled.unknowns.expansion(dof)) held.insert(unknown);
    }
    sizes.push_back(static_cast<double>(held.size()));
  }
  EXPECT_EQ(cells, mesh->triangulation.n_active_cells()) << "each is one process's";
  const double mean = std::accumulate(sizes.begin(), sizes.end(), 0.) / 4.;
  EXPECT_LT(*std::max_element(sizes.begin(), sizes.end()) / mean, 1.05);
}

}  // namespace own_cells_test
}  // namespace upbead::test
