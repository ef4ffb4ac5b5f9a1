#include "compiler/plants/expand.h"

#include <algorithm>

#include "compiler/contract/draw.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/plants/blue_noise.h"

namespace citykiln::plants {
namespace {

// Water, pitches and squares, paths, rails, roads and buildings, by their classes' priorities (surface_classes.inc).
constexpr int kLeastBarePriority = 50;

// Trees of one wood differ by this share of their mean height.
constexpr double kHeightSpread = 0.3;
constexpr double kUntaggedHeight_m = 9;

// A place's neighbours are asked this far, since what lies within the clearance of the farthest must be known too.
constexpr double kDecidingReach_m = kReach_m - kTrunkClearance_m;

// Indices of what is drawn for a tree.
enum Dice : std::uint32_t { kHeightDice, kSpeciesDice, kYawDice, kVariantDice };

void stand(Placed& placed, Species species, Vec3 foot, double height_m, const Draw& draw, OsmId feature) {
  const Vec2 yaw = direction_of(draw.unit(kYawDice));
  const auto variant = static_cast<std::uint8_t>(draw.unit(kVariantDice) * kVariants);
  placed[{species, variant}].push_back({snapped(foot), yaw.x, yaw.y, std::min(height_m, kTallestTree_m), feature});
}

double drawn_height_m(double mean_m, const Draw& draw) {
  return mean_m * draw.between(1 - kHeightSpread, 1 + kHeightSpread, kHeightDice);
}

bool stands_in(const Box2& box, Vec2 p) {
  return p.x >= box.min.x && p.y >= box.min.y && p.x < box.max.x && p.y < box.max.y;
}

bool is_covered(const ground::SurfaceMap& map, Vec2 p) {
  const std::uint32_t top = ground::surface_at(map, p);
  if (top == ground::kNoSurface) return false;
  const map::SurfaceValues& values = map::values_of(map.surfaces[top].surface);
  const bool is_driven = values.group == map::SurfaceGroup::kRoad || values.group == map::SurfaceGroup::kRail;
  return is_driven || values.group == map::SurfaceGroup::kBuilding || values.group == map::SurfaceGroup::kWater;
}

void place_trees(Placed& placed, std::span<const Tree> trees, const ground::SurfaceMap& map,
                 const ground::Carving& ground, const Box2& box, std::uint64_t seed, Report& report) {
  Account account;
  for (const Tree& tree : trees) {
    if (!stands_in(box, tree.at)) continue;
    ++account.in;
    if (is_covered(map, tree.at)) {
      report.drop(account, Code::kTreeOnRoad, tree.id.osm);
      continue;
    }
    ++account.out;
    const Draw draw(seed, stable_id(tree.id), "tree");
    const double height_m = tree.height_m > 0 ? tree.height_m : drawn_height_m(kUntaggedHeight_m, draw);
    stand(placed, tree.species, at_height(tree.at, land_m(ground, tree.at)), height_m, draw, tree.id.osm);
  }
  report.account("bake", "tree") = account;
}

// The index of a wood's surface, by id; surfaces are sorted by id.
std::uint32_t surface_of(const ground::SurfaceMap& map, const Wood& wood) {
  const auto found = std::lower_bound(map.surfaces.begin(), map.surfaces.end(), wood.surface,
                                      [](const ground::Surface& s, ObjectId id) { return s.id < id; });
  for (auto at = found; at != map.surfaces.end() && at->id == wood.surface; ++at)
    if (map::values_of(at->surface).group != map::SurfaceGroup::kBuilding)
      return static_cast<std::uint32_t>(at - map.surfaces.begin());
  return ground::kNoSurface;
}

Box2 common(const Box2& a, const Box2& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

void place_wood(Placed& placed, const Wood& wood, const ground::SurfaceMap& map, const ground::Carving& ground,
                const Box2& box, std::uint64_t seed, Report& report) {
  const std::uint32_t surface = surface_of(map, wood);
  if (surface == ground::kNoSurface) return;
  Box2 around;
  for (const Ring& ring : map.surfaces[surface].rings)
    for (const Vec2 p : ring) around.grow(p);
  const Box2 here = common(box, around);
  if (here.is_empty()) return;
  const auto allowed = [&](Vec2 p, double& height_m) {
    if (!around.contains(p) || !map.box.contains(p) || ground::surface_at(map, p) != surface) return false;
    if (ground::clearance_m(map, p, kLeastBarePriority, kTrunkClearance_m) < kTrunkClearance_m) return false;
    height_m = height_m_at(ground.terrain, p);
    return true;
  };
  const Sites sites = blue_noise(seed, stable_id(wood.surface), wood.spacing_m, here, kDecidingReach_m, allowed);
  if (sites.undecided > 0) report.add(Code::kTreesUndecided, wood.surface.osm, static_cast<double>(sites.undecided));
  for (const Site& site : sites.accepted) {
    const Draw draw(seed, site.id, "tree");
    const Species species = draw.unit(kSpeciesDice) < wood.needle_share ? Species::kSpruce : Species::kBeech;
    stand(placed, species, at_height(site.at, land_m(ground, site.at)), drawn_height_m(wood.height_m, draw), draw,
          wood.surface.osm);
  }
}

}  // namespace

Placed expand(std::span<const Tree> trees, std::span<const Wood> woods, const ground::SurfaceMap& surfaces,
              const ground::Carving& ground, const Box2& box, std::uint64_t seed, Report& report) {
  Placed placed;
  place_trees(placed, trees, surfaces, ground, box, seed, report);
  for (const Wood& wood : woods) place_wood(placed, wood, surfaces, ground, box, seed, report);
  return placed;
}

}  // namespace citykiln::plants
