#include "compiler/lots/border_yards.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::lots {
namespace {

// Barriers along a street stand this far inside the pavement's outer edge.
constexpr double kInsidePavement_m = 0.375;
// An edge of a lot lies on a street's strip if it is this near to its border.
constexpr double kOnStrip_m = 0.2;
// Barriers are left out where one is mapped this near.
constexpr double kMappedBarrier_m = 1.5;
// Distance of the axis of a barrier to walls, pavements, paths and openings.
constexpr double kToWall_m = 0.5, kToPavement_m = 0.25, kToPath_m = 0.375;
// Borders are tested at this spacing; shorter pieces are left out.
constexpr double kBorderStep_m = 0.5, kShortestBorder_m = 1.5;
// Lots may have needles, where the shares of neighbours meet: two edges this near to each other, to and fro.
constexpr double kNeedle_m = 0.5, kToAndFro = -0.9;
// The largest ratio of a mitre to the inset.
constexpr double kLeastMitreCosine = 0.5;

enum class BorderPart : std::uint8_t { kNone, kStreet, kSides };

// A piece of a border with what stands on it.
struct BorderPiece {
  Vec2 a, b;
  BorderPart part;
  double inset_m;
  bool continues(const BorderPiece& before) const {
    return before.b == a && before.part == part && before.inset_m == inset_m;
  }
};

SharedEdges::Entry entry_of(Vec2 a, Vec2 b, std::uint32_t lot) {
  const GridPoint p = grid_point(a), q = grid_point(b);
  return {std::min(p, q), std::max(p, q), lot};
}

struct BorderDrawer {
  std::uint32_t number;
  std::span<const Lot> lots;
  std::span<const std::optional<YardRule>> rules;
  const SharedEdges& edges;
  const BorderObstacles& obstacles;
  const Lot& lot = lots[number];
  const YardRule& rule = *rules[number];

  // True if another lot has the border along this edge.
  bool is_of_neighbour(Vec2 a, Vec2 b) const {
    const SharedEdges::Entry own = entry_of(a, b, 0);
    for (auto e = std::ranges::lower_bound(edges.entries, own); e != edges.entries.end(); ++e) {
      if (e->low != own.low || e->high != own.high) return false;
      if (e->lot != number && rules[e->lot] && lots[e->lot].parcel.id < lot.parcel.id) return true;
    }
    return false;
  }

  bool has_neighbour(Vec2 a, Vec2 b) const {
    const SharedEdges::Entry own = entry_of(a, b, 0);
    for (auto e = std::ranges::lower_bound(edges.entries, own); e != edges.entries.end(); ++e) {
      if (e->low != own.low || e->high != own.high) return false;
      if (e->lot != number) return true;
    }
    return false;
  }

  bool is_on_street(Vec2 a, Vec2 b) const {
    return std::abs(clearance_m(obstacles.street_fronts, (a + b) * 0.5, 1)) <= kOnStrip_m && !has_neighbour(a, b);
  }

  bool is_of_needle(Vec2 a, Vec2 b) const {
    const Ring& ring = lot.parcel.polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 c = ring[i], d = ring[(i + 1) % ring.size()];
      const bool is_back = dot(unit(b - a), unit(d - c)) < kToAndFro;
      if (is_back && distance_to_segment(c, d, (a + b) * 0.5) < kNeedle_m) return true;
    }
    return false;
  }

  // Adds an edge, cut where the front yard ends. Lots at a corner have the same barrier along both streets.
  void add_edge(Vec2 a, Vec2 b, std::vector<BorderPiece>& pieces) const {
    if (is_on_street(a, b)) return pieces.push_back({a, b, BorderPart::kStreet, kUnderPavement_m + kInsidePavement_m});
    if (is_of_neighbour(a, b) || is_of_needle(a, b)) return pieces.push_back({a, b, BorderPart::kNone, 0});
    const double ya = lot.frame.local(a).y - lot.setback_m, yb = lot.frame.local(b).y - lot.setback_m;
    const auto part_at = [](double y) { return y <= 0 ? BorderPart::kStreet : BorderPart::kSides; };
    if ((ya < 0) == (yb < 0) || std::abs(ya - yb) < kBorderStep_m) return pieces.push_back({a, b, part_at(ya + yb), 0});
    const Vec2 cut = a + (b - a) * (ya / (ya - yb));
    pieces.push_back({a, cut, part_at(ya), 0});
    pieces.push_back({cut, b, part_at(yb), 0});
  }

