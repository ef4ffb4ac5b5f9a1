#include "compiler/map/readers/coastline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <optional>

#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::map {
namespace {

// Coastlines joined end to start, as far as possible.
struct Chain {
  OsmId first_way, last_way;
  Polyline axis;
  bool is_closed = false;
};

std::vector<Chain> join(std::vector<CoastWay> ways) {
  std::sort(ways.begin(), ways.end(), [](const CoastWay& a, const CoastWay& b) { return a.id < b.id; });
  std::multimap<std::int64_t, std::size_t> by_start;
  for (std::size_t i = 0; i < ways.size(); ++i) by_start.emplace(ways[i].first_node, i);
  std::map<std::int64_t, int> ends;
  for (const CoastWay& way : ways) ++ends[way.last_node];
  std::vector<bool> used(ways.size(), false);
  std::vector<Chain> chains;
  const auto follow = [&](std::size_t start) {
    Chain chain{ways[start].id, ways[start].id, ways[start].axis, false};
    used[start] = true;
    for (std::size_t at = start;;) {
      if (ways[at].last_node == ways[start].first_node) {
        chain.is_closed = true;
        chain.axis.pop_back();
        break;
      }
      const auto [from, to] = by_start.equal_range(ways[at].last_node);
      const auto next = std::find_if(from, to, [&](const auto& entry) { return !used[entry.second]; });
      if (next == to) break;
      at = next->second;
      used[at] = true;
      chain.last_way = ways[at].id;
      chain.axis.insert(chain.axis.end(), ways[at].axis.begin() + 1, ways[at].axis.end());
    }
    chains.push_back(std::move(chain));
  };
  // open chains start where no way ends; what remains are rings
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (!used[i] && ends.count(ways[i].first_node) == 0) follow(i);
  for (std::size_t i = 0; i < ways.size(); ++i)
    if (!used[i]) follow(i);
  return chains;
}

// The position of a point along the box's sides, clockwise from the south-west corner, 0 to 4.
double place_on_sides(const Box2& box, Vec2 p) {
  if (p.x == box.min.x) return (p.y - box.min.y) / box.height();
  if (p.y == box.max.y) return 1 + (p.x - box.min.x) / box.width();
  if (p.x == box.max.x) return 2 + (box.max.y - p.y) / box.height();
  return 3 + (box.max.x - p.x) / box.width();
}

Vec2 corner(const Box2& box, int k) {
  const std::array<Vec2, 4> corners = {{box.min, {box.min.x, box.max.y}, box.max, {box.max.x, box.min.y}}};
  return corners[static_cast<std::size_t>(k % 4)];
}

Vec2 nearest_on_sides(const Box2& box, Vec2 p) {
  const double west = p.x - box.min.x, east = box.max.x - p.x, south = p.y - box.min.y, north = box.max.y - p.y;
  const double least = std::min({west, east, south, north});
  if (least == west) return {box.min.x, p.y};
  if (least == east) return {box.max.x, p.y};
  return least == south ? Vec2{p.x, box.min.y} : Vec2{p.x, box.max.y};
}

// The part of a segment inside the box (Liang, Barsky 1984), with new ends snapped onto the sides.
std::optional<std::array<Vec2, 2>> clipped(Vec2 a, Vec2 b, const Box2& box) {
  double from = 0, to = 1;
  const Vec2 d = b - a;
  const auto cut = [&](double step, double room) {
    if (step == 0) return room >= 0;
    const double t = room / step;
    if (step < 0)
      from = std::max(from, t);
    else
      to = std::min(to, t);
    return from <= to;
  };
  if (!cut(-d.x, a.x - box.min.x) || !cut(d.x, box.max.x - a.x) || !cut(-d.y, a.y - box.min.y) ||
      !cut(d.y, box.max.y - a.y))
    return std::nullopt;
  const auto on_side = [&](double t) {
    const Vec2 p = a + d * t, side = nearest_on_sides(box, p);
    return snapped_to(kMapStep_m,
                      Vec2{std::clamp(side.x, box.min.x, box.max.x), std::clamp(side.y, box.min.y, box.max.y)});
  };
  return std::array{from > 0 ? on_side(from) : a, to < 1 ? on_side(to) : b};
}

// A part of the coast inside the box that begins and ends on its sides.
struct Piece {
  Polyline axis;
  double entry = 0, exit = 0;
};

// Cuts an open line into its parts inside the box.
std::vector<Polyline> runs_inside(const Polyline& axis, const Box2& box) {
  std::vector<Polyline> runs;
  bool continues = false;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const auto part = clipped(axis[i], axis[i + 1], box);
    if (!part || (*part)[0] == (*part)[1]) {
      continues = continues && part && (*part)[1] == axis[i + 1];
      continue;
    }
    if (!continues || runs.back().back() != (*part)[0]) runs.push_back({(*part)[0]});
    runs.back().push_back((*part)[1]);
    continues = (*part)[1] == axis[i + 1];
  }
  return runs;
}

// A ring opened at a point outside the box, so that its parts begin and end on the sides.
Polyline opened(const Ring& ring, const Box2& box) {
  const auto outside = std::find_if(ring.begin(), ring.end(), [&](Vec2 p) { return !box.contains(p); });
  Polyline line(outside, ring.end());
  line.insert(line.end(), ring.begin(), outside);
  line.push_back(line.front());
  return line;
}

