// The plots in areas that the map names: allotments and building sites. See plots.h.
#pragma once

#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// Adds rows of plots to allotments, along the longest edge of each area. O(places).
void add_allotment_plots(const PlotInputs& inputs, Plots& plots);

/// Adds building sites as they are mapped, as grounds without surfaces. O(n).
void add_sites(const PlotInputs& inputs, Plots& plots);

}  // namespace citykiln::vacant
