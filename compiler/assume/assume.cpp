#include "compiler/assume/assume.h"

#include "compiler/assume/bridge_pavements.h"
#include "compiler/assume/lamps.h"
#include "compiler/assume/pavements.h"

namespace citykiln::assume {

map::Features assume(map::Features features, const Settings& settings, Report& report) {
  if (has(settings.on, Assumption::kPavements))
    features.tracks = assume_bridge_pavements(assume_pavements(features, report), report);
  if (has(settings.on, Assumption::kLamps)) features.tracks = assume_lamps(features, report);
  return features;
}

}  // namespace citykiln::assume
