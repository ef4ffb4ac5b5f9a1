#include "exporters/gltf/split_buildings.h"

#include <algorithm>
#include <cassert>

namespace citykiln::exporters {
namespace {

using bake::Primitive;

bool is_splittable(const Primitive& p) {
  return !p.features.empty() && std::ranges::all_of(p.triangles, [&](const auto& t) {
    return p.features[t[0]] == p.features[t[1]] && p.features[t[1]] == p.features[t[2]];
  });
}

Primitive without_triangles(const Primitive& like) {
  Primitive p;
  p.material = like.material, p.colour_source = like.colour_source, p.layer = like.layer;
  return p;
}

std::map<std::uint32_t, Primitive> by_feature(const Primitive& p) {
  std::map<std::uint32_t, Primitive> parts;
  std::vector<std::uint32_t> number;  // of each vertex in its part
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    Primitive& part = parts.try_emplace(p.features[v], without_triangles(p)).first->second;
    number.push_back(static_cast<std::uint32_t>(part.positions.size()));
    part.positions.push_back(p.positions[v]), part.normals.push_back(p.normals[v]);
    part.colours.push_back(p.colours[v]), part.features.push_back(p.features[v]);
    if (!p.uvs.empty()) part.uvs.push_back(p.uvs[v]);
  }
  for (const auto& t : p.triangles)
    parts.at(p.features[t[0]]).triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return parts;
}

template <typename T>
void append_values(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

SplitBuildings split_buildings(std::span<const Primitive> primitives) {
  SplitBuildings split;
  for (const Primitive& p : primitives) {
    if (!is_splittable(p)) {
      split.rest.push_back(p);
      continue;
    }
    for (auto& [feature, part] : by_feature(p)) split.buildings[feature].push_back(std::move(part));
  }
  return split;
}

void append_primitive(Primitive& to, const Primitive& from) {
  assert(key_of(to) == key_of(from));
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  append_values(to.positions, from.positions), append_values(to.normals, from.normals),
      append_values(to.colours, from.colours);
  append_values(to.features, from.features), append_values(to.uvs, from.uvs);
  for (const auto& t : from.triangles) to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace citykiln::exporters
