#include "compiler/buildings/meshes/railings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/materials/texture.h"
#include "compiler/materials/texture_pattern.h"
#include "grammars/shapes/scope.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;

// From bar to bar, middle to middle.
constexpr double kBarPitch_m = 0.14;
constexpr double kBarWidth_m = 0.02;
constexpr double kRailDepth_m = 0.04;

// The rectangle around a railing, in its plane.
struct RailingFrame {
  Vec3 corner, along, up, out;  // the lower left corner, seen from outside, and unit vectors
  double width_m, height_m;
  double gaps;  // between bars, a whole number

  Vec3 at(double share_along, double share_up) const {
    return corner + along * (share_along * width_m) + up * (share_up * height_m);
  }
};

RailingFrame frame_of_railing(const Face& railing) {
  constexpr double kNone_m = std::numeric_limits<double>::infinity();
  const auto [along, up, out] = grammars::axes_of(railing);
  const Vec3 first = railing.outer.front();
  Vec2 low{kNone_m, kNone_m}, high{-kNone_m, -kNone_m};
  for (const Vec3 p : railing.outer) {
    const Vec2 at{dot(p - first, along), dot(p - first, up)};
    low = {std::min(low.x, at.x), std::min(low.y, at.y)}, high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  const double width_m = high.x - low.x;
  const double gaps = std::max(1.0, std::floor((width_m - kBarWidth_m) / kBarPitch_m + 0.5));
  return {first + along * low.x + up * low.y, along, up, out, width_m, high.y - low.y, gaps};
}

// Texels of the texture between the left side of the first bar and the right side of the last one.
double texels_along(const RailingFrame& frame) { return frame.gaps * materials::kBarPitch_px + materials::kBar_px; }

double share_up(std::uint32_t row_px) {
  constexpr double kRows_px = materials::kRailingHigh_px - materials::kRailingLow_px;
  return (row_px - materials::kRailingLow_px) / kRows_px;
}

void add_from_both_sides(const Face& face, std::vector<Face>& faces) {
  faces.push_back(face);
  faces.push_back(reversed(face));
}

Face quadrilateral(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  Face face;
  face.outer = {a, b, c, d};
  return face;
}

}  // namespace

void add_railing_uvs(const Face& railing, materials::MaterialMesh& mesh) {
  constexpr double kStep_m = materials::kTextureCoordinateStep_m;
  const RailingFrame frame = frame_of_railing(railing);
  const double texel_m = materials::texture_side_m(materials::Material::kRailing) / 256;
  const auto on_grid = [&](double px) { return std::floor(px * texel_m / kStep_m + 0.5) * kStep_m; };
  for (std::size_t i = mesh.uvs.size(); i < mesh.mesh.positions.size(); ++i) {
    const Vec3 from = mesh.mesh.positions[i] - frame.corner;
    const double u = dot(from, frame.along) / frame.width_m, v = dot(from, frame.up) / frame.height_m;
    mesh.uvs.push_back(
        {on_grid(materials::kBarBegin_px + u * texels_along(frame)),
         on_grid(materials::kRailingLow_px + v * (materials::kRailingHigh_px - materials::kRailingLow_px))});
  }
}

std::vector<Face> parts_of_railing(const Face& railing) {
  const RailingFrame frame = frame_of_railing(railing);
  const double foot = share_up(materials::kBarsFrom_px), head = share_up(materials::kRailFrom_px);
  const double pitch = materials::kBarPitch_px / texels_along(frame), wide = materials::kBar_px / texels_along(frame);
  std::vector<Face> faces;
  for (double i = 0; i <= frame.gaps; ++i) {
    const double from = i * pitch;
    add_from_both_sides(quadrilateral(frame.at(from, foot), frame.at(from + wide, foot), frame.at(from + wide, head),
                                      frame.at(from, head)),
                        faces);
  }
  const Vec3 before = frame.out * kRailDepth_m, a = frame.at(0, head), b = frame.at(1, head), c = frame.at(1, 1),
             d = frame.at(0, 1);
  faces.push_back(quadrilateral(a + before, b + before, c + before, d + before));
  faces.push_back(quadrilateral(b, a, d, c));
  faces.push_back(quadrilateral(d + before, c + before, c, d));
  return faces;
}

}  // namespace citykiln::buildings
