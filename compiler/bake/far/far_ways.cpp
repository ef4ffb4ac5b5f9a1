#include "compiler/bake/far/far_ways.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

#include "compiler/bake/ground/ground_tint.h"
#include "compiler/geometry/snap.h"
#include "compiler/materials/noise.h"
#include "compiler/surroundings/curvature.h"

namespace citykiln::bake {
namespace {

using materials::Material;
using materials::MaterialMesh;

constexpr double kSegment_m = 12, kAbove_m = 0.2, kSteepest = 1.0 / 6, kGrid_m = 0x1p-7;
// The direction of a road is that of its last metres.
constexpr double kHeading_m = 40;
// Watercourses below this width do not go on.
constexpr double kLeastStream_m = 2;
// The share of a strip from which on its colour fades.
constexpr double kFadeFrom = 0.25;

// A road or watercourse at the edge of the scene.
struct Leaving {
  ObjectId id;
  map::LandCoverClass surface{};
  double half_m = 0;
  Vec2 at{}, heading{};  // unit, outwards

  bool is_water() const { return map::values_of(surface).group == map::LandCoverGroup::kWater; }
};

double length_m_of(const Leaving& leaving) {
  const int priority = leaving.is_water() ? 85 : map::values_of(leaving.surface).priority;
  return 350 + 180 * std::clamp(priority - 80, 0, 7);
}

bool goes_on(const roads::Road& road) {
  if (road.surface == map::LandCoverClass::kRunway || road.surface == map::LandCoverClass::kPedestrianStreet)
    return false;
  return map::is_street(road.surface) || road.surface == map::LandCoverClass::kRailway;
}

// The share of a segment at which it leaves a box; empty if it does not.
std::optional<double> leaves_box(const Box2& box, Vec2 a, Vec2 b) {
  if (!box.contains(a) || box.contains(b)) return std::nullopt;
  double share = 1;
  const auto cut = [&](double from, double to, double side) {
    if ((from - side) * (to - side) < 0) share = std::min(share, (side - from) / (to - from));
  };
  cut(a.x, b.x, box.min.x), cut(a.x, b.x, box.max.x), cut(a.y, b.y, box.min.y), cut(a.y, b.y, box.max.y);
  return share;
}

// The direction from a place up to kHeading_m before the end, along the axis.
Vec2 heading_at(const Polyline& axis, std::size_t before, Vec2 at) {
  Vec2 from = axis[before];
  for (std::size_t i = before; i > 0 && distance(from, at) < kHeading_m; --i) from = axis[i - 1];
  return distance(from, at) > 0 ? unit(at - from) : Vec2{};
}

void find_leaving(const Box2& box, const Leaving& what, const Polyline& axis, std::vector<Leaving>& all) {
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const auto share = leaves_box(box, axis[i], axis[i + 1]);
    if (!share) continue;
    Leaving leaving = what;
    leaving.at = axis[i] + (axis[i + 1] - axis[i]) * *share;
    leaving.heading = heading_at(axis, i, leaving.at);
    if (leaving.heading != Vec2{}) all.push_back(leaving);
  }
}

void find_both_ways(const Box2& box, const Leaving& what, const Polyline& axis, std::vector<Leaving>& all) {
  find_leaving(box, what, axis, all);
  find_leaving(box, what, Polyline(axis.rbegin(), axis.rend()), all);
}

std::vector<Leaving> leaving_ways(const scene::Scene& scene) {
  const Box2& box = scene.header.extent;
  std::vector<Leaving> all;
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const roads::Road& road : chunk.roads)
      if (goes_on(road)) {
        const double half_m = std::max(1.5, roads::width_m(road) / 2);
        find_both_ways(box, {.id = road.id, .surface = road.surface, .half_m = half_m}, road.axis, all);
      }
    for (const roads::Strip& stream : chunk.watercourses) {
      const double half_m = (stream.left_m + stream.right_m) / 2;
      if (half_m >= kLeastStream_m / 2)
        find_both_ways(box, {.id = stream.id, .surface = stream.surface, .half_m = half_m}, stream.axis, all);
    }
  }
  // a way near a corner of tiles is in several chunks
  std::set<std::tuple<ObjectId, double, double>> known;
  std::erase_if(all, [&](const Leaving& l) {
    return !known.insert({l.id, snapped_to(4, l.at.x), snapped_to(4, l.at.y)}).second;
  });
  return all;
}

// Where a strip lies at one distance along it.
struct Station {
  Vec3 left, right;
  double share;  // of the strip's length
};

