// Plots along streets: see plots.h.
#pragma once

#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// Adds the plots along streets. O(stations · samples).
void add_street_plots(const PlotInputs& inputs, Plots& plots);

}  // namespace citykiln::vacant
