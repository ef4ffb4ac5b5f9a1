#include "compiler/bake/tiles/weld.h"

#include <utility>

namespace citykiln::bake {
namespace {

using Index = std::uint32_t;
using FaceOf = std::array<Index, 3>;

void copy_vertex(Primitive& to, const Primitive& from, Index v) {
  to.positions.push_back(from.positions[v]);
  to.normals.push_back(from.normals[v]);
  to.colours.push_back(from.colours[v]);
  if (!from.features.empty()) to.features.push_back(from.features[v]);
  if (!from.uvs.empty()) to.uvs.push_back(from.uvs[v]);
}

}  // namespace

Primitive with_triangles(const Primitive& from, std::span<const FaceOf> triangles) {
  constexpr Index kNone = 0xffffffffu;
  Primitive to{.material = from.material,
               .positions = {},
               .normals = {},
               .colours = {},
               .features = {},
               .triangles = {},
               .colour_source = from.colour_source,
               .layer = from.layer};
  std::vector<Index> moved(from.positions.size(), kNone);
  for (const FaceOf& t : triangles) {
    FaceOf face{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (moved[t[i]] == kNone) moved[t[i]] = static_cast<Index>(to.positions.size()), copy_vertex(to, from, t[i]);
      face[i] = moved[t[i]];
    }
    to.triangles.push_back(face);
  }
  return to;
}

WeldedPrimitives welded(std::span<const Primitive> primitives, bool (*is_in)(const Primitive&)) {
  WeldedPrimitives all{{}, std::vector<std::map<Index, Index>>(primitives.size())};
  PositionNumbers places;
  std::vector<Index> has_seam;
  for (Index label = 0; label < primitives.size(); ++label) {
    const Primitive& p = primitives[label];
    if (!is_in(p)) continue;
    for (const FaceOf& t : p.triangles) {
      FaceOf face{};
      for (std::size_t i = 0; i < 3; ++i) {
        face[i] = places.of(p.positions[t[i]]);
        const Index first = all.vertex_at[label].emplace(face[i], t[i]).first->second;
        if (!p.uvs.empty() && p.uvs[first] != p.uvs[t[i]]) has_seam.push_back(face[i]);
      }
      if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
      all.mesh.triangles.push_back(face), all.mesh.labels.push_back(label);
    }
  }
  for (const Float3& p : places.positions) all.mesh.positions.push_back(widened(p));
  all.mesh.is_locked.assign(places.positions.size(), false);
  for (const Index i : has_seam) all.mesh.is_locked[i] = true;
  return all;
}

Primitive decimated_primitive(const Primitive& from, const WeldedPrimitives& source, std::uint32_t label,
                              const simplify::DecimatedMesh& decimated) {
  std::vector<FaceOf> faces;
  for (std::size_t t = 0; t < decimated.triangles.size(); ++t) {
    if (decimated.labels[t] != label) continue;
    FaceOf face{};
    for (std::size_t i = 0; i < 3; ++i) face[i] = source.vertex_at[label].at(decimated.triangles[t][i]);
    faces.push_back(face);
  }
  return with_triangles(from, faces);
}

}  // namespace citykiln::bake
