// Attributes of features (map elements of baked objects): class, name, height and tags, for programs that look objects
// up.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/findings/assumption.h"
#include "compiler/map/tag_list.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The attributes of one feature. Texts are valid UTF-8.
struct FeatureAttributes {
  std::string kind{};  ///< The class of a building ("Apartments"), road or land ("ResidentialRoad", "Park"), plant
                       ///< ("oak"), prop ("Fence"), thing ("Bench") or wires ("PowerLine"). Empty for the none feature,
                       ///< and for an element of which the chunk has only derived recipes, such as a yard's fence.
  std::string name{};  ///< Empty: none.
  float height_m = 0;  ///< From foot to top of buildings, barriers, lamps, things and single plants; of wires an upper
                       ///< bound of their height above the ground. 0: none or unknown.
  map::TagList tags{};                   ///< The map's tags, sorted by key; empty unless the scene keeps them.
  Assumptions assumed = kNoAssumptions;  ///< The assumptions of all its recipes.
  bool operator==(const FeatureAttributes&) const = default;
};

/// The classes of things by kind: "bench" is a "Bench".
using ThingClasses = std::map<std::string, std::string, std::less<>>;

/// Returns the attributes of each feature. An element with several recipes has the greatest height, all their
/// assumptions, and the class of the first one in this order: building, bridge, tunnel, road, watercourse, landform,
/// barrier, plant, lamp, thing, wires, land. O(n log n) in the recipes.
/// @param features  Sorted.
/// @param classes   The classes of things by kind; a kind without one is its own class.
std::vector<FeatureAttributes> attributes_of(const scene::Chunk& chunk, std::span<const OsmId> features,
                                             const ThingClasses& classes = {},
                                             const plants::SpeciesTable& species = plants::shipped_table());

}  // namespace citykiln::bake
