#include "tests/charts/assumed_lands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "compiler/fields/cut_rings.h"
#include "compiler/fields/divide_land.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/segment.h"

namespace citykiln::charts {
namespace {

using map::AreaFeature;
using map::LandCoverClass;

/// Borders are looked at this often, and neighbours share at least this much.
constexpr double kLookAlong_m = 8, kLeastShared_m = 16;
constexpr double kLandBucket_m = 128;
/// Smaller pieces of divided land are in no field (fields/divide_land.h).
constexpr double kLeastPart = 1.0 / 12;

bool is_whole_field(const AreaFeature& area, const Box2& extent) {
  const bool is_land = area.surface == LandCoverClass::kFarmland || area.surface == LandCoverClass::kMeadow;
  if (!is_land || area.plant_tags != map::PlantTags{} || area.polygon.outer.size() < 3) return false;
  const Box2 box = box_of(area.polygon.outer);
  return extent.contains(box.min) && extent.contains(box.max);
}

/// The edges of polygons, with the number of the polygon of each.
struct EdgesOfPolygons {
  std::vector<BorderPiece> edges;
  std::vector<std::size_t> owners;
  BoxGrid grid;
};

EdgesOfPolygons edges_of(std::span<const Polygon* const> polygons) {
  EdgesOfPolygons all;
  std::vector<Box2> boxes;
  for (std::size_t owner = 0; owner < polygons.size(); ++owner)
    for (const Ring* ring : rings_of(*polygons[owner]))
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const Vec2 a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
        all.edges.emplace_back(a, b), all.owners.push_back(owner), boxes.push_back(box_of_segment(a, b));
      }
  if (!boxes.empty()) all.grid = grid_of(boxes, kLandBucket_m);
  return all;
}

/// Calls visit(a, b, other) for each piece of an outline that lies near another polygon: the piece, and both polygons.
template <typename Visit>
void for_each_shared_piece(const EdgesOfPolygons& all, double gap_m, Visit visit) {
  for (std::size_t e = 0; e < all.edges.size(); ++e) {
    const auto& [a, b] = all.edges[e];
    const int looks = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kLookAlong_m)));
    for (int k = 0; k < looks; ++k) {
      const Vec2 from = a + (b - a) * (static_cast<double>(k) / looks), to = a + (b - a) * ((k + 1.0) / looks);
      const Vec2 at = (from + to) * 0.5;
      for (const std::uint32_t i : boxes_about(all.grid, Box2{at, at}.widened(gap_m)))
        if (all.owners[i] != all.owners[e] && distance_to_segment(all.edges[i].first, all.edges[i].second, at) <= gap_m)
          if (visit(BorderPiece{from, to}, all.owners[e], all.owners[i])) break;
    }
  }
}

