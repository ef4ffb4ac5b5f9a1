#include "compiler/assume/assume.h"

#include <span>
#include <utility>

#include "compiler/assume/bridge_pavements.h"
#include "compiler/assume/curves/curves.h"
#include "compiler/assume/fit_widths.h"
#include "compiler/assume/frontages.h"
#include "compiler/assume/fronts.h"
#include "compiler/assume/heights.h"
#include "compiler/assume/lamps.h"
#include "compiler/assume/parking.h"
#include "compiler/assume/pavements.h"
#include "compiler/assume/roofs.h"
#include "compiler/assume/signals.h"
#include "compiler/assume/surfaces.h"
#include "compiler/assume/verges.h"

namespace citykiln::assume {
namespace {

// Returns the footprints with Assumption::kStyles in Footprint::assumed of every one. The planning of buildings
// then takes the style, and the materials and colours that are not tagged, from Footprint::country: it chooses one of
// the styles of the group by storeys and party walls (buildings/styles/style.h). The radius is 0: no mark depends on
// another footprint.
std::vector<map::Footprint> assume_styles(std::span<const map::Footprint> footprints, Report& report) {
  std::vector<map::Footprint> styled(footprints.begin(), footprints.end());
  for (map::Footprint& footprint : styled) {
    footprint.assumed |= bit_of(Assumption::kStyles);
    if (!footprint.has_parts) report.count_assumed(Assumption::kStyles, footprint.id.osm);
  }
  return styled;
}

}  // namespace

map::FeatureView seen_with(map::FeatureView features, const Assumed& assumed) {
  features.tracks = assumed.tracks, features.footprints = assumed.footprints, features.fronts = assumed.fronts;
  features.waterways = assumed.waterways, features.barriers = assumed.barriers;
  features.things = assumed.things;
  return features;
}

Assumed assume(const map::FeatureView& mapped, const Settings& settings, Report& report) {
  const auto is_on = [&](Assumption assumption) { return has(settings.on, assumption); };
  // pavements and verges are measured from the fitted kerbs
  Assumed made{.tracks = fit_assumed_widths(mapped),
               .footprints = {mapped.footprints.begin(), mapped.footprints.end()},
               .fronts = {},
               .waterways = {mapped.waterways.begin(), mapped.waterways.end()},
               .barriers = {mapped.barriers.begin(), mapped.barriers.end()},
               .things = {mapped.things.begin(), mapped.things.end()}};
  const auto seen = [&] { return seen_with(mapped, made); };
  if (is_on(Assumption::kRoadsides)) {
    WithSignals signals = assume_signals(seen(), report);
    made.tracks = std::move(signals.tracks), made.things = std::move(signals.things);
  }
  if (is_on(Assumption::kHeights)) made.footprints = assume_heights(seen(), settings.seed, report);
  // by the assumed storeys
  if (is_on(Assumption::kRoofs)) made.footprints = assume_roofs(seen(), settings.seed, report);
  const std::vector<map::Track> fitted = made.tracks;
  if (is_on(Assumption::kPavements)) made.tracks = assume_bridge_pavements(assume_pavements(seen(), report), report);
  // beside the pavements
  if (is_on(Assumption::kVerges)) made.tracks = assume_verges(seen(), fitted, report);
  if (is_on(Assumption::kParking)) made.tracks = assume_parking(seen(), report);
  if (is_on(Assumption::kSurfaces)) made.tracks = assume_surfaces(seen(), report);
  if (is_on(Assumption::kLamps)) made.tracks = assume_lamps(seen(), report);
  if (is_on(Assumption::kRoadsides) && settings.lonlat_of)
    made.tracks = assume_avenues(seen(), settings.lonlat_of, settings.seed, report);
  if (is_on(Assumption::kFronts)) {
    AssumedFronts fronts = assume_fronts(seen(), settings.seed, report);
    for (const std::uint32_t f : fronts.footprints) made.footprints[f].assumed |= bit_of(Assumption::kFronts);
    made.fronts = std::move(fronts.fronts);
  }
  if (is_on(Assumption::kStyles)) made.footprints = assume_styles(made.footprints, report);
  // last, since stretches of streets are cut at mapped nodes
  if (is_on(Assumption::kCurves)) {
    made.tracks = curved_tracks(seen(), report);
    made.waterways = curved_waterways(mapped.waterways);
    made.barriers = curved_barriers(mapped.barriers);
  }
  // after curves, which keep their distance from pavements
  if (is_on(Assumption::kPavements)) made.tracks = assume_frontages(seen(), fitted, report);
  return made;
}

}  // namespace citykiln::assume
