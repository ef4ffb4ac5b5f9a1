// Cuts and fills: how far the profiles of roads, railways and watercourses lie below or above the terrain.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// Where one way deviates most from the terrain.
struct Earthwork {
  OsmId id;
  std::string_view line;  ///< What kind of line it is: a name of earthwork_limits.inc.
  double depth_m = 0;     ///< Of a cut > 0, of a fill < 0.
  Vec2 at;
  bool operator==(const Earthwork&) const = default;
};

/// The deepest cut and the highest fill of every way on the ground that has a profile, inside the chunk's tile, of
/// those over half a metre. Bridges and tunnels have none. O(length).
std::vector<Earthwork> measure_earthworks(const scene::Header& header, const scene::Chunk& chunk);

/// Joins the lists of tiles: one cut and one fill for each way, the largest first.
std::vector<Earthwork> combined(std::vector<Earthwork> all);

/// All cuts and fills of a scene, joined. O(length).
std::vector<Earthwork> measure_earthworks(const scene::Scene& scene);

/// Those over the limit of their kind, the largest first.
std::vector<Earthwork> over_their_limits(std::span<const Earthwork> earthworks);

/// The depth that a kind of line may have without being listed as over its limit, metres.
double earthwork_limit_m(std::string_view line);

}  // namespace citykiln::verify
