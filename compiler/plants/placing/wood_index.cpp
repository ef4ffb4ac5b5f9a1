#include "compiler/plants/placing/wood_index.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/plants/tree_line.h"

namespace citykiln::plants {
namespace {

// Spread of heights in one wood as a share of their mean.
constexpr double kWoodHeightSpread = 0.3;

// Wood::height_m is that of a species with this default height; other species scale with theirs.
constexpr double kTall_m = 22;

// The wood of each polygon. `surfaces` is sorted by id; a building may have the id of a wood.
std::vector<std::uint32_t> woods_by_surface(std::span<const Wood> woods,
                                            std::span<const ground::LandCoverPolygon> surfaces) {
  std::vector<std::uint32_t> of_surface(surfaces.size(), ground::kNoLandCover);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (map::values_of(surfaces[s].surface).group == map::LandCoverGroup::kBuilding) continue;
    const auto found = std::ranges::lower_bound(woods, surfaces[s].id, {}, &Wood::surface);
    if (found != woods.end() && found->surface == surfaces[s].id)
      of_surface[s] = static_cast<std::uint32_t>(found - woods.begin());
  }
  return of_surface;
}

}  // namespace

WoodIndex index_woods(std::span<const Wood> woods, const PlacingContext& context) {
  WoodIndex wood_index{woods, context, woods_by_surface(woods, context.surfaces.surfaces), {}};
  assert(std::ranges::is_sorted(woods, {}, &Wood::surface));
  for (const Wood& wood : woods) wood_index.densities.push_back(density_for(wood.trees_per_ha));
  return wood_index;
}

std::uint32_t wood_at(const WoodIndex& wood_index, Vec2 p) {
  const std::uint32_t surface = ground::land_cover_at(wood_index.context.surfaces, p);
  return surface == ground::kNoLandCover ? ground::kNoLandCover : wood_index.of_surface[surface];
}

SampleDensity density_at(const WoodIndex& woods, Vec2 p) {
  const PlacingContext& context = woods.context;
  if (!context.surfaces.box.contains(p)) return {};
  const std::uint32_t wood = wood_at(woods, p);
  if (wood == ground::kNoLandCover) return {};
  if (clearance_m(context.surfaces, p, kLeastObstaclePriority, kTrunkClearance_m) < kTrunkClearance_m) return {};
  SampleDensity density = woods.densities[wood];
  density.owner = wood;
  density.height_m = height_m_at(context.ground.terrain, p);
  density.normal_z = normal_at(context.ground.terrain, p).z;
  density.share *= wood_share_at(belt_m_at(context.latitude_deg, density.height_m));
  return density;
}

double height_in_wood_m(const Wood& wood, const SpeciesValues& species, const Habitat& habitat,
                        const RandomSequence& draw) {
  return wood.height_m * std::min(species.height_m / kTall_m, 1.4) * height_factor(habitat) *
         draw.between(1 - kWoodHeightSpread, 1 + kWoodHeightSpread, kHeightDraw);
}

CorridorIndex index_corridors(std::span<const PowerLineCorridor> corridors, const Box2& box) {
  constexpr double kBucket_m = 32;
  CorridorIndex sorted;
  std::vector<Box2> boxes;
  for (const PowerLineCorridor& lane : corridors)
    for (std::size_t i = 0; i + 1 < lane.axis.size(); ++i) {
      const Box2 about = box_of_segment(lane.axis[i], lane.axis[i + 1]).widened(lane.width_m / 2);
      if (!about.touches(box)) continue;
      sorted.segments.push_back({lane.axis[i], lane.axis[i + 1], lane.width_m / 2});
      boxes.push_back(about);
    }
  sorted.grid = grid_of(boxes, kBucket_m);
  return sorted;
}

bool is_in_corridor(const CorridorIndex& corridors, Vec2 p) {
  return std::ranges::any_of(boxes_about(corridors.grid, p), [&](std::uint32_t i) {
    const CorridorIndex::Segment& s = corridors.segments[i];
    return distance_to_segment(s.a, s.b, p) < s.half_m;
  });
}

}  // namespace citykiln::plants
