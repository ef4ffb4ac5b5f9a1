#include "exporters/tiles3d/oriented_box.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "exporters/rotated.h"

namespace citykiln::exporters {
namespace {

constexpr double kStep_m = 0x1p-6;

OrientedBox box_of(const std::vector<bake::Primitive>& primitives) {
  OrientedBox box;
  for (const bake::Primitive& p : primitives)
    for (const bake::Float3& at : p.positions) box.grow(bake::widened(at));
  return box;
}

}  // namespace

OrientedBox::OrientedBox(const Axes& a) : axes(a) {
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
}

void OrientedBox::grow(Vec3 p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = dot(axes[i], p);
    low[i] = std::min(low[i], along), high[i] = std::max(high[i], along);
  }
}

void OrientedBox::grow(const OrientedBox& box) {
  if (box.is_empty()) return;
  for (unsigned i = 0; i < 8; ++i) grow(box.corner(i));
}

void OrientedBox::round_outwards(double by_m) {
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = std::floor((low[i] - by_m) / kStep_m) * kStep_m;
    high[i] = std::ceil((high[i] + by_m) / kStep_m) * kStep_m;
  }
}

Vec3 OrientedBox::corner(unsigned i) const {
  assert(i < 8 && !is_empty());
  const auto side = [&](std::size_t axis) { return axes[axis] * ((i >> axis) % 2 == 0 ? low[axis] : high[axis]); };
  return side(0) + side(1) + side(2);
}

OrientedBox box_of(const bake::BakedTile& tile, const Axes& axes) {
  OrientedBox box(axes);
  for (const bake::Primitive& p : tile.primitives)
    for (const bake::Float3& at : p.positions) box.grow(tile.origin + bake::widened(at));
  for (const bake::InstancedMesh& instanced : tile.instanced) {
    const OrientedBox mesh = box_of(instanced.primitives);
    for (std::size_t i = 0; i < instanced.translations.size(); ++i)
      for (unsigned c = 0; c < 8; ++c)
        box.grow(tile.origin + bake::widened(instanced.translations[i]) +
                 rotated(instanced.rotations[i], mesh.corner(c) * instanced.scales[i]));
  }
  box.round_outwards(kStep_m);
  return box;
}

std::array<double, 12> numbers_of(const OrientedBox& box) {
  assert(!box.is_empty());
  std::array<double, 12> numbers{};
  Vec3 centre;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 half = box.axes[i] * ((box.high[i] - box.low[i]) / 2);
    centre = centre + box.axes[i] * ((box.low[i] + box.high[i]) / 2);
    numbers[3 + i * 3] = half.x, numbers[4 + i * 3] = half.y, numbers[5 + i * 3] = half.z;
  }
  numbers[0] = centre.x, numbers[1] = centre.y, numbers[2] = centre.z;
  return numbers;
}

}  // namespace citykiln::exporters
