// findings.json: all diagnoses of a run, each with its place, as GeoJSON. A finding is a diagnosis with its place.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/map/places.h"
#include "compiler/map/tags/layer_tags.h"
#include "compiler/scene/scene.h"

namespace citykiln::outputs {

/// A diagnosis with its place.
struct Finding {
  Diagnosis diagnosis;
  std::optional<LonLat> at;  ///< Empty: it is about the whole map (heightmaps), or the extract lacks the element.
  std::optional<scene::TileKey> tile;  ///< The tile at the place; empty outside the compiled extent.
  std::optional<std::size_t> level{};  ///< The level, if it was diagnosed while a tile was baked.
  std::string tags{};  ///< The tag concerned; for two ways, the tags that decide which one is above; else empty.
};

/// Returns the size of a diagnosis as it is written: with three decimals, millimetres or thousandths of a share.
double rounded_size(const Diagnosis& diagnosis);

/// Returns the diagnoses of compiling as findings.
/// @param places      Places of the elements that diagnoses name.
/// @param layer_tags  Tags of ways that pass over each other.
std::vector<Finding> findings_of(const Report& report, const map::Places& places, const map::LayerTags& layer_tags,
                                 const scene::Header& header);

/// Returns the diagnoses made while one tile was baked at one level as findings. The place of a finding is the place of
/// the diagnosis, else of its object in the chunk, else the tile's centre.
/// @param level  Index of the level.
std::vector<Finding> findings_of(const Report& report, const scene::Header& header, const scene::Chunk& chunk,
                                 std::size_t level);

/// Returns a FeatureCollection (RFC 7946) with one feature per line: what is missing first, sorted by its size, then
/// what was changed, then notes. The geometry is a point, or null without
/// a place. The properties are code, severity, id (null if it is about no element), size with at most three decimals,
/// and where present other, tags, tile and level. Places have seven decimals of a degree. Deterministic.
std::string findings_json(std::vector<Finding> findings, const scene::Header& header);

/// Reads the output of findings_json(). Places are in Finding::at; Diagnosis::at_m stays empty. Findings with a code
/// that this program does not know are left out. Errors: text of another form.
Result<std::vector<Finding>> parse_findings(std::string_view json);

}  // namespace citykiln::outputs
