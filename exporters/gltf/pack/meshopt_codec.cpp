#include "exporters/gltf/pack/meshopt_codec.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <numeric>
#include <tuple>

#include "exporters/gltf/packed_grids.h"

namespace citykiln::exporters {
namespace {

using Byte4 = std::array<std::int8_t, 4>;

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

// Orders the triangles of a mesh and rotates their corners, which changes no shape:
//
// 1. triangles that share vertices follow each other (meshopt_optimizeVertexCacheStrip);
// 2. connected parts of one feature are sorted by colour, then normal, so faces of one wall and direction are
// together;
// 3. the first triangle of a part begins at the corner from which positions change in the fewest bytes.
//
// Then sorts vertices by their first use and removes unused ones. On buildings of Monaco at 0.1 m this saves 7 % of a
// tile. O(n log n).
void order_for_meshopt(MeshArrays& mesh) {
  meshopt_optimizeVertexCacheStrip(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(), mesh.count);
  order_parts(mesh);
  turn_triangles(mesh);
  order_vertices(mesh);
}

MeshoptArray array_of(const void* values, std::size_t count, std::size_t stride, const char* filter) {
  const auto* bytes = static_cast<const unsigned char*>(values);
  return {{stride, "ATTRIBUTES", filter}, {bytes, bytes + count * stride}};
}

MeshoptArray direction_array(const VertexAttribute& attribute, std::size_t count) {
  std::vector<float> wide(count * 4);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(&wide[i * 4], attribute.bytes.data() + i * stride_of(attribute), stride_of(attribute));
  std::vector<Byte4> bytes(count);
  meshopt_encodeFilterOct(bytes.data(), count, sizeof(Byte4), kPackedNormalBits, wide.data());
  return array_of(bytes.data(), count, sizeof(Byte4), "OCTAHEDRAL");
}

// Encodes steps for the exponential filter with one exponent, where meshopt_encodeFilterExp would choose one per
// vector.
MeshoptArray array_of_steps(Steps steps, std::size_t count, std::size_t stride) {
  const auto exponent = static_cast<std::uint32_t>(steps.exponent) << 24;
  for (std::int32_t& s : steps.counts)
    s = static_cast<std::int32_t>((static_cast<std::uint32_t>(s) & 0xffffffu) | exponent);
  return array_of(steps.counts.data(), count, stride, "EXPONENTIAL");
}

MeshoptArray attribute_array(const VertexAttribute& attribute, std::size_t count) {
  if (is_direction(attribute)) return direction_array(attribute, count);
  if (auto steps = steps_of(attribute)) return array_of_steps(std::move(*steps), count, stride_of(attribute));
  return array_of(attribute.bytes.data(), count, stride_of(attribute), "NONE");
}

MeshoptArray index_array(const std::vector<std::uint32_t>& indices, std::size_t stride) {
  MeshoptArray array{{stride, "TRIANGLES", "NONE"}, std::vector<unsigned char>(indices.size() * stride)};
  for (std::size_t i = 0; i < indices.size(); ++i) std::memcpy(&array.bytes[i * stride], &indices[i], stride);
  return array;
}

// Whether so few bytes can hold the view: a block of vertices has at least two bits per sixteen bytes, a triangle at
// least one byte.
bool is_plausible(const MeshoptView& view) {
  constexpr std::size_t kMostTimes = 64;
  const std::size_t stride = view.kind.stride;
  if (view.kind.mode == "TRIANGLES")
    return (stride == 2 || stride == 4) && view.count % 3 == 0 && view.count / 3 <= view.bytes.size();
  return view.kind.mode == "ATTRIBUTES" && view.count > 0 && stride > 0 && stride <= 256 && stride % 4 == 0 &&
         view.count <= kMostTimes * view.bytes.size() / stride;
}

void unfilter(const std::string& filter, std::vector<unsigned char>& bytes, std::size_t count, std::size_t stride) {
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
  if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), count, stride);
}

}  // namespace

MeshoptMesh meshopt_arrays(MeshArrays mesh, std::size_t index_stride) {
  assert(index_stride == 2 || index_stride == 4);
  order_for_meshopt(mesh);
  MeshoptMesh out;
  for (const VertexAttribute& attribute : mesh.attributes) {
    out.attributes.push_back(attribute_array(attribute, mesh.count));
    out.components.push_back(is_direction(attribute) ? Component::kByte : attribute.component);
  }
  out.indices = index_array(mesh.indices, index_stride), out.count = mesh.count;
  return out;
}

MeshoptView encode_meshopt(const MeshoptArray& array, std::size_t vertices) {
  const std::size_t count = array.bytes.size() / array.kind.stride;
  MeshoptView view{array.kind, count, {}};
  if (array.kind.mode == "TRIANGLES") {
    std::vector<std::uint32_t> indices(count);
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(&indices[i], &array.bytes[i * array.kind.stride], array.kind.stride);
    view.bytes.resize(meshopt_encodeIndexBufferBound(count, vertices));
    view.bytes.resize(meshopt_encodeIndexBuffer(view.bytes.data(), view.bytes.size(), indices.data(), count));
    return view;
  }
  view.bytes.resize(meshopt_encodeVertexBufferBound(count, array.kind.stride));
  view.bytes.resize(
      meshopt_encodeVertexBuffer(view.bytes.data(), view.bytes.size(), array.bytes.data(), count, array.kind.stride));
  return view;
}

std::optional<std::vector<unsigned char>> decode_meshopt(const MeshoptView& view) {
  if (!is_plausible(view)) return std::nullopt;
  const auto& [kind, count, packed] = view;
  std::vector<unsigned char> bytes(count * kind.stride);
  const int failure = kind.mode == "TRIANGLES"
                          ? meshopt_decodeIndexBuffer(bytes.data(), count, kind.stride, packed.data(), packed.size())
                          : meshopt_decodeVertexBuffer(bytes.data(), count, kind.stride, packed.data(), packed.size());
  if (failure != 0 || (kind.filter == "OCTAHEDRAL" && kind.stride != 4)) return std::nullopt;
  unfilter(kind.filter, bytes, count, kind.stride);
  return bytes;
}

bool can_hold(const MeshoptKind& kind, const VertexAttribute& attribute) {
  if (kind.mode != "ATTRIBUTES") return false;
  if (kind.filter == "OCTAHEDRAL")
    return is_direction(attribute) && attribute.component == Component::kByte && kind.stride == 4 &&
           (attribute.width == 3 || attribute.width == 4);
  const bool is_filter =
      kind.filter == "NONE" || (kind.filter == "EXPONENTIAL" && attribute.component == Component::kFloat);
  return is_filter && kind.stride == stride_of(attribute);
}

}  // namespace citykiln::exporters
