#include "compiler/map/buildings/uncovered_pieces.h"

#include <algorithm>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/map/buildings/part_outlines.h"

namespace citykiln::map {
namespace {

// A part may begin a little below the eaves that it stands on, and end a little above the outline that stands on it.
constexpr double kOnEaves_m = 0.25;
// The height of an untagged roof that the building's height includes.
constexpr double kAssumedRoof_m = 3;
// Smaller remains of an offset are rounded corners.
constexpr double kLeastStrip_m2 = 0.25;

// Where the walls of an outline end, or a little lower if its roof has no tagged height.
double outline_eaves_m(const Footprint& f) {
  if (!f.has_roof_in_height) return f.height_m;
  const bool is_flat = f.has_roof_shape && f.roof.form == roofs::RoofForm::kFlat;
  const double roof_m = f.roof.height_m > 0 ? f.roof.height_m : is_flat ? 0 : kAssumedRoof_m;
  return std::max(f.min_height_m, f.height_m - roof_m);
}

bool covers(const Footprint& part, const Footprint& outline) {
  if (outline.min_height_m > 0 && part.height_m < outline.min_height_m + kOnEaves_m) return false;
  return part.min_height_m == 0 || part.min_height_m < outline_eaves_m(outline) - kOnEaves_m;
}

double border_m(const Polygon& polygon) {
  double sum_m = 0;
  for (const Ring* ring : rings_of(polygon)) sum_m += length_m(*ring) + distance(ring->back(), ring->front());
  return sum_m;
}

bool is_sliver(const Polygon& polygon) {
  return area_m2(polygon) < kLeastPiece_m2 || 2 * area_m2(polygon) < kSliver_m * border_m(polygon);
}

// The polygon without strips narrower than kSliver_m; unchanged if it has none.
std::vector<Polygon> without_strips(Polygon polygon) {
  const auto moved = [](const Polygon& p, auto move) {
    std::size_t edges = 0;
    for (const Ring* ring : rings_of(p)) edges += ring->size();
    return move(p, std::vector<double>(edges, kSliver_m / 2)).moved;
  };
  std::vector<Polygon> wide;
  for (const Polygon& core : moved(polygon, inset))
    for (Polygon& grown : moved(core, outset)) wide.push_back(std::move(grown));
  std::vector<Polygon> strips = difference(polygon, wide);
  std::erase_if(strips, [](const Polygon& strip) { return area_m2(strip) < kLeastStrip_m2; });
  if (strips.empty()) return {std::move(polygon)};
  return difference(polygon, strips);
}

std::vector<Polygon> uncovered(const Polygon& outline, std::span<const Polygon> parts) {
  std::vector<Polygon> pieces;
  for (Polygon& rest : difference(outline, parts)) {
    if (is_sliver(rest)) continue;
    for (Polygon& piece : without_strips(std::move(rest)))
      if (!is_sliver(piece)) pieces.push_back(std::move(piece));
  }
  return pieces;
}

Footprint piece_of(const Footprint& outline, Polygon polygon, std::size_t number) {
  Footprint piece = outline;
  piece.has_parts = false;
  piece.outline = outline.id;
  piece.id = piece_id(outline.id, static_cast<std::uint32_t>(number));
  piece.polygon = std::move(polygon);
  return piece;
}

}  // namespace

std::vector<Footprint> with_uncovered_pieces(std::vector<Footprint> footprints, std::span<const std::uint32_t> outlines,
                                             Account& account, Report& report) {
  std::vector<std::vector<Polygon>> covering(footprints.size());
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (outlines[i] == kNoOutline) continue;
    footprints[i].outline = footprints[outlines[i]].id;
    if (covers(footprints[i], footprints[outlines[i]])) covering[outlines[i]].push_back(footprints[i].polygon);
  }
  for (std::size_t i = 0; i < covering.size(); ++i) {
    if (covering[i].empty()) continue;
    footprints[i].has_parts = true;
    std::vector<Polygon> pieces = uncovered(footprints[i].polygon, covering[i]);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      footprints.push_back(piece_of(footprints[i], std::move(pieces[k]), k));
    const std::uint64_t counts = report.counts(footprints[i].id.osm);
    account.split += counts * pieces.size(), account.out += counts * pieces.size();
  }
  return footprints;
}

}  // namespace citykiln::map
