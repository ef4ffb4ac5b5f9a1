#include "compiler/parcels/edge_owners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/segment.h"

namespace citykiln::parcels {
namespace {

// Rays are not cast for parts of an edge narrower than this.
constexpr double kLeastSpan_m = 0.05;
// A building behind others is in front where at least this much of it is seen, or half of it.
constexpr double kLeastSeen_m = 3;
// A building on a corner is seen from the side street up to this distance.
constexpr double kCorner_m = 25;
// A shed this near to a building has no lot of its own.
constexpr double kShedNear_m = 25;
// Land behind a building that belongs to its lot.
constexpr double kBackyard_m = 10;
// Land beside a hidden building that belongs to its lot.
constexpr double kBesideHidden_m = 3;

struct FootprintEdge {
  Vec2 a, b;
  std::uint32_t footprint;
};

struct Buildings {
  const std::vector<Footprint>* footprints;
  std::vector<Box2> boxes;
  std::vector<bool> is_main;  // false: a shed
  std::vector<FootprintEdge> edges;
  BoxGrid grid, edge_grid;
};

bool has_larger_near(const Buildings& buildings, const std::vector<double>& areas, std::uint32_t i) {
  const Box2 around = buildings.boxes[i].widened(kShedNear_m);
  return any_about(buildings.grid, around, [&](std::uint32_t other) {
    return areas[other] >= kShed_m2 && buildings.boxes[other].touches(around);
  });
}

Buildings buildings_of(const std::vector<Footprint>& footprints) {
  Buildings buildings{&footprints, {}, {}, {}, {}, {}};
  std::vector<Box2> edge_boxes;
  std::vector<double> areas;
  for (std::uint32_t i = 0; i < footprints.size(); ++i) {
    const Ring& ring = footprints[i].ring;
    buildings.boxes.push_back(box_of(ring));
    areas.push_back(signed_area_m2(ring));
    for (std::size_t k = 0, j = ring.size() - 1; k < ring.size(); j = k++) {
      buildings.edges.push_back({ring[j], ring[k], i});
      edge_boxes.push_back(box_of_segment(ring[j], ring[k]));
    }
  }
  buildings.grid = grid_of(buildings.boxes, 32);
  buildings.edge_grid = grid_of(edge_boxes, 16);
  for (std::uint32_t i = 0; i < footprints.size(); ++i)
    buildings.is_main.push_back(areas[i] >= kShed_m2 || !has_larger_near(buildings, areas, i));
  return buildings;
}

struct Hit {
  std::uint32_t footprint = kNoIndex;
  double distance_m = 0;
};

// The first building that a ray meets, sheds or main buildings only.
Hit first_hit(const Buildings& buildings, Vec2 p, Vec2 towards, double most_m, bool sheds) {
  Hit hit{kNoIndex, most_m};
  const auto meet = [&](std::uint32_t i, double at_m) {
    if (at_m < hit.distance_m || (at_m == hit.distance_m && i < hit.footprint)) hit = {i, at_m};
  };
  for (const std::uint32_t i : boxes_about(buildings.grid, p))
    if (buildings.is_main[i] != sheds && buildings.boxes[i].contains(p) &&
        winding_number((*buildings.footprints)[i].ring, p) != 0)
      meet(i, 0);
  const Vec2 end = p + towards * most_m;
  any_about(buildings.edge_grid, box_of_segment(p, end), [&](std::uint32_t k) {
    const FootprintEdge& e = buildings.edges[k];
    if (buildings.is_main[e.footprint] != sheds)
      if (const auto shares = crossing_shares(p, end, e.a, e.b)) meet(e.footprint, shares->first * most_m);
    return false;
  });
  return hit;
}

// A part of a street edge from which a building is seen.
struct Run {
  double from_m = 0, to_m = 0;
  std::uint32_t footprint = 0;
};

struct View {
  const RightsOfWay& ways;
  const Buildings& buildings;
  const Field& field;  // of whole street edges
  const Obstacles& obstacles;
};

// False if another street that the building faces is nearer.
bool belongs_here(const View& view, std::uint32_t street_edge, Vec2 at, double distance_m) {
  const std::uint32_t other = nearest_other(view.field, at, street_edge, distance_m - 0.01);
  if (other == kNoIndex) return true;
  const double facing = dot(view.field.pieces[other].normal, view.ways.street_edges[street_edge].normal);
  return distance_m <= kCorner_m && facing > -0.3;
}

std::optional<std::uint32_t> seen_from(const View& view, std::uint32_t street_edge, Vec2 p, Vec2 towards) {
  const double most_m = distance_to_obstacle(view.obstacles, p, towards, kDepth_m);
  const Hit hit = first_hit(view.buildings, p, towards, most_m, false);
  if (hit.footprint == kNoIndex || !belongs_here(view, street_edge, p + towards * hit.distance_m, hit.distance_m))
    return {};
  return hit.footprint;
}

// The places along a street edge where the first building can change.
std::vector<double> breaks_of(const View& view, const RightOfWayEdge& f, const Ring& land) {
  const double length = f.length_m();
  const Vec2 along = unit(f.b - f.a);
  std::vector<double> breaks = {0, length};
  for (const std::uint32_t i : boxes_about(view.buildings.grid, box_of(land))) {
    if (!view.buildings.is_main[i]) continue;
    for (const Vec2 p : (*view.buildings.footprints)[i].ring) {
      const double at = dot(p - f.a, along), d = dot(p - f.a, f.normal);
      if (at > 0 && at < length && d > -kDepth_m && d < kDepth_m) breaks.push_back(at);
    }
  }
  std::ranges::sort(breaks);
  return breaks;
}

std::vector<Run> runs_of(const View& view, std::uint32_t street_edge) {
  const RightOfWayEdge& f = view.ways.street_edges[street_edge];
  std::vector<Run> runs;
  if (f.a == f.b) return runs;
  const Vec2 along = unit(f.b - f.a), rear = f.normal * kDepth_m;
  const std::vector<double> breaks = breaks_of(view, f, {f.a, f.b, f.b + rear, f.a + rear});
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    if (breaks[i] - breaks[i - 1] < kLeastSpan_m) continue;
    const auto seen = seen_from(view, street_edge, f.a + along * ((breaks[i - 1] + breaks[i]) / 2), f.normal);
    if (!seen) continue;
    if (!runs.empty() && runs.back().footprint == *seen && breaks[i - 1] - runs.back().to_m < 2 * kLeastSpan_m)
      runs.back().to_m = breaks[i];
    else
      runs.push_back({breaks[i - 1], breaks[i], *seen});
  }
  return runs;
}

// The extent of a building along a street edge and away from it.
struct Shadow {
  double from_m, to_m, rear_m;
};
Shadow shadow_of(const RightOfWayEdge& f, const Ring& ring) {
  const Vec2 along = unit(f.b - f.a);
  Shadow shadow{1e9, -1e9, 0};
  for (const Vec2 p : ring) {
    const double at = dot(p - f.a, along);
    shadow.from_m = std::min(shadow.from_m, at), shadow.to_m = std::max(shadow.to_m, at);
    shadow.rear_m = std::max(shadow.rear_m, dot(p - f.a, f.normal));
  }
  return shadow;
}

// Drops runs of buildings behind others, of which little is seen.
void drop_glimpses(const RightOfWayEdge& f, std::vector<Run>& runs, const Buildings& buildings) {
  std::erase_if(runs, [&](const Run& run) {
    const Shadow shadow = shadow_of(f, (*buildings.footprints)[run.footprint].ring);
    const double whole = std::min(shadow.to_m, f.length_m()) - std::max(shadow.from_m, 0.0);
    return run.to_m - run.from_m < std::min(kLeastSeen_m, whole / 2);
  });
}

// A stretch of one street edge within a gap.
struct Stretch {
  std::uint32_t street_edge;
  double from_m, to_m;
};

// The land between a run and the next one along the street, or its first part.
struct Gap {
  std::vector<Stretch> stretches;
  double length_m = 0;
  std::uint32_t next_edge = kNoIndex, next_run = 0;  // kNoIndex: none within reach
};

class Divider {
 public:
  Divider(const View& view, std::vector<std::vector<Run>> runs, const std::vector<LotSize>& sizes)
      : view_(view), runs_(std::move(runs)), sizes_(sizes), owners_(runs_.size()), has_before_(runs_.size()) {}

