// Trees and hedges beside roads outside of towns, as mapped and as built.
#include <algorithm>
#include <cmath>

#include "compiler/assume/beside.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "tests/charts/assumed_values.h"

namespace citykiln::charts {
namespace {

using map::LandCoverClass;
using map::Track;

/// A row is beside a road within this distance of its kerb. Trees of a row are at most twice kBetweenTrees_m apart.
constexpr double kRowFromKerb_m = 10, kBetweenTrees_m = 10;
/// Roads are looked at this often; shorter ones do not count.
constexpr double kLookBeside_m = 8, kShortestRoad_m = 60;
/// Where nothing of a kind is mapped within this distance of a road, the map says nothing about it.
constexpr double kMappedNear_m = 256;
/// Roads with houses along more than this share are in towns.
constexpr double kCountryHouses = 0.1;
constexpr double kRowBucket_m = 64;

constexpr int kLeftKey = 0, kRightKey = 1;

bool is_open_side(const assume::SideFacts& side) {
  return (side.land == assume::LandUse::kFarmland || side.land == assume::LandUse::kNone) &&
         side.houses < kCountryHouses;
}

bool may_have_rows(const Track& track) {
  const bool is_road =
      track.surface == LandCoverClass::kPrimaryRoad || track.surface == LandCoverClass::kSecondaryRoad ||
      track.surface == LandCoverClass::kTertiaryRoad || track.surface == LandCoverClass::kResidentialRoad;
  return is_road && track.passage == map::Passage::kGround && !track.is_link && !track.is_roundabout &&
         length_m(track.axis) >= kShortestRoad_m;
}

/// Rows as segments; single trees have no length.
struct RowSegments {
  std::vector<std::pair<Vec2, Vec2>> all;
  BoxGrid grid;
};

RowSegments indexed(std::vector<std::pair<Vec2, Vec2>> all) {
  RowSegments rows{std::move(all), {}};
  std::vector<Box2> boxes;
  for (const auto& [a, b] : rows.all) boxes.push_back(box_of_segment(a, b));
  if (!boxes.empty()) rows.grid = grid_of(boxes, kRowBucket_m);
  return rows;
}

void add_line(const Polyline& line, std::vector<std::pair<Vec2, Vec2>>& all) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) all.emplace_back(line[i], line[i + 1]);
}

RowSegments mapped_trees_of(const map::Features& features) {
  std::vector<std::pair<Vec2, Vec2>> all;
  for (const map::PointFeature& point : features.points)
    if (point.kind == map::PointKind::kTree) all.emplace_back(point.at, point.at);
  for (const map::TreeRow& row : features.tree_rows) add_line(row.axis, all);
  return indexed(std::move(all));
}

RowSegments hedges_of(const map::Features& features) {
  std::vector<std::pair<Vec2, Vec2>> all;
  for (const map::Barrier& barrier : features.barriers)
    if (barrier.kind == map::BarrierKind::kHedge) add_line(barrier.axis, all);
  return indexed(std::move(all));
}

/// True if a row is on a side of a road at a place of its axis.
/// @param out  The direction square to the road, towards the side.
bool has_row_beside(const RowSegments& rows, Vec2 at, Vec2 out, double kerb_m) {
  const double far_m = kerb_m + kRowFromKerb_m;
  return !rows.all.empty() && any_about(rows.grid, Box2{at, at}.widened(far_m), [&](std::uint32_t i) {
    const Vec2 offset = nearest_point(rows.all[i].first, rows.all[i].second, at) - at;
    const double beside_m = dot(offset, out);
    return beside_m > 0 && beside_m < far_m && std::abs(cross(offset, out)) < kBetweenTrees_m;
  });
}

/// The share of a road with rows on a side, 0 left and 1 right.
double share_with_rows(const Track& track, int side, const RowSegments& rows) {
  const double axis_m = track.section.axis_offset_m;
  const double kerb_m = side == kLeftKey ? axis_m : map::carriageway_width_m(track.section) - axis_m;
  double with_m = 0;
  for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
    const Vec2 a = track.axis[i], b = track.axis[i + 1], left = left_of(unit(b - a));
    const int looks = std::max(1, static_cast<int>(distance(a, b) / kLookBeside_m));
    for (int k = 0; k < looks; ++k)
      if (has_row_beside(rows, a + (b - a) * ((k + 0.5) / looks), side == kLeftKey ? left : left * -1.0, kerb_m))
        with_m += distance(a, b) / looks;
  }
  return with_m / length_m(track.axis);
}

bool has_mapped_near(const RowSegments& rows, const Track& track) {
  return !rows.all.empty() && any_about(rows.grid, box_of(track.axis).widened(kMappedNear_m), [&](std::uint32_t i) {
    return distance_to_polyline(track.axis, rows.all[i].first) < kMappedNear_m;
  });
}

/// Samples of both sides of the roads outside of towns that have rows near them.
std::vector<Sample> row_samples(const map::Features& features, const RowSegments& rows) {
  const assume::Surroundings surroundings = assume::index_surroundings(features);
  std::vector<Sample> samples;
  for (const Track& track : features.tracks) {
    if (!may_have_rows(track) || !has_mapped_near(rows, track)) continue;
    const assume::BothSides sides = assume::facts_beside(surroundings, track);
    if (!is_open_side(sides.left) || !is_open_side(sides.right)) continue;
    for (const int side : {kLeftKey, kRightKey})
      samples.push_back({.key = {track.id.osm, side},
                         .at = box_of(track.axis).centre(),
                         .kind = static_cast<int>(track.surface),
                         .tagged = share_with_rows(track, side, rows) >= 0.5 ? 1.0 : 0.0});
  }
  return samples;
}

}  // namespace

std::vector<Sample> tagged_avenues(const Place& place) {
  return row_samples(place.mapped, mapped_trees_of(place.mapped));
}

Values built_avenues(const map::Features& features) {
  MeansByWay built;
  for (const Track& track : features.tracks) {
    if (!map::is_street(track.surface)) continue;
    const double long_m = length_m(track.axis);
    const auto has_trees = [&](map::TreeSides side) {
      return track.trees == side || track.trees == map::TreeSides::kBoth ? 1.0 : 0.0;
    };
    built.add({track.id.osm, kLeftKey}, has_trees(map::TreeSides::kLeft), long_m);
    built.add({track.id.osm, kRightKey}, has_trees(map::TreeSides::kRight), long_m);
  }
  return built.means();
}

std::vector<Sample> tagged_lane_hedges(const Place& place) {
  return row_samples(place.mapped, hedges_of(place.mapped));
}

Values built_lane_hedges(const map::Features& features) {
  const RowSegments hedges = hedges_of(features);
  MeansByWay built;
  for (const Track& track : features.tracks) {
    if (!map::is_street(track.surface)) continue;
    for (const int side : {kLeftKey, kRightKey})
      built.add({track.id.osm, side}, share_with_rows(track, side, hedges), length_m(track.axis));
  }
  return built.means();
}

}  // namespace citykiln::charts
