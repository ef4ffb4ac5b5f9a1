#include "compiler/assume/cut_way.h"

#include <algorithm>
#include <cassert>

namespace citykiln::assume {
namespace {

// The vertex at which the piece that begins at `first` ends.
std::size_t end_of_piece(const map::Track& way, std::size_t first, double piece_m, const CommonNodes& common) {
  std::size_t last_near = 0, last_common = 0;
  double along_m = 0;
  for (std::size_t v = first + 1; v < way.axis.size(); ++v) {
    along_m += distance(way.axis[v - 1], way.axis[v]);
    if (along_m > piece_m) return last_common > 0 ? last_common : last_near > 0 ? last_near : v;
    last_near = v;
    if (std::ranges::binary_search(common, way.node_ids[v])) last_common = v;
  }
  return way.axis.size() - 1;
}

// Marks of the vertices first … last. The end of a closed way has those of its beginning.
std::vector<map::TrackPoint> points_between(const map::Track& way, std::size_t first, std::size_t last) {
  std::vector<map::TrackPoint> points;
  const bool is_closed = way.axis.front() == way.axis.back();
  for (map::TrackPoint point : way.points) {
    if (is_closed && point.vertex == 0 && last + 1 == way.axis.size())
      points.push_back(
          {.vertex = static_cast<std::uint32_t>(last - first), .kind = point.kind, .facing = point.facing});
    if (point.vertex < first || point.vertex > last) continue;
    point.vertex -= static_cast<std::uint32_t>(first);
    points.push_back(point);
  }
  std::ranges::sort(points);
  return points;
}

template <typename T>
std::vector<T> slice(const std::vector<T>& values, std::size_t first, std::size_t last) {
  return {values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

}  // namespace

CommonNodes common_nodes_of(const std::vector<map::Track>& tracks) {
  std::vector<std::int64_t> all, common;
  for (const map::Track& track : tracks) all.insert(all.end(), track.node_ids.begin(), track.node_ids.end());
  std::ranges::sort(all);
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i] == all[i - 1] && (common.empty() || common.back() != all[i])) common.push_back(all[i]);
  return common;
}

std::vector<map::Track> cut_way(const map::Track& way, double longest_m, double piece_m, const CommonNodes& common) {
  if (length_m(way.axis) <= longest_m) return {way};
  assert(way.section.axis_drift == 0 && way.id.part == 0);
  std::vector<map::Track> pieces;
  for (std::size_t first = 0; first + 1 < way.axis.size();) {
    const std::size_t last = end_of_piece(way, first, piece_m, common);
    map::Track piece = way;
    piece.id.part = static_cast<std::uint32_t>(pieces.size());
    piece.axis = slice(way.axis, first, last);
    piece.node_ids = slice(way.node_ids, first, last);
    piece.points = points_between(way, first, last);
    piece.is_piece = true;
    pieces.push_back(std::move(piece));
    first = last;
  }
  return pieces;
}

}  // namespace citykiln::assume
