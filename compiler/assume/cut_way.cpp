#include "compiler/assume/cut_way.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::assume {
namespace {

// The vertices at which pieces end, the last one of the way included.
std::vector<std::size_t> ends_of_pieces(const map::Track& way, double piece_m, const CommonNodes& common) {
  std::vector<std::size_t> ends;
  double along_m = 0, window_end_m = piece_m;
  std::size_t last = 0, last_common = 0;  // of the window; 0: none
  for (std::size_t v = 1; v + 1 < way.axis.size(); ++v) {
    along_m += distance(way.axis[v - 1], way.axis[v]);
    if (along_m > window_end_m) {
      if (last > 0) ends.push_back(last_common > 0 ? last_common : last);
      last = last_common = 0;
      window_end_m = piece_m * std::ceil(along_m / piece_m);
    }
    last = v;
    if (std::ranges::binary_search(common, way.node_ids[v])) last_common = v;
  }
  const double length_m = along_m + distance(way.axis[way.axis.size() - 2], way.axis.back());
  if (length_m > window_end_m && last > 0) ends.push_back(last_common > 0 ? last_common : last);
  ends.push_back(way.axis.size() - 1);
  return ends;
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

CommonNodes common_nodes_of(std::span<const map::Track> tracks) {
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
  std::size_t first = 0;
  for (const std::size_t last : ends_of_pieces(way, piece_m, common)) {
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
