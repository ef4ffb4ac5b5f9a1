#include "compiler/vacant/plots.h"

#include "compiler/vacant/area_plots.h"
#include "compiler/vacant/institution_plots.h"
#include "compiler/vacant/street_plots.h"

namespace citykiln::vacant {

Plots plots_of(const PlotInputs& inputs) {
  Plots plots;
  add_street_plots(inputs, plots);
  add_institution_plots(inputs, plots);
  add_allotment_plots(inputs, plots);
  add_sites(inputs, plots);
  return plots;
}

}  // namespace citykiln::vacant