/// Sets of numbers that are joined in pairs.
class JoinedNumbers {
 public:
  explicit JoinedNumbers(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }
  std::size_t lowest(std::size_t n) {
    while (parents_[n] != n) n = parents_[n] = parents_[parents_[n]];
    return n;
  }
  void join(std::size_t a, std::size_t b) {
    a = lowest(a), b = lowest(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parents_;
};

bool are_in_one_square(const AreaFeature& a, const AreaFeature& b) {
  const auto square_of = [](const AreaFeature& field) {
    const Vec2 at = box_of(field.polygon.outer).centre();
    return std::pair(std::floor(at.x / kLandSquare_m), std::floor(at.y / kLandSquare_m));
  };
  return square_of(a) == square_of(b);
}

/// The fields of one class in sets of neighbours, each sorted.
std::vector<std::vector<const AreaFeature*>> neighbourhoods(const std::vector<const AreaFeature*>& fields) {
  std::vector<const Polygon*> polygons;
  for (const AreaFeature* field : fields) polygons.push_back(&field->polygon);
  std::map<std::pair<std::size_t, std::size_t>, double> shared_m;
  for_each_shared_piece(edges_of(polygons), kFieldGap_m,
                        [&](const BorderPiece& piece, std::size_t own, std::size_t other) {
                          shared_m[{own, other}] += distance(piece.first, piece.second);
                          return true;
                        });
  JoinedNumbers joined(fields.size());
  for (const auto& [pair, length_m] : shared_m)
    if (length_m >= kLeastShared_m && are_in_one_square(*fields[pair.first], *fields[pair.second]))
      joined.join(pair.first, pair.second);
  std::vector<std::vector<const AreaFeature*>> sets(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) sets[joined.lowest(i)].push_back(fields[i]);
  std::erase_if(sets, [](const auto& set) { return set.size() < 2; });
  return sets;
}

Land joined_land(std::vector<const AreaFeature*> fields) {
  Land land{.id = fields.front()->id, .surface = fields.front()->surface, .fields = {}, .outlines = {}, .borders = {}};
  std::vector<const Polygon*> polygons;
  std::vector<OwnedSegment> segments;
  for (const AreaFeature* field : fields) {
    polygons.push_back(&field->polygon);
    for (const Ring* ring : rings_of(field->polygon)) add_ring(segments, *ring, 0);
  }
  land.borders = inner_borders(polygons, kFieldGap_m);
  for (const auto& [a, b] : land.borders)
    for (const Ring& strip : fields::strip_about({a, b}, kFieldGap_m / 2)) add_ring(segments, strip, 0);
  land.outlines = std::move(overlay(segments, 1).front());
  land.fields = std::move(fields);
  return land;
}

}  // namespace

std::vector<BorderPiece> inner_borders(std::span<const Polygon* const> polygons, double gap_m) {
  std::vector<BorderPiece> borders;
  for_each_shared_piece(edges_of(polygons), gap_m, [&](const BorderPiece& piece, std::size_t, std::size_t) {
    // pieces of one edge that follow each other are one piece
    if (!borders.empty() && borders.back().second == piece.first &&
        cross(unit(borders.back().second - borders.back().first), unit(piece.second - piece.first)) == 0)
      borders.back().second = piece.second;
    else
      borders.push_back(piece);
    return true;
  });
  return borders;
}

std::vector<Land> lands_of(const map::Features& features) {
  std::vector<Land> lands;
  for (const LandCoverClass surface : {LandCoverClass::kFarmland, LandCoverClass::kMeadow}) {
    std::vector<const AreaFeature*> fields;
    for (const AreaFeature& area : features.areas)
      if (area.surface == surface && is_whole_field(area, features.extent)) fields.push_back(&area);
    for (std::vector<const AreaFeature*>& set : neighbourhoods(fields)) lands.push_back(joined_land(std::move(set)));
  }
  std::ranges::sort(lands, {}, &Land::id);
  return lands;
}

void join_fields(map::Features& features) {
  std::vector<AreaFeature> joined;
  std::vector<const AreaFeature*> gone;
  for (const Land& land : lands_of(features)) {
    gone.insert(gone.end(), land.fields.begin(), land.fields.end());
    for (const Polygon& outline : land.outlines) {
      joined.push_back(*land.fields.front());
      joined.back().polygon = outline, joined.back().area_m2 = area_m2(outline);
    }
  }
  std::ranges::sort(gone);
  for (const AreaFeature& area : features.areas)
    if (!std::ranges::binary_search(gone, &area)) joined.push_back(area);
  std::ranges::stable_sort(joined, {}, &AreaFeature::id);
  features.areas = std::move(joined);
  features.barriers.clear(), features.tree_rows.clear();
}

DividingWays dividing_ways(const map::Features& features) {
  DividingWays ways;
  for (const map::Track& track : features.tracks)
    if (track.passage == map::Passage::kGround) ways.all.push_back(track.axis);
  for (const map::Waterway& water : features.waterways)
    if (water.passage == map::Passage::kGround) ways.all.push_back(water.axis);
  std::vector<Box2> boxes;
  for (const Polyline& line : ways.all)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      ways.pieces.emplace_back(line[i], line[i + 1]), boxes.push_back(box_of_segment(line[i], line[i + 1]));
  if (!boxes.empty()) ways.grid = grid_of(boxes, kLandBucket_m);
  return ways;
}

std::vector<Polygon> parts_between(const Polygon& field, const DividingWays& ways) {
  const Box2 box = box_of(field.outer);
  std::vector<Polygon> strips;
  if (!ways.pieces.empty())
    for (const std::uint32_t i : boxes_about(ways.grid, box)) {
      const auto& [a, b] = ways.pieces[i];
      if (!box_of_segment(a, b).touches(box)) continue;
      for (Ring& strip : fields::strip_about({a, b}, fields::kLineGap_m / 2)) strips.push_back({std::move(strip), {}});
    }
  std::vector<Polygon> parts = strips.empty() ? std::vector{field} : difference(field, strips);
  const double least_m2 = std::max(kLeastField_m2, area_m2(field) * kLeastPart);
  std::erase_if(parts, [&](const Polygon& part) { return area_m2(part) < least_m2; });
  return parts;
}

}  // namespace citykiln::charts
