#include "compiler/lots/land_of.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/ways/curve_nodes.h"
#include "compiler/parcels/rights_of_way.h"

namespace citykiln::lots {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using parcels::LineKind;
using roads::Road;

constexpr double kLandBucket_m = 64;
// A path is the pavement of a street within this distance of its kerb.
constexpr double kBesideStreet_m = 10;
// The widest half of a street to which this applies, and the shortest stretch of a path.
constexpr double kWidestHalf_m = 20, kShortestBeside_m = 20;
// The cosine of 20 degrees.
constexpr double kAlongStreet = 0.94;

struct SizeRow {
  map::CountryGroup group;
  double frontage_m, depth_m;
};
constexpr SizeRow kSizes[] = {
#define LOT_SIZE(group, frontage_m, depth_m) {map::CountryGroup::group, frontage_m, depth_m},
#define LOT_SIZE_ELSEWHERE(frontage_m, depth_m) {map::CountryGroup::kCount, frontage_m, depth_m},
#include "compiler/lots/lot_sizes.inc"
};

std::uint8_t size_of(map::CountryGroup group) {
  const auto row = std::ranges::find(kSizes, group, &SizeRow::group);
  return static_cast<std::uint8_t>(row == std::end(kSizes) ? std::size(kSizes) - 1 : row - std::begin(kSizes));
}

LineKind kind_of_line(const Road& road) {
  const LandCoverGroup group = map::values_of(road.surface).group;
  if (road.surface == LandCoverClass::kTram || road.surface == LandCoverClass::kStreetRails) return LineKind::kNone;
  if (road.surface == LandCoverClass::kMotorwayRoad || road.surface == LandCoverClass::kRunway)
    return LineKind::kBarrier;
  if (group == LandCoverGroup::kRail) return LineKind::kBarrier;
  return group == LandCoverGroup::kRoad ? LineKind::kStreet : LineKind::kNone;
}

bool may_be_pavement(const Road& road) {
  return road.surface == LandCoverClass::kPavedFootPath || road.surface == LandCoverClass::kFootPath ||
         road.surface == LandCoverClass::kCyclePath;
}

bool is_west_of(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// The points of curves between mapped nodes, sorted. Lots are divided by mapped axes, which are at most some metres
// from the curves: the work grows with the square of the number of points along a block.
std::vector<Vec2> points_of_curves(std::span<const map::Track> tracks) {
  std::vector<Vec2> points;
  for (const map::Track& track : tracks)
    for (std::size_t i = 0; i < track.node_ids.size(); ++i)
      if (map::is_curve_node(track.node_ids[i])) points.push_back(track.axis[i]);
  std::ranges::sort(points, is_west_of);
  return points;
}

// The ends of an axis, and its points that are not of curves.
Polyline mapped_axis(const Polyline& axis, std::span<const Vec2> of_curves) {
  Polyline mapped;
  for (std::size_t i = 0; i < axis.size(); ++i)
    if (i == 0 || i + 1 == axis.size() || !std::ranges::binary_search(of_curves, axis[i], is_west_of))
      mapped.push_back(axis[i]);
  return mapped;
}

// Sides of tracks with closed frontages, sorted by id.
using ClosedSides = std::vector<std::pair<ObjectId, std::uint8_t>>;

ClosedSides closed_sides_of(std::span<const map::Track> tracks) {
  ClosedSides sides;
  for (const map::Track& track : tracks)
    if (track.closed_sides != 0) sides.emplace_back(track.id, track.closed_sides);
  std::ranges::sort(sides);
  return sides;
}

// The width of a road's carriageway and lanes beyond it on one side. Where houses stand in a row it ends at the nearest
// wall, so that the recesses beside it belong to lots.
double side_m(double kerb_m, double raised_m, double half_m, std::span<const roads::WidthLimit> limits,
              bool is_closed) {
  if (!is_closed) return kerb_m + raised_m;
  for (const roads::WidthLimit& limit : limits) raised_m = std::min(raised_m, std::max(0.0, limit.half_m - half_m));
  return kerb_m + raised_m;
}

parcels::Line line_of(const Road& road, LineKind kind, const ClosedSides& closed) {
  const auto found = std::ranges::lower_bound(closed, road.id, {}, &ClosedSides::value_type::first);
  const int sides = found != closed.end() && found->first == road.id ? found->second : 0;
  const double half_m = roads::width_m(road) / 2;
  const double left_m = side_m(roads::widest_left_m(road), roads::raised_left_m(road), half_m, road.width_limits.left,
                               (sides & map::kLeftSide) != 0),
               right_m = side_m(roads::widest_right_m(road), roads::raised_right_m(road), half_m,
                                road.width_limits.right, (sides & map::kRightSide) != 0);
  return {.id = stable_id(road.id),
          .axis = road.axis,
          .left_m = left_m - kUnderPavement_m,
          .right_m = right_m - kUnderPavement_m,
          .kind = kind,
          .left_size = size_of(road.country),
          .right_size = size_of(road.country)};
}

// Segments of streets, to find paths that run along them.
struct StreetSegments {
  struct Segment {
    Vec2 a, b;
    double half_m;
  };
  std::vector<Segment> all;
  BoxGrid grid;
};

StreetSegments street_segments(std::span<const Road> roads) {
  StreetSegments streets;
  std::vector<Box2> boxes;
  for (const Road& road : roads) {
    if (kind_of_line(road) != LineKind::kStreet || road.surface == LandCoverClass::kServiceRoad) continue;
    const double half_m = std::min(kWidestHalf_m, std::max(roads::left_m(road), roads::right_m(road)));
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      streets.all.push_back({road.axis[i], road.axis[i + 1], half_m});
      boxes.push_back(box_of_segment(road.axis[i], road.axis[i + 1]).widened(half_m + kBesideStreet_m));
    }
  }
  if (!boxes.empty()) streets.grid = grid_of(boxes, kLandBucket_m);
  return streets;
}

bool is_beside_street(const StreetSegments& streets, Vec2 p, Vec2 along) {
  if (streets.all.empty()) return false;
  return std::ranges::any_of(boxes_about(streets.grid, p), [&](std::uint32_t i) {
    const StreetSegments::Segment& s = streets.all[i];
    return std::abs(dot(unit(s.b - s.a), along)) >= kAlongStreet &&
           distance_to_segment(s.a, s.b, p) <= s.half_m + kBesideStreet_m;
  });
}

// True if at two of three places a segment of a path runs along a street.
bool is_segment_beside(const StreetSegments& streets, Vec2 a, Vec2 b) {
  int beside = 0;
  for (const double share : {0.25, 0.5, 0.75}) beside += is_beside_street(streets, a + (b - a) * share, unit(b - a));
  return beside >= 2;
}

// Adds the stretches of a path along streets as streets.
void add_pavement_paths(const Road& path, const StreetSegments& streets, const ClosedSides& closed,
                        std::vector<parcels::Line>& lines) {
  for (std::size_t i = 0; i + 1 < path.axis.size();) {
    std::size_t end = i;
    while (end + 1 < path.axis.size() && is_segment_beside(streets, path.axis[end], path.axis[end + 1])) ++end;
    const auto first = path.axis.begin() + static_cast<std::ptrdiff_t>(i);
    Polyline stretch(first, first + static_cast<std::ptrdiff_t>(end - i + 1));
    if (end > i && length_m(stretch) >= kShortestBeside_m) {
      parcels::Line line = line_of(path, LineKind::kStreet, closed);
      line.id = stable_id(line.id, "pavement", i);
      line.axis = std::move(stretch);
      lines.push_back(std::move(line));
    }
    i = std::max(end, i + 1);
  }
}

bool is_house(const map::Footprint& footprint) {
  const auto own = static_cast<map::BuildingClass>(footprint.building_class);
  return !footprint.is_part && !footprint.outline && !footprint.is_open && footprint.min_height_m <= 0 &&
         footprint.polygon.outer.size() >= 3 && own != map::BuildingClass::kRoof && own != map::BuildingClass::kSteps &&
         own != map::BuildingClass::kColumn && own != map::BuildingClass::kShelter;
}

bool is_taken(const map::AreaFeature& area) {
  return area.surface != LandCoverClass::kUnknown && area.surface != LandCoverClass::kPool &&
         !is_land_of_yards(area.surface);
}

}  // namespace

