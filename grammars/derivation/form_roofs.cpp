#include "grammars/derivation/form_roofs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

#include "grammars/roofs/generate_roof.h"
#include "grammars/shapes/border_ring.h"
#include "grammars/shapes/cut.h"

namespace citykiln::grammars {
namespace {

/// By RoofKind.
constexpr roofs::RoofForm kForms[] = {roofs::RoofForm::kGabled, roofs::RoofForm::kHipped, roofs::RoofForm::kPyramidal,
                                      roofs::RoofForm::kSkillion, roofs::RoofForm::kMansard};

roofs::RoofShape shape_of(const RoofRequest& request) {
  roofs::RoofShape shape;
  shape.form = kForms[static_cast<std::size_t>(request.kind)];
  shape.overhang_m = request.overhang_m;
  (request.by_height ? shape.height_m : shape.angle_deg) = request.by_height ? request.height_m : request.angle_deg;
  if (request.kind == RoofKind::kMansard) shape.knee = {request.height_m, request.upper_angle_deg};
  const Ring& ring = request.footprint.outer;
  // a shed rises from its edge
  const Vec2 along = ring[(request.edge + 1) % ring.size()] - ring[request.edge % ring.size()];
  if (request.kind == RoofKind::kShed) shape.direction = left_of(along) * -1.0;
  return shape;
}

// The range of the grid of arrange(), with room for eaves; wider eaves are not built.
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

/// By roofs::RoofPart.
constexpr FaceTag kTags[] = {FaceTag::kTop, FaceTag::kSide, FaceTag::kBorder, FaceTag::kBorder};

/// Triangles of a roof in one plane, or nearly so.
struct Patch {
  std::span<const Vec3> at;
  std::vector<Triangle> triangles;
};

Vec3 twice_area(const Patch& patch, const Triangle& t) {
  return cross(patch.at[t[1]] - patch.at[t[0]], patch.at[t[2]] - patch.at[t[0]]);
}

Vec3 twice_area(const Patch& patch) {
  Vec3 sum;
  for (const Triangle& t : patch.triangles) sum = sum + twice_area(patch, t);
  return sum;
}

Vec3 patch_middle(const Patch& patch) {
  Vec3 sum;
  for (const auto& [a, b, c] : patch.triangles) sum = sum + (patch.at[a] + patch.at[b] + patch.at[c]) * (1 / 3.0);
  return sum * (1 / static_cast<double>(patch.triangles.size()));
}

/// Faces are planar to 1 cm. A roof plane may not be, over walls whose bends the skeleton ignores and where gaps
/// between planes were closed.
constexpr double kFlat_m = 0.005, kOnLargest_m = 0.004, kVertical = 0.01;

/// A ring with at least this area is a face; far above rounding error.
constexpr double kSurelyArea_m2 = 1e-9;

/// True if the triangle is oriented as the patch. Vertical patches may have folds of rounding size.
bool is_oriented_along(const Patch& patch, const Triangle& t, Vec3 normal) {
  return std::abs(normal.z) > kVertical || dot(twice_area(patch, t), normal) >= 0;
}

bool lies_along(const Patch& patch, const Triangle& t, Vec3 on_plane, Vec3 normal, double near_m) {
  const auto is_near = [&](std::uint32_t v) { return std::abs(dot(patch.at[v] - on_plane, normal)) <= near_m; };
  return std::all_of(t.begin(), t.end(), is_near) && is_oriented_along(patch, t, normal);
}

bool is_flat(const Patch& patch) {
  const Vec3 middle = patch_middle(patch), normal = unit(twice_area(patch));
  return std::all_of(patch.triangles.begin(), patch.triangles.end(),
                     [&](const Triangle& t) { return lies_along(patch, t, middle, normal, kFlat_m); });
}

/// Moves the triangles in the plane of the largest triangle out of `patch`.
Patch take_largest_plane(Patch& patch) {
  auto& all = patch.triangles;
  const Triangle seed = *std::max_element(all.begin(), all.end(), [&](const Triangle& a, const Triangle& b) {
    return length(twice_area(patch, a)) < length(twice_area(patch, b));
  });
  const Vec3 on_plane = patch.at[seed[0]], normal = unit(twice_area(patch, seed));
  const auto rest = std::stable_partition(all.begin(), all.end(), [&](const Triangle& t) {
    return t != seed && !lies_along(patch, t, on_plane, normal, kOnLargest_m);
  });
  Patch taken{patch.at, {rest, all.end()}};
  all.erase(rest, all.end());
  return taken;
}

/// The direction that separates outer rings from holes: vertical unless the patch is, because the normals of slivers
/// are unreliable.
Vec3 seen_from(const Patch& patch) {
  const Vec3 normal = unit(twice_area(patch));
  return normal.z == 0 ? normal : Vec3{0, 0, normal.z > 0 ? 1.0 : -1.0};
}

bool passes_twice(std::span<const Vec3> ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (std::find(ring.begin() + i + 1, ring.end(), ring[i]) != ring.end()) return true;
  return false;
}

/// Most patches have one border ring; the others are traced by the positions of their edges.
std::vector<Face> flat_faces(const Patch& patch) {
  const Vec3 normal = seen_from(patch);
  std::vector<Face> faces(1);
  Ring3& ring = faces.front().outer;
  const auto border = border_ring(patch.triangles);
  for (const std::uint32_t v : border.value_or(std::vector<std::uint32_t>{})) ring.push_back(patch.at[v]);
  if (dot(normal, double_area_vector_m2(ring)) > kSurelyArea_m2 && !passes_twice(ring)) return faces;
  std::vector<Edge3> edges;
  const auto add = [&](std::uint32_t from, std::uint32_t to) { edges.emplace_back(patch.at[from], patch.at[to]); };
  for (const auto& [a, b, c] : patch.triangles) add(a, b), add(b, c), add(c, a);
  return faces_along(edges, normal);
}

void add_flat_faces(const Patch& patch, FaceTag tag, std::vector<Face>& faces) {
  for (Face& face : flat_faces(patch)) {
    face.tag = tag;
    faces.push_back(std::move(face));
  }
}

void add_faces(Patch patch, FaceTag tag, std::vector<Face>& faces) {
  while (!is_flat(patch)) add_flat_faces(take_largest_plane(patch), tag, faces);
  if (!patch.triangles.empty()) add_flat_faces(patch, tag, faces);
}

/// Triangles with equal keys are one face. Roof planes have numbers; vertical parts are keyed by their plane, because a
/// gable may end several roof planes and a rim goes around corners.
using PatchKey = std::array<std::int64_t, 5>;

PatchKey patch_key(const roofs::Roof& roof, std::size_t i) {
  const auto part = static_cast<std::int64_t>(roof.parts[i]);
  const bool is_vertical = roof.parts[i] == roofs::RoofPart::kGable || roof.parts[i] == roofs::RoofPart::kEdge;
  if (!is_vertical) return {part, roof.faces[i], 0, 0, 0};
  const Vec3 a = roof.positions[roof.triangles[i][0]], b = roof.positions[roof.triangles[i][1]];
  const Vec3 normal = unit(cross(b - a, roof.positions[roof.triangles[i][2]] - a));
  const auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v * 256 + 0.5)); };
  return {part, cell(normal.x), cell(normal.y), cell(normal.z), cell(dot(normal, a))};
}

