#include "compiler/invent/country/add_farm_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/invent/country/split_convex.h"
#include "compiler/invent/land/noise.h"

namespace citykiln::invent {
namespace {

// a field keeps off the line that divides it from its neighbour by this, with and without a hedge
constexpr double kHedgeMargin_m = 1.5, kFarmFieldMargin_m = 0.5;
// pieces of fields that are smaller, or narrower on average, stay free
constexpr double kLeastFarmField_m2 = 700, kLeastFarmFieldWidth_m = 9;
// hedges keep off roads and woods
constexpr double kHedgeOff_m = 3, kHedgeStep_m = 5;
constexpr double kFarmFieldEdge_m = 60;  // fields begin beyond the square, which cuts them

struct FarmFieldPiece {
  Ring ring;
  std::uint64_t id;  ///< By the splits that led to it.
};

double share_of(std::uint64_t id, std::uint64_t purpose) {
  return static_cast<double>(hash_of(static_cast<std::int64_t>(id), 17, purpose) >> 11) * 0x1p-53;
}

class FarmFieldDivider {
 public:
  FarmFieldDivider(const Terrain& terrain, const CountrySettings& settings, std::uint64_t seed, const TakenLand& taken,
                   InventedMap& map)
      : terrain_(terrain), settings_(settings), seed_(seed), taken_(taken), map_(map) {
    for (const InventedLine& line : map.lines)
      if (half_right_of_way_m(line) > 0) add_guides(line.axis);
    guides_grid_ = grid_of(guide_boxes_, 128);
  }

  void divide(double side_m) {
    const double half_m = side_m / 2 + kFarmFieldEdge_m;
    std::vector<FarmFieldPiece> whole,
        open = {{{{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}}, 1}};
    while (!open.empty()) {
      const FarmFieldPiece piece = std::move(open.back());
      open.pop_back();
      const double wanted_m2 = settings_.farm_field_ha * 1e4 * (0.6 + 1.1 * share_of(piece.id, seed_ + 1));
      if (signed_area_m2(piece.ring) <= wanted_m2)
        whole.push_back(piece);
      else
        split(piece, open);
    }
    const auto fields = for_each_slot<std::vector<InventedArea>>(
        whole.size(), 0, [&](std::size_t i) { return farm_fields_of(whole[i]); });
    for (const std::vector<InventedArea>& of_piece : fields)
      map_.areas.insert(map_.areas.end(), of_piece.begin(), of_piece.end());
  }

 private:
  void add_guides(const Polyline& axis) {
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      guides_.emplace_back(axis[i], axis[i + 1]);
      guide_boxes_.push_back(box_of(std::span(axis).subspan(i, 2)));
    }
  }

  /// The direction of the nearest road within 160 m, else of the contour on slopes.
  std::optional<Vec2> direction_at(Vec2 p) const {
    double least_m = 160;
    std::optional<Vec2> found;
    for (const std::uint32_t i : boxes_about(guides_grid_, Box2{p, p}.widened(least_m))) {
      const auto& [a, b] = guides_[i];
      const Vec2 along = b - a;
      const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
      const double away_m = distance(a + along * share, p);
      if (away_m < least_m) least_m = away_m, found = unit(along);
    }
    if (found) return found;
    constexpr double kAround_m = 40, kContourSlope = 0.05;
    const Vec2 fall{terrain_.height_m({p.x + kAround_m, p.y}) - terrain_.height_m({p.x - kAround_m, p.y}),
                    terrain_.height_m({p.x, p.y + kAround_m}) - terrain_.height_m({p.x, p.y - kAround_m})};
    if (length(fall) / (2 * kAround_m) > kContourSlope) return unit(left_of(fall));
    return std::nullopt;
  }

  /// The line that splits a piece across its longer extent, along or square to the direction of its place.
  std::pair<Vec2, Vec2> line_of_split(const FarmFieldPiece& piece) const {
    const Box2 box = box_of(piece.ring);
    // large pieces are split near their middle in any direction, which later splits follow
    const Vec2 wander = unit(Vec2{1, (share_of(piece.id, seed_ + 2) - 0.5) * 0.5});
    const Vec2 along = direction_at(box.centre()).value_or(wander), across = left_of(along);
    const auto extent = [&](Vec2 axis) {
      double low = 1e300, high = -1e300;
      for (const Vec2 p : piece.ring) low = std::min(low, dot(p, axis)), high = std::max(high, dot(p, axis));
      return std::pair(low, high);
    };
    const auto [low_u, high_u] = extent(along);
    const auto [low_v, high_v] = extent(across);
    const double share = 0.38 + 0.24 * share_of(piece.id, seed_ + 3);
    // strips along a slope or road are longer than they are wide
    if (high_u - low_u > (high_v - low_v) * 1.3) return {along * (low_u + (high_u - low_u) * share), across};
    return {across * (low_v + (high_v - low_v) * share), along};
  }

