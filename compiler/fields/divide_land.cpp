#include "compiler/fields/divide_land.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/fields/cut_rings.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"
#include "compiler/parcels/tight_box.h"

namespace citykiln::fields {
namespace {

// Pieces within this factor of the usual area are not split, and smaller ones than this share are in no field.
constexpr double kNearUsual = 1.4, kLeastShare = 1.0 / 12;
// A split is off the middle by up to this share of the side.
constexpr double kOffMiddle = 0.1;
// Half a mile, the side of a quarter section.
constexpr double kHalfMile_m = 804.672;
// 2^12 fields a face: more than a face of kWholeFace_m can have
constexpr int kMostSplits = 12;

std::uint64_t place_of(Vec2 p) {
  const auto step = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v * 128))); };
  return step(p.x) << 32 ^ (step(p.y) & 0xffffffffu);
}

Vec2 lowest(const Polygon& polygon) { return *std::ranges::min_element(polygon.outer); }

// The line about a place, and the side of it on which a quarter lies: its left.
struct Cut {
  Vec2 at, along;
};

// The part of the plane that is nearer to its site than to others.
struct Quarter {
  Vec2 site;
  std::vector<Cut> sides;
};

Vec2 site_of(int column, int row, std::uint64_t seed) {
  const RandomSequence draw(
      seed, stable_id(StableId{static_cast<std::uint64_t>(column)}, "quarter", static_cast<std::uint64_t>(row)),
      "field quarter");
  return snapped_to(map::kMapStep_m, Vec2{(column + draw.between(0.2, 0.8, 0)) * kQuarter_m,
                                          (row + draw.between(0.2, 0.8, 1)) * kQuarter_m});
}

Quarter quarter_of(int column, int row, std::uint64_t seed) {
  Quarter quarter{site_of(column, row, seed), {}};
  for (int r = -2; r <= 2; ++r)
    for (int c = -2; c <= 2; ++c) {
      if (r == 0 && c == 0) continue;
      const Vec2 other = site_of(column + c, row + r, seed);
      // both quarters compute the line between them from the same numbers
      const Vec2 across = unit(quarter.site < other ? other - quarter.site : quarter.site - other);
      quarter.sides.push_back(
          {(quarter.site + other) * 0.5, quarter.site < other ? left_of(across) : left_of(across) * -1});
    }
  return quarter;
}

Quarter section_of(int column, int row) {
  const Vec2 low{column * kHalfMile_m, row * kHalfMile_m}, high{(column + 1) * kHalfMile_m, (row + 1) * kHalfMile_m};
  return {(low + high) * 0.5, {{low, {1, 0}}, {high, {0, 1}}, {high, {-1, 0}}, {low, {0, -1}}}};
}

class LandDivider {
 public:
  LandDivider(const RuleAt& rule_at, StableId id, std::uint64_t seed) : rule_at_(rule_at), id_(id), seed_(seed) {}

  void add_face(const Polygon& face) {
    const Box2 box = box_of(face.outer);
    const FieldRule rule = rule_at_(box.centre());
    if (rule.is_grid || std::max(box.width(), box.height()) > kWholeFace_m)
      add_quarters(face, box, rule.is_grid);
    else
      split(copied_rings(face), sized(rule, lowest(face)), kMostSplits);
  }

  Division finished() {
    std::ranges::sort(made_.fields, {}, &Field::number);
    std::ranges::sort(made_.borders, {}, &FieldBoundary::number);
    return std::move(made_);
  }

 private:
  // The rule of one face, whose fields are larger or smaller than usual.
  FieldRule sized(FieldRule rule, Vec2 at) const {
    rule.area_m2 *= draw_at(at).between(0.7, 1.4, 0);
    return rule;
  }

  RandomSequence draw_at(Vec2 at) const {
    return RandomSequence(seed_, stable_id(id_, "field", place_of(at)), "field split");
  }

