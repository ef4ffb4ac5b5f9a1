// The grounds of schools, churches and other institutions about their buildings: see plots.h.
#pragma once

#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// Adds paving about the buildings of 80 m2 or more in land of institutions, gravel about churches, and playgrounds
/// beside schools of 200 m2 or more. A building belongs to the smallest such area that contains its centroid.
/// O(buildings · areas).
void add_institution_plots(const PlotInputs& inputs, Plots& plots);

}  // namespace citykiln::vacant
