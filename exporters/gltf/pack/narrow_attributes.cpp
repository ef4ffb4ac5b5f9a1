#include "exporters/gltf/pack/narrow_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>

#include "exporters/gltf/glb_names.h"
#include "exporters/gltf/pack/glb_primitives.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

constexpr double kFar = std::numeric_limits<double>::infinity();

// ---- plan ----------------------------------------------------------------------------------------------------------

// The range of steps of all primitives that are narrowed in the same way.
struct Range {
  bool has_steps = true, may_move = true;
  int exponent = 0;
  std::array<double, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};  // units

  void add(const VertexAttribute& attribute) {
    const auto steps = has_steps ? steps_of(attribute) : std::nullopt;
    if (!steps) return void(has_steps = false);
    exponent = std::min(exponent, steps->exponent);
    for (std::size_t i = 0; i < steps->counts.size(); ++i) {
      const double value = std::ldexp(steps->counts[i], steps->exponent);
      double &least = low[i % attribute.width], &most = high[i % attribute.width];
      least = std::min(least, value), most = std::max(most, value);
    }
  }

  double lowest() const { return std::ldexp(*std::ranges::min_element(low), -exponent); }
  double highest() const { return std::ldexp(*std::ranges::max_element(high), -exponent); }

  // All positions are signed, since an axis that is positive in one tile is negative in the next.
  std::optional<NarrowSteps> positions() const {
    if (!has_steps) return std::nullopt;
    if (lowest() >= -32767 && highest() <= 32767) return NarrowSteps{exponent, true};
    NarrowSteps moved{exponent, true};
    for (std::size_t c = 0; c < 3; ++c) {
      moved.offset_m[c] = std::floor((low[c] + high[c]) / 2);
      if (!may_move || std::ldexp(high[c] - low[c], -exponent) > 2 * (32767 - std::ldexp(1, -exponent)))
        return std::nullopt;
    }
    return moved;
  }

  std::optional<NarrowSteps> uvs() const {
    if (!has_steps || lowest() < -32767 || highest() > (lowest() < 0 ? 32767 : 65535)) return std::nullopt;
    return NarrowSteps{exponent, lowest() < 0};
  }
};

bool may_be_scaled(const Json& node) {
  if (node.contains("matrix")) return false;
  if (!node.contains("extensions") || !node["extensions"].contains(kInstancingExtension)) return true;
  return node["extensions"][kInstancingExtension]["attributes"].contains("SCALE");
}

bool is_placed(const Json& node) {
  return node.contains("translation") || node.contains("rotation") || node.contains("scale") ||
         (node.contains("extensions") && node["extensions"].contains(kInstancingExtension));
}

std::vector<Range> ranges_of_positions(const GlbParts& plain) {
  std::vector<Range> ranges(plain.gltf["meshes"].size());
  for (const Json& node : plain.gltf["nodes"])
    if (node.contains("mesh")) {
      Range& range = ranges.at(node["mesh"].get<std::size_t>());
      range.has_steps &= may_be_scaled(node);
      range.may_move &= !is_placed(node);
    }
  return ranges;
}

// ---- attributes ----------------------------------------------------------------------------------------------------

// Converts each component of each element, and pads the elements.
template <typename To, typename Convert>
VertexAttribute converted(const VertexAttribute& from, Component component, Convert convert) {
  VertexAttribute to{from.name, component, from.width, {}};
  const std::size_t count = from.bytes.size() / stride_of(from), step = bytes_of(from.component);
  to.bytes.resize(count * stride_of(to));
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < from.width; ++c) {
      const To value = convert(from.bytes.data() + i * stride_of(from) + c * step, c);
      std::memcpy(to.bytes.data() + i * stride_of(to) + c * sizeof(To), &value, sizeof(To));
    }
  return to;
}

template <typename T>
T value_at(const unsigned char* at) {
  T value{};
  std::memcpy(&value, at, sizeof(T));
  return value;
}

