// compile() compiles a map to a scene of recipes. pipeline.cpp calls the stages in order: read it first.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/map/places.h"
#include "compiler/map/tags/layer_tags.h"
#include "compiler/scene/scene.h"
#include "compiler/source/owns_place.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "compiler/survey.h"

namespace citykiln {

/// A compiled map, and what was found and measured on the way.
struct CompileResult {
  scene::Scene scene;
  Report report;
  ground::ProfileMeasures profiles;  ///< How well the heights of roads, rails, bridges and tunnels agree.
  std::vector<StageCost> costs;
  map::Places places;         ///< The places of the elements that diagnoses name.
  map::LayerTags layer_tags;  ///< The height tags of ways that diagnoses of two objects name.
};

/// Compiles a map and heightmaps to a scene of recipes, with the ledger and diagnoses of all stages.
///
/// Guarantees: equal inputs and specs give equal scenes, for any number of threads and any order of elements in the
/// file. A tile compiled alone (spec.only) equals that tile of the whole. Errors: an input that cannot be read; a map
/// with nothing to compile; heightmaps that do not cover any of the map; tiles outside the map. Cost: linear, except
/// for sorting the extract; memory for the whole extract.
Result<CompileResult> compile(const CompileSpec& spec, const OnProgress& on_progress);

/// Compiles the tiles of spec.only from a part of a map.
/// @param extract  A file with all elements within regions::kRegionHalo_m of these tiles.
/// @param survey   The survey of the whole extent. Heights, waters and streams are only needed around these tiles.
/// @param owns     True for the places whose elements are counted and diagnosed (source/read_osm.cpp).
///
/// Guarantees: the chunks equal those of compile(), and so does the header, except that `rules`, `species` and `things`
/// list those of these tiles only. Errors: those of compile(). Memory: for this part.
Result<CompileResult> compile_region(const CompileSpec& spec, const std::string& extract, const Survey& survey,
                                     const source::OwnsPlace& owns, const OnProgress& on_progress);

}  // namespace citykiln