bool is_on_sides(const Box2& box, Vec2 p) {
  return p.x == box.min.x || p.x == box.max.x || p.y == box.min.y || p.y == box.max.y;
}

// Extends a loose end to the box's side in the direction of its last 400 m.
Vec2 led_on(const Polyline& from_end, const Box2& box) {
  constexpr double kLately_m = 400;
  const Vec2 end = from_end.front();
  Vec2 back = from_end.back();
  for (const Vec2 p : from_end)
    if (distance(p, end) >= kLately_m) {
      back = p;
      break;
    }
  const Vec2 d = unit(end - back);
  if (d == Vec2{}) return nearest_on_sides(box, end);
  const double to_x = d.x > 0 ? (box.max.x - end.x) / d.x : d.x < 0 ? (box.min.x - end.x) / d.x : 1e300;
  const double to_y = d.y > 0 ? (box.max.y - end.y) / d.y : d.y < 0 ? (box.min.y - end.y) / d.y : 1e300;
  const Vec2 p = snapped_to(kMapStep_m, end + d * std::min(to_x, to_y));
  if (to_x <= to_y) return {d.x > 0 ? box.max.x : box.min.x, std::clamp(p.y, box.min.y, box.max.y)};
  return {std::clamp(p.x, box.min.x, box.max.x), d.y > 0 ? box.max.y : box.min.y};
}

void lead_out(Polyline& run, const Chain& chain, const Box2& box, Sea& sea) {
  if (!is_on_sides(box, run.front())) {
    run.insert(run.begin(), led_on(run, box));
    sea.open_ends.push_back(chain.first_way);
  }
  if (!is_on_sides(box, run.back())) {
    run.push_back(led_on({run.rbegin(), run.rend()}, box));
    sea.open_ends.push_back(chain.last_way);
  }
}

// Connects the parts into rings: from each exit clockwise along the sides to the next entry. Water lies on the right,
// so the rings are clockwise.
std::vector<Ring> close_along_sides(const std::vector<Piece>& pieces, const Box2& box) {
  std::vector<bool> used(pieces.size(), false);
  const auto next_entry = [&](double exit) {
    std::size_t best = pieces.size();
    double least = 5;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double way = pieces[i].entry >= exit ? pieces[i].entry - exit : pieces[i].entry - exit + 4;
      if (way < least) least = way, best = i;
    }
    return best;
  };
  std::vector<Ring> rings;
  for (std::size_t start = 0; start < pieces.size(); ++start) {
    if (used[start]) continue;
    Ring ring;
    for (std::size_t at = start; !used[at];) {
      used[at] = true;
      ring.insert(ring.end(), pieces[at].axis.begin(), pieces[at].axis.end());
      const std::size_t next = next_entry(pieces[at].exit);
      const double end = pieces[next].entry >= pieces[at].exit ? pieces[next].entry : pieces[next].entry + 4;
      for (int k = static_cast<int>(pieces[at].exit) + 1; k < end; ++k) ring.push_back(corner(box, k));
      at = next;
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

void add_islands(Sea& sea, std::vector<Ring>&& islands, const Box2& box) {
  if (sea.polygons.empty() && !islands.empty())
    sea.polygons.push_back({{box.min, corner(box, 3), box.max, corner(box, 1)}, {}});
  for (Ring& island : islands) {
    // holes are clockwise
    std::reverse(island.begin(), island.end());
    for (Polygon& polygon : sea.polygons)
      if (winding_number(polygon.outer, island.front()) != 0) {
        polygon.holes.push_back(std::move(island));
        break;
      }
  }
}

}  // namespace

Sea close_sea(std::vector<CoastWay> ways, const Box2& box) {
  assert(box.width() > 0 && box.height() > 0);
  Sea sea;
  std::vector<Piece> pieces;
  std::vector<Ring> islands;
  for (const Chain& chain : join(std::move(ways))) {
    if (!box_of(chain.axis).touches(box)) continue;
    const bool is_inside = std::all_of(chain.axis.begin(), chain.axis.end(), [&](Vec2 p) { return box.contains(p); });
    if (chain.is_closed && is_inside) {
      Ring ring = without_repeats(chain.axis);
      if (signed_area_m2(ring) > 0)
        islands.push_back(std::move(ring));
      else if (ring.size() >= 3)
        sea.polygons.push_back({Ring(ring.rbegin(), ring.rend()), {}});
      continue;
    }
    for (Polyline& run : runs_inside(chain.is_closed ? opened(chain.axis, box) : chain.axis, box)) {
      lead_out(run, chain, box, sea);
      const double entry = place_on_sides(box, run.front()), exit = place_on_sides(box, run.back());
      pieces.push_back({std::move(run), entry, exit});
    }
  }
  for (Ring& ring : close_along_sides(pieces, box)) {
    ring = without_repeats(ring);
    std::reverse(ring.begin(), ring.end());
    if (ring.size() >= 3 && signed_area_m2(ring) > 0) sea.polygons.push_back({std::move(ring), {}});
  }
  add_islands(sea, std::move(islands), box);
  return sea;
}

}  // namespace citykiln::map
