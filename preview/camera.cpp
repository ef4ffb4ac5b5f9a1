#include <algorithm>
#include <cmath>

#include "preview/preview.h"

namespace citykiln::preview {
namespace {

// Where things are: the middle of all ground in plan, and heights that few points lie outside of.
struct Extent {
  Vec2 centre;
  double half_m = 0;           ///< Half of the longer side.
  double low_m = 0, high_m = 0;  ///< 2 and 98 in a hundred of the vertices' heights.
};

Extent extent_of(std::span<const bake::BakedTile> tiles) {
  Box2 box;
  std::vector<double> heights;
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Primitive& primitive : tile.primitives)
      for (const bake::Float3& p : primitive.positions) {
        box.grow({tile.origin.x + p[0], tile.origin.y + p[1]});
        heights.push_back(tile.origin.z + p[2]);
      }
  if (heights.empty()) return {{0, 0}, 100, 0, 10};
  const auto at = [&](double share) {
    const auto nth = heights.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(heights.size() - 1));
    std::nth_element(heights.begin(), nth, heights.end());
    return *nth;
  };
  return {box.centre(), std::max(box.width(), box.height()) / 2, at(0.02), at(0.98)};
}

struct View {
  const char* name;
  Vec3 from;       ///< Of the centre, in half extents (plan) and half extents above the high ground.
  double fov_deg;
};

constexpr View kViews[] = {{"overview", {0.75, -1.25, 0.85}, 40}, {"top", {0, 0, 2.9}, 40},       {"north", {0, 1.5, 0.7}, 42}, {"south", {0, -1.5, 0.7}, 42},
                           {"east", {1.5, 0, 0.7}, 42},         {"west", {-1.5, 0, 0.7}, 42}, {"low", {-0.55, -0.75, 0.10}, 50}};

}  // namespace

Result<Camera> named_view(std::span<const bake::BakedTile> tiles, const std::string& name) {
  const Extent extent = extent_of(tiles);
  const Vec3 middle = at_height(extent.centre, (extent.low_m + extent.high_m) / 2);
  if (name == "street") {
    // a few metres over the ground at the centre, looking north-east along it
    const Vec3 eye = at_height(extent.centre + Vec2{-40, -40}, extent.low_m + 12);
    return Camera{eye, eye + Vec3{60, 60, -4}, 60};
  }
  std::string known = "street";
  for (const View& view : kViews) {
    if (name == view.name) {
      const Vec3 eye = at_height(extent.centre + Vec2{view.from.x, view.from.y} * extent.half_m, extent.high_m + view.from.z * extent.half_m);
      return Camera{eye, middle, view.fov_deg};
    }
    known += std::string(", ") + view.name;
  }
  return Error{"--view " + name, "expected one of " + known};
}

}  // namespace citykiln::preview