VertexAttribute narrowed_to_steps(const VertexAttribute& attribute, const NarrowSteps& steps) {
  const auto count = [&](const unsigned char* at, std::size_t c) {
    return std::ldexp(double{value_at<float>(at)} - steps.offset_m.at(c), -steps.exponent);
  };
  if (!steps.is_signed)
    return converted<std::uint16_t>(attribute, Component::kUnsignedShort,
                                    [&](auto* at, std::size_t c) { return static_cast<std::uint16_t>(count(at, c)); });
  return converted<std::int16_t>(attribute, Component::kShort,
                                 [&](auto* at, std::size_t c) { return static_cast<std::int16_t>(count(at, c)); });
}

// Gives the first three components unit length.
void normalise(VertexAttribute& attribute) {
  const std::size_t stride = stride_of(attribute);
  for (std::size_t at = 0; at < attribute.bytes.size(); at += stride) {
    std::array<float, 3> v{};
    std::memcpy(v.data(), attribute.bytes.data() + at, sizeof v);
    const double length = std::sqrt(double{v[0]} * v[0] + double{v[1]} * v[1] + double{v[2]} * v[2]);
    if (length > 0)
      for (float& c : v) c = static_cast<float>(c / length) + 0.0f;
    else
      v = {0, 0, 1};
    std::memcpy(attribute.bytes.data() + at, v.data(), sizeof v);
  }
}

double step_m_of(const Json& accessor) {
  const double step_m = accessor.at("extras").at("step_m").get<double>();
  if (!std::isfinite(step_m) || step_m <= 0) throw std::runtime_error("steps above 0");
  return step_m;
}

// ---- scales --------------------------------------------------------------------------------------------------------

std::array<double, 3> node_scale(const Json& node) {
  if (!node.contains("scale")) return {1, 1, 1};
  return node["scale"].get<std::array<double, 3>>();
}

// Multiplies the SCALE attribute of instances.
void scale_instances(const Json& accessor, double factor, GlbParts& parts) {
  const auto bytes = bytes_of_view(parts, view_of(parts.gltf, accessor));
  const auto first = static_cast<std::size_t>(reinterpret_cast<const std::byte*>(bytes.data()) - parts.buffer.data());
  for (std::size_t at = first; at + sizeof(float) <= first + bytes.size(); at += sizeof(float)) {
    float scale = 0;
    std::memcpy(&scale, parts.buffer.data() + at, sizeof scale);
    scale = static_cast<float>(scale * factor);
    std::memcpy(parts.buffer.data() + at, &scale, sizeof scale);
  }
}

// The offset of an accessor's positions.
std::array<double, 3> offset_m_of(const Json& accessor) {
  if (!accessor.at("extras").contains("offset_m")) return {};
  const auto offset_m = accessor["extras"]["offset_m"].get<std::array<double, 3>>();
  for (const double c : offset_m)
    if (!(std::abs(c) < 1e6)) throw std::runtime_error("offsets inside the plane");
  return offset_m;
}

// Multiplies the scale of a node, or of its instances.
void scale_node(Json& node, double factor, std::set<std::size_t>& scaled, GlbParts& parts) {
  if (node.contains("extensions") && node["extensions"].contains(kInstancingExtension)) {
    const auto number = node["extensions"][kInstancingExtension].at("attributes").at("SCALE").get<std::size_t>();
    if (scaled.insert(number).second) scale_instances(parts.gltf.at("accessors").at(number), factor, parts);
    return;
  }
  auto scale = node_scale(node);
  for (double& s : scale) s *= factor;
  node["scale"] = scale;
}

// Gives a node's mesh a node of its own where it has children, which the mesh's scale would change too.
void separate_meshes(const NarrowPlan& plan, Json& gltf) {
  Json& nodes = gltf["nodes"];
  const std::size_t count = nodes.size();
  for (std::size_t n = 0; n < count; ++n) {
    if (!nodes[n].contains("mesh") || !nodes[n].contains("children")) continue;
    if (!plan.positions.at(nodes[n]["mesh"].get<std::size_t>())) continue;
    Json own = {{"mesh", nodes[n]["mesh"]}, {"extras", {{"mesh_of", n}}}};
    if (nodes[n].contains("name")) own["name"] = nodes[n]["name"];
    nodes[n].erase("mesh"), nodes[n]["children"].push_back(nodes.size());
    nodes.push_back(std::move(own));
  }
}

