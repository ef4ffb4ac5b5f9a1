// The properties of a whole scene: origin, sky, the land around it, sources, rules.
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/lots/fill_lots.h"
#include "compiler/map/plane/plane.h"
#include "compiler/plants/species_folder.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/things/catalogue.h"

namespace citykiln {

/// The recipes that the header depends on: the land around the extent goes on from heights, land cover and coastlines,
/// and buildings must fit into a cylinder.
struct HeaderInputs {
  const map::Heightfield& heights;
  std::span<const ground::LandCoverPolygon> surfaces{};
  std::span<const buildings::Building> buildings{};
  std::span<const Polyline> coasts{};  ///< map::Features::coasts.
};

/// The properties of the whole scene, without rules, species and things.
/// Errors: heightmaps that cannot be read, tiles in spec.only that the map lacks, a map that does not fit into the
/// spec's cylinder.
Result<scene::Header> make_header(const CompileSpec& spec, const map::Plane& plane, const Box2& extent,
                                  const HeaderInputs& recipes);

/// Returns the rules of houses on lots without buildings. Errors: those of the files of the spec's folder.
Result<lots::HouseRules> house_rules_for(const CompileSpec& spec);

/// Returns the rule files for the styles of the buildings. A file in the spec's folder replaces the shipped file of its
/// name. Errors: a folder that cannot be read; those of buildings::rules_for().
Result<std::vector<buildings::RuleText>> rules_for(const CompileSpec& spec,
                                                   const std::vector<buildings::Building>& buildings);

/// Returns the species of the spec's folder; the shipped ones alone without one. Errors: those of
/// plants::read_species_folder(); the folder cannot be read, or has no file of a species.
Result<plants::UserSpecies> read_species(const std::string& folder);

/// Returns the shipped things, with those of the spec's folder; cars only if the spec asks for them. Errors: those of
/// things::read_catalogue(); the folder cannot be read.
Result<things::Catalogue> read_things(const CompileSpec& spec);

}  // namespace citykiln
