#include "preview/scene/lit_panes.h"

#include <algorithm>
#include <cmath>

#include "compiler/bake/bounds.h"
#include "compiler/buildings/generate.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/snap.h"
#include "preview/rgb.h"

namespace citykiln::preview {
namespace {

// Fine enough for rooms of windows, which are 0.3 m deep.
constexpr double kTolerance_m = 0.2;

// Parts of one window are this near to each other.
constexpr double kGap_m = 0.15;

// A rectangle in a vertical plane; x along it.
struct Patch {
  Vec2 along;
  double off_m;  // of the plane, along its outward normal
  double x0, x1, z0, z1;
  double light;  // luminance times area

  bool joins(const Patch& o) const {
    constexpr double kAlike = 0.999;
    return dot(along, o.along) > kAlike && std::abs(off_m - o.off_m) < kGap_m && x0 < o.x1 + kGap_m &&
           o.x0 < x1 + kGap_m && z0 < o.z1 + kGap_m && o.z0 < z1 + kGap_m;
  }
  void join(const Patch& o) {
    x0 = std::min(x0, o.x0), x1 = std::max(x1, o.x1), z0 = std::min(z0, o.z0), z1 = std::max(z1, o.z1);
    light += o.light;
  }
};

void add_patch(Vec3 a, Vec3 b, Vec3 c, double luminance, std::vector<Patch>& patches) {
  const Vec3 across = cross(b - a, c - a);
  const double twice_m2 = length(across);
  constexpr double kUpright = 0.1;
  if (!(twice_m2 > 0) || std::abs(across.z) > kUpright * twice_m2) return;
  const Vec2 outward = unit(in_plan(across)), along{-outward.y, outward.x};
  const auto [x0, x1] = std::minmax({dot(in_plan(a), along), dot(in_plan(b), along), dot(in_plan(c), along)});
  const auto [z0, z1] = std::minmax({a.z, b.z, c.z});
  Patch patch{along, dot(in_plan(a), outward), x0, x1, z0, z1, luminance * twice_m2 / 2};
  for (auto other = patches.begin(); other != patches.end();) {
    if (!other->joins(patch)) {
      ++other;
      continue;
    }
    patch.along = other->along, patch.off_m = other->off_m;
    patch.join(*other), other = patches.erase(other);
  }
  patches.push_back(patch);
}

// The largest distance by which shining surfaces about a patch stand out from it: the depth of a room before its back
// wall.
double depth_m(const Patch& patch, std::span<const Vec3> shining) {
  constexpr double kDeepest_m = 1;
  const Vec2 outward{patch.along.y, -patch.along.x};
  double deepest_m = 0;
  for (const Vec3 p : shining) {
    const double x = dot(in_plan(p), patch.along), off_m = dot(in_plan(p), outward) - patch.off_m;
    if (off_m > deepest_m && off_m < kDeepest_m && p.z > patch.z0 - kGap_m && p.z < patch.z1 + kGap_m &&
        x > patch.x0 - kGap_m && x < patch.x1 + kGap_m)
      deepest_m = off_m;
  }
  return deepest_m;
}

// The back of a room, which faces as the window does, and its sides are all seen from outside through its opening.
std::vector<LitPane> panes_of(const buildings::Building& building, const buildings::GeneratedBuilding& generated) {
  std::vector<Patch> patches;
  std::vector<Vec3> shining;
  for (const materials::MaterialMesh& part : generated.meshes) {
    const auto& emitted = materials::emission_of(part.material);
    const double shine = luminance({emitted[0], emitted[1], emitted[2]});
    if (shine <= 0) continue;
    shining.insert(shining.end(), part.mesh.positions.begin(), part.mesh.positions.end());
    for (const Triangle& t : part.mesh.triangles)
      add_patch(part.mesh.positions[t[0]], part.mesh.positions[t[1]], part.mesh.positions[t[2]], shine, patches);
  }
  std::vector<LitPane> panes;
  constexpr double kLeast_m = 0.4;  // sides of rooms are narrower
  for (const Patch& p : patches) {
    const Vec2 outward{p.along.y, -p.along.x}, back = p.along * p.x0 + outward * p.off_m;
    if (p.x1 - p.x0 < kLeast_m || p.z1 - p.z0 < kLeast_m) continue;
    panes.push_back({.building = building.id.osm,
                     .corner = at_height(back + outward * depth_m(p, shining), p.z0),
                     .along = p.along,
                     .width_m = p.x1 - p.x0,
                     .height_m = p.z1 - p.z0,
                     .luminance = p.light / ((p.x1 - p.x0) * (p.z1 - p.z0))});
  }
  return panes;
}

bool is_near(const buildings::Building& building, std::span<const Vec3> eyes) {
  const bake::Bounds bounds = bake::bounds_of(building);
  return std::ranges::any_of(eyes, [&](Vec3 eye) { return bake::distance_m(bounds, eye) <= kLitNear_m; });
}

}  // namespace

std::vector<LitPane> lit_panes_of(const scene::Scene& scene, std::span<const Vec3> eyes, int threads) {
  const std::optional<buildings::WeekTime> night = scene::night_of(scene.header);
  if (!night || !shows(scene.header, scene::SceneLayer::kBuildings)) return {};
  std::vector<const buildings::Building*> near;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const buildings::Building& building : chunk.buildings)
      if (is_near(building, eyes)) near.push_back(&building);
  const buildings::Rulebook rulebook = buildings::parse_rulebook(scene.header.rules);
  const auto by_building = for_each_slot<std::vector<LitPane>>(near.size(), threads, [&](std::size_t i) {
    Report ignored;
    return panes_of(
        *near[i],
        buildings::generate(*near[i], rulebook,
                            {.seed = scene.header.seed, .night = night, .lit_share = scene.header.shown.lit_windows},
                            kTolerance_m, ignored));
  });
  std::vector<LitPane> panes;
  for (const std::vector<LitPane>& of_one : by_building) panes.insert(panes.end(), of_one.begin(), of_one.end());
  return panes;
}

}  // namespace citykiln::preview
