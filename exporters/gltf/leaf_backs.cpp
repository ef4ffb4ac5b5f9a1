#include "exporters/gltf/leaf_backs.h"

#include <algorithm>
#include <cstdint>

namespace citykiln::exporters {
namespace {

using bake::Primitive;

// The opacity in COLOR_0 of vertices of back sides.
constexpr std::uint8_t kBackOpacity = 254;

bool is_back(const materials::Tint& tint) { return tint[3] == kBackOpacity; }

template <typename T>
void append_self(std::vector<T>& values) {
  const std::size_t count = values.size();
  values.resize(2 * count);
  std::copy_n(values.begin(), count, values.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

bool has_backs(const Primitive& p) {
  return p.colour_source == materials::ColourSource::kByCutout && p.triangles.size() <= kMostTrianglesWithBacks &&
         std::ranges::none_of(p.colours, is_back);
}

Primitive with_backs(Primitive p) {
  const auto count = static_cast<std::uint32_t>(p.positions.size());
  append_self(p.positions), append_self(p.normals), append_self(p.colours), append_self(p.uvs);
  append_self(p.features);
  for (std::size_t v = count; v < p.colours.size(); ++v) p.colours[v][3] = kBackOpacity;
  const std::size_t triangles = p.triangles.size();
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto [a, b, c] = p.triangles[i];
    p.triangles.push_back({a + count, c + count, b + count});
  }
  return p;
}

Primitive without_backs(const Primitive& p) {
  Primitive front;
  front.material = p.material, front.colour_source = p.colour_source, front.layer = p.layer;
  std::vector<std::uint32_t> number(p.positions.size());
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    if (is_back(p.colours[v])) continue;
    number[v] = static_cast<std::uint32_t>(front.positions.size());
    front.positions.push_back(p.positions[v]), front.normals.push_back(p.normals[v]);
    front.colours.push_back(p.colours[v]);
    if (!p.uvs.empty()) front.uvs.push_back(p.uvs[v]);
    if (!p.features.empty()) front.features.push_back(p.features[v]);
  }
  for (const auto& t : p.triangles)
    if (std::ranges::none_of(t, [&](std::uint32_t v) { return is_back(p.colours[v]); }))
      front.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return front;
}

}  // namespace citykiln::exporters
