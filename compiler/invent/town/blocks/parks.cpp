#include "compiler/invent/town/blocks/parks.h"

#include "compiler/geometry/line_part.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/trig.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/town/blocks/house_tags.h"
#include "compiler/invent/town/streets/street_graph.h"

namespace citykiln::invent {
namespace {

Tags tree_tags() { return tags_of({{"natural", "tree"}, {"leaf_type", "broadleaved"}}); }

void add_land_of(const BlockRoom& room, Tags tags, InventedMap& map) {
  map.areas.push_back({{room.land(), {}}, std::move(tags)});
}

// benches, baskets and lamps beside a path, on alternate sides
void furnish_path(const Polyline& path, InventedMap& map) {
  const std::vector<double> along = distances_on(path);
  int number = 0;
  for (double at_m = 14; at_m < along.back() - 5; at_m += 13, ++number) {
    const Vec2 p = point_at(path, along, at_m), ahead = unit(point_at(path, along, at_m + 1) - p);
    const Vec2 beside = on_place_grid(p + left_of(ahead) * (number % 2 ? 2.1 : -2.1));
    if (number % 3 == 0)
      map.points.push_back({beside, tags_of({{"highway", "street_lamp"}, {"lamp_mount", "straight_mast"}})});
    else
      map.points.push_back({beside, tags_of({{"amenity", "bench"}, {"backrest", "yes"}})});
    if (number % 5 == 1)
      map.points.push_back({on_place_grid(beside + ahead * 1.8), tags_of({{"amenity", "waste_basket"}})});
  }
}

void add_paths(BlockRoom& room, std::size_t count, const char* surface, InventedMap& map) {
  for (const Polyline& path : room.take_paths(count)) {
    map.lines.push_back({path, tags_of({{"highway", "footway"}, {"surface", surface}})});
    furnish_path(path, map);
  }
}

// a round shape with some irregularity
Ring pond_ring(Vec2 middle, double radius_m, Draws& draws) {
  Ring ring;
  const double first = draws.unit();
  for (int i = 0; i < 18; ++i) {
    const double wide_m = radius_m * (1 + 0.22 * direction_of(first + i * 2.0 / 18).x) * draws.between(0.94, 1.06);
    ring.push_back(on_place_grid(middle + direction_of(i / 18.0) * wide_m));
  }
  return ring;
}

void add_pond(BlockRoom& room, InventedMap& map) {
  const Box2 box = box_of(room.land());
  for (int i = 0; i < 40; ++i) {
    const Vec2 p{room.draws().between(box.min.x, box.max.x), room.draws().between(box.min.y, box.max.y)};
    const Ring ring = pond_ring(p, room.draws().between(9, 24), room.draws());
    if (!room.take(ring, 6, 4)) continue;
    map.areas.push_back({{ring, {}}, tags_of({{"natural", "water"}, {"water", "pond"}})});
    return;
  }
}

void add_playground(BlockRoom& room, InventedMap& map) {
  const auto ring = room.take_box_shrunk(22, 16, 4, 4);
  if (!ring) return;
  map.areas.push_back({{*ring, {}}, tags_of({{"leisure", "playground"}, {"surface", "sand"}})});
  const Vec2 middle = centroid(Polygon{*ring, {}}), u = room.along();
  for (const auto& [what, at_m] : {std::pair("swing", -5.5), {"slide", 0.0}, {"climbingframe", 5.5}})
    map.points.push_back({on_place_grid(middle + u * at_m), tags_of({{"playground", what}})});
}

void add_pitch(const Ring& ring, const char* sport, const char* surface, InventedMap& map) {
  map.areas.push_back({{ring, {}}, tags_of({{"leisure", "pitch"}, {"sport", sport}, {"surface", surface}})});
}

void add_floodlights(const Ring& pitch, InventedMap& map) {
  const Vec2 middle = centroid(Polygon{pitch, {}});
  for (const Vec2 corner : pitch)
    map.points.push_back({on_place_grid(corner + unit(corner - middle) * 2.5),
                          tags_of({{"man_made", "mast"}, {"tower:type", "lighting"}, {"height", "14"}})});
}

}  // namespace

void add_park(const std::string& name, BlockRoom& room, InventedMap& map) {
  add_land_of(room, tags_of({{"leisure", "park"}, {"name", name + "park"}}), map);
  const double land_m2 = signed_area_m2(room.land());
  add_paths(room, land_m2 > 15000 ? 7 : 4, "fine_gravel", map);
  if (land_m2 > 9000) add_pond(room, map);
  if (land_m2 > 4000) add_playground(room, map);
  if (land_m2 > 20000) {
    const auto box = room.take_box(34, 20, 5, 5);
    if (box) add_pitch(*box, "soccer", "grass", map);
  }
  room.scatter(map, tree_tags(), 130, 3, 3);
}

void add_square(const std::string& name, BlockRoom& room, InventedMap& map) {
  add_land_of(room,
              tags_of({{"highway", "pedestrian"},
                       {"area", "yes"},
                       {"place", "square"},
                       {"name", name + "er Platz"},
                       {"surface", "sett"},
                       {"lit", "yes"}}),
              map);
  if (signed_area_m2(room.land()) > 3200)
    if (const auto ring = room.take_box_shrunk(34, 16, 5, 4)) {
      Tags tags = tags_of({{"building", "civic"},
                           {"amenity", "townhall"},
                           {"building:levels", "3"},
                           {"name", "Rathaus"},
                           {"roof:shape", "hipped"},
                           {"roof:colour", "#6b4a42"}});
      paint_walls(tags, room.draws());
      map.areas.push_back({{*ring, {}}, std::move(tags)});
    }
  if (const auto ring = room.take_box(5, 5, 6, 6))
    map.points.push_back({on_place_grid(centroid(Polygon{*ring, {}})), tags_of({{"amenity", "fountain"}})});
  room.line_border(map, tree_tags(), 4, 9);
  room.line_border(map, tags_of({{"amenity", "bench"}}), 7, 17);
  room.line_border(map, tags_of({{"highway", "street_lamp"}}), 2, 24);
  room.scatter(map, tags_of({{"amenity", "bicycle_parking"}}), 2500, 6, 4);
  room.scatter(map, tags_of({{"advertising", "column"}}), 4000, 6, 5);
}

void add_cemetery(BlockRoom& room, InventedMap& map) {
  add_land_of(room, tags_of({{"landuse", "cemetery"}, {"name", "Friedhof"}}), map);
  add_paths(room, 4, "gravel", map);
  if (const auto ring = room.take_box_shrunk(16, 9, 6, 3))
    map.areas.push_back({{*ring, {}},
                         tags_of({{"building", "chapel"},
                                  {"building:levels", "1"},
                                  {"height", "9"},
                                  {"roof:shape", "gabled"},
                                  {"building:colour", "#efe6d2"},
                                  {"roof:colour", "#6b4a42"}})});
  room.scatter(map, tags_of({{"cemetery", "grave"}}), 60, 4, 2);
  room.scatter(map, tree_tags(), 260, 4, 3);
  Polyline hedge = room.land();
  hedge.push_back(hedge.front());
  map.lines.push_back({std::move(hedge), tags_of({{"barrier", "hedge"}, {"height", "1.4"}})});
}

void add_allotments(BlockRoom& room, InventedMap& map) {
  add_land_of(room, tags_of({{"landuse", "allotments"}}), map);
  add_paths(room, 4, "gravel", map);
  for (int i = 0; i < static_cast<int>(signed_area_m2(room.land()) / 320); ++i)
    if (const auto ring = room.take_box(room.draws().between(3, 4.6), room.draws().between(2.6, 3.6), 3, 8, 3))
      map.areas.push_back({{*ring, {}},
                           tags_of({{"building", "shed"},
                                    {"building:levels", "1"},
                                    {"roof:shape", "gabled"},
                                    {"building:material", "wood"}})});
  room.scatter(map, tags_of({{"natural", "tree"}, {"genus", "Malus"}}), 220, 3, 2.5);
}

void add_sports_ground(BlockRoom& room, InventedMap& map) {
  add_land_of(room, tags_of({{"landuse", "recreation_ground"}, {"leisure", "sports_centre"}}), map);
  if (const auto ring = room.take_box_shrunk(105, 68, 4, 4)) {
    add_pitch(*ring, "soccer", "grass", map);
    add_floodlights(*ring, map);
  }
  for (int i = 0; i < 3; ++i)
    if (const auto ring = room.take_box(24, 11, 4, 4)) add_pitch(*ring, "tennis", "clay", map);
  if (const auto ring = room.take_box(28, 15, 4, 3)) add_pitch(*ring, "basketball", "asphalt", map);
  if (const auto ring = room.take_box(18, 9, 4, 4))
    map.areas.push_back(
        {{*ring, {}}, tags_of({{"building", "sports_centre"}, {"building:levels", "1"}, {"roof:shape", "gabled"}})});
  room.line_border(map, tree_tags(), 3, 12);
}

}  // namespace citykiln::invent
