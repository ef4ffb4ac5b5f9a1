#include "compiler/invent/town/streets/road_curve.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/line_part.h"
#include "compiler/geometry/segment.h"

namespace citykiln::invent {
namespace {

void keep_farthest(const Polyline& path, std::size_t first, std::size_t last, double within_m,
                   std::vector<char>& keep) {
  double most_m = within_m;
  std::size_t farthest = first;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double d = distance_to_segment(path[first], path[last], path[i]); d > most_m) {
      most_m = d;
      farthest = i;
    }
  if (farthest == first) return;
  keep[farthest] = 1;
  keep_farthest(path, first, farthest, within_m, keep);
  keep_farthest(path, farthest, last, within_m, keep);
}

}  // namespace

Polyline simplified_path(const Polyline& path, double within_m) {
  if (path.size() < 3) return path;
  std::vector<char> keep(path.size());
  keep.front() = keep.back() = 1;
  keep_farthest(path, 0, path.size() - 1, within_m, keep);
  Polyline simple;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (keep[i]) simple.push_back(path[i]);
  return simple;
}

Polyline without_corners(const Polyline& path, int times) {
  Polyline curve = path;
  for (int t = 0; t < times && curve.size() > 2; ++t) {
    Polyline next = {curve.front()};
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      if (i > 0) next.push_back(curve[i] * 0.75 + curve[i + 1] * 0.25);
      if (i + 2 < curve.size()) next.push_back(curve[i] * 0.25 + curve[i + 1] * 0.75);
    }
    next.push_back(curve.back());
    curve = std::move(next);
  }
  return curve;
}

Polyline with_even_steps(const Polyline& path, double step_m) {
  Polyline clean;
  for (const Vec2 p : path)
    if (clean.empty() || clean.back() != p) clean.push_back(p);
  if (clean.size() < 2) return clean;
  const std::vector<double> along = distances_on(clean);
  const int steps = std::max(1, static_cast<int>(std::round(along.back() / step_m)));
  Polyline even = {clean.front()};
  for (int i = 1; i < steps; ++i) even.push_back(point_at(clean, along, along.back() * i / steps));
  even.push_back(clean.back());
  return even;
}

}  // namespace citykiln::invent
