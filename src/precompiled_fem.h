// Headers of other projects that most files from the layer fem on include; precompiled, as reading them takes
// seconds.
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/affine_constraints.h>

#include <boost/math/constants/constants.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "precompiled_algebra.h"
