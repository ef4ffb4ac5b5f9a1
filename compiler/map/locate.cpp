#include "compiler/map/locate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/map/bridge_areas.h"
#include "compiler/map/extent/map_box.h"
#include "compiler/map/rails_in_streets.h"
#include "compiler/map/readers/feature_readers.h"
#include "compiler/map/tagged_words.h"
#include "compiler/map/tags/unread.h"
#include "compiler/map/things/locate_things.h"
#include "compiler/map/ways/assumed_layers.h"
#include "compiler/map/ways/culverts.h"
#include "compiler/map/ways/passageways.h"

namespace citykiln::map {
namespace {

using source::LonLatBox;

double to_cell_down(double v) { return std::floor(v / kCell_m) * kCell_m; }
double to_cell_up(double v) { return std::ceil(v / kCell_m) * kCell_m; }

}  // namespace

// The sides of the box are curves in the plane, so points along them are included.
Box2 extent_of(const Plane& plane, const LonLatBox& box) {
  constexpr int kSteps = 8;
  Box2 around;
  for (int i = 0; i <= kSteps; ++i) {
    const double lon = box.west + (box.east - box.west) * i / kSteps,
                 lat = box.south + (box.north - box.south) * i / kSteps;
    for (const LonLat p :
         {LonLat{lon, box.south}, LonLat{lon, box.north}, LonLat{box.west, lat}, LonLat{box.east, lat}})
      around.grow(plane.forward(p));
  }
  Box2 extent{{to_cell_down(around.min.x), to_cell_down(around.min.y)},
              {to_cell_up(around.max.x), to_cell_up(around.max.y)}};
  if (extent.width() == 0) extent.max.x += kCell_m;
  if (extent.height() == 0) extent.max.y += kCell_m;
  return extent;
}

LonLatBox choose_box(const source::OsmData& osm, const Options& options) {
  return options.bbox ? *options.bbox : map_box(osm).box;
}

LonLat default_origin(const LonLatBox& box) {
  const auto rounded = [](double v) { return std::floor(v * 100 + 0.5) / 100; };
  return {rounded((box.west + box.east) / 2), rounded((box.south + box.north) / 2)};
}

Features locate(const source::OsmData& osm, const Plane& plane, const LonLatBox& box, const Options& options,
                Report& report) {
  assert(box.west <= box.east && box.south <= box.north);
  const ReadContext context{osm, plane, extent_of(plane, box), report, options.user_plants};
  Features features;
  features.extent = context.extent;
  std::vector<Track> tracks = locate_tracks(context, options.driving_side);
  features.footprints = locate_footprints(context);
  // a tunnel that only leads through buildings needs no layer
  CarriedTracks carried = with_bridge_areas(
      with_rails_in_streets(with_ordered_bridges(
          with_assumed_layers(with_passages_on_ground(std::move(tracks), features.footprints)), report)),
      locate_bridge_areas(context), report);
  features.tracks = std::move(carried.tracks), features.bridge_areas = std::move(carried.areas);
  features.areas = locate_areas(context, features.footprints);
  features.sports_areas = locate_sports_areas(context, features.areas);
  LocatedSea sea = locate_sea(context);
  std::ranges::move(sea.areas, std::back_inserter(features.areas));
  features.coasts = std::move(sea.coasts);
  features.waterways = locate_waterways(context);
  features.barriers = locate_barriers(context);
  features.landforms = locate_landforms(context);
  features.waterways = with_culverts(std::move(features.waterways), features.landforms);
  features.points = locate_points(context);
  features.tree_rows = locate_tree_rows(context);
  features.power_lines = locate_power_lines(context);
  if (options.things != nullptr) {
    LocatedThings located = locate_things(context, *options.things, features);
    features.things = std::move(located.things), features.supports_beyond = std::move(located.supports_beyond);
  }
  diagnose_unread(context, features);
  diagnose_unknown_words(context);
  const auto sort_by_id = [](auto&... kinds) {
    (std::ranges::sort(kinds, {}, [](const auto& f) { return f.id; }), ...);
  };
  sort_by_id(features.tracks, features.footprints, features.areas, features.sports_areas, features.waterways,
             features.barriers, features.landforms, features.points, features.things, features.supports_beyond,
             features.tree_rows, features.power_lines);
  features.texts = element_texts(osm, features, options.keeps_tags);
  return features;
}

}  // namespace citykiln::map
