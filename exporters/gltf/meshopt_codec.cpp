#include "exporters/gltf/meshopt_codec.h"

#include <meshoptimizer.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstring>

#include "exporters/gltf/compression.h"

namespace citykiln::exporters {
namespace {

using Short4 = std::array<std::int16_t, 4>;

bool is_direction(const std::string& name) { return name == "NORMAL" || name == "TANGENT"; }

// Orders triangles so that neighbours follow each other, then vertices by their first use.
void reorder(MeshArrays& mesh) {
  const std::size_t corners = mesh.indices.size();
  meshopt_optimizeVertexCacheStrip(mesh.indices.data(), mesh.indices.data(), corners, mesh.count);
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

MeshoptView packed(const void* values, std::size_t count, std::size_t stride, const char* filter) {
  MeshoptView view{{}, count, stride, "ATTRIBUTES", filter};
  view.bytes.resize(meshopt_encodeVertexBufferBound(count, stride));
  view.bytes.resize(meshopt_encodeVertexBuffer(view.bytes.data(), view.bytes.size(), values, count, stride));
  return view;
}

MeshoptAttribute packed_direction(const VertexAttribute& attribute, std::size_t count) {
  std::vector<float> wide(count * 4);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(&wide[i * 4], attribute.bytes.data() + i * stride_of(attribute), stride_of(attribute));
  std::vector<Short4> shorts(count);
  meshopt_encodeFilterOct(shorts.data(), count, sizeof(Short4), kPackedNormalBits, wide.data());
  return {attribute.name, Component::kShort, attribute.width,
          packed(shorts.data(), count, sizeof(Short4), "OCTAHEDRAL")};
}

// Encodes steps for the exponential filter with one exponent, where meshopt_encodeFilterExp would choose one per
// vector.
MeshoptView packed_steps(Steps steps, std::size_t count, std::size_t stride) {
  const auto exponent = static_cast<std::uint32_t>(steps.exponent) << 24;
  for (std::int32_t& s : steps.counts)
    s = static_cast<std::int32_t>((static_cast<std::uint32_t>(s) & 0xffffffu) | exponent);
  return packed(steps.counts.data(), count, stride, "EXPONENTIAL");
}

MeshoptAttribute packed_attribute(const VertexAttribute& attribute, std::size_t count) {
  if (is_direction(attribute.name)) return packed_direction(attribute, count);
  MeshoptAttribute out{attribute.name, attribute.component, attribute.width, {}};
  if (auto steps = steps_of(attribute))
    out.view = packed_steps(std::move(*steps), count, stride_of(attribute));
  else
    out.view = packed(attribute.bytes.data(), count, stride_of(attribute), "NONE");
  return out;
}

MeshoptView packed_indices(const MeshArrays& mesh, std::size_t stride) {
  MeshoptView view{{}, mesh.indices.size(), stride, "TRIANGLES", "NONE"};
  view.bytes.resize(meshopt_encodeIndexBufferBound(mesh.indices.size(), mesh.count));
  view.bytes.resize(
      meshopt_encodeIndexBuffer(view.bytes.data(), view.bytes.size(), mesh.indices.data(), mesh.indices.size()));
  return view;
}

// Whether so few bytes can hold the view: a block of vertices has at least two bits per sixteen bytes.
bool is_plausible(const MeshoptView& view) {
  constexpr std::size_t kMostTimes = 64;
  return view.count > 0 && view.stride > 0 && view.stride <= 256 && view.stride % 4 == 0 &&
         view.count <= kMostTimes * view.bytes.size() / view.stride;
}

void unfilter(const std::string& filter, std::vector<unsigned char>& bytes, std::size_t count, std::size_t stride) {
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
  if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), count, stride);
}

// A direction of unit length; the fourth component is a sign.
std::array<float, 4> direction(const Short4& s) {
  const double x = s[0], y = s[1], z = s[2], length = std::sqrt(x * x + y * y + z * z);
  if (length == 0) return {0, 0, 1, 1};
  const auto part = [&](double v) { return static_cast<float>(v / length) + 0.0f; };
  return {part(x), part(y), part(z), s[3] < 0 ? -1.0f : 1.0f};
}

std::vector<unsigned char> as_floats(const std::vector<unsigned char>& bytes, std::size_t count, std::size_t width) {
  std::vector<unsigned char> out(count * width * sizeof(float));
  for (std::size_t i = 0; i < count; ++i) {
    Short4 shorts{};
    std::memcpy(shorts.data(), bytes.data() + i * sizeof(Short4), sizeof(Short4));
    const auto floats = direction(shorts);
    std::memcpy(out.data() + i * width * sizeof(float), floats.data(), width * sizeof(float));
  }
  return out;
}

}  // namespace

MeshoptMesh encode_meshopt(MeshArrays mesh, std::size_t index_stride) {
  assert(index_stride == 2 || index_stride == 4);
  reorder(mesh);
  MeshoptMesh out;
  for (const VertexAttribute& attribute : mesh.attributes)
    out.attributes.push_back(packed_attribute(attribute, mesh.count));
  out.indices = packed_indices(mesh, index_stride);
  return out;
}

std::optional<VertexAttribute> decode_meshopt(const MeshoptAttribute& attribute) {
  const auto& [name, component, width, view] = attribute;
  VertexAttribute out{name, component, width, {}};
  const bool is_octahedral = view.filter == "OCTAHEDRAL";
  const bool fits = is_octahedral ? is_direction(name) && component == Component::kShort && view.stride == 8 &&
                                        (width == 3 || width == 4)
                                  : view.stride == stride_of(out);
  if (!fits || view.mode != "ATTRIBUTES" || !is_plausible(view)) return std::nullopt;
  out.bytes.resize(view.count * view.stride);
  if (meshopt_decodeVertexBuffer(out.bytes.data(), view.count, view.stride, view.bytes.data(), view.bytes.size()) != 0)
    return std::nullopt;
  unfilter(view.filter, out.bytes, view.count, view.stride);
  if (!is_octahedral) return out;
  return VertexAttribute{name, Component::kFloat, width, as_floats(out.bytes, view.count, width)};
}

std::optional<std::vector<std::uint32_t>> decode_meshopt_indices(const MeshoptView& view) {
  // a triangle takes at least one byte
  const bool fits = view.mode == "TRIANGLES" && view.count % 3 == 0 && view.count / 3 <= view.bytes.size();
  if (!fits) return std::nullopt;
  std::vector<std::uint32_t> indices(view.count);
  if (meshopt_decodeIndexBuffer(indices.data(), view.count, 4, view.bytes.data(), view.bytes.size()) != 0)
    return std::nullopt;
  return indices;
}

}  // namespace citykiln::exporters
