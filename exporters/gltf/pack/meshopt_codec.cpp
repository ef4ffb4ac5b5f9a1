#include "exporters/gltf/pack/meshopt_codec.h"

#include <meshoptimizer.h>

#include <array>
#include <cassert>
#include <cstring>

#include "exporters/gltf/pack/meshopt_order.h"
#include "exporters/gltf/packed_grids.h"

namespace citykiln::exporters {
namespace {

using Byte4 = std::array<std::int8_t, 4>;

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
