// Describes the features of a tile, in a property table for the whole tile and in extras of nodes that show one
// feature.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {

/// Adds the columns of the tile's property table to the buffer and returns the value of EXT_structural_metadata. Row i
/// describes feature i; row 0 means "no feature".
///
/// | property | type           | value                                                        | noData |
/// |----------|----------------|--------------------------------------------------------------|--------|
/// | id       | UINT64         | id of the OpenStreetMap element                              |        |
/// | type     | UINT8          | 0 none, 1 node, 2 way, 3 relation, 4 lot                     |        |
/// | class    | ENUM of UINT16 | its class, "Apartments"; the enum lists the tile's, sorted   | none   |
/// | name     | STRING         | name=*                                                       | ""     |
/// | height_m | FLOAT32        | from foot to top: buildings, barriers, lamps, single plants  | 0      |
/// | tags     | STRING         | all tags as a JSON object, where the scene keeps them        | ""     |
/// | assumed  | UINT16         | what is assumed, a sum of bits, which the description names  | 0      |
///
/// Leaves out columns without values: name or tags if all are empty, assumed if all are 0, and class to assumed if the
/// tile has no attributes.
nlohmann::json property_table(GlbBuilder& builder);

/// Returns the name of a feature's node: "way_1234", or "none" for row 0.
std::string feature_name(const bake::BakedTile& tile, std::uint32_t feature);

/// Returns the extras of a node that shows one feature: {feature, osm_id, osm_type, class, name, height_m, tags,
/// assumed}. `feature` is the row of the property table, osm_type is "node", "way", "relation" or "lot", tags is an
/// object, and assumed is a list of names. Unknown values are left out; row 0 has `feature` only.
/// @param feature  An index into tile.features.
nlohmann::json extras_of(const bake::BakedTile& tile, std::uint32_t feature);

}  // namespace citykiln::exporters