  std::vector<BorderPiece> pieces() const {
    const Ring& ring = lot.parcel.polygon.outer;
    std::vector<BorderPiece> all;
    for (std::size_t i = 0; i < ring.size(); ++i) add_edge(ring[i], ring[(i + 1) % ring.size()], all);
    // begin at a change, so that no chain is cut at the ring's first point
    for (std::size_t i = 1; i < all.size(); ++i)
      if (!all[i].continues(all[i - 1])) {
        std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), all.end());
        break;
      }
    return all;
  }

  // The line of a chain of pieces, moved into the lot, which lies to its left.
  static Polyline line_of_chain(std::span<const BorderPiece> chain) {
    Polyline line;
    for (std::size_t i = 0; i <= chain.size(); ++i) {
      const BorderPiece& before = chain[i > 0 ? i - 1 : 0];
      const BorderPiece& after = chain[std::min(i, chain.size() - 1)];
      const Vec2 u = unit(before.b - before.a), v = unit(after.b - after.a);
      const Vec2 middle = u + v == Vec2{} ? u : unit(u + v);
      const double mitre = std::max(kLeastMitreCosine, dot(middle, v));
      line.push_back((i < chain.size() ? after.a : before.b) + left_of(middle) * (before.inset_m / mitre));
    }
    return line;
  }

  bool is_free(Vec2 p, BorderPart part) const {
    const MappedThings& mapped = obstacles.mapped;
    const bool is_along_street = part == BorderPart::kStreet;
    return clearance_m(obstacles.openings, p, kToPath_m) >= kToPath_m &&
           clearance_m(mapped.roads, p, kToPavement_m) >= kToPavement_m &&
           clearance_m(mapped.paths, p, kToPath_m) >= kToPavement_m &&
           clearance_m(mapped.drives, p, kToPath_m) >= kToPath_m &&
           clearance_m(mapped.barriers, p, kMappedBarrier_m) >= kMappedBarrier_m &&
           clearance_m(mapped.trees, p, kToWall_m) >= kToWall_m &&
           (!is_along_street || clearance_m(mapped.junction_zones, p, 0.25) > 0) && is_off_houses(p);
  }

  // On an edge between two houses a barrier would stand in their walls.
  bool is_off_houses(Vec2 p) const {
    return clearance_m(obstacles.mapped.walls, p, kToWall_m) >= kToWall_m &&
           !is_inside_any(obstacles.mapped.buildings, p);
  }

  // Adds the free runs of a line.
  void add_runs(const Polyline& line, BorderPart part, const BorderRule& border,
                std::vector<map::Barrier>& barriers) const {
    Polyline run;
    const auto end_run = [&] {
      if (run.size() >= 2 && length_m(run) >= kShortestBorder_m)
        barriers.push_back(
            {.id = {}, .axis = without_equal_points(run), .kind = *border.kind, .height_m = border.height_m});
      run.clear();
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 a = line[i], b = line[i + 1];
      const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kBorderStep_m)));
      for (int k = 0; k < steps; ++k) {
        const Vec2 from = a + (b - a) * (static_cast<double>(k) / steps), to = a + (b - a) * ((k + 1.0) / steps);
        if (!is_free((from + to) * 0.5, part)) {
          end_run();
          continue;
        }
        if (run.empty()) run.push_back(from);
        // the end of the run moves on along the segment
        if (k > 0 && run.size() > 1)
          run.back() = to;
        else
          run.push_back(to);
      }
    }
    end_run();
  }

  static Polyline without_equal_points(const Polyline& line) {
    Polyline clean;
    for (const Vec2 p : line)
      if (clean.empty() || clean.back() != snapped(p)) clean.push_back(snapped(p));
    return clean;
  }
};

}  // namespace

SharedEdges index_edges(std::span<const Lot> lots) {
  SharedEdges edges;
  for (std::uint32_t i = 0; i < lots.size(); ++i) {
    const Ring& ring = lots[i].parcel.polygon.outer;
    for (std::size_t k = 0; k < ring.size(); ++k)
      edges.entries.push_back(entry_of(ring[k], ring[(k + 1) % ring.size()], i));
  }
  std::ranges::sort(edges.entries);
  return edges;
}

std::vector<map::Barrier> barriers_of(std::uint32_t lot, std::span<const Lot> lots,
                                      std::span<const std::optional<YardRule>> rules, const SharedEdges& edges,
                                      const BorderObstacles& obstacles) {
  std::vector<map::Barrier> barriers;
  if (!rules[lot]) return barriers;
  const BorderDrawer drawer{lot, lots, rules, edges, obstacles};
  const std::vector<BorderPiece> pieces = drawer.pieces();
  const bool has_mapped = axis_enters(obstacles.mapped.barriers, lots[lot].parcel.polygon);
  for (std::size_t i = 0; i < pieces.size();) {
    std::size_t end = i + 1;
    while (end < pieces.size() && pieces[end].continues(pieces[end - 1])) ++end;
    const BorderPart part = pieces[i].part;
    const BorderRule& border = part == BorderPart::kStreet ? rules[lot]->street : rules[lot]->sides;
    const bool is_left_out = part == BorderPart::kNone || !border.kind || (part == BorderPart::kStreet && has_mapped);
    if (!is_left_out)
      drawer.add_runs(BorderDrawer::line_of_chain(std::span(pieces).subspan(i, end - i)), part, border, barriers);
    i = end;
  }
  return barriers;
}

}  // namespace citykiln::lots
