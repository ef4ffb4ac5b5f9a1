#include "compiler/parcels/divide.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/geometry/snap.h"
#include "compiler/parcels/edge_owners.h"
#include "compiler/parcels/empty_lots.h"
#include "compiler/parcels/faces.h"
#include "compiler/parcels/lot_borders.h"
#include "compiler/parcels/lots_of_faces.h"

namespace citykiln::parcels {
namespace {

// Sections: stretches of streets without buildings, each of which is one lot before it is split (empty_lots.h).

// The side of the cells in which sections of streets without buildings end, in metres.
constexpr double kSection_m = 128;

// Appends the distances along a → b at which a coordinate passes a multiple of kSection_m.
void add_crossings(double a, double b, double length_m, std::vector<double>& places) {
  const auto [low, high] = std::minmax(a, b);
  for (double at = std::ceil(low / kSection_m) * kSection_m; at < high; at += kSection_m)
    if (at > low) places.push_back(length_m * (at - a) / (b - a));
}

// Cuts free spans where a street edge leaves a cell, except near a corner or a building's land.
void cut_spans(const RightsOfWay& ways, std::uint32_t f, double frontage_m, std::vector<Span>& spans) {
  const RightOfWayEdge& street_edge = ways.street_edges[f];
  const double length = street_edge.length_m();
  std::vector<double> places;
  add_crossings(street_edge.a.x, street_edge.b.x, length, places);
  add_crossings(street_edge.a.y, street_edge.b.y, length, places);
  std::ranges::sort(places);
  const bool goes_on = street_edge.next != kNoIndex && !street_edge.is_corner;
  const bool comes_from = street_edge.previous != kNoIndex && !ways.street_edges[street_edge.previous].is_corner;
  std::vector<Span> cut;
  for (Span span : spans) {
    const double first = span.from_m > 0 || !comes_from ? span.from_m + frontage_m : 0;
    const double last = span.to_m < length || !goes_on ? span.to_m - frontage_m : length;
    for (const double at : places) {
      if (span.label != kRest || at <= std::max(first, span.from_m) || at >= last) continue;
      Span part = span;
      part.to_m = span.from_m = at;
      cut.push_back(part);
    }
    cut.push_back(span);
  }
  spans = std::move(cut);
}

// Cuts the spans without an owner (kRest) into sections, gives each section a label from first_label on, and returns
// the usual size of lots of each. Sections end at corners, at buildings' land, and where they leave a cell of
// kSection_m that begins at whole multiples of it, so that they are local. They do not end within a usual frontage of a
// corner or a building's land.
// @param owners  The spans, which are cut and labelled.
std::vector<LotSize> label_sections(const RightsOfWay& ways, const std::vector<LotSize>& sizes,
                                    std::uint32_t first_label, EdgeOwners& owners) {
  const auto size_at = [&](std::uint32_t f) {
    return sizes[std::min<std::size_t>(ways.street_edges[f].size, sizes.size() - 1)];
  };
  for (std::uint32_t f = 0; f < owners.size(); ++f) cut_spans(ways, f, size_at(f).frontage_m, owners[f]);
  std::vector<LotSize> of_labels;
  const auto may_join = [&](std::uint32_t f, std::uint32_t next) {
    return next != kNoIndex && !ways.street_edges[f].is_corner;
  };
  // labels run on along the street: begin where a section begins, then at what is left, which are loops
  for (const bool is_loop : {false, true})
    for (std::uint32_t f = 0; f < owners.size(); ++f)
      for (std::size_t i = 0; i < owners[f].size(); ++i) {
        if (owners[f][i].label != kRest) continue;
        const std::uint32_t before = ways.street_edges[f].previous;
        if (!is_loop && i == 0 && before != kNoIndex && may_join(before, f) &&
            (owners[before].empty() || owners[before].back().label == kRest))
          continue;
        const auto label = static_cast<std::uint32_t>(first_label + of_labels.size());
        of_labels.push_back(size_at(f));
        std::uint32_t at = f;
        for (std::size_t k = i;;) {
          if (!owners[at].empty()) {
            if (owners[at][k].label != kRest) break;
            owners[at][k].label = label;
            if (k + 1 < owners[at].size()) break;
          }
          const std::uint32_t next = ways.street_edges[at].next;
          if (!may_join(at, next) || next == f) break;
          at = next, k = 0;
        }
      }
  return of_labels;
}

// The indices of things, sorted by id.
template <typename Thing>
std::vector<std::uint32_t> order_of(const std::vector<Thing>& things) {
  std::vector<std::uint32_t> order(things.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return things[i].id; });
  return order;
}

template <typename Thing>
std::vector<Thing> in_order(const std::vector<Thing>& things, const std::vector<std::uint32_t>& order) {
  std::vector<Thing> sorted;
  for (const std::uint32_t i : order) sorted.push_back(things[i]);
  return sorted;
}

// Counter-clockwise for sign = 1, clockwise for -1.
Ring clean_ring(const Ring& ring, int sign) {
  Ring clean;
  for (const Vec2 p : ring) clean.push_back(snapped(p));
  clean = without_repeats(clean);
  if (sign * signed_area_m2(clean) < 0) std::ranges::reverse(clean);
  return clean;
}

std::vector<Polygon> clean_polygons(const std::vector<Polygon>& polygons) {
  std::vector<Polygon> clean;
  for (const Polygon& polygon : polygons) {
    Polygon& mended = clean.emplace_back();
    mended.outer = clean_ring(polygon.outer, 1);
    for (const Ring& hole : polygon.holes)
      if (Ring ring = clean_ring(hole, -1); ring.size() > 2) mended.holes.push_back(std::move(ring));
    std::ranges::sort(mended.holes);
    if (mended.outer.size() < 3) clean.pop_back();
  }
  std::ranges::sort(clean, [](const Polygon& a, const Polygon& b) {
    return std::tie(a.outer, a.holes) < std::tie(b.outer, b.holes);
  });
  return clean;
}

// Indices become those of the caller's land; lots are sorted by id, blocks and rest by their rings.
void renumber(Parcels& parcels, const std::vector<std::uint32_t>& lines, const std::vector<std::uint32_t>& footprints) {
  for (Block& block : parcels.blocks)
    for (std::vector<Border>& ring : block.borders)
      for (Border& border : ring)
        if (border.kind == BorderKind::kLine) border.line = lines[border.line];
  for (Lot& lot : parcels.lots) {
    lot.frontage.line = lines[lot.frontage.line];
    for (std::uint32_t& f : lot.footprints) f = footprints[f];
    std::ranges::sort(lot.footprints);
  }
  for (Failure& failure : parcels.failures) failure.footprint = footprints[failure.footprint];
  std::vector<std::uint32_t> order(parcels.blocks.size()), place(order.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) -> const Ring& { return parcels.blocks[i].polygon.outer; });
  std::vector<Block> blocks;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    blocks.push_back(std::move(parcels.blocks[order[i]]));
  }
  parcels.blocks = std::move(blocks);
  for (Lot& lot : parcels.lots) lot.block = place[lot.block];
  std::ranges::sort(parcels.lots, {}, &Lot::id);
  std::ranges::sort(parcels.rest, {}, &Polygon::outer);
}

