// The plots in areas that the map names: allotments and building sites. See plots.h.
#pragma once

#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// Adds rows of plots to allotments, parallel to the longest edge of each area: at most 60 rows and 60 columns on each
/// side of its start. O(areas · 120²).
void add_allotment_plots(const PlotInputs& inputs, Plots& plots);

/// Adds mapped building sites of 150 m2 or more to Plots::grounds; they have no surfaces of their own. O(n).
void add_sites(const PlotInputs& inputs, Plots& plots);

}  // namespace citykiln::vacant
