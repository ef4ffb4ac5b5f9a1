#include "compiler/lots/lay_yard.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::lots {
namespace {

using map::BuildingClass;

// Paths and drives begin below the pavement.
constexpr double kBelowPavement_m = 0.25;
// The front yard ends a little behind the front wall, below the house.
constexpr double kBehindFront_m = 0.25;
// Front yards narrower than this are not seen beside the pavement, or have no path.
constexpr double kLeastSeen_m = 0.3125, kLeastFront_m = 0.75;
// From the wall of a side door to the path along the house.
constexpr double kBesideHouse_m = 1.25;
// A path ends below the wall.
constexpr double kBelowWall_m = 0.25;
// Spacing of tests for room.
constexpr double kRoomStep_m = 0.5;
// A drive past the house goes on behind its front wall by this. A car in front of the house needs this much.
constexpr double kPastFront_m = 6, kCarLength_m = 5.5;
// The first is the distance of drives to walls and the lot's border, on which a fence may stand; the second that of
// paths and drives to mapped things.
constexpr double kBesideDrive_m = 0.4375, kClearOfMapped_m = 0.5;
// A row of bays and its lane (pitches/pitches.inc).
constexpr double kBaysDepth_m = 11;
// Sheds of this size, with a plain class, may be garages.
constexpr double kLeastGarage_m2 = 12, kLargestGarage_m2 = 60;
// Private ways and car parks count as the lot's if they lie in it, or touch its border within this distance.
constexpr double kTouchesLot_m = 1;

// The part of a polygon with y below a limit in the frame.
std::vector<Polygon> part_below(const Polygon& polygon, const Frame& frame, double limit_m) {
  std::vector<Ring> rings;
  for (const Ring* ring : rings_of(polygon)) {
    Ring clipped;
    for (std::size_t i = 0; i < ring->size(); ++i) {
      const Vec2 a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
      const double ya = frame.local(a).y - limit_m, yb = frame.local(b).y - limit_m;
      if (ya <= 0) clipped.push_back(a);
      if ((ya < 0) != (yb < 0) && ya != yb) clipped.push_back(snapped(a + (b - a) * (ya / (ya - yb))));
    }
    if (Ring clean = without_repeats(clipped); clean.size() >= 3) rings.push_back(std::move(clean));
  }
  return united(rings);
}

// The rectangle about a segment.
Polygon strip_about(Vec2 a, Vec2 b, double width_m) {
  const Vec2 aside = left_of(unit(b - a)) * (width_m / 2);
  return {.outer = {snapped(a - aside), snapped(b - aside), snapped(b + aside), snapped(a + aside)}, .holes = {}};
}

struct YardLayer {
  const map::FeatureView& features;
  const Lot& lot;
  const YardRule& rule;
  const MappedThings& mapped;
  YardGround ground{};

  bool is_in_lot(Vec2 p) const { return contains(lot.parcel.polygon, p); }

  // True if a place of a path or drive is free. Places before y = 0 lie below the pavement.
  bool is_free(Vec2 p) const {
    if (lot.frame.local(p).y > kBelowPavement_m && !is_in_lot(p)) return false;
    return !is_inside_any(mapped.buildings, p) && !is_inside_any(mapped.pools, p) &&
           clearance_m(mapped.barriers, p, kClearOfMapped_m) >= kClearOfMapped_m &&
           clearance_m(mapped.trees, p, kClearOfMapped_m) >= kClearOfMapped_m;
  }

