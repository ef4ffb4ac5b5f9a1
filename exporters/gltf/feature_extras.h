// What the node of a single feature says about it.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/tinygltf_config.h"

namespace citykiln::exporters {

/// The name of a feature's node: "way_1234".
std::string feature_name(const bake::BakedTile& tile, std::uint32_t feature);

/// The extras of a feature's node: osm_type and osm_id; null for the none feature.
tinygltf::Value feature_extras(const bake::BakedTile& tile, std::uint32_t feature);

}  // namespace citykiln::exporters
