#include "compiler/parcels/lots_of_faces.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "compiler/contract/disjoint_sets.h"
#include "compiler/parcels/edge_owners.h"
#include "compiler/parcels/straight_points.h"
#include "compiler/parcels/trace_rings.h"

namespace citykiln::parcels {
namespace {

// Smaller blocks are gaps between rights-of-way, and belong to these.
constexpr double kLeastBlock_m2 = 1;
// Shorter frontages give no access: a path needs about a metre.
constexpr double kLeastFrontage_m = 1;
// Smaller lots without buildings are rest.
constexpr double kLeastEmpty_m2 = 20;

using Labels = std::vector<std::uint32_t>;

bool is_land(const Faces& faces, std::uint32_t face) {
  return face != kNoIndex && faces.faces[face].kind == FaceKind::kLand;
}

// Joins neighbouring faces for which is_same(face, face) is true.
template <typename IsSame>
Labels components_of(const Faces& faces, IsSame is_same) {
  DisjointSets sets(faces.faces.size());
  for (const FaceEdge& edge : faces.edges)
    if (edge.beyond != kNoIndex && is_same(edge.face, edge.beyond)) sets.join(edge.face, edge.beyond);
  return sets.lowest();
}

// Land of blocks that are too small becomes land of lines.
void drop_small_blocks(Faces& faces) {
  const Labels blocks = components_of(faces, [&](auto a, auto b) { return is_land(faces, a) && is_land(faces, b); });
  std::vector<double> areas(faces.faces.size(), 0);
  for (std::uint32_t i = 0; i < blocks.size(); ++i) areas[blocks[i]] += faces.faces[i].area_m2;
  for (std::uint32_t i = 0; i < blocks.size(); ++i)
    if (is_land(faces, i) && areas[blocks[i]] < kLeastBlock_m2)
      faces.faces[i].kind = FaceKind::kLine, faces.faces[i].label = kOff;
}

// The key of the largest area; the lowest of equal ones. kNoIndex if there is none.
std::uint32_t largest_of(const std::map<std::uint32_t, double>& areas) {
  std::uint32_t best = kNoIndex;
  double most = 0;
  for (const auto& [key, area] : areas)
    if (area > most) best = key, most = area;
  return best;
}

// Areas by footprint and key.
using Shares = std::vector<std::map<std::uint32_t, double>>;

Shares shares_of(const Faces& faces, std::size_t footprint_count, const Labels& keys) {
  Shares shares(footprint_count);
  for (std::uint32_t i = 0; i < faces.faces.size(); ++i)
    if (faces.faces[i].footprint != kNoIndex && keys[i] != kNoIndex)
      shares[faces.faces[i].footprint][keys[i]] += faces.faces[i].area_m2;
  return shares;
}

// The label of each face: that of the footprint on it, else the field's.
Labels labels_of(const Faces& faces, std::size_t footprint_count) {
  Labels labels(faces.faces.size());
  std::vector<bool> has_label(footprint_count, false);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    labels[i] = faces.faces[i].label;
    if (labels[i] >= kFirstBuilding && labels[i] - kFirstBuilding < footprint_count)
      has_label[labels[i] - kFirstBuilding] = true;
  }
  Labels keys(labels);
  for (std::uint32_t& key : keys)
    if (key <= kRest) key = kNoIndex;
  const Shares shares = shares_of(faces, footprint_count, keys);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    const std::uint32_t footprint = faces.faces[i].footprint;
    if (!is_land(faces, i) || footprint == kNoIndex) continue;
    const std::uint32_t best = has_label[footprint] ? label_of_building(footprint) : largest_of(shares[footprint]);
    if (best != kNoIndex) labels[i] = best;
  }
  return labels;
}

bool is_on_street(const Faces& faces, const std::vector<Line>& lines, const FaceEdge& edge) {
  return edge.beyond != kNoIndex && faces.faces[edge.beyond].kind == FaceKind::kLine &&
         edge.border.kind == BorderKind::kLine && lines[edge.border.line].kind == LineKind::kStreet;
}

