#include "exporters/gltf/feature_extras.h"

#include <array>
#include <cassert>

namespace citykiln::exporters {
namespace {

using tinygltf::Value;

std::string type_name(OsmType type) {
  constexpr std::array<const char*, 4> kNames = {"none", "node", "way", "relation"};
  return kNames[static_cast<std::size_t>(type)];
}

}  // namespace

std::string feature_name(const bake::BakedTile& tile, std::uint32_t feature) {
  assert(feature < tile.features.size());
  const OsmId id = tile.features[feature];
  return id.type == OsmType::kNone ? "none" : type_name(id.type) + "_" + std::to_string(id.id);
}

Value feature_extras(const bake::BakedTile& tile, std::uint32_t feature) {
  assert(feature < tile.features.size());
  const OsmId id = tile.features[feature];
  if (id.type == OsmType::kNone) return {};
  // a double, since ids need more than 32 bits, which some readers refuse as whole numbers
  return Value(Value::Object{{"osm_type", Value(type_name(id.type))}, {"osm_id", Value(static_cast<double>(id.id))}});
}

}  // namespace citykiln::exporters
