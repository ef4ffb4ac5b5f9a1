// Places the street lamps of a tile from recipes, without generating meshes.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/props/street_lamps.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Street lamps of a tile.
struct Lamps {
  std::vector<props::StreetLamp> standing;  ///< Mapped lamps first, then lamps along lit streets.
  std::size_t mapped = 0;                   ///< Number of mapped lamps.
};

/// Returns the lamps in a box: mapped lamps, then lamps along lit streets.
/// @param land_cover  Land cover of the box.
Lamps place_lamps(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, const Box2& box);

/// A lamp on the ground.
struct PlacedLamp {
  Placement placement;  ///< +x is the direction of its arm; the scale is its height in metres.
  props::LampKind kind{};
  props::Luminaire light{};
  Vec3 up{0, 0, 1};  ///< The vertical of its place.
};

/// Returns the lamps of a tile on the ground of fine levels. Cost: grading the terrain of the tile.
std::vector<PlacedLamp> lamps_of(const scene::Header& header, const scene::Chunk& chunk);

/// The lamps with the largest luminous flux, at most `most`, in the given order; on a tie the first ones.
std::vector<PlacedLamp> brightest(std::vector<PlacedLamp> lamps, std::size_t most);

}  // namespace citykiln::bake
