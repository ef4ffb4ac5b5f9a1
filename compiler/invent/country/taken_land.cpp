#include "compiler/invent/country/taken_land.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"

namespace citykiln::invent {
namespace {

constexpr double kTakenBucket_m = 64;
// fields keep off the water by a bank
constexpr double kBank_m = 3;

struct RightOfWay {
  std::string_view value;
  double half_m;
};
// carriageway, pavements or shoulders, and a verge
constexpr RightOfWay kRoadRightsOfWay[] = {
    {"motorway", 15},    {"trunk", 12},      {"primary", 9},       {"secondary", 8},  {"tertiary", 7},
    {"unclassified", 6}, {"residential", 7}, {"living_street", 5}, {"service", 4},    {"pedestrian", 5},
    {"track", 3},        {"path", 1.5},      {"footway", 2},       {"cycleway", 2.5}, {"bridleway", 2}};

Polygon quadrangle(Vec2 a, Vec2 b, double half_m) {
  const Vec2 along = unit(b - a), side = left_of(along) * half_m;
  // strips of neighbouring segments overlap a little at bends
  const Vec2 beyond = along * (half_m * 0.4);
  return {{a - beyond - side, b + beyond - side, b + beyond + side, a - beyond + side}, {}};
}

double distance_to_polygon(const Polygon& polygon, Vec2 p) {
  double least_m = distance_to_ring(polygon.outer, p);
  for (const Ring& hole : polygon.holes) least_m = std::min(least_m, distance_to_ring(hole, p));
  return contains(polygon, p) ? -least_m : least_m;
}

bool is_town_area(const Tags& tags) {
  for (const std::string_view key : {"landuse", "leisure", "amenity", "building", "natural", "tourism", "aeroway"})
    if (!value_in(tags, key).empty()) return true;
  return false;
}

}  // namespace

double half_right_of_way_m(const InventedLine& line) {
  if (!value_in(line.tags, "railway").empty()) return 6;
  const std::string_view road = value_in(line.tags, "highway");
  if (road.empty()) return 0;
  const auto found = std::ranges::find(kRoadRightsOfWay, road, &RightOfWay::value);
  return found == std::end(kRoadRightsOfWay) ? 5 : found->half_m;
}

void TakenLand::add(const Polygon& polygon) {
  if (polygon.outer.size() < 3) return;
  pieces_.push_back({polygon, {}, {}, 0});
  boxes_.push_back(box_of(polygon.outer));
}

void TakenLand::add(const Polyline& axis, double half_width_m) {
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    if (axis[i] == axis[i + 1]) continue;
    pieces_.push_back({{}, axis[i], axis[i + 1], half_width_m});
    boxes_.push_back(box_of(std::span(axis).subspan(i, 2)).widened(half_width_m));
  }
}

void TakenLand::index() { grid_ = grid_of(boxes_, kTakenBucket_m); }

double TakenLand::distance_m(Vec2 p, double within_m) const {
  double least_m = within_m;
  for (const std::uint32_t i : boxes_about(grid_, Box2{p, p}.widened(within_m))) {
    const Piece& piece = pieces_[i];
    if (!boxes_[i].widened(std::max(least_m, 0.0)).contains(p)) continue;
    least_m =
        std::min(least_m, piece.polygon.outer.empty() ? distance_to_segment(piece.a, piece.b, p) - piece.half_width_m
                                                      : distance_to_polygon(piece.polygon, p));
  }
  return least_m;
}

std::vector<Polygon> TakenLand::polygons_near(const Box2& box) const {
  std::vector<Polygon> near;
  for (const std::uint32_t i : boxes_about(grid_, box)) {
    if (!boxes_[i].touches(box)) continue;
    const Piece& piece = pieces_[i];
    if (piece.polygon.outer.empty()) {
      near.push_back(quadrangle(piece.a, piece.b, piece.half_width_m));
      continue;
    }
    Polygon trimmed{trimmed_to(piece.polygon.outer, box), {}};
    for (const Ring& hole : piece.polygon.holes)
      if (Ring part = trimmed_to(hole, box); !part.empty()) trimmed.holes.push_back(std::move(part));
    if (!trimmed.outer.empty()) near.push_back(std::move(trimmed));
  }
  return near;
}

TakenLand taken_land_of(const InventedMap& map, const Terrain& terrain, bool with_areas) {
  TakenLand taken;
  for (const InventedLine& line : map.lines)
    if (const double half_m = half_right_of_way_m(line); half_m > 0) taken.add(line.axis, half_m);
  if (with_areas) {
    for (const InventedArea& area : map.areas)
      if (is_town_area(area.tags)) taken.add(area.polygon);
    for (const River& river : terrain.rivers)
      taken.add(river.axis, *std::ranges::max_element(river.width_m) / 2 + kBank_m);
    for (const Polygon& sea : terrain.sea) taken.add(sea);
  }
  return taken;
}

}  // namespace citykiln::invent
