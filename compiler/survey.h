// Facts about the whole extent that regions need: heights, waters, the header.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/places.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/roads/recipe.h"
#include "compiler/scene/scene.h"
#include "compiler/source/osm_data.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "compiler/whole_map.h"

namespace citykiln {

/// Facts about the whole extent that a region cannot derive from its own data (regions/radii.h).
struct Survey {
  source::LonLatBox extent;                      ///< In degrees.
  scene::Header header;                          ///< Without rules, species and things.
  map::Heightfield heights;                      ///< Heights of the extent, or around a region.
  std::vector<ground::LandCoverPolygon> waters;  ///< Areas of water, with their levels.
  std::vector<roads::Strip> streams;             ///< Watercourses, with their profiles.
  map::Places places{};                          ///< The places of the elements that diagnoses name.
};

/// Computes the facts about the whole extent, from the waters and coasts of a map and its heightmaps. Diagnoses only
/// heightmaps and the heights of waters.
/// @param extract  A file with the waters and coasts of spec.map_path. Other elements in it change nothing.
/// Errors: those of compile(). Memory: the heights of the extent, and its waters.
Result<Survey> survey(const CompileSpec& spec, const std::string& extract, const source::LonLatBox& extent,
                      Report& report, const OnProgress& on_progress);

/// Returns the areas and watercourses, with the heights of those that the survey contains.
ground::Waters surveyed_waters(const map::FeatureView& features, const Survey& survey, Report& report);

}  // namespace citykiln
