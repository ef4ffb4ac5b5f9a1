#include "compiler/verify/ground/ground_index.h"

#include <algorithm>
#include <array>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/segment.h"

namespace citykiln::verify {
namespace {

/// Returns the side of buckets: ground faces along roads are some metres long, those of open land up to hundreds.
double bucket_m_of(std::span<const Box2> boxes) {
  double sides_m = 0;
  for (const Box2& box : boxes) sides_m += (box.width() + box.height()) / 2;
  return std::max(4.0, sides_m / static_cast<double>(std::max<std::size_t>(boxes.size(), 1)));
}

double plan_area_m2(const GroundFace& face) {
  return twice_area(in_plan(face.corners[0]), in_plan(face.corners[1]), in_plan(face.corners[2])) / 2;
}

/// Snapping moves borders by up to this much.
constexpr double kBeside_m = 2 * kQuantum_m;

/// True if the point is inside the edge, or outside by at most kBeside_m.
bool is_inside(double twice_area, Vec3 a, Vec3 b) {
  return twice_area >= -kBeside_m * distance(in_plan(a), in_plan(b));
}

std::optional<double> height_m_at(const GroundFace& face, Vec2 p) {
  const auto& [a, b, c] = face.corners;
  const double area = twice_area(in_plan(a), in_plan(b), in_plan(c));
  const double of_a = twice_area(p, in_plan(b), in_plan(c)), of_b = twice_area(in_plan(a), p, in_plan(c));
  const double of_c = area - of_a - of_b;
  if (!is_inside(of_a, b, c) || !is_inside(of_b, c, a) || !is_inside(of_c, a, b)) return std::nullopt;
  const double z_m = (of_a * a.z + of_b * b.z + of_c * c.z) / area;
  // the plane of a thin face is steep, so its height beside the face is limited to the corners' heights
  return std::clamp(z_m, std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z}));
}

/// The place of a face's border nearest to p in plan, for a p outside of the face.
Vec2 nearest_on_border(const GroundFace& face, Vec2 p) {
  Vec2 nearest = in_plan(face.corners[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 q = nearest_point(in_plan(face.corners[i]), in_plan(face.corners[(i + 1) % 3]), p);
    if (distance(p, q) < distance(p, nearest)) nearest = q;
  }
  return nearest;
}

}  // namespace

GroundIndex index_ground(const bake::BakedTile& tile) {
  GroundIndex index;
  for_each_ground_face(tile, [&](const GroundFace& face) { index.faces.push_back(face); });
  std::erase_if(index.faces, [](const GroundFace& face) { return plan_area_m2(face) <= 0; });
  std::vector<Box2> boxes;
  for (const GroundFace& face : index.faces)
    boxes.push_back(box_of(std::array{in_plan(face.corners[0]), in_plan(face.corners[1]), in_plan(face.corners[2])})
                        .widened(kBeside_m));
  index.grid = grid_of(boxes, bucket_m_of(boxes));
  return index;
}

std::vector<GroundHit> ground_at(const GroundIndex& index, Vec2 p) {
  std::vector<GroundHit> places;
  for (const std::uint32_t i : boxes_about(index.grid, p))
    if (const auto z_m = height_m_at(index.faces[i], p)) places.push_back({*z_m, index.faces[i].feature});
  std::ranges::stable_sort(places, {}, &GroundHit::z_m);
  return places;
}

std::optional<double> highest_ground_m(const GroundIndex& index, Vec2 p, double distance_m) {
  std::optional<double> highest_m;
  for (const std::uint32_t i : boxes_about(index.grid, Box2{p, p}.widened(distance_m))) {
    const GroundFace& face = index.faces[i];
    std::optional<double> z_m = height_m_at(face, p);
    const Vec2 beside = nearest_on_border(face, p);
    if (!z_m && distance(p, beside) <= distance_m) z_m = height_m_at(face, beside);
    if (z_m) highest_m = std::max(highest_m.value_or(*z_m), *z_m);
  }
  return highest_m;
}

}  // namespace citykiln::verify
