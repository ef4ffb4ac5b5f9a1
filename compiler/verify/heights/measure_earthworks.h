// Measures cuts and fills: how far the profiles of roads, railways and watercourses lie below or above the terrain.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The place where one way lies deepest below the terrain, or highest above it.
struct Earthwork {
  OsmId id;
  std::string_view line;  ///< The kind of line: a name in earthwork_limits.inc.
  double depth_m = 0;     ///< In metres; > 0 for a cut, < 0 for a fill.
  Vec2 at;
  bool operator==(const Earthwork&) const = default;
};

/// Returns the deepest cut and the highest fill of every way with a profile inside the chunk's tile, if deeper than
/// half a metre. Bridges and tunnels are left out. O(length).
std::vector<Earthwork> measure_earthworks(const scene::Header& header, const scene::Chunk& chunk);

/// Merges the lists of several tiles: keeps for each way the deepest cut and the highest fill. The largest come first.
std::vector<Earthwork> combined(std::vector<Earthwork> all);

/// Returns all cuts and fills of a scene, joined. O(length).
std::vector<Earthwork> measure_earthworks(const scene::Scene& scene);

/// Returns the earthworks that are deeper than the limit of their kind, in the given order.
std::vector<Earthwork> over_their_limits(std::span<const Earthwork> earthworks);

/// Returns the largest usual depth of a kind of line, in metres; 0 for a name that is not in earthwork_limits.inc.
double earthwork_limit_m(std::string_view line);

}  // namespace citykiln::verify
