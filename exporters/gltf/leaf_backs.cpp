#include "exporters/gltf/leaf_backs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>

namespace citykiln::exporters {
namespace {

using bake::Primitive;
using Triangle = std::array<std::uint32_t, 3>;
using Corner = std::array<float, 5>;

Triangle reversed(const Triangle& t) { return {t[0], t[2], t[1]}; }

// The corners, the smallest first, in the order of the winding.
std::array<Corner, 3> corners_of(const Primitive& p, const Triangle& t) {
  std::array<Corner, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    const bake::Float3& at = p.positions[t[i]];
    const bake::Float2 uv = p.uvs.empty() ? bake::Float2{} : p.uvs[t[i]];
    corners[i] = {at[0], at[1], at[2], uv[0], uv[1]};
  }
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

}  // namespace

bool has_backs(const Primitive& p) {
  return p.colour_source == materials::ColourSource::kByCutout && p.triangles.size() <= kMostTrianglesWithBacks;
}

Primitive with_backs(Primitive p) {
  const std::size_t count = p.triangles.size();
  p.triangles.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) p.triangles.push_back(reversed(p.triangles[i]));
  return p;
}

Primitive without_backs(Primitive p) {
  std::set<std::array<Corner, 3>> fronts;
  std::erase_if(p.triangles, [&](const Triangle& t) {
    if (fronts.contains(corners_of(p, reversed(t)))) return true;
    fronts.insert(corners_of(p, t));
    return false;
  });
  return p;
}

}  // namespace citykiln::exporters