// Sizes within what kInfluenceRadius_m allows; at least one.
std::vector<LotSize> limited(std::vector<LotSize> sizes) {
  if (sizes.empty()) sizes.emplace_back();
  for (LotSize& size : sizes) {
    size.area_m2 = std::max(size.area_m2, 20.0);
    size.frontage_m = std::clamp(size.frontage_m, 2.0, kDepth_m);
    size.depth_m = std::clamp(size.depth_m, 5.0, kDepth_m);
  }
  return sizes;
}

// Splits the largest lot of each section.
Splits splits_of(const LabelledParcels& labelled, const std::vector<LotSize>& sections, std::uint32_t first_label) {
  Splits splits{first_label, std::vector<SplitTree>(sections.size()), {}};
  std::vector<double> largest(sections.size(), 0);
  for (std::size_t i = 0; i < labelled.labels.size(); ++i) {
    if (labelled.labels[i] < first_label) continue;
    const std::uint32_t section = labelled.labels[i] - first_label;
    const Ring& ring = labelled.parcels.lots[i].polygon.outer;
    if (const double area = signed_area_m2(ring); area > largest[section]) {
      largest[section] = area;
      splits.trees[section] = split(ring, labelled.frontages[i], sections[section]);
    }
  }
  std::uint32_t next = first_label;
  for (const SplitTree& tree : splits.trees) {
    splits.first_leaf.push_back(next);
    next += leaf_limit(tree);
  }
  return splits;
}

}  // namespace

Parcels divide(const Land& land, int threads) {
  const std::vector<std::uint32_t> line_order = order_of(land.lines);
  std::vector<std::uint32_t> footprint_order = order_of(land.footprints);
  std::vector<Failure> failures;
  std::erase_if(footprint_order, [&](std::uint32_t i) {
    if (clean_ring(land.footprints[i].ring, 1).size() > 2) return false;
    failures.push_back({Cause::kWithoutArea, i});
    return true;
  });
  std::vector<Line> lines = in_order(land.lines, line_order);
  std::vector<Footprint> footprints = in_order(land.footprints, footprint_order);
  for (Line& line : lines)
    for (Vec2& p : line.axis) p = snapped(p);
  for (Footprint& footprint : footprints) footprint.ring = clean_ring(footprint.ring, 1);
  const std::vector<Polygon> taken = clean_polygons(land.taken);

  const RightsOfWay ways = rights_of_way_of(lines);
  const Obstacles obstacles = obstacles_of(lines, taken);
  const std::vector<LotSize> sizes = limited(land.sizes);
  EdgeOwners owners = edge_owners_of(ways, footprints, sizes, obstacles);
  const std::uint32_t first_section = label_of_building(static_cast<std::uint32_t>(footprints.size()));
  std::vector<LotSize> sections;
  if (land.split_empty) sections = label_sections(ways, sizes, first_section, owners);
  const Field field = field_of(pieces_of(ways, owners), obstacles);
  auto borders = lot_borders(field, threads);
  Layout layout{land.extent, ways.pieces, taken, footprints, borders, &field};
  LabelledParcels labelled = lots_of_faces(faces_of(layout, threads), lines, footprints);
  if (!sections.empty()) {
    const Splits splits = splits_of(labelled, sections, first_section);
    for (const SplitTree& tree : splits.trees) borders.insert(borders.end(), tree.cuts.begin(), tree.cuts.end());
    layout.borders = borders;
    layout.splits = &splits;
    labelled = lots_of_faces(faces_of(layout, threads), lines, footprints);
  }
  Parcels parcels = std::move(labelled.parcels);
  renumber(parcels, line_order, footprint_order);
  parcels.failures.insert(parcels.failures.end(), failures.begin(), failures.end());
  std::ranges::sort(parcels.failures, {}, &Failure::footprint);
  return parcels;
}

}  // namespace citykiln::parcels
