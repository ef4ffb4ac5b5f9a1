// The grounds of schools, churches and other institutions about their buildings: see plots.h.
#pragma once

#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// Adds paving about the buildings in land of institutions, gravel about churches, and playgrounds beside schools. Land
/// counts by the middle of a building. O(buildings · areas of institutions).
void add_institution_plots(const PlotInputs& inputs, Plots& plots);

}  // namespace citykiln::vacant