  EdgeOwners divide() {
    for (std::uint32_t f = 0; f < runs_.size(); ++f) {
      has_before_[f].resize(runs_[f].size());
      for (const Run& run : runs_[f]) put(f, run.from_m, run.to_m, run.footprint);
    }
    for (std::uint32_t f = 0; f < runs_.size(); ++f)
      for (std::uint32_t r = 0; r < runs_[f].size(); ++r) divide_after(f, r);
    for (std::uint32_t f = 0; f < runs_.size(); ++f)
      for (std::uint32_t r = 0; r < runs_[f].size(); ++r)
        if (!has_before_[f][r]) extend_before(f, r);
    for (std::uint32_t f = 0; f < runs_.size(); ++f) complete(f);
    return std::move(owners_);
  }

 private:
  const RightOfWayEdge& street_edge(std::uint32_t f) const { return view_.ways.street_edges[f]; }
  const LotSize& size(std::uint32_t f) const {
    return sizes_[std::min<std::size_t>(street_edge(f).size, sizes_.size() - 1)];
  }

  void put(std::uint32_t f, double from_m, double to_m, std::uint32_t footprint) {
    if (to_m <= from_m) return;
    const double rear = shadow_of(street_edge(f), (*view_.buildings.footprints)[footprint].ring).rear_m + kBackyard_m;
    owners_[f].push_back({from_m, to_m, label_of_building(footprint), std::clamp(rear, size(f).depth_m, kDepth_m)});
  }

