#include "compiler/plants/prototypes/crossed_cards.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"
#include "compiler/impostor/impostor.h"
#include "compiler/materials/paint.h"

namespace citykiln::plants {
namespace {

using materials::MaterialMesh;
using materials::TextureImage;

// Depth of a picture in tolerances; the rest of the tolerance is a texel.
constexpr double kDepth = 0.75;
// Side of a normal texel in colour texels.
constexpr std::uint32_t kNormalTexels = 2;
// Least component of normals towards the viewer: a sphere's rim would be black.
constexpr double kLeastOut = 0.35;

struct Extent {
  double radius_m = 0, low_m = 1e300, high_m = -1e300;
};

Extent extent_of(const std::vector<MaterialMesh>& shape) {
  Extent extent;
  for (const MaterialMesh& dressed : shape)
    for (const Vec3 p : dressed.mesh.positions) {
      extent.radius_m = std::max(extent.radius_m, length(in_plan(p)));
      extent.low_m = std::min(extent.low_m, p.z), extent.high_m = std::max(extent.high_m, p.z);
    }
  return extent;
}

// A picture's rectangle, viewed from cross(along, across).
struct Plane {
  Vec3 corner, across, along;  // top left; unit directions
  double width_m = 0, height_m = 0, depth_m = 0;
};

double plane_distance_m(const Extent& extent, int planes) { return extent.radius_m * sine(90.0 / planes); }

int planes_for(const Extent& extent, double tolerance_m) {
  int planes = 2;
  while (planes < kMostPlanes && plane_distance_m(extent, planes) > kDepth * tolerance_m) ++planes;
  return planes;
}

Plane vertical_plane(const Extent& extent, double turns, double depth_m) {
  const Vec3 across = at_height(direction_of(turns), 0);
  return {across * -extent.radius_m + Vec3{0, 0, extent.high_m},
          across,
          {0, 0, -1},
          2 * extent.radius_m,
          extent.high_m - extent.low_m,
          depth_m};
}

Plane horizontal_plane(const Extent& extent, double height_m, double depth_m) {
  return {{-extent.radius_m, extent.radius_m, height_m},
          {1, 0, 0},
          {0, -1, 0},
          2 * extent.radius_m,
          2 * extent.radius_m,
          depth_m};
}

// The vertical planes, and horizontal ones in the upper three quarters of the plant.
std::vector<Plane> planes_of(const Extent& extent, double tolerance_m) {
  const int count = planes_for(extent, tolerance_m);
  const double depth_m = std::max(kDepth * tolerance_m, plane_distance_m(extent, count));
  std::vector<Plane> planes;
  for (int i = 0; i < count; ++i) planes.push_back(vertical_plane(extent, 0.5 * i / count, depth_m));
  const double crown_m = (extent.high_m - extent.low_m) * 0.75;
  const int levels = std::clamp(static_cast<int>(std::ceil(crown_m / (2 * depth_m))), 1, kMostLevels);
  for (int i = 0; i < levels; ++i)
    planes.push_back(horizontal_plane(extent, extent.high_m - crown_m * (i + 0.5) / levels, depth_m));
  return planes;
}

impostor::View view_of(const Plane& plane, double texel_m) {
  const auto texels = [&](double metres) {
    return static_cast<std::uint32_t>(std::max(2.0, std::ceil(metres / texel_m)));
  };
  return {plane.corner,          plane.across,           plane.along,   texel_m,
          texels(plane.width_m), texels(plane.height_m), plane.depth_m, plane.depth_m};
}

void add_card(MaterialMesh& dressed, const impostor::View& view, Vec2 at_m) {
  const auto first = static_cast<std::uint32_t>(dressed.mesh.positions.size());
  const double width_m = view.columns * view.texel_m, height_m = view.rows * view.texel_m;
  const Vec3 normal = cross(view.v, view.u);
  for (const Vec2 uv : {Vec2{0, 0}, Vec2{0, height_m}, Vec2{width_m, height_m}, Vec2{width_m, 0}}) {
    dressed.mesh.positions.push_back(view.corner + view.u * uv.x + view.v * uv.y);
    dressed.mesh.normals.push_back(normal);
    dressed.uvs.push_back(at_m + uv);
  }
  dressed.mesh.triangles.push_back({first, first + 1, first + 2});
  dressed.mesh.triangles.push_back({first, first + 2, first + 3});
}

// A sphere's normal, limited by kLeastOut, at a place from -1 to 1 in the picture.
TextureImage::Texel normal_at(double x, double y) {
  const double off = std::sqrt(x * x + y * y), most = std::sqrt(1 - kLeastOut * kLeastOut);
  const double shrink = off > most ? most / off : 1;
  const Vec3 n = unit(Vec3{x * shrink, y * shrink, std::sqrt(std::max(0.0, 1 - (x * x + y * y) * shrink * shrink))});
  const auto byte = [](double v) { return static_cast<std::uint8_t>((v + 1) / 2 * 255 + 0.5); };
  return {byte(n.x), byte(n.y), byte(n.z)};
}

// Normals extend one texel beyond the picture, so that filtering at its edge is correct.
void draw_normals(TextureImage& normals, const impostor::View& view, Vec2 at_m) {
  const double width_m = view.columns * view.texel_m, height_m = view.rows * view.texel_m;
  for (std::uint32_t row = 0; row < normals.rows; ++row)
    for (std::uint32_t column = 0; column < normals.columns; ++column) {
      const double u = (column + 0.5) * normals.texel_m - at_m.x, v = (row + 0.5) * normals.texel_m - at_m.y;
      const double rim_m = view.texel_m;
      if (u < -rim_m || v < -rim_m || u > width_m + rim_m || v > height_m + rim_m) continue;
      normals.texels[std::size_t{row} * normals.columns + column] =
          normal_at(2 * u / width_m - 1, 1 - 2 * v / height_m);
    }
}

}  // namespace

CrossedCards crossed_cards(const std::vector<MaterialMesh>& shape, double tolerance_m) {
  assert(tolerance_m > 0);
  const Extent extent = extent_of(shape);
  const double texel_m = (1 - kDepth) * tolerance_m;
  const impostor::Model ready = impostor::model_of(shape);
  std::vector<impostor::View> views;
  std::vector<impostor::Picture> pictures;
  CrossedCards out;
  for (const Plane& plane : planes_of(extent, tolerance_m)) {
    views.push_back(view_of(plane, texel_m));
    pictures.push_back(impostor::render(ready, views.back()).picture);
    out.error_m = std::max(out.error_m, plane.depth_m + texel_m);
  }
  impostor::CutoutLayout layout = impostor::lay_out_cutout(std::move(pictures), texel_m);
  out.cutout = std::move(layout.cutout);
  const TextureImage& colour = out.cutout.colour;
  out.cutout.normal = materials::blank_image(colour.texel_m * kNormalTexels, (colour.columns + 1) / kNormalTexels,
                                             (colour.rows + 1) / kNormalTexels, {128, 128, 255});
  out.mesh.colour_source = materials::ColourSource::kByCutout;
  for (std::size_t i = 0; i < views.size(); ++i) {
    add_card(out.mesh, views[i], layout.at_m[i]);
    draw_normals(out.cutout.normal, views[i], layout.at_m[i]);
  }
  return out;
}

}  // namespace citykiln::plants
