// Adds what the map does not say: streets and buildings get the properties that are usual at their place.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/assume/avenues.h"
#include "compiler/contract/findings/assumption.h"
#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Settings of assume().
struct Settings {
  Assumptions on = kNamedAssumptions;  ///< The assumptions that are made.
  std::uint64_t seed = 0;              ///< Selects the random draws.
  LonLatOf lonlat_of{};                ///< The place of a point of the plane; empty: no avenues are assumed.
};

/// The lists of a map of which something is assumed. Each list is whole, and sorted by id.
struct Assumed {
  std::vector<map::Track> tracks;
  std::vector<map::Footprint> footprints;
  std::vector<map::FrontPoint> fronts;
  std::vector<map::Waterway> waterways;
  std::vector<map::Barrier> barriers;
  std::vector<map::ThingFeature> things;
};

/// Returns the features with these lists in place of the map's. `assumed` must outlive the result.
map::FeatureView seen_with(map::FeatureView features, const Assumed& assumed);

/// Returns the features with assumed properties. Track::assumed and Footprint::assumed say which assumptions changed a
/// feature, and the report counts these features. No property that a tag states is changed. Ways of more than
/// kLongestWhole_m (pavements.h) may become several tracks. If Settings::on is kNoAssumptions, only widths are fitted.
///
/// The steps run in this order: widths (fit_widths.h), signals, storeys, roofs, pavements, pavements of bridges,
/// verges, parking, surfaces, lamps, avenues, shop fronts, styles, curves, closed frontages (frontages.h). Roofs and
/// shop fronts depend on assumed storeys, bridges and verges on assumed pavements, lamps on assumed surfaces.
///
/// Each assumption is local: it depends on what is mapped within the radius that its header states, and on the earlier
/// steps that it reads within this radius. The order of the features does not matter, except where areas of equal size
/// overlap.
Assumed assume(const map::FeatureView& mapped, const Settings& settings, Report& report);

}  // namespace citykiln::assume