// The inverse: the nodes that separate_meshes() made have no parent any more.
void rejoin_meshes(Json& gltf) {
  Json& nodes = gltf["nodes"];
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!nodes[n].contains("extras") || !nodes[n]["extras"].contains("mesh_of")) continue;
    Json& parent = nodes.at(nodes[n]["extras"]["mesh_of"].get<std::size_t>());
    Json& children = parent.at("children");
    if (parent.contains("mesh") || children.empty() || children.back() != n)
      throw std::runtime_error("meshes of nodes as citykiln writes them");
    parent["mesh"] = nodes[n].at("mesh"), nodes[n].erase("mesh"), nodes[n].erase("extras");
    children.erase(children.size() - 1);
    if (children.empty()) parent.erase("children");
  }
}

void scale_textures(Json& at, double factor) {
  for (auto& [name, value] : at.items()) {
    if (!value.is_object()) continue;
    if (!name.ends_with("Texture")) {
      scale_textures(value, factor);
      continue;
    }
    Json& transform = value["extensions"][kTextureTransformExtension];
    auto scale = transform.value("scale", std::array<double, 2>{1, 1});
    for (double& s : scale) s *= factor;
    transform["scale"] = scale;
  }
}

// Writes the step of an accessor, and its limits in steps.
void note_steps(const NarrowSteps& steps, Json& accessor) {
  const double step_m = std::ldexp(1.0, steps.exponent);
  accessor["extras"]["step_m"] = step_m;
  if (steps.offset_m != std::array<double, 3>{}) accessor["extras"]["offset_m"] = steps.offset_m;
  for (const char* limit : {"min", "max"})
    for (std::size_t c = 0; accessor.contains(limit) && c < accessor[limit].size(); ++c)
      accessor[limit][c] = (accessor[limit][c].get<double>() - steps.offset_m.at(c)) / step_m;
}

}  // namespace

NarrowPlan plan_narrowing(const GlbParts& plain) {
  if (!plain.gltf.contains("meshes")) return {};
  std::vector<Range> positions = ranges_of_positions(plain), uvs(plain.gltf.value("materials", Json::array()).size());
  for (std::size_t m = 0; m < positions.size(); ++m)
    for (const Json& primitive : plain.gltf["meshes"][m]["primitives"])
      for (const auto& [name, number] : primitive["attributes"].items()) {
        Range* const range = name == "POSITION"     ? &positions[m]
                             : name == "TEXCOORD_0" ? &uvs.at(primitive.at("material").get<std::size_t>())
                                                    : nullptr;
        if (range == nullptr) continue;
        range->add(attribute_of(plain, name, plain.gltf["accessors"].at(number.get<std::size_t>())));
      }
  NarrowPlan plan;
  for (const Range& range : positions) plan.positions.push_back(range.positions());
  for (const Range& range : uvs) plan.uvs.push_back(range.uvs());
  return plan;
}

void narrow_steps(const NarrowPlan& plan, std::size_t mesh, std::size_t material, MeshArrays& arrays) {
  for (VertexAttribute& attribute : arrays.attributes) {
    if (attribute.name == "POSITION" && plan.positions.at(mesh))
      attribute = narrowed_to_steps(attribute, *plan.positions[mesh]);
    if (attribute.name == "TEXCOORD_0" && plan.uvs.at(material))
      attribute = narrowed_to_steps(attribute, *plan.uvs[material]);
  }
}

void narrow_directions(MeshArrays& arrays) {
  for (VertexAttribute& attribute : arrays.attributes)
    if (is_direction(attribute))
      attribute = converted<std::int8_t>(attribute, Component::kByte, [](auto* at, std::size_t) {
        return static_cast<std::int8_t>(std::lround(value_at<float>(at) * 127));
      });
}

