// Fills what the map does not say: streets and buildings as they usually are at their place.
#pragma once

#include <cstdint>

#include "compiler/contract/assumption.h"
#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Settings of assume().
struct Settings {
  Assumptions on = kAllAssumptions;  ///< The assumptions that are made; the rest stays as mapped.
  std::uint64_t seed = 0;
};

/// Returns the features with what is assumed of them, marked in Track::assumed and Footprint::assumed and counted in
/// the report. Nothing that tags state is changed.
///
/// Each assumption is local: it depends on what is mapped within the radius that its header states. Without any
/// assumption the features are returned unchanged.
map::Features assume(map::Features features, const Settings& settings, Report& report);

}  // namespace citykiln::assume
