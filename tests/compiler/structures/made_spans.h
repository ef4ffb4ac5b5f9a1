// Spans, and measures of meshes, for tests.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "compiler/structures/generate.h"
#include "tests/compiler/mesh_volume.h"

namespace citykiln::structures {

/// A span with a road of two lanes, 6 m from kerb to kerb, and with pavements of 2 m each if `has_pavements`.
inline Span made_span(Polyline axis, Profile profile, bool has_pavements = false) {
  using map::LaneDirection;
  using map::LaneKind;
  Span span;
  span.id = {{OsmType::kWay, 5}, 0};
  span.axis = std::move(axis), span.profile = std::move(profile);
  span.surface = map::LandCoverClass::kPrimaryRoad;
  const map::Lane walk{LaneKind::kSidewalk, LaneDirection::kBoth, 2, 0, true};
  span.section = {{{LaneKind::kDriving, LaneDirection::kBackward, 3}, {LaneKind::kDriving, LaneDirection::kForward, 3}},
                  3};
  if (has_pavements) {
    span.section.lanes.insert(span.section.lanes.begin(), walk);
    span.section.lanes.push_back(walk);
  }
  return span;
}

inline std::vector<materials::MaterialMesh> all_meshes(const GeneratedStructure& expanded) {
  std::vector<materials::MaterialMesh> meshes = expanded.meshes;
  for (const MarkedMesh& marked : expanded.marked) meshes.push_back(marked.mesh);
  return meshes;
}

/// The number of triangles along each edge in the order of its positions, less those in the opposite order. Edges with
/// 0 are left out, so closed meshes have none.
inline std::map<std::pair<Vec3, Vec3>, int> open_edges(const std::vector<materials::MaterialMesh>& meshes) {
  std::map<std::pair<Vec3, Vec3>, int> edges;
  for (const auto& part : meshes)
    for (const Triangle& t : part.mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const Vec3 a = part.mesh.positions[t[i]], b = part.mesh.positions[t[(i + 1) % 3]];
        if (a < b)
          ++edges[{a, b}];
        else
          --edges[{b, a}];
      }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

inline bool has_point(const std::vector<materials::MaterialMesh>& meshes, Vec3 at) {
  for (const auto& part : meshes)
    for (const Vec3 p : part.mesh.positions)
      if (p == at) return true;
  return false;
}

}  // namespace citykiln::structures