/// A triangle of the roof and its patch.
struct Keyed {
  PatchKey patch;
  std::size_t triangle;
  auto operator<=>(const Keyed&) const = default;
};

std::vector<Keyed> by_patch(const roofs::Roof& roof) {
  std::vector<Keyed> keyed;
  keyed.reserve(roof.triangles.size());
  for (std::size_t i = 0; i < roof.triangles.size(); ++i) keyed.push_back({patch_key(roof, i), i});
  std::sort(keyed.begin(), keyed.end());
  return keyed;
}

Patch floor_of(const roofs::Roof& roof) {
  Patch floor{roof.positions, {}};
  for (const auto& [a, b, c] : roof.floor) floor.triangles.push_back({c, b, a});
  return floor;
}

}  // namespace

std::vector<Face> faces_of(const roofs::Roof& roof) {
  const std::vector<Keyed> keyed = by_patch(roof);
  std::vector<Face> faces;
  for (auto first = keyed.begin(); first != keyed.end();) {
    Patch patch{roof.positions, {}};
    const auto end = std::find_if(first, keyed.end(), [&](const Keyed& k) { return k.patch != first->patch; });
    for (auto k = first; k != end; ++k) patch.triangles.push_back(roof.triangles[k->triangle]);
    add_faces(std::move(patch), kTags[static_cast<std::size_t>(roof.parts[first->triangle])], faces);
    first = end;
  }
  add_faces(floor_of(roof), FaceTag::kBottom, faces);
  return faces;
}

RoofBuilder form_roofs(double tolerance_m) {
  assert(tolerance_m > 0);
  return [tolerance_m](const RoofRequest& request) -> std::optional<std::vector<Face>> {
    if (!can_be_built(request)) return std::nullopt;
    Report ignored;
    const roofs::Roof roof = roofs::generate_roof(request.footprint, shape_of(request), tolerance_m, {}, ignored);
    if (roof.triangles.empty() || roof.form == roofs::RoofForm::kFlat) return std::nullopt;
    return faces_of(roof);
  };
}

}  // namespace citykiln::grammars
