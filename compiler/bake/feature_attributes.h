// Attributes of features: what a baked object is in the map, for programs that look objects up.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// What the map says of one feature. Texts are valid UTF-8.
struct FeatureAttributes {
  std::string kind{};  ///< Its class: of a building ("Apartments"), road or land ("ResidentialRoad", "Park"), plant
                       ///< ("oak"), or prop ("Fence"). Empty for the none feature.
  std::string name{};  ///< Empty: none.
  float height_m = 0;  ///< Of buildings, barriers, lamps and single plants, from foot to top; 0: none or unknown.
  std::string tags{};  ///< The map's tags as a JSON object; empty unless the scene keeps them.
  bool operator==(const FeatureAttributes&) const = default;
};

/// Returns the attributes of features, one each. An element that is in several recipes has the class of the first of:
/// building, bridge or tunnel, road, watercourse, barrier, plant, lamp, land; and the greatest height. Total.
/// O(n log n) in the recipes.
/// @param features  Sorted.
std::vector<FeatureAttributes> attributes_of(const scene::Chunk& chunk, std::span<const OsmId> features);

}  // namespace citykiln::bake
