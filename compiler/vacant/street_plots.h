// Plots along streets: see plots.h.
#pragma once

#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// Adds the plots along streets, but not along motorways and slip roads, at stations 24 m apart on both sides.
/// O(stations · (samples + plots)).
void add_street_plots(const PlotInputs& inputs, Plots& plots);

}  // namespace citykiln::vacant
