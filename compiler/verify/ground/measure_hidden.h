// Finds what is mapped on the ground and not seen: areas below larger ones, tracks below streets.
#pragma once

#include <cstdint>

#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// Mapped things of one kind in a tile.
struct HiddenThings {
  std::uint64_t tests = 0;   ///< Number of areas, or of places along tracks.
  std::uint64_t hidden = 0;  ///< Number of those that are not seen.
  Vec2 at;                   ///< The first of these,
  OsmId first{}, below{};    ///< its element, and the element on top of it.
};

/// Tests each mapped area that lies in the tile with at least four places of a grid of 12 by 12 over its box: it is
/// hidden if one area, at least 1.05 times as large, is on top at all of them. Yards, buildings, streets and areas
/// without a class do not count. O(areas).
/// @param land_cover  Land cover of the tile.
/// @param box         The tile, in which land cover is known.
HiddenThings measure_hidden_areas(const ground::LandCoverIndex& land_cover, const Box2& box);

/// Tests the axes of railways and tramways on the ground every 4 m: a place is hidden if a carriageway has been on top
/// since more than kLongestBoards_m. O(length of tracks).
HiddenThings measure_hidden_tracks(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box);

/// The longest carriageway along a track that is a crossing: a wide street at a small angle.
inline constexpr double kLongestBoards_m = 40;

}  // namespace citykiln::verify
