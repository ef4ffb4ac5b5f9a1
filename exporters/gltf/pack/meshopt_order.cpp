#include "exporters/gltf/pack/meshopt_order.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <tuple>

namespace citykiln::exporters {
namespace {

const VertexAttribute* attribute_named(const MeshArrays& mesh, const char* name) {
  const auto found = std::ranges::find(mesh.attributes, name, &VertexAttribute::name);
  return found == mesh.attributes.end() ? nullptr : &*found;
}

// The first four bytes of a vertex's attribute.
std::uint32_t word_of(const VertexAttribute& attribute, std::size_t vertex) {
  std::uint32_t word = 0;
  std::memcpy(&word, attribute.bytes.data() + vertex * stride_of(attribute), sizeof word);
  return word;
}

// ---- connected parts -----------------------------------------------------------------------------------------------

// The smallest vertex of each vertex's connected part.
std::vector<std::uint32_t> part_of_vertices(const MeshArrays& mesh) {
  std::vector<std::uint32_t> parent(mesh.count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = root(mesh.indices[i / 3 * 3]), b = root(mesh.indices[i]);
    parent[std::max(a, b)] = std::min(a, b);
  }
  for (std::uint32_t v = 0; v < mesh.count; ++v) parent[v] = root(v);
  return parent;
}

// Triangles from the first to before the last, in connected parts that follow each other.
struct Part {
  std::vector<std::uint32_t> corners;
  std::size_t feature_run = 0;  // counts changes of the feature
  std::uint32_t colour = 0;
  std::array<std::int8_t, 3> normal{};
};

std::array<std::int8_t, 3> coarse_normal(const VertexAttribute& normals, std::size_t vertex) {
  std::array<float, 3> n{};
  std::memcpy(n.data(), normals.bytes.data() + vertex * stride_of(normals), sizeof n);
  const auto part = [](float c) { return static_cast<std::int8_t>(c * 127); };
  return {part(n[0]), part(n[1]), part(n[2])};
}

std::vector<Part> parts_of(const MeshArrays& mesh, const VertexAttribute& features, const VertexAttribute& normals) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  const VertexAttribute* colours = attribute_named(mesh, "COLOR_0");
  const std::vector<std::uint32_t> root = part_of_vertices(mesh);
  std::vector<std::uint32_t> number(mesh.count, kNone);
  std::vector<Part> parts;
  std::uint32_t feature = 0;
  std::size_t run = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t v = mesh.indices[i];
    if (number[root[v]] == kNone) {
      number[root[v]] = static_cast<std::uint32_t>(parts.size());
      if (word_of(features, v) != feature) feature = word_of(features, v), ++run;
      parts.push_back({{}, run, colours == nullptr ? 0 : word_of(*colours, v), coarse_normal(normals, v)});
    }
    Part& part = parts[number[root[v]]];
    part.corners.insert(part.corners.end(), &mesh.indices[i], &mesh.indices[i] + 3);
  }
  return parts;
}

void order_parts(MeshArrays& mesh) {
  const VertexAttribute *features = attribute_named(mesh, "_FEATURE_ID_0"), *normals = attribute_named(mesh, "NORMAL");
  if (features == nullptr || normals == nullptr || normals->component != Component::kFloat) return;
  std::vector<Part> parts = parts_of(mesh, *features, *normals);
  std::ranges::stable_sort(parts, {}, [](const Part& p) { return std::tuple(p.feature_run, p.colour, p.normal); });
  std::size_t at = 0;
  for (const Part& part : parts)
    for (const std::uint32_t corner : part.corners) mesh.indices[at++] = corner;
}

// ---- first corners -------------------------------------------------------------------------------------------------

// Estimates the bits in which meshopt stores the change from one vertex to the next, byte by byte.
int change_of(const VertexAttribute& positions, std::uint32_t from, std::uint32_t to) {
  const std::size_t stride = stride_of(positions);
  int bits = 0;
  for (std::size_t i = 0; i < stride; ++i) {
    const auto change = static_cast<std::int8_t>(positions.bytes[to * stride + i] - positions.bytes[from * stride + i]);
    bits += change == 0 ? 0 : change >= -1 && change <= 1 ? 2 : change >= -7 && change <= 7 ? 4 : 8;
  }
  return bits;
}

// Turns triangles whose vertices are all new so that the first is like its predecessor, and the last like the next.
void turn_triangles(MeshArrays& mesh) {
  const VertexAttribute* positions = attribute_named(mesh, "POSITION");
  if (positions == nullptr || mesh.indices.empty()) return;
  std::vector<bool> is_used(mesh.count);
  std::uint32_t last = mesh.indices.front();
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const auto corners = mesh.indices.begin() + static_cast<std::ptrdiff_t>(t);
    if (std::none_of(corners, corners + 3, [&](std::uint32_t v) { return is_used[v]; })) {
      const auto change = [&](int turn) {
        const std::uint32_t a = corners[turn], b = corners[(turn + 1) % 3], c = corners[(turn + 2) % 3];
        return change_of(*positions, last, a) + change_of(*positions, a, b) + change_of(*positions, b, c);
      };
      const std::array changes{change(0), change(1), change(2)};
      std::rotate(corners, corners + (std::ranges::min_element(changes) - changes.begin()), corners + 3);
    }
    for (int k = 0; k < 3; ++k)
      if (!is_used[corners[k]]) is_used[corners[k]] = true, last = corners[k];
  }
}

void order_vertices(MeshArrays& mesh) {
  const std::size_t corners = mesh.indices.size();
  std::vector<unsigned int> remap(mesh.count);
  const std::size_t used = meshopt_optimizeVertexFetchRemap(remap.data(), mesh.indices.data(), corners, mesh.count);
  meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), corners, remap.data());
  for (VertexAttribute& attribute : mesh.attributes) {
    std::vector<unsigned char> ordered(used * stride_of(attribute));
    meshopt_remapVertexBuffer(ordered.data(), attribute.bytes.data(), mesh.count, stride_of(attribute), remap.data());
    attribute.bytes = std::move(ordered);
  }
  mesh.count = used;
}

}  // namespace

void order_for_meshopt(MeshArrays& mesh) {
  meshopt_optimizeVertexCacheStrip(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(), mesh.count);
  order_parts(mesh);
  turn_triangles(mesh);
  order_vertices(mesh);
}

}  // namespace citykiln::exporters
