// What each feature of a tile is: as a property table for the whole tile, and as extras of nodes that show one feature.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/bake/baked_tile.h"
#include "exporters/gltf/glb_builder.h"

namespace citykiln::exporters {

/// Adds the columns of the tile's property table to the buffer and returns the value of EXT_structural_metadata. Row i
/// is feature i; row 0 is none.
///
/// | property | type           | value                                                        | noData |
/// |----------|----------------|--------------------------------------------------------------|--------|
/// | id       | UINT64         | id of the OpenStreetMap element                              |        |
/// | type     | UINT8          | 0 none, 1 node, 2 way, 3 relation                            |        |
/// | class    | ENUM of UINT16 | its class, "Apartments"; the enum lists the tile's, sorted   | none   |
/// | name     | STRING         | name=*                                                       | ""     |
/// | height_m | FLOAT32        | from foot to top: buildings, barriers, lamps, single plants  | 0      |
/// | tags     | STRING         | all tags as a JSON object, where the scene keeps them        | ""     |
///
/// Columns without a value are left out: name and tags that are all empty, and all of class to tags where the tile has
/// no attributes.
nlohmann::json property_table(GlbBuilder& builder);

/// The name of the node of a feature: "way_1234"; "none" for the none feature.
std::string feature_name(const bake::BakedTile& tile, std::uint32_t feature);

/// The extras of a node that shows one feature: {feature, osm_id, osm_type, class, name, height_m, tags}, where
/// osm_type is "node", "way" or "relation" and tags is an object. Values that are not known are left out; the none
/// feature has `feature` alone. `feature` is the row of the property table.
/// @param feature  Index into tile.features.
nlohmann::json extras_of(const bake::BakedTile& tile, std::uint32_t feature);

}  // namespace citykiln::exporters