  // True if a strip from a to b in the frame is free; its ends lie on its middle line.
  bool is_strip_free(Vec2 a, Vec2 b, double width_m) const {
    const double length = distance(a, b);
    const Vec2 along = unit(b - a), aside = left_of(along);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kRoomStep_m)));
    // houses stand at the far end
    for (int i = steps; i >= 0; --i)
      for (const double share : {-0.5, 0.0, 0.5}) {
        const Vec2 p = a + along * (length * i / steps) + aside * (width_m * share);
        if (!is_free(lot.frame.plane(p))) return false;
      }
    return true;
  }

  // True if a capsule lies partly in the lot or touches its border.
  bool touches_lot(const Capsules& capsules) const {
    if (capsules.all.empty()) return false;
    if (axis_enters(capsules, lot.parcel.polygon)) return true;
    return std::ranges::any_of(lot.parcel.polygon.outer,
                               [&](Vec2 p) { return clearance_m(capsules, p, kTouchesLot_m) < kTouchesLot_m; });
  }

  // A path mapped in the lot, not only beside it.
  bool has_mapped_path() const {
    if (mapped.paths.all.empty()) return false;
    const Ring& ring = lot.parcel.polygon.outer;
    for (const std::uint32_t i : boxes_about(mapped.paths.grid, box_of(ring))) {
      const Capsule& c = mapped.paths.all[i];
      for (const double share : {0.25, 0.5, 0.75})
        if (is_in_lot(c.a + (c.b - c.a) * share)) return true;
    }
    return false;
  }

  void add(map::LandCoverClass surface, Polygon polygon) {
    if (signed_area_m2(polygon.outer) < 0) std::ranges::reverse(polygon.outer);
    if (polygon.outer.size() >= 3) ground.areas.push_back({surface, std::move(polygon)});
  }

  void add_strip(map::LandCoverClass surface, Vec2 a, Vec2 b, double width_m) {
    const Vec2 from = lot.frame.plane(a), to = lot.frame.plane(b);
    add(surface, strip_about(from, to, width_m));
    ground.openings.push_back({from, to, width_m / 2});
  }

  bool has_bays() const {
    const bool has_customers = lot.kind == LotKind::kShop || lot.kind == LotKind::kWorks;
    return has_customers && lot.setback_m >= kBaysDepth_m && !touches_lot(mapped.parking);
  }

  void lay_surfaces() {
    add(rule.rear, lot.parcel.polygon);
    const bool is_with_bays = has_bays();
    if ((rule.front == rule.rear && !is_with_bays) || lot.setback_m < kLeastSeen_m) return;
    for (Polygon& part : part_below(lot.parcel.polygon, lot.frame, lot.setback_m + kBehindFront_m)) {
      if (area_m2(part) < 1) continue;
      add(rule.front, std::move(part));
      ground.areas.back().has_bays = is_with_bays;
    }
  }

  void lay_path() {
    if (!lot.door || has_mapped_path()) return;
    const Vec2 door = lot.frame.local(lot.door->at);
    const Vec2 outward{dot(lot.door->outward, lot.frame.along), dot(lot.door->outward, lot.frame.inward)};
    if (door.y < kLeastFront_m) return;
    const Vec2 on_wall = door - outward * kBelowWall_m, before = door + outward * kRoomStep_m;
    const Vec2 aside = door + outward * kBesideHouse_m;
    // a door in the front leads straight to the street, one in a side first away from the wall
    const bool is_front = outward.y < -0.7;
    const Vec2 turn = is_front ? door : aside, street{turn.x, -kBelowPavement_m};
    if (turn.y < kLeastFront_m || !is_strip_free(is_front ? before : aside, street, kYardPath_m)) return;
    if (is_front) return add_path(on_wall, street);
    if (outward.y > 0.7 || !is_strip_free(before, aside, kYardPath_m / 2)) return;
    add_path(on_wall, aside + outward * (kYardPath_m / 2));
    add_path(Vec2{aside.x, aside.y + kYardPath_m / 2}, street);
  }

  void add_path(Vec2 a, Vec2 b) {
    add_strip(rule.path, a, b, kYardPath_m);
    ground.has_path = true;
  }

  bool is_garage(const map::Footprint& f) const {
    const auto own = static_cast<BuildingClass>(f.building_class);
    const double area = area_m2(f.polygon);
    return own == BuildingClass::kGarage ||
           (own == BuildingClass::kPlain && area >= kLeastGarage_m2 && area <= kLargestGarage_m2);
  }

  // A drive that ends at a garage of the lot.
  bool lay_drive_to_garage() {
    for (const std::uint32_t f : lot.footprints) {
      if (f == lot.main || !is_garage(features.footprints[f])) continue;
      Box2 box;
      for (const Vec2 p : features.footprints[f].polygon.outer) box.grow(lot.frame.local(p));
      const Vec2 to{box.centre().x, box.min.y};
      const double test_m = to.y - kBesideDrive_m;
      if (test_m < 1 || !is_strip_free({to.x, -kBelowPavement_m}, {to.x, test_m}, kDriveWidth_m)) continue;
      add_strip(rule.drive, {to.x, -kBelowPavement_m}, {to.x, to.y + kBelowWall_m}, kDriveWidth_m);
      return true;
    }
    return false;
  }

  // The place across the lot, farthest from another one, at which a drive up to `end_m` is free.
  std::optional<double> drive_place(double end_m, Vec2 away_from) const {
    Box2 box;
    for (const Vec2 p : lot.parcel.polygon.outer) box.grow(lot.frame.local(p));
    std::vector<double> places;
    for (double x = std::floor(box.min.x / kRoomStep_m) * kRoomStep_m; x <= box.max.x; x += kRoomStep_m)
      places.push_back(x);
    std::ranges::sort(places, std::greater{}, [&](double x) { return std::pair(std::abs(x - away_from.x), x); });
    for (const double x : places)
      if (is_strip_free({x, -kBelowPavement_m}, {x, end_m}, kDriveWidth_m + 2 * kBesideDrive_m)) return x;
    return std::nullopt;
  }

  void lay_drive() {
    if (!rule.has_drive || touches_lot(mapped.drives) || touches_lot(mapped.parking)) return;
    if (lay_drive_to_garage()) {
      ground.has_drive = true;
      return;
    }
    Box2 house;
    for (const Vec2 p : features.footprints[lot.main].polygon.outer) house.grow(lot.frame.local(p));
    const double past_m = lot.setback_m + std::min(kPastFront_m, house.height());
    std::optional<double> at = drive_place(past_m, house.centre());
    double end_m = past_m;
    if (!at && lot.setback_m >= kCarLength_m) {
      end_m = lot.setback_m - kBesideDrive_m;
      at = drive_place(end_m, lot.door ? lot.frame.local(lot.door->at) : house.centre());
    }
    if (!at) return;
    add_strip(rule.drive, {*at, -kBelowPavement_m}, {*at, end_m}, kDriveWidth_m);
    ground.has_drive = true;
  }
};

}  // namespace

YardGround lay_yard(const map::FeatureView& features, const Lot& lot, const YardRule& rule,
                    const MappedThings& mapped) {
  YardLayer layer{features, lot, rule, mapped};
  layer.lay_surfaces();
  layer.lay_path();
  layer.lay_drive();
  return std::move(layer.ground);
}

}  // namespace citykiln::lots