std::vector<Station> stations_of(const Leaving& leaving, std::uint64_t seed,
                                 const surroundings::AroundSurface& surface) {
  const double length_m = length_m_of(leaving);
  std::vector<Station> stations;
  Vec2 at = leaving.at + leaving.heading * 0.25, heading = leaving.heading;
  std::optional<double> before_m;
  for (double along_m = 0; along_m <= length_m; along_m += kSegment_m) {
    // water cannot fade, and becomes narrow
    const double half_m = leaving.half_m * (leaving.is_water() ? 1 - along_m / length_m : 1);
    const Vec2 left = at + left_of(heading) * half_m, right = at - left_of(heading) * half_m;
    const auto left_m = surface.height_m_at(left), right_m = surface.height_m_at(right);
    const surroundings::Patch* patch = surface.patch_at(at);
    if (!left_m || !right_m || patch == nullptr) break;
    if (map::values_of(patch->cover).group == map::LandCoverGroup::kWater) break;
    const double middle_m = (*left_m + *right_m) / 2;
    if (before_m && std::abs(middle_m - *before_m) > kSteepest * kSegment_m) break;
    before_m = middle_m;
    stations.push_back(
        {at_height(left, *left_m + kAbove_m), at_height(right, *right_m + kAbove_m), along_m / length_m});
    // bends by up to 1 in 20 a segment
    const double bend = 0.05 * materials::noise_at(at, 240, seed + 21) * std::min(1.0, along_m / 100);
    heading = unit(heading + left_of(heading) * bend);
    at = at + heading * kSegment_m;
  }
  return stations;
}

std::uint32_t add_vertex(MaterialMesh& mesh, Vec3 at, materials::Tint tint) {
  mesh.mesh.positions.push_back({snapped_to(kGrid_m, at.x), snapped_to(kGrid_m, at.y), snapped_to(kGrid_m, at.z)});
  mesh.tints.push_back(tint);
  return static_cast<std::uint32_t>(mesh.mesh.positions.size() - 1);
}

materials::Tint tint_on_the_way(materials::Tint a, materials::Tint b, double share) {
  materials::Tint tint = a;
  for (std::size_t c = 0; c < 3; ++c) tint[c] = static_cast<std::uint8_t>(a[c] + (b[c] - a[c]) * share + 0.5);
  return tint;
}

// The tint of the light base material that has the colour of another.
materials::Tint tint_of_colour(Material material, Material base) {
  const auto &own = materials::values_of(material).base_colour, &light = materials::values_of(base).base_colour;
  return tint_of({own[0] / light[0], own[1] / light[1], own[2] / light[2]}, {});
}

// The tint of a road where it has faded by a share into the land.
materials::Tint faded_tint(const Leaving& leaving, const Station& station, double share, const FarLand& land,
                           const surroundings::AroundSurface& surface, Material base) {
  const Vec3 middle = (station.left + station.right) * 0.5;
  const double away_m = surroundings::away_m(land.header.extent, in_plan(middle));
  const surroundings::Patch* patch = surface.patch_at(in_plan(middle));
  const materials::Tint below = tint_of(land, *patch, base, middle, {0, 0, 1}, away_m);
  const double faded = std::clamp((share - kFadeFrom) / (1 - kFadeFrom), 0.0, 1.0);
  const materials::Tint road = tint_of_colour(map::values_of(leaving.surface).material, base);
  return tint_on_the_way(road, below, faded * faded * (3 - 2 * faded));
}

void add_strip(const Leaving& leaving, const std::vector<Station>& stations, const FarLand& land,
               const surroundings::AroundSurface& surface, MaterialMesh& mesh) {
  if (stations.size() < 3) return;
  const double end = stations.back().share;
  std::uint32_t before = 0;
  for (std::size_t k = 0; k < stations.size(); ++k) {
    const Station& s = stations[k];
    const materials::Tint tint =
        leaving.is_water() ? materials::kNoTint : faded_tint(leaving, s, s.share / end, land, surface, mesh.material);
    const std::uint32_t left = add_vertex(mesh, s.left, tint);
    add_vertex(mesh, s.right, tint);
    if (k > 0) add_quad(mesh.mesh, before + 1, left + 1, left, before);
    before = left;
  }
}

}  // namespace

std::vector<MaterialMesh> far_ways(const scene::Scene& scene, const FarLand& land,
                                   const surroundings::AroundSurface& surface) {
  std::vector<MaterialMesh> meshes(2);
  meshes[0].material = Material::kScree, meshes[1].material = Material::kRiverWater;
  for (const Leaving& leaving : leaving_ways(scene))
    add_strip(leaving, stations_of(leaving, scene.header.seed, surface), land, surface,
              meshes[leaving.is_water() ? 1 : 0]);
  std::erase_if(meshes, [](const MaterialMesh& mesh) { return mesh.mesh.triangles.empty(); });
  return meshes;
}

}  // namespace citykiln::bake
