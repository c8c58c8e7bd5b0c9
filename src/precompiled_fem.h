// Headers of others that most files from the layer fem on read; precompiled, as reading them takes seconds.
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
