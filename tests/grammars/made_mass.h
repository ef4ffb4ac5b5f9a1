// Masses of buildings, as the compiler makes them for rules: a closed body of tagged faces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "grammars/cut.h"
#include "grammars/derive.h"
#include "grammars/roofs/expand_roof.h"

namespace citykiln::grammars {

struct MadeMass {
  Polygon footprint;
  std::vector<std::size_t> street = {0};  ///< Edges of the outer ring that face a street.
  std::vector<std::size_t> party = {};    ///< Edges that stand against a neighbour.
  roofs::RoofShape roof;
  double height_m = 10;  ///< From the lot, at 0, to the eaves.
  StableId id{1};
};

inline FaceTag tag_of(roofs::Part part) {
  return part == roofs::Part::kRoof    ? FaceTag::kTop
         : part == roofs::Part::kGable ? FaceTag::kVertical
                                       : FaceTag::kBorder;
}

/// Triangles of one part and plane, whichever the roof's numbers say.
inline void add_roof(const roofs::Roof& roof, double eaves_m, std::vector<Face>& faces) {
  struct Patch {
    std::vector<Edge3> edges;
    Vec3 normal;
  };
  std::map<std::pair<int, std::array<std::int64_t, 4>>, Patch> patches;
  for (std::size_t i = 0; i < roof.triangles.size(); ++i) {
    std::array<Vec3, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = roof.positions[roof.triangles[i][c]] + Vec3{0, 0, eaves_m};
    const Vec3 normal = unit(cross(p[1] - p[0], p[2] - p[0]));
    const auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v * 256 + 0.5)); };
    const bool is_gable = roof.parts[i] == roofs::Part::kGable;
    const auto plane = is_gable
                           ? std::array<std::int64_t, 4>{cell(normal.x), cell(normal.y), cell(dot(normal, p[0])), 0}
                           : std::array<std::int64_t, 4>{roof.faces[i], 0, 0, 0};
    Patch& patch = patches[{static_cast<int>(roof.parts[i]), plane}];
    patch.normal = normal;
    patch.edges.insert(patch.edges.end(), {{p[0], p[1]}, {p[1], p[2]}, {p[2], p[0]}});
  }
  for (auto& [key, patch] : patches)
    for (Face& face : faces_along(std::move(patch.edges), patch.normal)) {
      face.tag = tag_of(static_cast<roofs::Part>(key.first));
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

/// Scope x along the first edge, y up.
inline Shape mass_of(const MadeMass& made, roofs::Form* became = nullptr) {
  Report ignored;
  const roofs::Roof roof = roofs::expand_roof(made.footprint, made.roof, 0.02, {}, ignored);
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
