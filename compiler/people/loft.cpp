#include "compiler/people/loft.h"

#include <algorithm>
#include <vector>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::people {

void add_loft(std::span<const Ring3> rings, int sides, materials::Tint tint, materials::MaterialMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.mesh.positions.size()), n = static_cast<std::uint32_t>(sides);
  for (const Ring3& ring : rings)
    for (int i = 0; i < sides; ++i) {
      const Vec2 turn = direction_of((i + 0.5) / sides);
      mesh.mesh.positions.push_back(snapped(ring.at + ring.u * turn.x + ring.v * turn.y));
      mesh.tints.push_back(tint);
    }
  const auto last = static_cast<std::uint32_t>(mesh.mesh.positions.size()) - n;
  for (std::uint32_t ring = first; ring < last; ring += n)
    for (std::uint32_t i = 0; i < n; ++i)
      add_quad(mesh.mesh, ring + i, ring + (i + 1) % n, ring + n + (i + 1) % n, ring + n + i);
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.mesh.triangles.push_back({first, first + i + 1, first + i});
    mesh.mesh.triangles.push_back({last, last + i, last + i + 1});
  }
}

void add_limb(std::span<const Joint> joints, int sides, double flat, materials::Tint tint,
              materials::MaterialMesh& mesh) {
  std::vector<Ring3> rings;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Vec3 before = joints[i == 0 ? 0 : i - 1].at, after = joints[std::min(i + 1, joints.size() - 1)].at;
    const Vec3 along = unit(after - before);
    const Vec3 across = unit(Vec3{1, 0, 0} - along * along.x);
    rings.push_back({joints[i].at, across * joints[i].radius_m, cross(along, across) * (joints[i].radius_m * flat)});
  }
  add_loft(rings, sides, tint, mesh);
}

void smooth(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), {});
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    for (const std::uint32_t corner : t) mesh.normals[corner] = mesh.normals[corner] + normal;
  }
  for (Vec3& normal : mesh.normals) normal = normal == Vec3{} ? Vec3{0, 0, 1} : unit(normal);
}

}  // namespace citykiln::people
