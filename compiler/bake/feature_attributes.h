// Attributes of features (map elements of baked objects): class, name, height and tags, for programs that look objects
// up.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/contract/assumption.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The attributes of one feature. Texts are valid UTF-8.
struct FeatureAttributes {
  std::string kind{};  ///< The class of a building ("Apartments"), road or land ("ResidentialRoad", "Park"), plant
                       ///< ("oak"), or prop ("Fence"). Empty for the none feature.
  std::string name{};  ///< Empty: none.
  float height_m = 0;  ///< From foot to top of buildings, barriers, lamps and single plants; 0: none or unknown.
  std::string tags{};  ///< The map's tags as a JSON object; empty unless the scene keeps them.
  Assumptions assumed = kNoAssumptions;  ///< The assumptions of all its recipes.
  bool operator==(const FeatureAttributes&) const = default;
};

/// Returns the attributes of each feature. An element with several recipes has the greatest height, all their
/// assumptions, and the class of the first one in this order: building, bridge or tunnel, road, watercourse, barrier,
/// plant, lamp, land. O(n log n) in the recipes.
/// @param features  Sorted.
std::vector<FeatureAttributes> attributes_of(const scene::Chunk& chunk, std::span<const OsmId> features);

}  // namespace citykiln::bake
