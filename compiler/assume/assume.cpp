#include "compiler/assume/assume.h"

#include "compiler/assume/fronts.h"

namespace citykiln::assume {

map::Features assume(map::Features features, const Settings& settings, Report& report) {
  if (has(settings.on, Assumption::kFronts)) assume_fronts(features, settings.seed, report);
  return features;
}

}  // namespace citykiln::assume
