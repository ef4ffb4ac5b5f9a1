// Closed bodies of tagged faces, as the compiler makes them for rules.
#pragma once

#include <algorithm>

#include "grammars/derivation/derive.h"
#include "grammars/derivation/form_roofs.h"
#include "grammars/roofs/generate_roof.h"

namespace citykiln::grammars {

struct MadeMass {
  Polygon footprint;
  std::vector<std::size_t> street = {0};  ///< Edges of the outer ring that face a street.
  std::vector<std::size_t> party = {};    ///< Edges that stand against a neighbour.
  roofs::RoofShape roof;
  double height_m = 10;  ///< Height of the eaves above the lot, which is at 0.
  StableId id{1};
};

/// Adds a roof as compiler/buildings/meshes/mass_model.h does: gables are tagged kVertical, the floor of the roof is
/// left out.
inline void add_roof(const roofs::Roof& roof, double eaves_m, std::vector<Face>& faces) {
  for (Face& face : faces_of(roof)) {
    if (face.tag == FaceTag::kBottom) continue;
    if (face.tag == FaceTag::kSide) face.tag = FaceTag::kVertical;
    each_vertex(face, [&](Vec3& p) { p.z += eaves_m; });
    faces.push_back(std::move(face));
  }
}

inline void add_walls(const MadeMass& made, const Ring& ring, bool is_outer, std::vector<Face>& faces) {
  const auto is_among = [&](const std::vector<std::size_t>& edges, std::size_t i) {
    return is_outer && std::find(edges.begin(), edges.end(), i) != edges.end();
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    Face& wall = faces.emplace_back();
    wall.outer = {{a.x, a.y, 0}, {b.x, b.y, 0}, {b.x, b.y, made.height_m}, {a.x, a.y, made.height_m}};
    wall.tag = is_among(made.party, i) ? FaceTag::kInside : FaceTag::kSide;
    wall.street = is_among(made.street, i);
  }
}

/// Returns the mass as first shape: scope x along the first edge, y up.
inline Shape mass_model_of(const MadeMass& made, roofs::RoofForm* became = nullptr) {
  Report ignored;
  const roofs::Roof roof = roofs::generate_roof(made.footprint, made.roof, 0.02, {}, ignored);
  if (became) *became = roof.form;
  Shape shape = lot(made.footprint, 0, 0, made.id, made.street);
  Face floor = reversed(shape.faces.front());
  floor.tag = FaceTag::kBottom;
  floor.street_edges.clear();
  shape.faces = {floor};
  add_walls(made, made.footprint.outer, true, shape.faces);
  for (const Ring& hole : made.footprint.holes) add_walls(made, hole, false, shape.faces);
  add_roof(roof, made.height_m, shape.faces);
  fit_scope(shape);
  return shape;
}

}  // namespace citykiln::grammars
