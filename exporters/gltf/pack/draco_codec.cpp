#include "exporters/gltf/pack/draco_codec.h"

#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "exporters/gltf/packed_grids.h"

namespace citykiln::exporters {
namespace {

using draco::GeometryAttribute;

GeometryAttribute::Type draco_type_of(const std::string& name) {
  if (name == "POSITION") return GeometryAttribute::POSITION;
  if (name == "NORMAL") return GeometryAttribute::NORMAL;
  if (name == "COLOR_0") return GeometryAttribute::COLOR;
  if (name == "TEXCOORD_0") return GeometryAttribute::TEX_COORD;
  return GeometryAttribute::GENERIC;
}

draco::DataType data_type_of(Component component) {
  switch (component) {
    case Component::kByte:
      return draco::DT_INT8;
    case Component::kUnsignedByte:
      return draco::DT_UINT8;
    case Component::kShort:
      return draco::DT_INT16;
    case Component::kUnsignedShort:
      return draco::DT_UINT16;
    case Component::kUnsignedInt:
      return draco::DT_UINT32;
    case Component::kFloat:
      return draco::DT_FLOAT32;
  }
  return draco::DT_INVALID;
}

// The distinct values of an attribute, and the index of each vertex's.
struct Values {
  std::vector<unsigned char> bytes;
  std::vector<unsigned int> of_vertex;
  std::size_t count = 0;
};

Values different_values(const VertexAttribute& attribute, std::size_t vertices) {
  const std::size_t stride = stride_of(attribute);
  Values values{{}, std::vector<unsigned int>(vertices), 0};
  values.count =
      meshopt_generateVertexRemap(values.of_vertex.data(), nullptr, vertices, attribute.bytes.data(), vertices, stride);
  values.bytes.resize(values.count * stride);
  meshopt_remapVertexBuffer(values.bytes.data(), attribute.bytes.data(), vertices, stride, values.of_vertex.data());
  return values;
}

// Gives a vertex a copy of its position, so that it shares none.
void separate(unsigned int vertex, std::size_t stride, Values& positions) {
  const auto at = static_cast<std::ptrdiff_t>(positions.of_vertex[vertex] * stride);
  const std::vector<unsigned char> same(positions.bytes.begin() + at,
                                        positions.bytes.begin() + at + static_cast<std::ptrdiff_t>(stride));
  positions.bytes.insert(positions.bytes.end(), same.begin(), same.end());
  positions.of_vertex[vertex] = static_cast<unsigned int>(positions.count++);
}

// Draco drops triangles two of whose corners share a position: gives these corners positions of their own.
void keep_thin_triangles(const MeshArrays& mesh, std::size_t stride, Values& positions) {
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const unsigned int a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
    const auto& index = positions.of_vertex;
    if (index[a] == index[b] || index[b] == index[c]) separate(b, stride, positions);
    if (index[a] == index[c]) separate(c, stride, positions);
  }
}

int add_attribute(const MeshArrays& mesh, const VertexAttribute& attribute, draco::Mesh& out) {
  const std::size_t stride = stride_of(attribute);
  Values values = different_values(attribute, mesh.count);
  if (attribute.name == "POSITION") keep_thin_triangles(mesh, stride, values);
  GeometryAttribute target;
  const bool is_normalised = attribute.component != Component::kFloat;
  target.Init(draco_type_of(attribute.name), nullptr, static_cast<std::int8_t>(attribute.width),
              data_type_of(attribute.component), is_normalised, static_cast<std::int64_t>(stride), 0);
  const int id = out.AddAttribute(target, false, static_cast<std::uint32_t>(values.count));
  for (std::size_t i = 0; i < values.count; ++i)
    out.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(static_cast<std::uint32_t>(i)),
                                         values.bytes.data() + i * stride);
  for (std::size_t i = 0; i < mesh.count; ++i)
    out.attribute(id)->SetPointMapEntry(draco::PointIndex(static_cast<std::uint32_t>(i)),
                                        draco::AttributeValueIndex(values.of_vertex[i]));
  return id;
}

// Sets a grid of 2^exponent from an origin on. Draco computes steps in single precision, which is exact below 2^23, and
// passes origin and range on as texts of six decimals, which is exact where the origin is a whole number and the range
// is above 16.
void set_grid(draco::ExpertEncoder& encoder, int id, int exponent, const std::vector<float>& origin, int least_bits) {
  const int bits = std::max(least_bits, 5 - exponent);
  const auto range = static_cast<float>(std::ldexp((1 << bits) - 1, exponent));
  encoder.SetAttributeExplicitQuantization(id, bits, static_cast<int>(origin.size()), origin.data(), range);
}

