#include "compiler/plants/expand.h"

#include <algorithm>

#include "compiler/contract/draw.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/plants/blue_noise.h"

namespace citykiln::plants {
namespace {

// A trunk's distance to roads, paths and buildings.
constexpr double kTrunkClearance_m = 1.25;
// Roads, paths and rails, and buildings, by their classes' priorities (surface_classes.inc).
constexpr int kLeastBuiltPriority = 70;
// Trunks reach below the ground by their own roots; their feet stand on the exact field.
constexpr double kHeightSpread = 0.3;
constexpr double kUntaggedHeight_m = 9;

void stand(Placed& placed, Archetype archetype, Vec2 at, double height_m, const Draw& draw, OsmId feature, const map::Heightfield& heights) {
  const Vec2 place = snapped(at), yaw = direction_of(draw.unit(10));
  placed[static_cast<std::size_t>(archetype)].push_back({at_height(place, snapped(map::height_m_at(heights, place))), yaw.x, yaw.y, std::min(height_m, kTallestTree_m), feature});
}

bool is_covered(const ground::SurfaceMap& map, Vec2 p) {
  const std::uint32_t top = ground::surface_at(map, p);
  if (top == ground::kNoSurface) return false;
  const map::SurfaceValues& values = map::values_of(map.surfaces[top].surface);
  const bool is_driven = values.group == map::SurfaceGroup::kRoad || values.group == map::SurfaceGroup::kRail;
  return is_driven || values.group == map::SurfaceGroup::kBuilding || values.group == map::SurfaceGroup::kWater;
}

void place_trees(Placed& placed, std::span<const Tree> trees, const ground::SurfaceMap& map, const map::Heightfield& heights, std::uint64_t seed, Report& report) {
  Account account;
  for (const Tree& tree : trees) {
    ++account.in;
    if (is_covered(map, tree.at)) {
      report.drop(account, Code::kTreeOnRoad, tree.id.osm);
      continue;
    }
    ++account.out;
    const Draw draw(seed, stable_id(tree.id), "tree");
    const double height_m = tree.height_m > 0 ? tree.height_m : kUntaggedHeight_m * (1 + kHeightSpread * (2 * draw.unit(0) - 1));
    stand(placed, tree.archetype, tree.at, height_m, draw, tree.id.osm, heights);
  }
  report.account("bake", "tree") = account;
}

// The index of a wood's surface, by id; surfaces are sorted by id.
std::uint32_t surface_of(const ground::SurfaceMap& map, const Wood& wood) {
  const auto found = std::lower_bound(map.surfaces.begin(), map.surfaces.end(), wood.surface, [](const ground::Surface& s, ObjectId id) { return s.id < id; });
  for (auto at = found; at != map.surfaces.end() && at->id == wood.surface; ++at)
    if (map::values_of(at->surface).group != map::SurfaceGroup::kBuilding) return static_cast<std::uint32_t>(at - map.surfaces.begin());
  return ground::kNoSurface;
}

Box2 common(const Box2& a, const Box2& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)}, {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

void place_wood(Placed& placed, const Wood& wood, const ground::SurfaceMap& map, const map::Heightfield& heights, const Box2& box, std::uint64_t seed) {
  const std::uint32_t surface = surface_of(map, wood);
  if (surface == ground::kNoSurface) return;
  Box2 around;
  for (const Ring& ring : map.surfaces[surface].rings)
    for (const Vec2 p : ring) around.grow(p);
  const Box2 here = common(box, around);
  if (here.is_empty()) return;
  const auto allowed = [&](Vec2 p, double& slope) {
    if (!map.box.contains(p) || ground::surface_at(map, p) != surface) return false;
    if (ground::clearance_m(map, p, kLeastBuiltPriority, kTrunkClearance_m) < kTrunkClearance_m) return false;
    slope = 1 / map::normal_at(heights, p).z;
    return true;
  };
  for (const Site& site : blue_noise(seed, stable_id(wood.surface), wood.spacing_m, here, kReach_m, allowed)) {
    const Draw draw(seed, site.id, "tree");
    const Archetype archetype = draw.unit(1) < wood.needle_share ? Archetype::kNeedleLeaved : Archetype::kBroadLeaved;
    stand(placed, archetype, site.at, wood.height_m * (1 + kHeightSpread * (2 * draw.unit(0) - 1)), draw, wood.surface.osm, heights);
  }
}

}  // namespace

Placed expand(std::span<const Tree> trees, std::span<const Wood> woods, const ground::SurfaceMap& surfaces, const map::Heightfield& heights,
              const Box2& box, std::uint64_t seed, Report& report) {
  Placed placed;
  place_trees(placed, trees, surfaces, heights, seed, report);
  for (const Wood& wood : woods) place_wood(placed, wood, surfaces, heights, box, seed);
  return placed;
}

}  // namespace citykiln::plants
