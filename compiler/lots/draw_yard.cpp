#include "compiler/lots/draw_yard.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/lots/land_of.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::lots {
namespace {

using map::BarrierKind;

// Pieces of a front yard that are smaller are left out.
constexpr double kLeastFront_m2 = 1;
constexpr double kLongestSegment_m = 0.5;
// The largest ratio of a mitre to the inset.
constexpr double kLeastMitreCosine = 0.5;
// Plants: the squares of their grid, and their distance from the border.
constexpr double kSquare_m = 4, kMostMoved_m = 1.2, kPlantToBorder_m = 0.75;
// Shrubs of gardens, as they are kept.
constexpr double kLeastShrub_m = 0.75, kHighestShrub_m = 1.75;
// Draws of one square: their first index follows from the square, within the lot.
constexpr std::uint32_t kDraws = 4, kFirstDraw = 16;
// Areas and plants are numbered; ids of barriers leave room for pieces at the extent's border.
constexpr std::uint32_t kPartsOfBarrier = 4;

Vec2 on_map(Vec2 p) { return snapped_to(map::kMapStep_m, p); }

// The part of a polygon with y below a limit in the frame.
std::vector<Polygon> part_below(const Polygon& polygon, const Frame& frame, double limit_m) {
  std::vector<Ring> rings;
  for (const Ring* ring : rings_of(polygon)) {
    Ring clipped;
    for (std::size_t i = 0; i < ring->size(); ++i) {
      const Vec2 a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
      const double ya = frame.local(a).y - limit_m, yb = frame.local(b).y - limit_m;
      if (ya <= 0) clipped.push_back(a);
      if ((ya < 0) != (yb < 0) && ya != yb) clipped.push_back(on_map(a + (b - a) * (ya / (ya - yb))));
    }
    if (Ring clean = without_repeats(clipped); clean.size() >= 3) rings.push_back(std::move(clean));
  }
  return united(rings);
}

// The rectangle about a segment, counter-clockwise.
Ring rectangle_about(const Capsule& strip) {
  const Vec2 aside = left_of(unit(strip.b - strip.a)) * strip.radius_m;
  return {on_map(strip.a - aside), on_map(strip.b - aside), on_map(strip.b + aside), on_map(strip.a + aside)};
}

struct Drawer {
  const Yard& yard;
  const YardRule& rule;
  DrawnYard drawn{};

  ObjectId id_of(std::uint32_t n) const { return derived_id(yard.building, kPartsOfYard, n); }

  void add_area(map::LandCoverClass surface, Polygon polygon) {
    if (polygon.outer.size() < 3) return;
    const auto id = id_of(static_cast<std::uint32_t>(drawn.areas.size()));
    const double area = area_m2(polygon);
    drawn.areas.push_back({.id = id, .polygon = std::move(polygon), .surface = surface, .area_m2 = area});
  }

  void add_surfaces() {
    add_area(rule.rear, yard.polygon);
    if (rule.front == rule.rear && !yard.has_bays) return;
    if (yard.setback_m < kLeastSeen_m && !rule.is_paved_front) return;
    for (Polygon& part : part_below(yard.polygon, frame_at(yard.frame), rule.front_m)) {
      if (area_m2(part) < kLeastFront_m2) continue;
      add_area(rule.front, std::move(part));
      if (yard.has_bays) drawn.bays.push_back({drawn.areas.back().id, kBays});
    }
  }

  void add_strips() {
    const std::vector<Capsule> openings = openings_of(yard);
    for (std::size_t i = 0; i < openings.size(); ++i)
      add_area(yard.strips[i].is_drive ? rule.drive : rule.path, {rectangle_about(openings[i]), {}});
  }

  static double width_of(BarrierKind kind) {
    return kind == BarrierKind::kHedge ? 0.625 : kind == BarrierKind::kWall ? 0.25 : 0.125;
  }

  void add_barriers() {
    const std::vector<BorderSegment> segments = border_segments(yard.polygon.outer);
    std::uint32_t part = 0;
    for (const BorderRun& run : yard.borders) {
      const BorderRule& border = border_at(rule, run.place);
      if (!border.kind || run.first >= segments.size() || run.count - 1 >= segments.size() || part >= kPartsOfYard)
        continue;
      drawn.barriers.push_back({.id = id_of(part),
                                .axis = border_line(segments, run),
                                .kind = *border.kind,
                                .height_m = border.height_m,
                                .width_m = width_of(*border.kind),
                                .fence = border.fence});
      part += kPartsOfBarrier;
    }
  }

