// Finds areas and tracks that are mapped on the ground but not seen: areas below larger ones, tracks below streets.
#pragma once

#include <cstdint>

#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The tests of areas, or of places along tracks, in a tile.
struct HiddenThings {
  std::uint64_t tests = 0;    ///< Number of areas, or of places along tracks.
  std::uint64_t hidden = 0;   ///< Number of those that are not seen.
  Vec2 at;                    ///< The first hidden one, plane metres: the middle of the area's box, or the place.
  OsmId element{}, on_top{};  ///< Its element, and the element that lies on top of it.
};

/// Tests each mapped area whose box lies in the tile. An area is hidden if one other area, at least 1.05 times as
/// large, is on top at all places of a grid of 12 by 12 over its box that lie in the area; if fewer than four do, it is
/// not hidden. Yards, buildings, roads, paths, railways and areas without a class are neither tested nor count as on
/// top. O(areas).
/// @param land_cover  Land cover of the tile.
/// @param box         The tile, plane metres; `land_cover` must cover it.
HiddenThings measure_hidden_areas(const ground::LandCoverIndex& land_cover, const Box2& box);

/// The longest stretch of a track under a carriageway that is still a level crossing: a wide street at a small angle.
inline constexpr double kLongestBoards_m = 40;

/// Tests the axes of railways and tramways on the ground at places at most 4 m apart. A place is hidden if a
/// carriageway of another element is on top there, and has been without a gap for more than kLongestBoards_m of the
/// axis before it. O(length of tracks).
/// @param land_cover, box  As above. Places outside of the box are not tested.
HiddenThings measure_hidden_tracks(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box);

}  // namespace citykiln::verify
