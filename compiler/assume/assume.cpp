#include "compiler/assume/assume.h"

#include <utility>

#include "compiler/assume/fronts.h"
#include "compiler/assume/heights.h"
#include "compiler/assume/lamps.h"
#include "compiler/assume/pavements.h"

namespace citykiln::assume {

map::Features assume(map::Features features, const Settings& settings, Report& report) {
  if (has(settings.on, Assumption::kHeights)) features = assume_heights(std::move(features), settings.seed, report);
  if (has(settings.on, Assumption::kPavements)) features.tracks = assume_pavements(features, report);
  if (has(settings.on, Assumption::kLamps)) features.tracks = assume_lamps(features, report);
  if (has(settings.on, Assumption::kFronts)) assume_fronts(features, settings.seed, report);
  return features;
}

}  // namespace citykiln::assume
