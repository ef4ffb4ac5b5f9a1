#include "compiler/assume/assume.h"

#include <utility>

#include "compiler/assume/bridge_pavements.h"
#include "compiler/assume/fronts.h"
#include "compiler/assume/heights.h"
#include "compiler/assume/lamps.h"
#include "compiler/assume/parking.h"
#include "compiler/assume/pavements.h"
#include "compiler/assume/roofs.h"
#include "compiler/assume/styles.h"
#include "compiler/assume/surfaces.h"
#include "compiler/assume/verges.h"

namespace citykiln::assume {

map::Features assume(map::Features features, const Settings& settings, Report& report) {
  if (has(settings.on, Assumption::kHeights)) features = assume_heights(std::move(features), settings.seed, report);
  // by the assumed storeys
  if (has(settings.on, Assumption::kRoofs)) features = assume_roofs(std::move(features), settings.seed, report);
  const std::vector<map::Track> mapped = features.tracks;
  if (has(settings.on, Assumption::kPavements))
    features.tracks = assume_bridge_pavements(assume_pavements(features, report), report);
  // beside the pavements
  if (has(settings.on, Assumption::kVerges)) features.tracks = assume_verges(features, mapped, report);
  if (has(settings.on, Assumption::kParking)) features.tracks = assume_parking(features, report);
  if (has(settings.on, Assumption::kSurfaces)) features.tracks = assume_surfaces(features, report);
  if (has(settings.on, Assumption::kLamps)) features.tracks = assume_lamps(features, report);
  if (has(settings.on, Assumption::kFronts)) assume_fronts(features, settings.seed, report);
  if (has(settings.on, Assumption::kStyles)) features = assume_styles(std::move(features), report);
  return features;
}

}  // namespace citykiln::assume
