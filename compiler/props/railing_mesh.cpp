#include "compiler/props/railing_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/props/drape_line.h"

namespace citykiln::props {
namespace {

constexpr double kPostsApart_m = 2, kRailingFoot_m = 0.125;
constexpr int kRails = 4;
// A draped line is bent only where it would be off the ground by more than this; the railing's foot is deeper.
constexpr double kBend_m = 0.03;

// A rail of three sides whose upper edge is `top_m` above the line.
void add_rail(Mesh& mesh, const std::vector<Vec3>& line, double top_m, double width_m) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 at = in_plan(line[i]), side = mitred_side(line, i, false) * (width_m / 2);
    const double z_m = line[i].z + top_m;
    for (const Vec3 corner :
         {at_height(at, z_m), at_height(at + side, z_m - width_m), at_height(at - side, z_m - width_m)})
      mesh.positions.push_back(snapped(corner));
  }
  const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - 3;
  for (std::uint32_t a = first; a < last; a += 3)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      add_quad(mesh, a + k, a + k + 3, a + next + 3, a + next);
    }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({last, last + 2, last + 1});
}

// A square post whose foot is in the ground.
void add_post(Mesh& mesh, Vec3 at, Vec2 along, double top_m, double width_m) {
  const Vec2 a = along * (width_m / 2), b = left_of(a), p = in_plan(at);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const std::array<Vec2, 4> base = {p - a - b, p + a - b, p + a + b, p - a + b};
  for (const double z_m : {at.z - kRailingFoot_m, at.z + top_m})
    for (const Vec2 corner : base) mesh.positions.push_back(snapped(at_height(corner, z_m)));
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    add_quad(mesh, first + k, first + next, first + 4 + next, first + 4 + k);
  }
  add_quad(mesh, first + 4, first + 5, first + 6, first + 7);
  add_quad(mesh, first, first + 3, first + 2, first + 1);
}

void add_posts(Mesh& mesh, const std::vector<Vec3>& line, double top_m, double width_m) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double long_m = distance(in_plan(line[i]), in_plan(line[i + 1]));
    const Vec2 along = unit(in_plan(line[i + 1] - line[i]));
    const int gaps = std::max(1, static_cast<int>(std::ceil(long_m / kPostsApart_m)));
    // the last post belongs to the next segment
    const int posts = i + 2 < line.size() ? gaps : gaps + 1;
    if (long_m < kPostsApart_m / 4 && i > 0 && i + 2 < line.size()) continue;
    for (int k = 0; k < posts; ++k)
      add_post(mesh, line[i] + (line[i + 1] - line[i]) * (static_cast<double>(k) / gaps), along, top_m, width_m);
  }
}

}  // namespace

GeneratedProp railing_mesh(const Barrier& railing, const ground::GradedTerrain& ground, double tolerance_m) {
  if (railing.height_m <= tolerance_m) return {{}, railing.height_m};
  const std::vector<Vec3> draped = drape_line(railing.axis, ground);
  if (draped.size() < 2) return {};
  const std::vector<Vec3> line = without_small_bends(draped, kBend_m);
  const double apart_m = railing.height_m / kRails;
  Mesh mesh;
  for (int i = 1; i <= kRails; ++i) add_rail(mesh, line, apart_m * i, railing.width_m * (i == kRails ? 1 : 0.5));
  // the foot of a post is farther from a rail than the middle between two rails
  const double without_posts_m = apart_m + kRailingFoot_m;
  const bool has_posts = tolerance_m < without_posts_m;
  if (has_posts) add_posts(mesh, line, railing.height_m - railing.width_m / 2, railing.width_m * 0.75);
  return {{{std::move(mesh), materials::Material::kPaintedMetal, materials::kNoTint, railing.id.osm}},
          has_posts ? 0 : without_posts_m};
}

}  // namespace citykiln::props