double length_m(const FaceEdge& edge) { return distance(plane_point(edge.from), plane_point(edge.to)); }

struct Component {
  double area_m2 = 0, frontage_m = 0;
  bool has_footprint = false;
};

// Components of labels, by their lowest face.
struct Components {
  Labels roots;
  std::vector<Component> at;
};

Components measured(const Faces& faces, const std::vector<Line>& lines, const Labels& labels) {
  Components all;
  all.roots = components_of(faces, [&](auto a, auto b) { return labels[a] == labels[b] && labels[a] > kRest; });
  all.at.resize(labels.size());
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    Component& c = all.at[all.roots[i]];
    c.area_m2 += faces.faces[i].area_m2;
    c.has_footprint = c.has_footprint || faces.faces[i].footprint != kNoIndex;
  }
  for (const FaceEdge& edge : faces.edges)
    if (labels[edge.face] > kRest && is_on_street(faces, lines, edge))
      all.at[all.roots[edge.face]].frontage_m += length_m(edge);
  return all;
}

// Faces without access go back to the field's label where it differs, else they are rest.
void mend_landlocked(const Faces& faces, const std::vector<Line>& lines, Labels& labels) {
  const Components first = measured(faces, lines, labels);
  for (std::uint32_t i = 0; i < labels.size(); ++i)
    if (labels[i] > kRest && first.at[first.roots[i]].frontage_m < kLeastFrontage_m)
      labels[i] = labels[i] != faces.faces[i].label ? faces.faces[i].label : kRest;
  const Components second = measured(faces, lines, labels);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    const Component& c = second.at[second.roots[i]];
    if (labels[i] > kRest && (c.frontage_m < kLeastFrontage_m || (c.area_m2 < kLeastEmpty_m2 && !c.has_footprint)))
      labels[i] = kRest;
  }
}

// Numbers the components that is_kept accepts, and returns the number of each face.
template <typename IsKept>
std::pair<Labels, std::uint32_t> numbered(const Labels& roots, IsKept is_kept) {
  Labels numbers(roots.size(), kNoIndex);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < roots.size(); ++i)
    if (is_kept(i)) numbers[i] = roots[i] == i ? count++ : numbers[roots[i]];
  return {std::move(numbers), count};
}

Ring plane_ring_of(const TracedRing& traced) {
  Ring ring;
  for (const GridPoint p : traced.points) ring.push_back(plane_point(p));
  return ring;
}

// The outer ring, then the holes, of one connected region.
std::pair<Polygon, std::vector<std::vector<Border>>> polygon_of(const std::vector<TracedRing>& rings) {
  std::pair<Polygon, std::vector<std::vector<Border>>> result;
  for (const TracedRing& ring : rings)
    if (twice_area(ring) > 0) {
      result.first.outer = plane_ring_of(ring);
      result.second.insert(result.second.begin(), ring.borders);
    } else {
      result.first.holes.push_back(plane_ring_of(ring));
      result.second.push_back(ring.borders);
    }
  return result;
}

LinePlace place_on(const Line& line, std::uint32_t segment, Vec2 p) {
  const Vec2 a = line.axis[segment];
  return {segment, dot(p - a, unit(line.axis[segment + 1] - a))};
}

bool is_earlier(const LinePlace& a, const LinePlace& b) {
  return std::tie(a.segment, a.at_m) < std::tie(b.segment, b.at_m);
}