void set_steps(draco::ExpertEncoder& encoder, int id, const Steps& steps, std::size_t width) {
  constexpr std::int32_t kMostSteps = 1 << 23;
  const auto whole = [&](std::int32_t count) { return std::floor(std::ldexp(count, steps.exponent)); };
  std::vector<double> origin(width, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < steps.counts.size(); ++i)
    origin[i % width] = std::min(origin[i % width], whole(steps.counts[i]));
  double range = 1;
  for (std::size_t i = 0; i < steps.counts.size(); ++i)
    range = std::max(range, steps.counts[i] - std::ldexp(origin[i % width], -steps.exponent));
  if (range >= kMostSteps) return;
  int bits = 1;
  while ((1 << bits) - 1 < range) ++bits;
  set_grid(encoder, id, steps.exponent, {origin.begin(), origin.end()}, bits);
}

void set_quantisation(draco::ExpertEncoder& encoder, int id, const VertexAttribute& attribute) {
  if (attribute.name == "NORMAL") return encoder.SetAttributeQuantization(id, kPackedNormalBits);
  // a grid that contains -1 and 1
  if (attribute.name == "TANGENT") return set_grid(encoder, id, -7, {-1, -1, -1, -1}, 0);
  if (const auto steps = steps_of(attribute)) set_steps(encoder, id, *steps, attribute.width);
}

void add_triangles(const MeshArrays& mesh, draco::Mesh& out) {
  out.set_num_points(static_cast<std::uint32_t>(mesh.count));
  out.SetNumFaces(mesh.indices.size() / 3);
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3)
    out.SetFace(draco::FaceIndex(static_cast<std::uint32_t>(t / 3)),
                {draco::PointIndex(mesh.indices[t]), draco::PointIndex(mesh.indices[t + 1]),
                 draco::PointIndex(mesh.indices[t + 2])});
}

bool read_attribute(const draco::Mesh& mesh, int id, VertexAttribute& attribute) {
  const draco::PointAttribute* const source =
      id >= 0 ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id)) : nullptr;
  const std::size_t stride = stride_of(attribute);
  if (source == nullptr || source->data_type() != data_type_of(attribute.component) ||
      source->num_components() != static_cast<int>(attribute.width) ||
      source->byte_stride() != static_cast<std::int64_t>(stride))
    return false;
  attribute.bytes.resize(mesh.num_points() * stride);
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex value = source->mapped_index(draco::PointIndex(i));
    if (value.value() >= source->size()) return false;
    source->GetValue(value, attribute.bytes.data() + i * stride);
  }
  return true;
}

}  // namespace

std::optional<DracoMesh> encode_draco(const MeshArrays& mesh) {
  draco::Mesh plain;
  add_triangles(mesh, plain);
  DracoMesh out;
  for (const VertexAttribute& attribute : mesh.attributes) out.ids.push_back(add_attribute(mesh, attribute, plain));
  draco::ExpertEncoder encoder(plain);
  encoder.SetTrackEncodedProperties(true);
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) set_quantisation(encoder, out.ids[i], mesh.attributes[i]);
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeToBuffer(&buffer).ok()) return std::nullopt;
  out.bytes.assign(buffer.data(), buffer.data() + buffer.size());
  out.count = encoder.num_encoded_points(), out.triangles = encoder.num_encoded_faces();
  for (int& id : out.ids) id = static_cast<int>(plain.attribute(id)->unique_id());
  return out;
}

std::optional<MeshArrays> decode_draco(std::span<const unsigned char> bytes, std::vector<VertexAttribute> wanted,
                                       std::span<const int> ids) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return std::nullopt;
  const draco::Mesh& mesh = *decoded.value();
  MeshArrays out{mesh.num_points(), std::move(wanted), {}};
  for (std::size_t i = 0; i < out.attributes.size(); ++i)
    if (!read_attribute(mesh, ids[i], out.attributes[i])) return std::nullopt;
  for (std::uint32_t t = 0; t < mesh.num_faces(); ++t)
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(t))) out.indices.push_back(corner.value());
  return out;
}

}  // namespace citykiln::exporters