  Gap gap_after(std::uint32_t f, std::uint32_t r, double reach_m) const {
    Gap gap;
    const std::uint32_t first = f;
    double from = runs_[f][r].to_m;
    ++r;
    for (;;) {
      const bool has_run = r < runs_[f].size();
      const double to = has_run ? runs_[f][r].from_m : street_edge(f).length_m();
      gap.stretches.push_back({f, from, std::max(from, to)});
      gap.length_m += std::max(0.0, to - from);
      if (gap.length_m > reach_m) return gap;
      if (has_run) {
        gap.next_edge = f, gap.next_run = r;
        return gap;
      }
      f = street_edge(f).next;
      if (f == kNoIndex || f == first) return gap;
      r = 0, from = 0;
    }
  }

  void divide_after(std::uint32_t f, std::uint32_t r) {
    const double margin = size(f).frontage_m;
    const Gap gap = gap_after(f, r, 2 * margin);
    const std::uint32_t own = runs_[f][r].footprint;
    if (gap.next_edge == kNoIndex) {
      give(gap, 0, margin, own);
      return;
    }
    has_before_[gap.next_edge][gap.next_run] = true;
    const std::uint32_t other = runs_[gap.next_edge][gap.next_run].footprint;
    const double cut = own == other ? gap.length_m : cut_of(gap);
    give(gap, 0, cut, own);
    give(gap, cut, gap.length_m, other);
  }

  // Gives a part of a gap, by distances along it.
  void give(const Gap& gap, double from_m, double to_m, std::uint32_t footprint) {
    double at = 0;
    for (const Stretch& s : gap.stretches) {
      const double length = s.to_m - s.from_m;
      const double from = std::clamp(from_m - at, 0.0, length), to = std::clamp(to_m - at, 0.0, length);
      if (to > from) put(s.street_edge, s.from_m + from, to == length ? s.to_m : s.from_m + to, footprint);
      at += length;
    }
  }