// The line and side along which a lot has most of its frontage.
Frontage frontage_of(const std::vector<TracedRing>& rings, const std::vector<Line>& lines) {
  std::map<std::pair<std::uint32_t, Side>, Frontage> frontages;
  for (const TracedRing& ring : rings)
    for (std::size_t i = 0, n = ring.points.size(); i < n; ++i) {
      const Border& border = ring.borders[i];
      if (border.kind != BorderKind::kLine || lines[border.line].kind != LineKind::kStreet) continue;
      const Vec2 a = plane_point(ring.points[i]), b = plane_point(ring.points[(i + 1) % n]);
      LinePlace from = place_on(lines[border.line], border.segment, a),
                to = place_on(lines[border.line], border.segment, b);
      if (is_earlier(to, from)) std::swap(from, to);
      const auto [at, is_new] =
          frontages.try_emplace({border.line, border.side}, Frontage{border.line, border.side, from, to, 0});
      Frontage& frontage = at->second;
      if (is_earlier(from, frontage.from)) frontage.from = from;
      if (is_earlier(frontage.to, to)) frontage.to = to;
      frontage.length_m += distance(a, b);
    }
  Frontage best;
  for (const auto& [key, frontage] : frontages)
    if (frontage.length_m > best.length_m) best = frontage;
  return best;
}

std::vector<FrontageEdge> frontage_edges(const std::vector<TracedRing>& rings, const std::vector<Line>& lines) {
  std::vector<FrontageEdge> edges;
  for (const TracedRing& ring : rings)
    for (std::size_t i = 0, n = ring.points.size(); i < n; ++i)
      if (ring.borders[i].kind == BorderKind::kLine && lines[ring.borders[i].line].kind == LineKind::kStreet)
        edges.emplace_back(plane_point(ring.points[i]), plane_point(ring.points[(i + 1) % n]));
  return edges;
}

// The lowest first point of a frontage's edges. Another lot's edge cannot begin there.
GridPoint start_of(const std::vector<TracedRing>& rings, const Frontage& frontage) {
  GridPoint start{INT64_MAX, INT64_MAX};
  for (const TracedRing& ring : rings)
    for (std::size_t i = 0; i < ring.points.size(); ++i)
      if (const Border& border = ring.borders[i];
          border.kind == BorderKind::kLine && border.line == frontage.line && border.side == frontage.side)
        start = std::min(start, ring.points[i]);
  return start;
}

StableId id_of(const Frontage& frontage, GridPoint start, const std::vector<Line>& lines) {
  const Line& line = lines[frontage.line];
  const auto number = [](GridPoint g) {
    return static_cast<std::uint64_t>(g.x) << 32 ^ (static_cast<std::uint64_t>(g.y) & 0xffffffffu);
  };
  const auto end_of = [&](std::uint32_t i) { return number(grid_point(line.axis[frontage.from.segment + i])); };
  StableId id = stable_id(line.id, frontage.side == Side::kLeft ? "left" : "right", end_of(0));
  id = stable_id(id, "segment", end_of(1));
  return stable_id(id, "lot", number(start));
}

Cause cause_of(const std::array<double, 5>& areas) {
  const auto largest = std::ranges::max_element(areas) - areas.begin();
  constexpr Cause kCauses[] = {Cause::kOutside, Cause::kOnLine, Cause::kOnTaken, Cause::kFarFromStreet,
                               Cause::kNoStreet};
  return areas == std::array<double, 5>{} ? Cause::kOutside : kCauses[largest];
}

struct Homes {
  Labels lot_of;  // by footprint; kNoIndex: none
  std::vector<Failure> failures;
};

// The lot of each footprint, or why it has none.
Homes homes_of(const Faces& faces, const Labels& lots, std::size_t footprint_count,
               const std::vector<Footprint>& footprints) {
  Homes homes{Labels(footprint_count, kNoIndex), {}};
  const Shares shares = shares_of(faces, footprint_count, lots);
  std::vector<std::array<double, 5>> areas(footprint_count);  // outside, on lines, on taken land, far, landlocked
  for (const Face& face : faces.faces)
    if (face.footprint != kNoIndex) {
      const std::size_t kind = face.kind != FaceKind::kLand ? static_cast<std::size_t>(face.kind)
                               : face.label <= kRest        ? 3
                                                            : 4;
      areas[face.footprint][kind] += face.area_m2;
    }
  for (std::uint32_t f = 0; f < footprint_count; ++f) {
    const std::uint32_t lot = largest_of(shares[f]);
    const double in_lot = lot == kNoIndex ? 0 : shares[f].at(lot);
    const double on_lots = areas[f][3] + areas[f][4];
    // buildings mostly on streets or taken land have no lot, even if a corner of them lies in one
    if (in_lot > 0 && in_lot >= areas[f][0] && in_lot >= areas[f][1] && in_lot >= areas[f][2] && 4 * in_lot >= on_lots)
      homes.lot_of[f] = lot;
    else if (signed_area_m2(footprints[f].ring) <= 0)
      homes.failures.push_back({Cause::kWithoutArea, f});
    else
      homes.failures.push_back({cause_of(areas[f]), f});
  }
  return homes;
}

}  // namespace

