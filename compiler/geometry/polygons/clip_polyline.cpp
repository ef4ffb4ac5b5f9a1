#include "compiler/geometry/polygons/clip_polyline.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "compiler/geometry/snap.h"

namespace citykiln {
namespace {

// The shares of a segment between which it lies in a box.
struct Shares {
  double from = 0, to = 1;
};

std::optional<Shares> shares_in(Vec2 a, Vec2 b, const Box2& box) {
  Shares shares;
  // the part of the segment where start + share * step >= 0
  const auto keep = [&](double start, double step) {
    if (step == 0) return start >= 0;
    const double at = -start / step;
    step > 0 ? shares.from = std::max(shares.from, at) : shares.to = std::min(shares.to, at);
    return shares.from <= shares.to;
  };
  const Vec2 along = b - a;
  const bool is_in = keep(a.x - box.min.x, along.x) && keep(box.max.x - a.x, -along.x) &&
                     keep(a.y - box.min.y, along.y) && keep(box.max.y - a.y, -along.y);
  return is_in ? std::optional(shares) : std::nullopt;
}

Vec2 on_grid(Vec2 a, Vec2 b, double share, const Box2& box, double step_m) {
  if (share == 0 || share == 1) return share == 0 ? a : b;
  const Vec2 p = snapped_to(step_m, a + (b - a) * share);
  return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
}

// The end of the last part runs on in the first one.
void join_ends(std::vector<Polyline>& parts) {
  Polyline last = std::move(parts.back());
  parts.pop_back();
  last.insert(last.end(), parts.front().begin() + 1, parts.front().end());
  parts.front() = std::move(last);
}

}  // namespace

std::vector<Polyline> clipped_to(const Polyline& polyline, const Box2& box, double step_m) {
  assert(step_m > 0 && !box.is_empty());
  std::vector<Polyline> parts;
  bool continues = false;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const Vec2 a = polyline[i], b = polyline[i + 1];
    const std::optional<Shares> shares = shares_in(a, b, box);
    if (!shares) {
      continues = false;
      continue;
    }
    if (!continues) parts.push_back({on_grid(a, b, shares->from, box, step_m)});
    const Vec2 to = on_grid(a, b, shares->to, box, step_m);
    if (to != parts.back().back()) parts.back().push_back(to);
    continues = shares->to == 1;
  }
  const bool is_closed = polyline.size() > 3 && polyline.front() == polyline.back();
  std::erase_if(parts, [](const Polyline& part) { return part.size() < 2; });
  if (is_closed && parts.size() > 1 && parts.front().front() == polyline.front() &&
      parts.back().back() == polyline.back())
    join_ends(parts);
  return parts;
}

}  // namespace citykiln
