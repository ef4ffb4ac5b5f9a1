#include "grammars/roofs/plan_cells.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/polygons/overlay.h"

namespace citykiln::roofs {
namespace {

// The owners of rings.
enum Owner : std::uint32_t { kFootprint, kEaves, kFirstFacet };

void add_polygon(std::vector<OwnedSegment>& segments, const Polygon& polygon, Owner owner) {
  if (polygon.outer.size() < 3) return;
  add_ring(segments, polygon.outer, owner);
  for (const Ring& hole : polygon.holes)
    if (hole.size() >= 3) add_ring(segments, hole, owner);
}

Box2 cell_about(const std::vector<OwnedSegment>& segments) {
  Box2 box;
  for (const OwnedSegment& s : segments) box.grow(plane_point(s.a)), box.grow(plane_point(s.b));
  return {{std::floor(box.min.x) - 1, std::floor(box.min.y) - 1}, {std::ceil(box.max.x) + 1, std::ceil(box.max.y) + 1}};
}

// The nonzero winding numbers of a position, by owner.
using Windings = std::vector<WindingStep>;

void cross(Windings& windings, std::span<const WindingStep> steps, int sign) {
  for (const WindingStep& step : steps) {
    const auto own = std::find_if(windings.begin(), windings.end(), [&](auto& w) { return w.owner == step.owner; });
    if (own == windings.end())
      windings.push_back({step.owner, sign * step.winding});
    else if ((own->winding += sign * step.winding) == 0)
      windings.erase(own);
  }
}

struct Region {
  Windings windings;
  std::uint32_t facet = kNoFacet;
  bool is_in_footprint = false, is_in_eaves = false;
};

void label(Region& region) {
  for (const WindingStep& w : region.windings) {
    if (w.owner == kFootprint) region.is_in_footprint = w.winding % 2 != 0;
    if (w.owner == kEaves) region.is_in_eaves = w.winding % 2 != 0;
    if (w.owner >= kFirstFacet && w.winding > 0) region.facet = std::min(region.facet, w.owner - kFirstFacet);
  }
}

// A flood fill over all faces from outside, counting winding numbers at the edges it crosses.
class Walk {
 public:
  Walk(const Arrangement& arrangement, const Delaunay& delaunay)
      : arrangement_(arrangement), faces_(delaunay.faces()), region_of_(faces_.size(), kNoFace) {
    const auto first = [](const ArrangedEdge& x, const ArrangedEdge& y) {
      return std::pair(x.a, x.b) < std::pair(y.a, y.b);
    };
    is_lower_ = first;
    for (std::uint32_t face = 0; face < faces_.size(); ++face)
      if (region_of_[face] == kNoFace && is_outside(face)) start(face, {});
    for (std::size_t next = 0; next < queue_.size(); ++next) visit(queue_[next]);
  }

  const Region& region(std::uint32_t face) const { return regions_[region_of_[face]]; }

 private:
  // vertex 0 is the south-west corner of the arrangement, outside of all rings
  bool is_outside(std::uint32_t face) const {
    const auto& v = faces_[face].vertices;
    return regions_.empty() && std::find(v.begin(), v.end(), 0u) != v.end();
  }

  void start(std::uint32_t face, Windings windings) {
    Region region{std::move(windings)};
    label(region);
    join(face, static_cast<std::uint32_t>(regions_.size()));
    regions_.push_back(std::move(region));
  }

  void join(std::uint32_t face, std::uint32_t region) {
    region_of_[face] = region;
    queue_.push_back(face);
  }

  const ArrangedEdge* edge_between(std::uint32_t a, std::uint32_t b) const {
    const ArrangedEdge wanted{std::min(a, b), std::max(a, b)};
    const auto found = std::lower_bound(arrangement_.edges.begin(), arrangement_.edges.end(), wanted, is_lower_);
    const bool is_it = found != arrangement_.edges.end() && found->a == wanted.a && found->b == wanted.b;
    return is_it && found->count > 0 ? &*found : nullptr;
  }

  void visit(std::uint32_t face) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t beyond = faces_[face].neighbours[i];
      if (beyond == kNoFace || region_of_[beyond] != kNoFace) continue;
      const std::uint32_t a = faces_[face].vertices[(i + 1) % 3], b = faces_[face].vertices[(i + 2) % 3];
      const ArrangedEdge* edge = faces_[face].is_constrained[i] ? edge_between(a, b) : nullptr;
      if (edge == nullptr) {
        join(beyond, region_of_[face]);
        continue;
      }
      // this face is left of a -> b; crossing to the right subtracts what the edge adds on its left
      Windings windings = regions_[region_of_[face]].windings;
      cross(windings, std::span(arrangement_.steps).subspan(edge->first, edge->count), a < b ? -1 : 1);
      start(beyond, std::move(windings));
    }
  }

  const Arrangement& arrangement_;
  const std::vector<DelaunayFace>& faces_;
  bool (*is_lower_)(const ArrangedEdge&, const ArrangedEdge&) = nullptr;
  std::vector<std::uint32_t> region_of_, queue_;
  std::vector<Region> regions_;
};

PlanCells inner_cells(const Arrangement& arrangement, const Delaunay& delaunay, const Walk& walk) {
  PlanCells plan;
  for (const GridPoint p : arrangement.vertices) plan.points.push_back(plane_point(p));
  const auto& faces = delaunay.faces();
  std::vector<std::uint32_t> cell_of(faces.size(), kNoFace);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const Region& region = walk.region(f);
    if (!region.is_in_footprint && !region.is_in_eaves) continue;
    cell_of[f] = static_cast<std::uint32_t>(plan.cells.size());
    plan.cells.push_back({.points = faces[f].vertices,
                          .neighbours = faces[f].neighbours,
                          .facet = region.facet,
                          .is_uncovered = region.facet == kNoFacet,
                          .is_over_footprint = region.is_in_footprint});
  }
  for (PlanCell& cell : plan.cells)
    for (std::uint32_t& neighbour : cell.neighbours) neighbour = neighbour == kNoFace ? kNoFace : cell_of[neighbour];
  return plan;
}

// Cells stay uncovered where walls bend a little beside their facets, and by rounding. Breadth-first from covered
// cells.
void cover_cells(PlanCells& plan) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c)
    if (!plan.cells[c].is_uncovered) queue.push_back(c);
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (const std::uint32_t beyond : plan.cells[queue[next]].neighbours) {
      if (beyond == kNoFace || plan.cells[beyond].facet != kNoFacet) continue;
      plan.cells[beyond].facet = plan.cells[queue[next]].facet;
      queue.push_back(beyond);
    }
}

}  // namespace

PlanCells plan_cells(const Polygon& footprint, const Polygon& eaves_outline, std::span<const Facet> facets) {
  std::vector<OwnedSegment> segments;
  add_polygon(segments, footprint, kFootprint);
  add_polygon(segments, eaves_outline, kEaves);
  if (segments.empty()) return {};
  for (std::uint32_t i = 0; i < facets.size(); ++i)
    if (!facets[i].ring.empty()) add_ring(segments, facets[i].ring, kFirstFacet + i);
  const Arrangement arrangement = arrange(segments, {}, cell_about(segments));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const ArrangedEdge& e : arrangement.edges) edges.emplace_back(e.a, e.b);
  const Delaunay delaunay(arrangement.vertices, edges);
  PlanCells plan = inner_cells(arrangement, delaunay, Walk(arrangement, delaunay));
  cover_cells(plan);
  return plan;
}

}  // namespace citykiln::roofs