bool is_land_of_yards(LandCoverClass surface) {
  return surface == LandCoverClass::kResidential || surface == LandCoverClass::kCommercial ||
         surface == LandCoverClass::kRetail || surface == LandCoverClass::kIndustrial;
}

MapLand land_of(const map::FeatureView& features, std::span<const Road> roads, std::span<const OsmId> private_ways) {
  MapLand made;
  parcels::Land& land = made.land;
  land.extent = features.extent;
  land.sizes.clear();
  for (const SizeRow& row : kSizes)
    land.sizes.push_back(
        {.area_m2 = row.frontage_m * row.depth_m, .frontage_m = row.frontage_m, .depth_m = row.depth_m});
  const StreetSegments streets = street_segments(roads);
  const ClosedSides closed = closed_sides_of(features.tracks);
  const std::vector<Vec2> of_curves = points_of_curves(features.tracks);
  for (const Road& road : roads) {
    if (std::ranges::binary_search(private_ways, road.id.osm)) continue;
    if (may_be_pavement(road)) add_pavement_paths(road, streets, closed, land.lines);
    if (const LineKind kind = kind_of_line(road); kind != LineKind::kNone)
      land.lines.push_back(line_of(road, kind, closed));
    made.roads.resize(land.lines.size(), static_cast<std::uint32_t>(&road - roads.data()));
  }
  for (parcels::Line& line : land.lines) line.axis = mapped_axis(line.axis, of_curves);
  for (const map::Waterway& river : features.waterways)
    if (river.passage == map::Passage::kGround)
      land.lines.push_back({.id = stable_id(river.id),
                            .axis = river.axis,
                            .left_m = std::max(river.width_m, river.most_width_m) / 2,
                            .right_m = std::max(river.width_m, river.most_width_m) / 2,
                            .kind = LineKind::kBarrier});
  made.roads.resize(land.lines.size(), parcels::kNoIndex);
  for (const map::AreaFeature& area : features.areas)
    if (is_taken(area)) land.taken.push_back(area.polygon);
  for (std::uint32_t f = 0; f < features.footprints.size(); ++f) {
    if (!is_house(features.footprints[f])) continue;
    land.footprints.push_back({stable_id(features.footprints[f].id), features.footprints[f].polygon.outer});
    made.footprints.push_back(f);
  }
  return made;
}

}  // namespace citykiln::lots