  // At the corner of two streets if one lies between; else where no shed is cut, as near to the middle as possible.
  double cut_of(const Gap& gap) const {
    double at = 0, best = gap.length_m / 2, off = 1e9;
    for (std::size_t i = 0; i + 1 < gap.stretches.size(); ++i) {
      at += gap.stretches[i].to_m - gap.stretches[i].from_m;
      if (street_edge(gap.stretches[i].street_edge).is_corner && std::abs(at - gap.length_m / 2) < off)
        best = at, off = std::abs(at - gap.length_m / 2);
    }
    if (off < 1e9) return best;
    for (int step = 0; step <= 18; ++step)
      for (const int sign : {1, -1})
        if (const double place = gap.length_m * (0.5 + sign * 0.025 * step); is_free(gap, place)) return place;
    return gap.length_m / 2;
  }

  bool is_free(const Gap& gap, double place_m) const {
    double at = 0;
    for (const Stretch& s : gap.stretches) {
      const double length = s.to_m - s.from_m;
      if (place_m <= at + length) {
        const RightOfWayEdge& f = street_edge(s.street_edge);
        const Vec2 p = f.a + unit(f.b - f.a) * (s.from_m + place_m - at);
        return first_hit(view_.buildings, p, f.normal, kDepth_m / 2, true).footprint == kNoIndex;
      }
      at += length;
    }
    return true;
  }

  void extend_before(std::uint32_t f, std::uint32_t r) {
    const std::uint32_t own = runs_[f][r].footprint;
    double left = size(f).frontage_m, to = runs_[f][r].from_m;
    const std::uint32_t first = f;
    for (;;) {
      // spans that belong to others end the walk
      double from = 0;
      for (const Span& span : owners_[f])
        if (span.from_m < to) from = std::max(from, std::min(span.to_m, to));
      const double start = std::max(from, to - left);
      left -= to - start;
      put(f, start, to, own);
      if (left <= 0 || from > 0) return;
      f = street_edge(f).previous;
      if (f == kNoIndex || f == first) return;
      to = street_edge(f).length_m();
    }
  }

  // Sorts the spans and fills free spans.
  void complete(std::uint32_t f) {
    std::ranges::sort(owners_[f], {}, &Span::from_m);
    std::vector<Span> all;
    double at = 0;
    for (Span span : owners_[f]) {
      span.from_m = std::max(span.from_m, at);
      if (span.to_m <= span.from_m) continue;
      if (span.from_m > at) all.push_back({at, span.from_m, kRest, size(f).depth_m});
      if (!all.empty() && all.back().label == span.label)
        all.back().to_m = span.to_m, all.back().depth_m = std::max(all.back().depth_m, span.depth_m);
      else
        all.push_back(span);
      at = span.to_m;
    }
    if (at < street_edge(f).length_m()) all.push_back({at, street_edge(f).length_m(), kRest, size(f).depth_m});
    owners_[f] = std::move(all);
  }

