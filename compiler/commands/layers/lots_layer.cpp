#include "compiler/commands/layers/lots_layer.h"

#include <utility>

#include "compiler/assume/assume.h"
#include "compiler/assume/fit_widths.h"
#include "compiler/climate/climate_at.h"
#include "compiler/lots/add_yards.h"
#include "compiler/map/ways/passageways.h"
#include "compiler/roads/plan.h"
#include "compiler/roads/width_limits/limit_widths.h"

namespace citykiln::commands {

Layer lots_layer(const map::FeatureView& mapped, std::span<const OsmId> private_ways, const map::Plane& plane) {
  Report ignored;
  const assume::Assumed assumed = assume::assume(mapped, {}, ignored);
  const map::FeatureView features = seen_with(mapped, assumed);
  const auto [roads, junctions, passageways] = roads::plan(features, ignored);
  const lots::ClimateAt climate_at = [&](Vec2 at) {
    const LonLat place = plane.backward(at);
    return climate::climate_at(place.lon_deg, place.lat_deg);
  };
  Layer layer;
  for (const lots::Lot& lot : lots::lots_of_map(
           features,
           {.roads = roads, .junctions = junctions, .private_ways = private_ways, .climate_at = climate_at})) {
    const ObjectId id = features.footprints[lot.main].id;
    LayerFeature& feature = layer.emplace_back(LayerFeature{
        id, std::string(lots::name_of(lot.kind)), GeometryKind::kPolygon, flat(std::span(&lot.parcel.polygon, 1))});
    feature.properties.add("area_m2", area_m2(lot.parcel.polygon));
    feature.properties.add("front_m", lot.parcel.frontage.length_m);
    feature.properties.add("setback_m", lot.setback_m);
    feature.properties.add("buildings", lot.footprints.size());
    feature.properties.add("country_group", map::name_of(lot.country));
    feature.properties.add("climate", climate::name_of(lot.climate));
  }
  return layer;
}

}  // namespace citykiln::commands
