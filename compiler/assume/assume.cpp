#include "compiler/assume/assume.h"

#include <utility>

#include "compiler/assume/heights.h"
#include "compiler/assume/roofs.h"

namespace citykiln::assume {

map::Features assume(map::Features features, const Settings& settings, Report& report) {
  if (has(settings.on, Assumption::kHeights)) features = assume_heights(std::move(features), settings.seed, report);
  // by the assumed storeys
  if (has(settings.on, Assumption::kRoofs)) features = assume_roofs(std::move(features), settings.seed, report);
  return features;
}

}  // namespace citykiln::assume