  void add_plants(std::uint64_t seed) {
    const std::vector<YardPlant> all = plants_drawn(yard, rule, seed);
    for (std::size_t i = 0; i < std::min(all.size(), yard.plants.size()); ++i) {
      if (!yard.plants[i]) continue;
      const map::PlantKind kind = all[i].is_shrub ? map::PlantKind::kBush : map::PlantKind::kUnknown;
      drawn.plants.push_back({.id = id_of(static_cast<std::uint32_t>(drawn.plants.size())),
                              .at = all[i].at,
                              .kind = map::PointKind::kTree,
                              .height_m = all[i].height_m,
                              .plant_tags = {.kind = kind}});
    }
  }
};

// A number of a square that does not depend on the lot's extent.
std::uint32_t draw_index(std::int64_t column, std::int64_t row) {
  const auto square = static_cast<std::uint32_t>((column & 0x3fff) << 14 | (row & 0x3fff));
  return kFirstDraw + kDraws * square;
}

// The plant that the seed draws in a square; nothing in most.
std::optional<YardPlant> plant_in(std::int64_t column, std::int64_t row, const YardRule& rule,
                                  const RandomSequence& draw) {
  constexpr double kSquare_m2 = kSquare_m * kSquare_m;
  const std::uint32_t index = draw_index(column, row);
  const double kept = draw.unit(index) * 100;
  if (kept >= (rule.trees + rule.shrubs) * kSquare_m2) return std::nullopt;
  const bool is_shrub = kept >= rule.trees * kSquare_m2;
  const Vec2 moved{draw.between(-kMostMoved_m, kMostMoved_m, index + 1),
                   draw.between(-kMostMoved_m, kMostMoved_m, index + 2)};
  const Vec2 middle{(static_cast<double>(column) + 0.5) * kSquare_m, (static_cast<double>(row) + 0.5) * kSquare_m};
  const double height_m = is_shrub ? draw.between(kLeastShrub_m, kHighestShrub_m, index + 3) : 0;
  return YardPlant{snapped_to(kYardStep_m, middle + moved), is_shrub, std::floor(height_m / kYardStep_m) * kYardStep_m};
}

bool is_on_soft_ground(const Yard& yard, const YardRule& rule, const Frame& frame, Vec2 p) {
  const bool is_front = rule.front != rule.rear && frame.local(p).y <= rule.front_m;
  return is_planted(is_front ? rule.front : rule.rear) && contains(yard.polygon, p) &&
         distance_to_ring(yard.polygon.outer, p) >= kPlantToBorder_m;
}

}  // namespace

std::vector<Capsule> openings_of(const Yard& yard) {
  const Frame frame = frame_at(yard.frame);
  std::vector<Capsule> openings;
  for (const YardStrip& strip : yard.strips)
    openings.push_back(
        {frame.plane(strip.from), frame.plane(strip.to), (strip.is_drive ? kDriveWidth_m : kYardPath_m) / 2});
  return openings;
}

std::vector<BorderSegment> border_segments(const Ring& ring) {
  std::vector<BorderSegment> segments;
  for (std::uint32_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const int count = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kLongestSegment_m)));
    const auto at = [&](int k) { return a + (b - a) * (static_cast<double>(k) / count); };
    for (int k = 0; k < count; ++k) segments.push_back({at(k), at(k + 1), i});
  }
  return segments;
}

double inset_m(BorderPlace place) { return place == BorderPlace::kStreet ? kUnderPavement_m + kInsidePavement_m : 0; }

Polyline border_line(std::span<const BorderSegment> segments, const BorderRun& run) {
  const double inset = inset_m(run.place);
  Polyline line;
  const auto add = [&](Vec2 p, Vec2 before, Vec2 after) {
    const Vec2 middle = before + after == Vec2{} ? before : unit(before + after);
    const Vec2 moved = on_map(p + left_of(middle) * (inset / std::max(kLeastMitreCosine, dot(middle, after))));
    if (line.empty() || line.back() != moved) line.push_back(moved);
  };
  const auto segment = [&](std::uint32_t i) { return segments[(run.first + i) % segments.size()]; };
  const auto along = [](const BorderSegment& s) { return unit(s.to - s.from); };
  add(segment(0).from, along(segment(0)), along(segment(0)));
  for (std::uint32_t i = 1; i < run.count; ++i)
    if (segment(i).edge != segment(i - 1).edge) add(segment(i).from, along(segment(i - 1)), along(segment(i)));
  const BorderSegment last = segment(run.count - 1);
  add(last.to, along(last), along(last));
  return line;
}

std::vector<YardPlant> plants_drawn(const Yard& yard, const YardRule& rule, std::uint64_t seed) {
  std::vector<YardPlant> plants;
  if (rule.trees + rule.shrubs <= 0) return plants;
  const RandomSequence draw = draws_of(yard, seed);
  const Frame frame = frame_at(yard.frame);
  const Box2 box = box_of(yard.polygon.outer);
  const auto first = [](double v) { return static_cast<std::int64_t>(std::floor(v / kSquare_m)); };
  for (std::int64_t row = first(box.min.y); row <= first(box.max.y); ++row)
    for (std::int64_t column = first(box.min.x); column <= first(box.max.x); ++column)
      if (const auto plant = plant_in(column, row, rule, draw);
          plant && is_on_soft_ground(yard, rule, frame, plant->at))
        plants.push_back(*plant);
  return plants;
}

DrawnYard draw_yard(const Yard& yard, std::uint64_t seed) {
  const std::optional<YardRule> rule = rule_of(yard, seed);
  if (!rule || yard.polygon.outer.size() < 3) return {};
  Drawer drawer{yard, *rule};
  drawer.add_surfaces();
  drawer.add_strips();
  drawer.add_barriers();
  drawer.add_plants(seed);
  return std::move(drawer.drawn);
}

}  // namespace citykiln::lots
