// findings.json: every diagnosis of a run with its place, as GeoJSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/map/layer_tags.h"
#include "compiler/map/places.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// A diagnosis and where it applies.
struct Finding {
  Diagnosis diagnosis;
  std::optional<map::LonLat> at;       ///< None: of the whole map (heightmaps), or the extract lacks the element.
  std::optional<scene::TileKey> tile;  ///< Of the place; none outside the compiled region.
  std::optional<std::size_t> level{};  ///< Of a finding while a tile was baked.
  std::string tags{};  ///< The tag that it is about; of two ways, those that decide which is above; else empty.
};

/// The findings of compiling, before tiles are baked.
std::vector<Finding> findings_of(const Report& report, const map::Places& places, const map::LayerTags& layer_tags,
                                 const scene::Header& header);

/// The findings of baking one tile at one level. The place is the diagnosis' own, else that of
/// its object in the chunk, else the tile's centre.
std::vector<Finding> findings_of(const Report& report, const scene::Header& header, const scene::Chunk& chunk,
                                 std::size_t level);

/// A FeatureCollection (RFC 7946), one feature a line, sorted: a point, or null without a place, with the properties
/// code, severity, id (null: of no element), other, size, tags, tile and level (where it has these). Deterministic.
std::string findings_json(std::vector<Finding> findings, const scene::Header& header);

/// Reads what findings_json() wrote; the diagnoses' own places (at_m) are in `at`. Errors: text of another form.
Result<std::vector<Finding>> parse_findings(std::string_view json);

}  // namespace citykiln::verify