void scale_by_plan(const NarrowPlan& plan, GlbParts& parts) {
  std::set<std::size_t> scaled;
  separate_meshes(plan, parts.gltf);
  for (Json& node : parts.gltf["nodes"])
    if (node.contains("mesh"))
      if (const auto& steps = plan.positions.at(node["mesh"].get<std::size_t>())) {
        scale_node(node, std::ldexp(1.0, steps->exponent), scaled, parts);
        if (steps->offset_m != std::array<double, 3>{}) node["translation"] = steps->offset_m;
      }
  for (std::size_t m = 0; m < plan.uvs.size(); ++m)
    if (plan.uvs[m]) scale_textures(parts.gltf["materials"][m], std::ldexp(1.0, plan.uvs[m]->exponent));
  const auto note = [&](const Json& number, const NarrowSteps& steps) {
    note_steps(steps, parts.gltf["accessors"].at(number.get<std::size_t>()));
  };
  for (std::size_t m = 0; m < plan.positions.size(); ++m)
    for (const Json& primitive : parts.gltf["meshes"][m]["primitives"]) {
      const Json& attributes = primitive["attributes"];
      if (plan.positions[m]) note(attributes.at("POSITION"), *plan.positions[m]);
      const auto& uvs = plan.uvs.at(primitive.at("material").get<std::size_t>());
      if (uvs && attributes.contains("TEXCOORD_0")) note(attributes["TEXCOORD_0"], *uvs);
    }
}

void set_component(Component component, Json& accessor) {
  accessor["componentType"] = static_cast<int>(component);
  accessor.erase("byteOffset");
  if (component == Component::kByte)
    accessor["normalized"] = true;
  else if (component != Component::kUnsignedByte)
    accessor.erase("normalized");
}

VertexAttribute widened(VertexAttribute attribute, const Json& accessor) {
  if (is_direction(attribute) && attribute.component == Component::kByte) {
    VertexAttribute wide = converted<float>(attribute, Component::kFloat, [](auto* at, std::size_t) {
      return std::max(-1.0f, static_cast<float>(value_at<std::int8_t>(at)) / 127.0f);
    });
    normalise(wide);
    return wide;
  }
  const bool is_stepped = attribute.name == "POSITION" || attribute.name == "TEXCOORD_0";
  if (!is_stepped || attribute.component == Component::kFloat) return attribute;
  const double step_m = step_m_of(accessor);
  const std::array<double, 3> offset_m = offset_m_of(accessor);
  const auto metres = [&](double steps, std::size_t c) { return static_cast<float>(steps * step_m + offset_m.at(c)); };
  if (attribute.component == Component::kShort)
    return converted<float>(attribute, Component::kFloat,
                            [&](auto* at, std::size_t c) { return metres(value_at<std::int16_t>(at), c); });
  if (attribute.component != Component::kUnsignedShort) return attribute;
  return converted<float>(attribute, Component::kFloat,
                          [&](auto* at, std::size_t c) { return metres(value_at<std::uint16_t>(at), c); });
}

void unscale(GlbParts& parts) {
  std::set<std::size_t> scaled;
  Json& gltf = parts.gltf;
  if (!gltf.contains("meshes") || !gltf.contains("nodes")) return;
  for (Json& node : gltf["nodes"]) {
    if (!node.contains("mesh")) continue;
    const Json& primitives = gltf["meshes"].at(node["mesh"].get<std::size_t>()).at("primitives");
    if (primitives.empty()) continue;
    const auto number = primitives.at(0).at("attributes").at("POSITION").get<std::size_t>();
    const Json& accessor = gltf.at("accessors").at(number);
    if (!accessor.contains("extras")) continue;
    scale_node(node, 1 / step_m_of(accessor), scaled, parts);
    if (offset_m_of(accessor) != std::array<double, 3>{}) node.erase("translation");
  }
  rejoin_meshes(gltf);
}

}  // namespace citykiln::exporters
