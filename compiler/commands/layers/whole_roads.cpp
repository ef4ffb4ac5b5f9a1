#include "compiler/commands/layers/whole_roads.h"

#include <algorithm>
#include <tuple>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::commands {
namespace {

using roads::Road;
using roads::WidthLimit;

// Adds the limits of the next piece. The is_wall of the first limit of a piece is unknown, so that of either piece
// counts.
void add_limits(std::vector<WidthLimit>& all, const std::vector<WidthLimit>& more) {
  for (const WidthLimit& limit : more) {
    const auto place = std::ranges::lower_bound(all, limit.at_m, {}, &WidthLimit::at_m);
    if (place != all.end() && place->at_m == limit.at_m)
      place->is_wall = place->is_wall || limit.is_wall;
    else
      all.insert(place, limit);
  }
}

void add_points(Road& road, const Road& piece, std::size_t first_vertex) {
  for (map::TrackPoint point : piece.points) {
    point.vertex += static_cast<std::uint32_t>(first_vertex);
    road.points.push_back(point);
  }
  sort_unique(road.points);
}

void add_profile(Profile& all, const Profile& more) {
  all.insert(all.end(), more.begin(), more.end());
  std::ranges::stable_sort(all, {}, &Knot::at_m);
  erase_repeated(all, &Knot::at_m);
}

// Appends a piece of the same road that begins before the road ends; pieces consist of whole segments, and vertices
// have the same distances along the way in all of them.
void append(Road& road, const Road& piece) {
  const std::vector<double> known = distances_along(road), along = distances_along(piece);
  const auto shared = std::ranges::lower_bound(known, along.front()) - known.begin();
  const auto first_new = std::ranges::upper_bound(along, known.back()) - along.begin();
  road.axis.insert(road.axis.end(), piece.axis.begin() + first_new, piece.axis.end());
  add_points(road, piece, static_cast<std::size_t>(shared));
  add_limits(road.width_limits.left, piece.width_limits.left);
  add_limits(road.width_limits.right, piece.width_limits.right);
  add_profile(road.profile, piece.profile);
}

}  // namespace

std::vector<Road> whole_roads(const scene::Scene& scene) {
  std::vector<const Road*> pieces;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const Road& road : chunk.roads) pieces.push_back(&road);
  const auto order = [](const Road* road) { return std::tuple(road->id, road->start_along_m, road->axis.size()); };
  std::ranges::stable_sort(pieces, {}, order);
  std::vector<Road> whole;
  for (const Road* piece : pieces) {
    const bool continues =
        !whole.empty() && whole.back().id == piece->id && piece->start_along_m <= distances_along(whole.back()).back();
    continues ? append(whole.back(), *piece) : whole.push_back(*piece);
  }
  return whole;
}

}  // namespace citykiln::commands
