#include "grammars/form_roofs.h"

#include <array>
#include <cmath>
#include <map>

#include "grammars/cut.h"
#include "grammars/roofs/expand_roof.h"

namespace citykiln::grammars {
namespace {

roofs::Form form_of(RoofKind kind) {
  switch (kind) {
    case RoofKind::kGable:
      return roofs::Form::kGabled;
    case RoofKind::kHip:
      return roofs::Form::kHipped;
    case RoofKind::kPyramid:
      return roofs::Form::kPyramidal;
    case RoofKind::kShed:
      return roofs::Form::kSkillion;
    case RoofKind::kMansard:
      return roofs::Form::kMansard;
  }
  return roofs::Form::kFlat;
}

roofs::RoofShape shape_of(const RoofRequest& request) {
  roofs::RoofShape shape;
  shape.form = form_of(request.kind);
  shape.overhang_m = request.overhang_m;
  (request.by_height ? shape.height_m : shape.angle_deg) = request.by_height ? request.height_m : request.angle_deg;
  const Ring& ring = request.footprint.outer;
  // a shed rises from the edge that it is asked to begin at
  const Vec2 along = ring[(request.edge + 1) % ring.size()] - ring[request.edge % ring.size()];
  if (request.kind == RoofKind::kShed) shape.direction = left_of(along) * -1.0;
  return shape;
}

FaceTag tag_of(roofs::Part part) {
  switch (part) {
    case roofs::Part::kRoof:
      return FaceTag::kTop;
    case roofs::Part::kGable:
      return FaceTag::kSide;
    case roofs::Part::kEdge:
    case roofs::Part::kSoffit:
      return FaceTag::kBorder;
  }
  return FaceTag::kNone;
}

/// Triangles of one plane.
struct Patch {
  std::vector<Edge3> edges;
  Vec3 area_vector;
};

void add(Patch& patch, Vec3 a, Vec3 b, Vec3 c) {
  patch.edges.insert(patch.edges.end(), {{a, b}, {b, c}, {c, a}});
  patch.area_vector = patch.area_vector + cross(b - a, c - a);
}

void add_faces(Patch& patch, FaceTag tag, std::vector<Face>& faces) {
  for (Face& face : faces_along(std::move(patch.edges), unit(patch.area_vector))) {
    face.tag = tag;
    faces.push_back(std::move(face));
  }
}

/// Which triangles are one face: those of a roof plane by its number, those of gables by where they stand, since a
/// gable may be several roof planes' end.
using PatchKey = std::array<std::int64_t, 5>;

PatchKey key_of(const roofs::Roof& roof, std::size_t i) {
  const auto part = static_cast<std::int64_t>(roof.parts[i]);
  if (roof.parts[i] != roofs::Part::kGable) return {part, roof.faces[i], 0, 0, 0};
  const Vec3 a = roof.positions[roof.triangles[i][0]], b = roof.positions[roof.triangles[i][1]];
  const Vec3 normal = unit(cross(b - a, roof.positions[roof.triangles[i][2]] - a));
  const auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v * 256 + 0.5)); };
  return {part, cell(normal.x), cell(normal.y), cell(normal.z), cell(dot(normal, a))};
}

}  // namespace

std::vector<Face> faces_of(const roofs::Roof& roof) {
  std::map<PatchKey, Patch> patches;
  const auto& p = roof.positions;
  for (std::size_t i = 0; i < roof.triangles.size(); ++i) {
    const Triangle t = roof.triangles[i];
    add(patches[key_of(roof, i)], p[t[0]], p[t[1]], p[t[2]]);
  }
  Patch base;
  for (const Triangle t : roof.floor) add(base, p[t[2]], p[t[1]], p[t[0]]);
  std::vector<Face> faces;
  for (auto& [key, patch] : patches) add_faces(patch, tag_of(static_cast<roofs::Part>(key[0])), faces);
  add_faces(base, FaceTag::kBottom, faces);
  return faces;
}

RoofBuilder form_roofs(double tolerance_m) {
  return [tolerance_m](const RoofRequest& request) -> std::optional<std::vector<Face>> {
    const bool rises = request.by_height ? request.height_m > 0 : request.angle_deg > 0;
    if (!rises || request.footprint.outer.size() < 3) return std::nullopt;
    Report ignored;
    const roofs::Roof roof = roofs::expand_roof(request.footprint, shape_of(request), tolerance_m, {}, ignored);
    if (roof.triangles.empty() || roof.form == roofs::Form::kFlat) return std::nullopt;
    return faces_of(roof);
  };
}

}  // namespace citykiln::grammars
