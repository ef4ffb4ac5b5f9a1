#include "compiler/cars/facets.h"

#include <algorithm>
#include <map>

#include "compiler/geometry/snap.h"

namespace citykiln::cars {
namespace {

constexpr double kCreaseCosine = 0.755;

Vec3 area_of(const Facet& facet) {
  return cross(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]);
}

// The facets about each place.
using About = std::map<Vec3, std::vector<std::size_t>>;

About facets_about(std::span<const Facet> facets) {
  About about;
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (const Vec3 corner : facets[i].corners) about[corner].push_back(i);
  return about;
}

Vec3 normal_at(Vec3 corner, const Facet& facet, std::span<const Facet> facets, const About& about) {
  const Vec3 own = unit(area_of(facet));
  Vec3 sum{};
  for (const std::size_t other : about.at(corner))
    if (const Vec3 area = area_of(facets[other]); dot(unit(area), own) > kCreaseCosine) sum = sum + area;
  return sum == Vec3{} ? own : unit(sum);
}

}  // namespace

void Facets::add(Vec3 a, Vec3 b, Vec3 c, const Surface& surface) {
  const Facet facet{{snapped(a), snapped(b), snapped(c)}, surface};
  if (area_of(facet) != Vec3{}) all.push_back(facet);
}

void Facets::add(Vec3 a, Vec3 b, Vec3 c, Vec3 d, const Surface& surface) {
  add(a, b, c, surface);
  add(a, c, d, surface);
}

void Facets::add_twice(Vec3 a, Vec3 b, Vec3 c, Vec3 d, const Surface& surface) {
  const auto mirrored = [](Vec3 p) { return Vec3{-p.x, p.y, p.z}; };
  add(a, b, c, d, surface);
  add(mirrored(a), mirrored(d), mirrored(c), mirrored(b), surface);
}

void Facets::add_box(Vec3 l, Vec3 h, const Surface& surface) {
  add({l.x, l.y, l.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z}, surface);
  add({l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z}, surface);
  add({l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z}, surface);
  add({h.x, h.y, l.z}, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z}, surface);
  add({l.x, h.y, l.z}, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, surface);
  add({h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z}, surface);
}

std::vector<materials::MaterialMesh> meshes_of(const Facets& facets, bool is_paint) {
  const About about = facets_about(facets.all);
  std::map<materials::Material, materials::MaterialMesh> meshes;
  for (const Facet& facet : facets.all) {
    if (facet.surface.is_paint != is_paint) continue;
    materials::MaterialMesh& mesh =
        meshes.try_emplace(facet.surface.material, materials::MaterialMesh{{}, facet.surface.material, {}, {}})
            .first->second;
    const auto first = static_cast<std::uint32_t>(mesh.mesh.positions.size());
    for (const Vec3 corner : facet.corners) {
      mesh.mesh.positions.push_back(corner);
      mesh.mesh.normals.push_back(normal_at(corner, facet, facets.all, about));
      mesh.tints.push_back(facet.surface.tint);
    }
    mesh.mesh.triangles.push_back({first, first + 1, first + 2});
  }
  std::vector<materials::MaterialMesh> all;
  for (auto& [material, mesh] : meshes) all.push_back(std::move(mesh));
  return all;
}

}  // namespace citykiln::cars
