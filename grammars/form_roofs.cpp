#include "grammars/form_roofs.h"

#include <algorithm>
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
  if (request.kind == RoofKind::kMansard) shape.knee = {request.height_m, request.upper_angle_deg};
  const Ring& ring = request.footprint.outer;
  // a shed rises from the edge that it is asked to begin at
  const Vec2 along = ring[(request.edge + 1) % ring.size()] - ring[request.edge % ring.size()];
  if (request.kind == RoofKind::kShed) shape.direction = left_of(along) * -1.0;
  return shape;
}

// beyond it arrange() has no grid, with room for eaves; no eaves are so wide
constexpr double kFar_m = 256e3, kMostOverhang_m = 100, kSteepest_deg = 89.5;

bool lies_on_the_grid(const Polygon& footprint) {
  const auto is_near = [](Vec2 p) { return std::abs(p.x) < kFar_m && std::abs(p.y) < kFar_m; };
  return std::all_of(footprint.outer.begin(), footprint.outer.end(), is_near);
}

bool can_be_built(const RoofRequest& request) {
  const double rise = request.by_height ? request.height_m : request.angle_deg;
  if (!(rise > 0) || rise > (request.by_height ? kFar_m : kSteepest_deg)) return false;
  if (request.overhang_m < 0 || request.overhang_m > kMostOverhang_m) return false;
  return request.footprint.outer.size() >= 3 && lies_on_the_grid(request.footprint);
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

using Corners = std::array<Vec3, 3>;

/// Triangles of one plane, or nearly.
using Patch = std::vector<Corners>;

Vec3 twice_area(const Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

Vec3 twice_area(const Patch& patch) {
  Vec3 sum;
  for (const Corners& t : patch) sum = sum + twice_area(t);
  return sum;
}

bool lies_near(const Corners& t, Vec3 on_plane, Vec3 normal, double near_m) {
  return std::all_of(t.begin(), t.end(), [&](Vec3 p) { return std::abs(dot(p - on_plane, normal)) <= near_m; });
}

Vec3 middle_of(const Patch& patch) {
  Vec3 sum;
  for (const Corners& t : patch) sum = sum + (t[0] + t[1] + t[2]) * (1 / 3.0);
  return sum * (1 / static_cast<double>(patch.size()));
}

/// Faces are flat to a centimetre. Roof planes may be less so: over walls that bend by less than the skeleton sees, and
/// where planes that do not meet were joined.
constexpr double kFlat_m = 0.005, kOnLargest_m = 0.004, kUpright = 0.01;

/// What stands upright may be folded by a hair, and look both ways.
bool looks_along(const Corners& t, Vec3 normal) {
  return std::abs(normal.z) > kUpright || dot(twice_area(t), normal) >= 0;
}

bool is_flat(const Patch& patch) {
  const Vec3 middle = middle_of(patch), normal = unit(twice_area(patch));
  return std::all_of(patch.begin(), patch.end(),
                     [&](const Corners& t) { return lies_near(t, middle, normal, kFlat_m) && looks_along(t, normal); });
}

/// What lies in the plane of the largest triangle, which it leaves out of `patch`.
Patch take_largest_plane(Patch& patch) {
  const auto largest = std::max_element(patch.begin(), patch.end(), [](const Corners& a, const Corners& b) {
    return length(twice_area(a)) < length(twice_area(b));
  });
  const Corners seed = *largest;
  const Vec3 normal = unit(twice_area(seed));
  const auto rest = std::stable_partition(patch.begin(), patch.end(), [&](const Corners& t) {
    return t != seed && !(lies_near(t, seed[0], normal, kOnLargest_m) && looks_along(t, normal));
  });
  Patch taken(rest, patch.end());
  patch.erase(rest, patch.end());
  return taken;
}

/// Where rings are told from holes. What does not stand upright is seen from above or below: there slivers show their
/// right side, whatever their own planes are.
Vec3 seen_from(const Patch& patch) {
  const Vec3 normal = unit(twice_area(patch));
  return normal.z == 0 ? normal : Vec3{0, 0, normal.z > 0 ? 1.0 : -1.0};
}

void add_flat_faces(const Patch& patch, FaceTag tag, std::vector<Face>& faces) {
  std::vector<Edge3> edges;
  for (const auto& [a, b, c] : patch) edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  for (Face& face : faces_along(edges, seen_from(patch))) {
    face.tag = tag;
    faces.push_back(std::move(face));
  }
}

void add_faces(Patch patch, FaceTag tag, std::vector<Face>& faces) {
  while (!is_flat(patch)) add_flat_faces(take_largest_plane(patch), tag, faces);
  if (!patch.empty()) add_flat_faces(patch, tag, faces);
}

/// Which triangles are one face: those of a roof plane by its number, what stands upright by where it stands: a gable
/// may be several roof planes' end, and a plane's rim goes around corners.
using PatchKey = std::array<std::int64_t, 5>;

PatchKey key_of(const roofs::Roof& roof, std::size_t i) {
  const auto part = static_cast<std::int64_t>(roof.parts[i]);
  const bool is_upright = roof.parts[i] == roofs::Part::kGable || roof.parts[i] == roofs::Part::kEdge;
  if (!is_upright) return {part, roof.faces[i], 0, 0, 0};
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
    patches[key_of(roof, i)].push_back({p[t[0]], p[t[1]], p[t[2]]});
  }
  Patch base;
  for (const Triangle t : roof.floor) base.push_back({p[t[2]], p[t[1]], p[t[0]]});
  std::vector<Face> faces;
  for (auto& [key, patch] : patches) add_faces(std::move(patch), tag_of(static_cast<roofs::Part>(key[0])), faces);
  add_faces(std::move(base), FaceTag::kBottom, faces);
  return faces;
}

RoofBuilder form_roofs(double tolerance_m) {
  return [tolerance_m](const RoofRequest& request) -> std::optional<std::vector<Face>> {
    if (!can_be_built(request)) return std::nullopt;
    Report ignored;
    const roofs::Roof roof = roofs::expand_roof(request.footprint, shape_of(request), tolerance_m, {}, ignored);
    if (roof.triangles.empty() || roof.form == roofs::Form::kFlat) return std::nullopt;
    return faces_of(roof);
  };
}

}  // namespace citykiln::grammars
