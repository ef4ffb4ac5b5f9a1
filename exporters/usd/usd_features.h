// Writes the features of a tile as a table: one array attribute per column, on one prim.
#pragma once

#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {

/// Writes the scope "features". Element i of each array belongs to feature i, to which primvars:feature refers; element
/// 0 means "no feature".
///
/// | attribute     | type     | value                                              |
/// |---------------|----------|----------------------------------------------------|
/// | osm:id        | int64[]  | id of the OpenStreetMap element                    |
/// | osm:type      | token[]  | "none", "node", "way" or "relation"                |
/// | osm:class     | string[] | its class, "Apartments"                            |
/// | osm:name      | string[] | name=*, or ""                                      |
/// | osm:height_m  | float[]  | from foot to top, or 0                             |
/// | osm:tags      | string[] | all tags as a JSON object, where the scene keeps them |
///
/// Leaves out columns without values.
void write_features(UsdBuilder& b);

}  // namespace citykiln::exporters
