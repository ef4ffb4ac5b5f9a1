#include "compiler/lots/lay_yard.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "compiler/geometry/snap.h"
#include "compiler/lots/draw_yard.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::lots {
namespace {

using map::BuildingClass;

// Paths and drives begin below the pavement.
constexpr double kBelowPavement_m = 0.25;
// Narrower front yards have no path.
constexpr double kLeastFront_m = 0.75;
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

// A place in the frame on the grid of recipes.
Vec2 on_grid(Vec2 p) { return snapped_to(kYardStep_m, p); }

struct YardLayer {
  const map::FeatureView& features;
  const Lot& lot;
  const YardRule& rule;
  const MappedThings& mapped;
  const Frame frame = frame_at(lot.frame);
  YardLayout layout{};

  bool is_in_lot(Vec2 p) const { return contains(lot.parcel.polygon, p); }

  // True if a place of a path or drive is free. It may lie below the pavement.
  bool is_free(Vec2 p) const {
    if (frame.local(p).y > kUnderPavement_m && !is_in_lot(p)) return false;
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
        if (!is_free(frame.plane(p))) return false;
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

  void add_strip(bool is_drive, Vec2 from, Vec2 to) { layout.strips.push_back({is_drive, on_grid(from), on_grid(to)}); }

  bool has_bays() const {
    const bool has_customers = lot.kind == LotKind::kShop || lot.kind == LotKind::kWorks;
    return has_customers && lot.setback_m >= kBaysDepth_m && !touches_lot(mapped.parking);
  }

  void lay_path() {
    if (!lot.door || has_mapped_path()) return;
    const Vec2 door = on_grid(frame.local(lot.door->at));
    const Vec2 outward{dot(lot.door->outward, frame.along), dot(lot.door->outward, frame.inward)};
    if (door.y < kLeastFront_m) return;
    const Vec2 before = door + outward * kRoomStep_m;
    const Vec2 aside = door + outward * kBesideHouse_m;
    // a door in the front leads straight to the street, one in a side first away from the wall
    const bool is_front = outward.y < -0.7;
    const Vec2 turn = is_front ? door : aside, street{turn.x, -kBelowPavement_m};
    if (turn.y < kLeastFront_m || !is_strip_free(is_front ? before : aside, street, kYardPath_m)) return;
    if (is_front) return add_strip(false, door + Vec2{0, kBelowWall_m}, street);
    if (outward.y > 0.7 || !is_strip_free(before, aside, kYardPath_m / 2)) return;
    add_strip(false, door - outward * kBelowWall_m, aside + outward * (kYardPath_m / 2));
    add_strip(false, {aside.x, aside.y + kYardPath_m / 2}, street);
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
      for (const Vec2 p : features.footprints[f].polygon.outer) box.grow(frame.local(p));
      const Vec2 to{box.centre().x, box.min.y};
      const double test_m = to.y - kBesideDrive_m;
      if (test_m < 1 || !is_strip_free({to.x, -kBelowPavement_m}, {to.x, test_m}, kDriveWidth_m)) continue;
      add_strip(true, {to.x, to.y + kBelowWall_m}, {to.x, -kBelowPavement_m});
      return true;
    }
    return false;
  }

  // The place across the lot, farthest from another one, at which a drive up to `end_m` is free.
  std::optional<double> drive_place(double end_m, Vec2 away_from) const {
    Box2 box;
    for (const Vec2 p : lot.parcel.polygon.outer) box.grow(frame.local(p));
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
    if (lay_drive_to_garage()) return;
    Box2 house;
    for (const Vec2 p : features.footprints[lot.main].polygon.outer) house.grow(frame.local(p));
    const double past_m = lot.setback_m + std::min(kPastFront_m, house.height());
    std::optional<double> at = drive_place(past_m, house.centre());
    double end_m = past_m;
    if (!at && lot.setback_m >= kCarLength_m) {
      end_m = lot.setback_m - kBesideDrive_m;
      at = drive_place(end_m, lot.door ? frame.local(lot.door->at) : house.centre());
    }
    if (at) add_strip(true, {*at, end_m}, {*at, -kBelowPavement_m});
  }
};

}  // namespace

YardLayout lay_yard(const map::FeatureView& features, const Lot& lot, const YardRule& rule,
                    const MappedThings& mapped) {
  YardLayer layer{features, lot, rule, mapped};
  layer.layout.has_bays = layer.has_bays();
  layer.lay_path();
  layer.lay_drive();
  return std::move(layer.layout);
}

}  // namespace citykiln::lots
