#include "compiler/parcels/divide.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "compiler/geometry/snap.h"
#include "compiler/parcels/faces.h"
#include "compiler/parcels/fronts.h"
#include "compiler/parcels/lot_borders.h"
#include "compiler/parcels/lots_of_faces.h"

namespace citykiln::parcels {
namespace {

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
    lot.front.line = lines[lot.front.line];
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

  const Strips strips = strips_of(lines);
  const Obstacles obstacles = obstacles_of(lines, taken);
  const Fronts fronts = fronts_of(strips, footprints, land.sizes, obstacles);
  const Field field = field_of(pieces_of(strips, fronts), obstacles);
  const auto borders = lot_borders(field, threads);
  const Layout layout{land.extent, strips.pieces, taken, footprints, borders, &field};
  Parcels parcels = lots_of_faces(faces_of(layout, threads), lines, footprints);
  renumber(parcels, line_order, footprint_order);
  parcels.failures.insert(parcels.failures.end(), failures.begin(), failures.end());
  std::ranges::sort(parcels.failures, {}, &Failure::footprint);
  return parcels;
}

}  // namespace citykiln::parcels