  void add_quarters(const Polygon& face, const Box2& box, bool is_grid) {
    const double side_m = is_grid ? kHalfMile_m : kQuarter_m;
    const auto number = [&](double v) { return static_cast<int>(std::floor(v / side_m)); };
    for (int row = number(box.min.y) - 1; row <= number(box.max.y) + 1; ++row)
      for (int column = number(box.min.x) - 1; column <= number(box.max.x) + 1; ++column)
        add_quarter(face, is_grid ? section_of(column, row) : quarter_of(column, row, seed_));
  }

  void add_quarter(const Polygon& face, const Quarter& quarter) {
    std::vector<Ring> rings = copied_rings(face);
    for (const Cut& side : quarter.sides) {
      rings = left_of_cut(rings, side.at, side.along);
      if (rings.empty()) return;
    }
    // what a line cuts out of a face may be in several pieces
    for (const Polygon& piece : united(rings))
      split(copied_rings(piece), sized(rule_at_(quarter.site), lowest(piece)), kMostSplits);
  }

  void split(const std::vector<Ring>& rings, const FieldRule& rule, int depth) {
    if (depth == 0 || area_of(rings) <= rule.area_m2 * kNearUsual) return add_leaf(rings, rule);
    const parcels::TightBox box = parcels::tight_box(rings.front());
    const bool is_across =
        halves_fit(box.long_m / 2, box.short_m, rule.aspect) <= halves_fit(box.long_m, box.short_m / 2, rule.aspect);
    const Vec2 axis = is_across ? box.along : left_of(box.along);
    const double side_m = is_across ? box.long_m : box.short_m;
    const double off = draw_at(box.centre).between(-kOffMiddle, kOffMiddle, 1);
    const Vec2 at = box.centre + axis * (off * side_m), along = left_of(axis);
    const std::vector<Ring> left = left_of_cut(rings, at, along), right = left_of_cut(rings, at, along * -1);
    if (left.empty() || right.empty()) return add_leaf(rings, rule);
    for (const auto& [from, to] : inside_parts(rings, at, along))
      made_.borders.push_back({from, to, number_at((from + to) * 0.5)});
    split(left, rule, depth - 1), split(right, rule, depth - 1);
  }

  // How far the form of a half is from the usual one: 1 if they are equal.
  static double halves_fit(double length_m, double width_m, double aspect) {
    const double own = std::max(length_m, width_m) / std::max(std::min(length_m, width_m), 1e-3);
    return std::max(own / aspect, aspect / own);
  }

  void add_leaf(const std::vector<Ring>& rings, const FieldRule& rule) {
    for (Polygon& piece : united(rings)) {
      if (area_m2(piece) < rule.area_m2 * kLeastShare) continue;
      const Vec2 along = parcels::tight_box(piece.outer).along;
      const std::uint32_t number = number_at(lowest(piece));
      made_.fields.push_back({std::move(piece), along, number});
    }
  }

  std::uint32_t number_at(Vec2 at) const {
    const auto hash = static_cast<std::uint64_t>(stable_id(id_, "field", place_of(at)));
    return static_cast<std::uint32_t>(hash % kFirstFieldPart);
  }

  const RuleAt& rule_at_;
  StableId id_;
  std::uint64_t seed_;
  Division made_;
};

// Elements of equal numbers, which are one in 2^28 by chance, would have equal ids.
template <typename Element>
void keep_unique(std::vector<Element>& sorted) {
  const auto is_equal = [](const Element& a, const Element& b) { return a.number == b.number; };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), is_equal), sorted.end());
}

}  // namespace

Division divide(const Polygon& land, std::span<const Polyline> lines, const RuleAt& rule_at, StableId id,
                std::uint64_t seed) {
  std::vector<Polygon> strips;
  for (const Polyline& line : lines)
    for (Ring& strip : strip_about(line, kLineGap_m / 2)) strips.push_back({std::move(strip), {}});
  LandDivider divider(rule_at, id, seed);
  if (strips.empty())
    divider.add_face(land);
  else
    for (const Polygon& face : difference(land, strips)) divider.add_face(face);
  Division made = divider.finished();
  keep_unique(made.fields), keep_unique(made.borders);
  return made;
}

}  // namespace citykiln::fields