  const View& view_;
  std::vector<std::vector<Run>> runs_;
  const std::vector<LotSize>& sizes_;
  EdgeOwners owners_;
  std::vector<std::vector<bool>> has_before_;
};

// A building that no ray meets, before land without an owner.
struct Claim {
  double from_m, to_m, distance_m;
  std::uint32_t footprint;
};

std::vector<std::vector<Claim>> claims_of(const View& view, const EdgeOwners& owners) {
  const std::vector<Footprint>& footprints = *view.buildings.footprints;
  std::vector<bool> has_edge(footprints.size(), false);
  for (const std::vector<Span>& spans : owners)
    for (const Span& span : spans)
      if (span.label >= kFirstBuilding) has_edge[span.label - kFirstBuilding] = true;
  const Field field = field_of(pieces_of(view.ways, owners), view.obstacles);
  std::vector<std::vector<Claim>> claims(owners.size());
  for (std::uint32_t i = 0; i < footprints.size(); ++i) {
    if (has_edge[i]) continue;
    const Vec2 centre = centroid({footprints[i].ring, {}});
    const std::uint32_t piece = nearest_piece(field, centre);
    if (piece == kNoIndex || field.pieces[piece].label != kRest) continue;
    const std::uint32_t f = field.pieces[piece].street_edge;
    const Shadow shadow = shadow_of(view.ways.street_edges[f], footprints[i].ring);
    claims[f].push_back(
        {shadow.from_m - kBesideHidden_m, shadow.to_m + kBesideHidden_m, distance_m(field.pieces[piece], centre), i});
  }
  return claims;
}

// The nearest of the claims to a place; null if there is none.
const Claim* claim_at(const std::vector<Claim>& claims, double at_m) {
  const Claim* best = nullptr;
  for (const Claim& claim : claims)
    if (claim.from_m <= at_m && at_m <= claim.to_m && (!best || claim.distance_m < best->distance_m)) best = &claim;
  return best;
}

// Gives hidden buildings the land before them without an owner.
void adopt_hidden(const View& view, const std::vector<LotSize>& sizes, EdgeOwners& owners) {
  const auto claims = claims_of(view, owners);
  for (std::uint32_t f = 0; f < owners.size(); ++f) {
    if (claims[f].empty()) continue;
    const RightOfWayEdge& street_edge = view.ways.street_edges[f];
    const double usual_m = sizes[std::min<std::size_t>(street_edge.size, sizes.size() - 1)].depth_m;
    std::vector<Span> all;
    for (const Span& span : owners[f]) {
      std::vector<double> breaks = {span.from_m, span.to_m};
      for (const Claim& claim : claims[f])
        for (const double at : {claim.from_m, claim.to_m})
          if (span.label == kRest && at > span.from_m && at < span.to_m) breaks.push_back(at);
      std::ranges::sort(breaks);
      for (std::size_t i = 1; i < breaks.size(); ++i) {
        Span part{breaks[i - 1], breaks[i], span.label, span.depth_m};
        if (const Claim* claim = claim_at(claims[f], (part.from_m + part.to_m) / 2); claim && span.label == kRest) {
          part.label = label_of_building(claim->footprint);
          const double rear = shadow_of(street_edge, (*view.buildings.footprints)[claim->footprint].ring).rear_m;
          part.depth_m = std::clamp(rear + kBackyard_m, usual_m, kDepth_m);
        }
        if (!all.empty() && all.back().label == part.label)
          all.back().to_m = part.to_m, all.back().depth_m = std::max(all.back().depth_m, part.depth_m);
        else
          all.push_back(part);
      }
    }
    owners[f] = std::move(all);
  }
}

Field whole_field(const RightsOfWay& ways, const Obstacles& obstacles) {
  std::vector<Piece> pieces;
  for (std::uint32_t f = 0; f < ways.street_edges.size(); ++f) {
    add_piece(pieces, ways, f, 0, ways.street_edges[f].length_m(), kDepth_m, kRest);
    add_wedges(pieces, ways, f, kDepth_m, kRest);
  }
  return field_of(std::move(pieces), obstacles);
}

}  // namespace

EdgeOwners edge_owners_of(const RightsOfWay& ways, const std::vector<Footprint>& footprints,
                          const std::vector<LotSize>& sizes, const Obstacles& obstacles) {
  const Buildings buildings = buildings_of(footprints);
  const Field field = whole_field(ways, obstacles);
  const View view{ways, buildings, field, obstacles};
  std::vector<std::vector<Run>> runs(ways.street_edges.size());
  for (std::uint32_t f = 0; f < runs.size() && !footprints.empty(); ++f) {
    runs[f] = runs_of(view, f);
    drop_glimpses(ways.street_edges[f], runs[f], buildings);
  }
  EdgeOwners owners = Divider(view, std::move(runs), sizes).divide();
  if (!footprints.empty()) adopt_hidden(view, sizes, owners);
  return owners;
}

std::vector<Piece> pieces_of(const RightsOfWay& ways, const EdgeOwners& owners) {
  std::vector<Piece> pieces;
  for (std::uint32_t f = 0; f < owners.size(); ++f) {
    for (const Span& span : owners[f]) add_piece(pieces, ways, f, span.from_m, span.to_m, span.depth_m, span.label);
    if (!owners[f].empty()) add_wedges(pieces, ways, f, owners[f].back().depth_m, owners[f].back().label);
  }
  return pieces;
}

}  // namespace citykiln::parcels
