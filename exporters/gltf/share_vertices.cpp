#include "exporters/gltf/share_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exporters/gltf/object_runs.h"
#include "exporters/gltf/packed_grids.h"

namespace citykiln::exporters {
namespace {

using bake::Primitive;

constexpr std::uint32_t kNoVertex = 0xffffffffu;
using Key = std::array<std::uint32_t, 8>;

// A normal in few bits.
std::uint32_t key_of_normal(const bake::Float3& normal) {
  constexpr float kLargest = (1 << (kPackedNormalBits - 1)) - 1;
  std::uint32_t key = 0;
  for (const float c : normal)
    key = key << kPackedNormalBits | (static_cast<std::uint32_t>(std::lround(c * kLargest)) & 0xff);
  return key;
}

Key key_of_vertex(const Primitive& p, std::size_t v) {
  const auto bits = [](float c) { return std::bit_cast<std::uint32_t>(c); };
  const bake::Float2 uv = p.uvs.empty() ? bake::Float2{} : p.uvs[v];
  return {bits(p.positions[v][0]),
          bits(p.positions[v][1]),
          bits(p.positions[v][2]),
          p.normals.empty() ? 0 : key_of_normal(p.normals[v]),
          std::bit_cast<std::uint32_t>(p.colours[v]),
          p.features.empty() ? 0 : p.features[v],
          bits(uv[0]),
          bits(uv[1])};
}

std::size_t hash_of(const Key& key) {
  std::uint64_t h = 0;
  for (const std::uint32_t part : key) h = (h ^ part) * 0x9e3779b97f4a7c15ull, h ^= h >> 29;
  return static_cast<std::size_t>(h >> 20);
}

std::vector<bool> used_vertices(const Primitive& primitive) {
  std::vector<bool> used(primitive.positions.size());
  for (const auto& t : primitive.triangles)
    for (const std::uint32_t v : t) used[v] = true;
  return used;
}

// For each vertex the first equal one of its run, itself if it is that; kNoVertex without a triangle.
std::vector<std::uint32_t> first_equals(const Primitive& primitive) {
  std::vector<std::uint32_t> first(primitive.positions.size(), kNoVertex);
  const std::vector<bool> used = used_vertices(primitive);
  for (const ObjectRun& run : feature_runs(primitive, object_runs(primitive))) {
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * run.vertices()), kNoVertex);
    for (std::size_t v = run.first_vertex; v < run.last_vertex; ++v) {
      if (!used[v]) continue;
      const Key key = key_of_vertex(primitive, v);
      std::size_t slot = hash_of(key) & (slots.size() - 1);
      while (slots[slot] != kNoVertex && key_of_vertex(primitive, slots[slot]) != key)
        slot = (slot + 1) & (slots.size() - 1);
      if (slots[slot] == kNoVertex) slots[slot] = static_cast<std::uint32_t>(v);
      first[v] = slots[slot];
    }
  }
  return first;
}

// Drops triangles that use a vertex twice, but not all of a primitive.
void drop_thin_triangles(Primitive& primitive) {
  const auto is_thin = [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  if (!std::ranges::all_of(primitive.triangles, is_thin)) std::erase_if(primitive.triangles, is_thin);
}

void drop_unused_vertices(Primitive& primitive) {
  const std::vector<bool> used = used_vertices(primitive);
  std::vector<std::uint32_t> number(used.size());
  std::uint32_t count = 0;
  const auto keep = [&](auto& values, std::size_t from) {
    if (!values.empty()) values[count] = values[from];
  };
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    keep(primitive.positions, v), keep(primitive.normals, v), keep(primitive.colours, v);
    keep(primitive.features, v), keep(primitive.uvs, v);
    number[v] = count++;
  }
  const auto shorten = [&](auto& values) {
    if (!values.empty()) values.resize(count);
  };
  shorten(primitive.positions), shorten(primitive.normals), shorten(primitive.colours);
  shorten(primitive.features), shorten(primitive.uvs);
  for (auto& t : primitive.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

}  // namespace

void share_vertices(Primitive& primitive) {
  const std::vector<std::uint32_t> first = first_equals(primitive);
  for (auto& t : primitive.triangles)
    for (std::uint32_t& v : t) v = first[v];
  drop_thin_triangles(primitive);
  drop_unused_vertices(primitive);
}

}  // namespace citykiln::exporters
