#include "compiler/invent/town/blocks/public_buildings.h"

#include <array>

#include "compiler/geometry/polygons/centroid.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/town/blocks/house_tags.h"
#include "compiler/invent/town/streets/street_graph.h"

namespace citykiln::invent {
namespace {

/// A rectangle's corner and directions, for rings in its frame.
struct Frame {
  Vec2 corner, u, n;
  Vec2 at(double x, double y) const { return on_place_grid(corner + u * x + n * y); }
};

Frame frame_of(const Ring& box) { return {box[0], unit(box[1] - box[0]), unit(box[3] - box[0])}; }

Tags shade_tree() { return tags_of({{"natural", "tree"}, {"leaf_type", "broadleaved"}}); }

void add_access(BlockRoom& room, InventedMap& map) {
  for (const Polyline& path : room.take_paths(2))
    map.lines.push_back({path, tags_of({{"highway", "footway"}, {"surface", "paving_stones"}})});
}

// a fence along the land, open where it is entered
void add_fence(const BlockRoom& room, InventedMap& map) {
  Polyline fence(room.land().begin() + 1, room.land().end());
  fence.push_back(room.land().front());
  if (fence.size() > 2) map.lines.push_back({std::move(fence), tags_of({{"barrier", "fence"}, {"height", "1.2"}})});
}

// three wings about a yard
Ring school_ring(const Ring& box, double wing_m) {
  const Frame f = frame_of(box);
  const double w = distance(box[0], box[1]), d = distance(box[0], box[3]);
  return {f.at(0, 0),
          f.at(wing_m, 0),
          f.at(wing_m, d - wing_m),
          f.at(w - wing_m, d - wing_m),
          f.at(w - wing_m, 0),
          f.at(w, 0),
          f.at(w, d),
          f.at(0, d)};
}

void add_parts_of_church(const Frame& f, double nave_m, double wide_m, double tower_m, double height_m,
                         InventedMap& map) {
  const double low = (wide_m - tower_m) / 2, high = (wide_m + tower_m) / 2;
  const Ring tower = {f.at(0, low), f.at(tower_m, low), f.at(tower_m, high), f.at(0, high)};
  const Ring nave = {f.at(tower_m, 0), f.at(tower_m + nave_m, 0), f.at(tower_m + nave_m, wide_m),
                     f.at(tower_m, wide_m)};
  map.areas.push_back({{nave, {}},
                       tags_of({{"building:part", "nave"},
                                {"height", "16"},
                                {"roof:shape", "gabled"},
                                {"roof:height", "7"},
                                {"roof:colour", "#8f4a36"},
                                {"building:colour", "#efe6d2"}})});
  map.areas.push_back({{tower, {}},
                       tags_of({{"building:part", "tower"},
                                {"height", std::to_string(static_cast<int>(height_m))},
                                {"roof:shape", "pyramidal"},
                                {"roof:height", std::to_string(static_cast<int>(height_m * 0.42))},
                                {"roof:colour", "#4d5c56"},
                                {"building:colour", "#e8e0cc"}})});
}

}  // namespace

void add_school(const std::string& name, BlockRoom& room, InventedMap& map) {
  map.areas.push_back({{room.land(), {}}, tags_of({{"amenity", "school"}, {"name", name + "-Schule"}})});
  if (const auto box = room.take_box_shrunk(58, 40, 4, 4)) {
    Tags tags = tags_of({{"building", "school"},
                         {"building:levels", "3"},
                         {"roof:shape", "hipped"},
                         {"roof:colour", "#8f4a36"},
                         {"roof:levels", "1"}});
    paint_walls(tags, room.draws());
    map.areas.push_back({{school_ring(*box, 11), {}}, std::move(tags)});
  }
  if (const auto box = room.take_box_shrunk(30, 18, 4, 4))
    map.areas.push_back(
        {{*box, {}},
         tags_of({{"building", "sports_hall"}, {"building:levels", "1"}, {"height", "8"}, {"roof:shape", "flat"}})});
  if (const auto box = room.take_box_shrunk(28, 15, 3, 3))
    map.areas.push_back({{*box, {}}, tags_of({{"leisure", "pitch"}, {"sport", "basketball"}, {"surface", "asphalt"}})});
  if (const auto box = room.take_box(24, 16, 2, 3))
    map.areas.push_back({{*box, {}}, tags_of({{"amenity", "parking"}, {"surface", "paving_stones"}})});
  add_fence(room, map);
  room.line_border(map, shade_tree(), 3, 11);
  room.scatter(map, shade_tree(), 500, 4, 4);
  room.scatter(map, tags_of({{"amenity", "bench"}}), 1500, 5, 3);
}

void add_church(const std::string& name, BlockRoom& room, InventedMap& map) {
  map.areas.push_back({{room.land(), {}}, tags_of({{"landuse", "religious"}})});
  for (const double share : {1.0, 0.8, 0.65}) {
    const double nave_m = 27 * share, wide_m = 14 * share, tower_m = 7.5 * share, height_m = 44 * share;
    const auto box = room.take_box(nave_m + tower_m, wide_m, 3, 3, 120);
    if (!box) continue;
    const Frame f = frame_of(*box);
    const double low = (wide_m - tower_m) / 2, high = (wide_m + tower_m) / 2, whole_m = nave_m + tower_m;
    const Ring outline = {f.at(0, low),          f.at(tower_m, low),    f.at(tower_m, 0),    f.at(whole_m, 0),
                          f.at(whole_m, wide_m), f.at(tower_m, wide_m), f.at(tower_m, high), f.at(0, high)};
    map.areas.push_back({{outline, {}},
                         tags_of({{"building", "church"},
                                  {"amenity", "place_of_worship"},
                                  {"religion", "christian"},
                                  {"name", "Sankt " + name},
                                  {"height", "16"}})});
    add_parts_of_church(f, nave_m, wide_m, tower_m, height_m, map);
    break;
  }
  add_access(room, map);
  room.line_border(map, shade_tree(), 3.5, 11);
  room.scatter(map, tags_of({{"amenity", "bench"}}), 700, 4, 3);
}

void add_supermarket(BlockRoom& room, InventedMap& map) {
  map.areas.push_back({{room.land(), {}}, tags_of({{"landuse", "retail"}})});
  if (const auto box = room.take_box_shrunk(56, 30, 4, 3))
    map.areas.push_back({{*box, {}},
                         tags_of({{"building", "retail"},
                                  {"shop", "supermarket"},
                                  {"building:levels", "1"},
                                  {"height", "7"},
                                  {"roof:shape", "flat"},
                                  {"building:colour", "#d9d2c6"}})});
  if (const auto box = room.take_box_shrunk(52, 34, 2, 2))
    map.areas.push_back(
        {{*box, {}}, tags_of({{"amenity", "parking"}, {"surface", "asphalt"}, {"parking", "surface"}})});
  room.scatter(map, tags_of({{"amenity", "recycling"}, {"recycling_type", "container"}}), 6000, 4, 3);
  room.line_border(map, shade_tree(), 2, 10);
}

}  // namespace citykiln::invent
