#include "compiler/assume/avenues.h"

#include <algorithm>
#include <optional>

#include "compiler/assume/beside.h"
#include "compiler/assume/cut_way.h"
#include "compiler/assume/pavements.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"

namespace citykiln::assume {
namespace {

// The regions of avenues.inc.
enum class AvenueRegion : std::uint8_t {
#define AVENUE_REGION(name, ...) name,
#include "compiler/assume/avenues.inc"
#undef AVENUE_REGION
  kCount
};

const std::vector<Ring>& avenue_rings() {
  static const std::vector<Ring> kRings = {
#define AVENUE_REGION(name, ...) Ring{__VA_ARGS__},
#include "compiler/assume/avenues.inc"
#undef AVENUE_REGION
  };
  return kRings;
}

struct AvenueRow {
  AvenueRegion region;
  map::LandCoverClass surface;
  int percent;
  map::PlantKind kind;
};
constexpr AvenueRow kAvenues[] = {
#define AVENUE(region, surface, percent, kind) \
  {AvenueRegion::region, map::LandCoverClass::surface, percent, map::PlantKind::kind},
#include "compiler/assume/avenues.inc"
#undef AVENUE
};

// Shorter stretches have no row of trees.
constexpr double kShortestAvenue_m = 60;
constexpr double kAvenueHouses = 0.1;
constexpr double kTreeBucket_m = 64;

std::optional<AvenueRegion> avenue_region_at(LonLat place) {
  const std::vector<Ring>& rings = avenue_rings();
  for (std::size_t i = 0; i < rings.size(); ++i)
    if (winding_number(rings[i], {place.lon_deg, place.lat_deg}) != 0) return static_cast<AvenueRegion>(i);
  return std::nullopt;
}

bool may_have_avenue(const map::Track& track) {
  const bool is_street = track.passage == map::Passage::kGround && !track.is_rail && !track.is_indoor &&
                         !track.is_link && !track.is_roundabout && !track.is_through_building;
  return is_street && track.trees == map::TreeSides::kNone &&
         std::ranges::find(kAvenues, track.surface, &AvenueRow::surface) != std::end(kAvenues);
}

// The species along a way, drawn by its id; kUnknown: no avenue.
map::PlantKind avenue_kind(const map::Track& track, AvenueRegion region, std::uint64_t seed) {
  const RandomSequence draw(seed, stable_id(ObjectId{track.id.osm, 0}), "avenue");
  double left = 100 * draw.unit(0);
  for (const AvenueRow& row : kAvenues)
    if (row.region == region && row.surface == track.surface && (left -= row.percent) < 0) return row.kind;
  return map::PlantKind::kUnknown;
}

// Mapped trees and rows of trees, as segments.
struct MappedTrees {
  std::vector<std::pair<Vec2, Vec2>> all;
  BoxGrid grid;
};

MappedTrees mapped_trees(const map::FeatureView& features) {
  MappedTrees trees;
  for (const map::PointFeature& point : features.points)
    if (point.kind == map::PointKind::kTree) trees.all.emplace_back(point.at, point.at);
  for (const map::TreeRow& row : features.tree_rows)
    for (std::size_t i = 0; i + 1 < row.axis.size(); ++i) trees.all.emplace_back(row.axis[i], row.axis[i + 1]);
  std::vector<Box2> boxes;
  for (const auto& [a, b] : trees.all) boxes.push_back(box_of_segment(a, b));
  if (!boxes.empty()) trees.grid = grid_of(boxes, kTreeBucket_m);
  return trees;
}

// True if a tree is near one of the points along a line, at most 8 m apart.
bool has_trees_near(const MappedTrees& trees, const Polyline& line) {
  constexpr double kStep_m = 8;
  const auto is_near = [&](Vec2 at) {
    return any_about(trees.grid, Box2{at, at}.widened(kMappedTrees_m), [&](std::uint32_t i) {
      return distance_to_segment(trees.all[i].first, trees.all[i].second, at) < kMappedTrees_m;
    });
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const int steps = 1 + static_cast<int>(distance(line[i], line[i + 1]) / kStep_m);
    for (int k = 0; k <= steps; ++k)
      if (is_near(line[i] + (line[i + 1] - line[i]) * (static_cast<double>(k) / steps))) return true;
  }
  return false;
}

bool is_open(const SideFacts& side) {
  const bool is_open_land = side.land == LandUse::kFarmland || side.land == LandUse::kNone;
  return is_open_land && side.houses < kAvenueHouses && side.houses_across < kAvenueHouses &&
         side.room_m >= kAvenueRoom_m;
}

map::TreeSides open_sides(const BothSides& sides) {
  const bool left = is_open(sides.left), right = is_open(sides.right);
  if (left && right) return map::TreeSides::kBoth;
  return left ? map::TreeSides::kLeft : right ? map::TreeSides::kRight : map::TreeSides::kNone;
}

}  // namespace

std::vector<map::Track> assume_avenues(const map::FeatureView& features, const LonLatOf& lonlat_of, std::uint64_t seed,
                                       Report& report) {
  const Surroundings surroundings = index_surroundings(features);
  const CommonNodes common = common_nodes_of(features.tracks);
  const MappedTrees trees = mapped_trees(features);
  const auto kind_of = [&](const map::Track& track) {
    if (!may_have_avenue(track)) return map::PlantKind::kUnknown;
    const std::optional<AvenueRegion> region = avenue_region_at(lonlat_of(track.axis.front()));
    return region ? avenue_kind(track, *region, seed) : map::PlantKind::kUnknown;
  };
  const auto cut = [&](const map::Track& track) {
    const bool may_be_cut = !track.is_piece && kind_of(track) != map::PlantKind::kUnknown;
    return may_be_cut ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
  };
  const auto change = [&](map::Track& stretch) {
    const map::PlantKind kind = kind_of(stretch);
    const double long_m = length_m(stretch.axis);
    if (kind == map::PlantKind::kUnknown || long_m > kLongestWhole_m || long_m < kShortestAvenue_m) return false;
    if (has_trees_near(trees, stretch.axis)) return false;
    stretch.trees = open_sides(facts_beside(surroundings, stretch));
    if (stretch.trees != map::TreeSides::kNone) stretch.tree_kind = kind;
    return stretch.trees != map::TreeSides::kNone;
  };
  return with_changed_stretches(features.tracks, Assumption::kRoadsides, "avenue_track", cut, change, report);
}

}  // namespace citykiln::assume
