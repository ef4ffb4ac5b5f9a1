#include "exporters/gltf/meshopt_codec.h"

#include <meshoptimizer.h>

#include <array>
#include <cassert>
#include <cstring>

#include "exporters/gltf/compression.h"
#include "exporters/gltf/meshopt_order.h"

namespace citykiln::exporters {
namespace {

using Byte4 = std::array<std::int8_t, 4>;

bool is_direction(const std::string& name) { return name == "NORMAL" || name == "TANGENT"; }

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
  std::vector<Byte4> bytes(count);
  meshopt_encodeFilterOct(bytes.data(), count, sizeof(Byte4), kPackedNormalBits, wide.data());
  return {attribute.name, Component::kByte, attribute.width, packed(bytes.data(), count, sizeof(Byte4), "OCTAHEDRAL")};
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

}  // namespace

MeshoptMesh encode_meshopt(MeshArrays mesh, std::size_t index_stride) {
  assert(index_stride == 2 || index_stride == 4);
  order_for_meshopt(mesh);
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
  const bool is_filter = view.filter == "NONE" || (view.filter == "EXPONENTIAL" && component == Component::kFloat);
  const bool fits = is_octahedral ? is_direction(name) && component == Component::kByte && view.stride == 4 &&
                                        (width == 3 || width == 4)
                                  : is_filter && view.stride == stride_of(out);
  if (!fits || view.mode != "ATTRIBUTES" || !is_plausible(view)) return std::nullopt;
  out.bytes.resize(view.count * view.stride);
  if (meshopt_decodeVertexBuffer(out.bytes.data(), view.count, view.stride, view.bytes.data(), view.bytes.size()) != 0)
    return std::nullopt;
  unfilter(view.filter, out.bytes, view.count, view.stride);
  return out;
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