  void split(const FarmFieldPiece& piece, std::vector<FarmFieldPiece>& open) {
    const auto [on_line, direction] = line_of_split(piece);
    const bool has_hedge = share_of(piece.id, seed_ + 4) < settings_.hedge_share;
    const double margin_m = has_hedge ? kHedgeMargin_m : kFarmFieldMargin_m;
    const SplitConvex halves = split_convex(piece.ring, on_line, direction, margin_m);
    if (halves.left.empty() || halves.right.empty()) return;
    if (has_hedge) add_hedge(halves.from, halves.to, piece.id);
    open.push_back({halves.left, piece.id * 2});
    open.push_back({halves.right, piece.id * 2 + 1});
  }

  /// Adds the parts of a line that are on free land, each with a gate, and trees on it.
  void add_hedge(Vec2 from, Vec2 to, std::uint64_t id) {
    const double length_m = distance(from, to);
    const int steps = static_cast<int>(length_m / kHedgeStep_m);
    Polyline part;
    const auto finish = [&] {
      if (part.size() >= 4) add_hedge_part(part, id);
      part.clear();
    };
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = from + (to - from) * (i / std::max(1.0, static_cast<double>(steps)));
      const bool is_gate = i % 24 == static_cast<int>(share_of(id, seed_ + 5) * 24);
      if (is_gate || taken_.distance_m(p, kHedgeOff_m) < kHedgeOff_m || terrain_.is_water(p))
        finish();
      else
        part.push_back(p);
    }
    finish();
  }

  void add_hedge_part(const Polyline& part, std::uint64_t id) {
    map_.lines.push_back({{part.front(), part.back()},
                          {{"barrier", "hedge"}, {"height", share_of(id, seed_ + 6) < 0.5 ? "1.8" : "2.5"}}});
    for (std::size_t i = 1; i + 1 < part.size(); ++i)
      if (share_of(id * 131 + i, seed_ + 7) < 0.12)
        map_.points.push_back({part[i], {{"leaf_type", "broadleaved"}, {"natural", "tree"}}});
  }

  /// The free parts of a piece, as fields.
  std::vector<InventedArea> farm_fields_of(const FarmFieldPiece& piece) const {
    std::vector<InventedArea> fields;
    for (Polygon& field : difference({piece.ring, {}}, taken_.polygons_near(box_of(piece.ring)))) {
      const double area = area_m2(field);
      double border_m = 0;
      for (const Ring* ring : rings_of(field)) border_m += length_m(*ring) + distance(ring->back(), ring->front());
      // twice the area by half the border: the width of a long strip
      if (area < kLeastFarmField_m2 || 2 * area / border_m < kLeastFarmFieldWidth_m) continue;
      Tags tags = tags_of(field, piece.id);
      fields.push_back({std::move(field), std::move(tags)});
    }
    return fields;
  }

  Tags tags_of(const Polygon& field, std::uint64_t id) const {
    const Vec2 middle = box_of(field.outer).centre();
    const double slope =
        length(Vec2{terrain_.height_m({middle.x + 30, middle.y}) - terrain_.height_m({middle.x - 30, middle.y}),
                    terrain_.height_m({middle.x, middle.y + 30}) - terrain_.height_m({middle.x, middle.y - 30})}) /
        60;
    const double drawn = share_of(id, seed_ + 8);
    if (drawn < settings_.orchard_share && slope < settings_.farm_field_slope * 1.5)
      return {{"landuse", "orchard"}, {"trees", drawn < settings_.orchard_share / 2 ? "apple_trees" : "cherry_trees"}};
    const bool is_wet = terrain_.is_water(middle + Vec2{35, 0}) || terrain_.is_water(middle - Vec2{35, 0}) ||
                        terrain_.is_water(middle + Vec2{0, 35}) || terrain_.is_water(middle - Vec2{0, 35});
    if (slope > settings_.farm_field_slope || is_wet || drawn > 0.72) return {{"landuse", "meadow"}};
    constexpr const char* kCrops[] = {"wheat", "barley", "maize", "rape", "sugar_beet"};
    return {{"crop", kCrops[hash_of(static_cast<std::int64_t>(id), 3, seed_) % 5]}, {"landuse", "farmland"}};
  }

  const Terrain& terrain_;
  const CountrySettings& settings_;
  std::uint64_t seed_;
  const TakenLand& taken_;
  InventedMap& map_;
  std::vector<std::pair<Vec2, Vec2>> guides_;
  std::vector<Box2> guide_boxes_;
  BoxGrid guides_grid_;
};

}  // namespace

void add_farm_fields(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                     const TakenLand& taken, InventedMap& map) {
  FarmFieldDivider(terrain, settings, seed, taken, map).divide(side_m);
}

}  // namespace citykiln::invent