LabelledParcels lots_of_faces(const Faces& given, const std::vector<Line>& lines,
                              const std::vector<Footprint>& footprints) {
  Faces faces = given;
  drop_small_blocks(faces);
  Labels labels = labels_of(faces, footprints.size());
  mend_landlocked(faces, lines, labels);

  const Labels block_roots =
      components_of(faces, [&](auto a, auto b) { return is_land(faces, a) && is_land(faces, b); });
  const auto [blocks, block_count] = numbered(block_roots, [&](auto i) { return is_land(faces, i); });
  const Labels lot_roots = components_of(
      faces, [&](auto a, auto b) { return labels[a] == labels[b] && is_land(faces, a) && is_land(faces, b); });
  const auto [lots, lot_count] = numbered(lot_roots, [&](auto i) { return labels[i] > kRest && is_land(faces, i); });
  const auto [rests, rest_count] = numbered(lot_roots, [&](auto i) { return labels[i] == kRest && is_land(faces, i); });

  std::vector<std::uint32_t> regions(lots.size(), kNoIndex);
  for (std::uint32_t i = 0; i < regions.size(); ++i)
    if (is_land(faces, i)) regions[i] = lots[i] != kNoIndex ? lots[i] : lot_count + rests[i];
  const std::vector<GridPoint> dropped = straight_points(faces, regions);

  LabelledParcels labelled;
  Parcels& parcels = labelled.parcels;
  for (const auto& rings : trace_rings(faces, blocks, block_count, dropped)) {
    Block& block = parcels.blocks.emplace_back();
    std::tie(block.polygon, block.borders) = polygon_of(rings);
    for (const std::vector<Border>& ring : block.borders)
      for (const Border& border : ring) block.is_at_extent = block.is_at_extent || border.kind == BorderKind::kExtent;
  }
  Labels block_of(lot_count, 0);
  labelled.labels.resize(lot_count);
  for (std::uint32_t i = 0; i < lots.size(); ++i)
    if (lots[i] != kNoIndex) block_of[lots[i]] = blocks[i], labelled.labels[lots[i]] = labels[i];
  const auto lot_rings = trace_rings(faces, lots, lot_count, dropped);
  for (std::uint32_t i = 0; i < lot_count; ++i) {
    Lot lot{.id = {},
            .polygon = polygon_of(lot_rings[i]).first,
            .block = block_of[i],
            .frontage = frontage_of(lot_rings[i], lines),
            .footprints = {}};
    lot.id = id_of(lot.frontage, start_of(lot_rings[i], lot.frontage), lines);
    parcels.lots.push_back(std::move(lot));
    labelled.frontages.push_back(frontage_edges(lot_rings[i], lines));
  }
  for (const auto& rings : trace_rings(faces, rests, rest_count, dropped))
    parcels.rest.push_back(polygon_of(rings).first);
  Homes homes = homes_of(faces, lots, footprints.size(), footprints);
  for (std::uint32_t f = 0; f < footprints.size(); ++f)
    if (homes.lot_of[f] != kNoIndex) parcels.lots[homes.lot_of[f]].footprints.push_back(f);
  parcels.failures = std::move(homes.failures);
  return labelled;
}

}  // namespace citykiln::parcels
