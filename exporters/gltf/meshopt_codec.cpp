#include "exporters/gltf/meshopt_codec.h"

#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <cstring>

#include "exporters/gltf/compression.h"

namespace citykiln::exporters {
namespace {

using Short4 = std::array<std::int16_t, 4>;

bool is_direction(const std::string& name) { return name == "NORMAL" || name == "TANGENT"; }

// First triangles that share corners follow each other, then corners in the order in which they are used.
void reorder(MeshArrays& mesh) {
  const std::size_t corners = mesh.indices.size();
  meshopt_optimizeVertexCacheStrip(mesh.indices.data(), mesh.indices.data(), corners, mesh.count);
  std::vector<unsigned int> places(mesh.count);
  const std::size_t used = meshopt_optimizeVertexFetchRemap(places.data(), mesh.indices.data(), corners, mesh.count);
  meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), corners, places.data());
  for (VertexAttribute& stream : mesh.streams) {
    std::vector<unsigned char> ordered(used * stride_of(stream));
    meshopt_remapVertexBuffer(ordered.data(), stream.bytes.data(), mesh.count, stride_of(stream), places.data());
    stream.bytes = std::move(ordered);
  }
  mesh.count = used;
}

MeshoptView packed(const void* values, std::size_t count, std::size_t stride, const char* filter) {
  MeshoptView view{{}, count, stride, "ATTRIBUTES", filter};
  view.bytes.resize(meshopt_encodeVertexBufferBound(count, stride));
  view.bytes.resize(meshopt_encodeVertexBuffer(view.bytes.data(), view.bytes.size(), values, count, stride));
  return view;
}

MeshoptAttribute packed_direction(const VertexAttribute& stream, std::size_t count) {
  std::vector<float> wide(count * 4);
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(&wide[i * 4], stream.bytes.data() + i * stride_of(stream), stride_of(stream));
  std::vector<Short4> shorts(count);
  meshopt_encodeFilterOct(shorts.data(), count, sizeof(Short4), kPackedNormalBits, wide.data());
  return {stream.name, Component::kShort, stream.width, packed(shorts.data(), count, sizeof(Short4), "OCTAHEDRAL")};
}

// What meshopt_encodeFilterExp chooses by the size of each vector is one exponent for all.
MeshoptView packed_steps(Steps steps, std::size_t count, std::size_t stride) {
  const auto exponent = static_cast<std::uint32_t>(steps.exponent) << 24;
  for (std::int32_t& s : steps.counts)
    s = static_cast<std::int32_t>((static_cast<std::uint32_t>(s) & 0xffffffu) | exponent);
  return packed(steps.counts.data(), count, stride, "EXPONENTIAL");
}

MeshoptAttribute packed_stream(const VertexAttribute& stream, std::size_t count) {
  if (is_direction(stream.name)) return packed_direction(stream, count);
  MeshoptAttribute out{stream.name, stream.component, stream.width, {}};
  if (auto steps = steps_of(stream))
    out.view = packed_steps(std::move(*steps), count, stride_of(stream));
  else
    out.view = packed(stream.bytes.data(), count, stride_of(stream), "NONE");
  return out;
}

MeshoptView packed_indices(const MeshArrays& mesh, std::size_t stride) {
  MeshoptView view{{}, mesh.indices.size(), stride, "TRIANGLES", "NONE"};
  view.bytes.resize(meshopt_encodeIndexBufferBound(mesh.indices.size(), mesh.count));
  view.bytes.resize(
      meshopt_encodeIndexBuffer(view.bytes.data(), view.bytes.size(), mesh.indices.data(), mesh.indices.size()));
  return view;
}

// A block of vertices has a header of two bits for each sixteen bytes that are alike: no file holds more than this.
bool is_plausible(const MeshoptView& view) {
  constexpr std::size_t kMostTimes = 64;
  return view.count > 0 && view.stride > 0 && view.stride <= 256 && view.stride % 4 == 0 &&
         view.count <= kMostTimes * view.bytes.size() / view.stride;
}

void unfilter(const std::string& filter, std::vector<unsigned char>& bytes, std::size_t count, std::size_t stride) {
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
  if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), count, stride);
}

// Of unit length, which whole numbers only nearly are; the fourth number, a sign, as it is.
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
  reorder(mesh);
  MeshoptMesh out;
  for (const VertexAttribute& stream : mesh.streams) out.streams.push_back(packed_stream(stream, mesh.count));
  out.indices = packed_indices(mesh, index_stride);
  return out;
}

std::optional<VertexAttribute> decode_meshopt(const MeshoptAttribute& stream) {
  const auto& [name, component, width, view] = stream;
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
  // a triangle takes a byte at least
  const bool fits = view.mode == "TRIANGLES" && view.count % 3 == 0 && view.count / 3 <= view.bytes.size();
  if (!fits) return std::nullopt;
  std::vector<std::uint32_t> indices(view.count);
  if (meshopt_decodeIndexBuffer(indices.data(), view.count, 4, view.bytes.data(), view.bytes.size()) != 0)
    return std::nullopt;
  return indices;
}

}  // namespace citykiln::exporters
