#include "compiler/furniture/yard_things.h"

#include <algorithm>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/snap.h"
#include "compiler/lots/draw_yard.h"
#include "compiler/lots/yard_rules.h"
#include "compiler/things/facing.h"
#include "compiler/things/yard_kinds.h"

namespace citykiln::furniture {
namespace {

using lots::Yard;
using map::LandCoverClass;
using roadside::is_clear;
using things::YardKind;
using things::YardSpot;
using things::YardUse;

constexpr std::uint32_t kTries = 12, kDrawsOfPlace = 4;
constexpr double kApart_m = 0.75, kBinToWall_m = 0.6, kInsideBorder_m = 0.8;
// The rear begins behind the front wall of a usual house.
constexpr double kBehindFront_m = 3;
// The parts of ids of the kinds' things; gates have those after them.
constexpr std::uint32_t kPartsOfKinds = static_cast<std::uint32_t>(std::size(things::kYardKinds)) * things::kMostOfKind;
static_assert(kPartsOfKinds < lots::kPartsOfYard - 16);
constexpr double kGatePercent = 60, kHighestGate_m = 1.5, kGateDepth_m = 0.3;

YardUse use_of(lots::LotKind kind) {
  switch (kind) {
    case lots::LotKind::kApartments:
      return YardUse::kApartments;
    case lots::LotKind::kPerimeter:
    case lots::LotKind::kGreenCourt:
    case lots::LotKind::kPavedCourt:
      return YardUse::kCourt;
    case lots::LotKind::kShop:
      return YardUse::kShop;
    case lots::LotKind::kWorks:
      return YardUse::kWorks;
    case lots::LotKind::kSchool:
      return YardUse::kSchool;
    case lots::LotKind::kChurch:
      return YardUse::kChurch;
    case lots::LotKind::kStorage:
      return YardUse::kStorage;
    case lots::LotKind::kGreen:
      return YardUse::kGreen;
    case lots::LotKind::kAllotment:
      return YardUse::kAllotment;
    case lots::LotKind::kSite:
      return YardUse::kSite;
    default:
      return YardUse::kNone;
  }
}

bool is_home(const Yard& yard) { return yard.kind == lots::LotKind::kDetached || yard.kind == lots::LotKind::kRow; }

// True for classes of land on which plots lie, and which they leave as they are.
bool is_land_of_plots(LandCoverClass surface) {
  const map::LandCoverGroup group = map::values_of(surface).group;
  return group == map::LandCoverGroup::kTown || group == map::LandCoverGroup::kIndustry ||
         surface == LandCoverClass::kAllotments || surface == LandCoverClass::kUnknown;
}

// The rectangle that a thing of a yard takes.
struct YardRectangle {
  Vec2 at, right, back;  // unit vectors of its width and depth
  double width_m, depth_m;

  Vec2 corner(double x, double y, double margin_m) const {
    return at + right * (x * (width_m / 2 + margin_m)) + back * (y * (depth_m / 2 + margin_m));
  }
  bool is_apart(const YardRectangle& other) const {
    const double reach = (width_m + depth_m + other.width_m + other.depth_m) / 4 + kApart_m;
    return distance(at, other.at) >= reach;
  }
};

struct YardFurnisher {
  const roadside::TileRecipes& recipes;
  const roadside::ClearZones& zones;
  const Yard& yard;
  std::uint64_t seed;
  bool is_plot = false;
  lots::Frame frame = frame_at(yard.frame);
  std::vector<YardRectangle> taken{};

  // The random numbers of a kind of the yard's things.
  RandomSequence draws(const char* kind) const { return {seed, stable_id(yard.building), kind}; }

  bool is_own_ground(Vec2 p) const {
    if (!recipes.land_cover.box.contains(p)) return false;
    if (is_plot && !contains(yard.polygon, p)) return false;
    const std::uint32_t top = ground::land_cover_at(recipes.land_cover, p);
    if (top == ground::kNoLandCover) return is_plot;
    const ground::LandCoverPolygon& area = recipes.land_cover.surfaces[top];
    if (is_plot) return is_land_of_plots(area.surface) && !ground::is_yard(area);
    const bool is_usable = lots::is_planted(area.surface) || area.surface == LandCoverClass::kPavedYard ||
                           (area.surface == LandCoverClass::kAsphaltYard && !is_home(yard));
    return area.id.osm == yard.building.osm && is_usable;
  }

  bool is_free(const YardRectangle& place, double margin_m) const {
    // a path may cross a large thing between its corners
    for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0})
      for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0})
        if (!is_own_ground(place.corner(x, y, margin_m))) return false;
    const double reach_m = (place.width_m + place.depth_m) / 4 + kApart_m;
    return lots::clearance_m(zones.trunks, place.at, reach_m) >= reach_m &&
           std::ranges::all_of(taken, [&](const YardRectangle& other) { return place.is_apart(other); });
  }

  bool is_own_land(Vec2 p) const {
    if (!recipes.land_cover.box.contains(p)) return false;
    const std::uint32_t top = ground::land_cover_at(recipes.land_cover, p);
    if (top == ground::kNoLandCover) return false;
    const ground::LandCoverPolygon& area = recipes.land_cover.surfaces[top];
    return area.id.osm == yard.building.osm && map::values_of(area.surface).group != map::LandCoverGroup::kBuilding;
  }

  // True if a rectangle lies on ground of the yard, drives included, off trunks, doors and other things.
  bool is_open(const YardRectangle& place) const {
    constexpr int kParts = 4;
    for (int x = -kParts; x <= kParts; ++x)
      for (int y = -kParts; y <= kParts; ++y)
        if (!is_own_land(place.at + place.right * (x * place.width_m / (2 * kParts)) +
                         place.back * (y * place.depth_m / (2 * kParts))))
          return false;
    const OrientedRect rect{place.at, place.back, place.depth_m, place.width_m};
    return is_clear(zones.trunks, rect) && is_clear(zones.doors, rect) &&
           std::ranges::all_of(taken, [&](const YardRectangle& other) { return place.is_apart(other); });
  }

  // A place at the inner end of a drive, before or behind it.
  std::optional<YardRectangle> place_at_drive(const YardKind& kind) const {
    constexpr double kDriveBefore_m = 0.5, kBehindEnd_m = 0.125;
    const bool is_over = kind.spot == YardSpot::kOverDrive;
    for (const lots::YardStrip& strip : yard.strips) {
      const double inner_m = std::max(strip.from.y, strip.to.y), outer_m = std::min(strip.from.y, strip.to.y);
      if (!strip.is_drive || (is_over && inner_m - outer_m < kind.depth_m + kDriveBefore_m)) continue;
      const double y = is_over ? inner_m - kind.depth_m / 2 : inner_m + kBehindEnd_m + kind.depth_m / 2;
      const YardRectangle place{.at = frame.plane({strip.from.x, y}),
                                .right = frame.along * -1.0,
                                .back = frame.inward,
                                .width_m = kind.width_m,
                                .depth_m = kind.depth_m};
      if (is_open(place)) return place;
    }
    return std::nullopt;
  }

  double to_wall_m(Vec2 p, double search_m) const {
    const int buildings = map::values_of(LandCoverClass::kBuilding).priority;
    return ground::clearance_m(recipes.land_cover, p, buildings, search_m);
  }

  bool suits(const YardKind& kind, const YardRectangle& place) const {
    if (!recipes.land_cover.box.contains(place.at)) return false;
    if (kind.spot == YardSpot::kBesideHouse)
      return is_free(place, 0) && (is_home(yard) || is_off_doors(place)) &&
             to_wall_m(place.at, 2 * kBinToWall_m + kind.depth_m) < kBinToWall_m + kind.depth_m / 2;
    const bool is_rear = is_plot || frame.local(place.at).y > yard.setback_m + kBehindFront_m;
    const double margin_m = kind.spot == YardSpot::kBorder ? kInsideBorder_m / 2 : kApart_m;
    return is_rear && is_free(place, margin_m) && (is_home(yard) || is_off_doors(place));
  }

  bool is_off_doors(const YardRectangle& place) const {
    return roadside::is_clear(zones.doors, {place.at, place.back, place.depth_m, place.width_m}) &&
           !overlaps_any(zones.things, {place.at, place.back, place.depth_m, place.width_m}, 0);
  }

  // A place drawn in the box of the yard, aligned with its frame.
  YardRectangle drawn_place(const YardKind& kind, const RandomSequence& draw, std::uint32_t index) const {
    if (kind.spot == YardSpot::kBorder) return place_at_border(kind, draw, index);
    const Box2 box = box_of(yard.polygon.outer);
    const bool is_turned = draw.below(2, index + 2) == 0;
    const Vec2 right = is_turned ? frame.inward : frame.along;
    return {
        .at = snapped(Vec2{draw.between(box.min.x, box.max.x, index), draw.between(box.min.y, box.max.y, index + 1)}),
        .right = right,
        .back = left_of(right),
        .width_m = kind.width_m,
        .depth_m = kind.depth_m};
  }

  // A place drawn along the border, its back to it.
  YardRectangle place_at_border(const YardKind& kind, const RandomSequence& draw, std::uint32_t index) const {
    const Ring& ring = yard.polygon.outer;
    double left_m = draw.unit(index) * perimeter_m();
    std::size_t edge = 0;
    while (edge + 1 < ring.size() && left_m > distance(ring[edge], ring[edge + 1])) {
      left_m -= distance(ring[edge], ring[edge + 1]);
      ++edge;
    }
    const Vec2 along = unit(ring[(edge + 1) % ring.size()] - ring[edge]), inward = left_of(along);
    return {.at = snapped(ring[edge] + along * left_m + inward * (kind.depth_m / 2 + kInsideBorder_m)),
            .right = along * -1.0,
            .back = inward * -1.0,
            .width_m = kind.width_m,
            .depth_m = kind.depth_m};
  }

  double perimeter_m() const {
    const Ring& ring = yard.polygon.outer;
    double sum_m = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum_m += distance(ring[i], ring[(i + 1) % ring.size()]);
    return sum_m;
  }

  // How many of a kind the yard wants.
  std::uint32_t number_of(const YardKind& kind) const {
    if (is_home(yard)) {
      const things::YardShare share = things::yard_share(kind.name, yard.country);
      const int percent = yard.kind == lots::LotKind::kDetached ? share.detached_percent : share.row_percent;
      return 100 * draws(kind.name).unit(0) < percent ? 1 : 0;
    }
    const things::YardNumber wanted = things::yard_number(kind.name, use_of(yard.kind));
    const RandomSequence draw{seed, stable_id(stable_id(yard.building), "number", 0), kind.name};
    std::uint32_t number = 0;
    for (std::uint32_t i = 0; i < wanted.most; ++i) number += 100 * draw.unit(i) < wanted.percent ? 1 : 0;
    return number;
  }

  // The first free of the places that are drawn for the n-th of a kind. A wall is found less often than a garden.
  std::optional<YardRectangle> place_for(const YardKind& kind, std::uint32_t n) const {
    if (kind.spot == YardSpot::kBehindDrive || kind.spot == YardSpot::kOverDrive) return place_at_drive(kind);
    const RandomSequence draw = draws(kind.name);
    const std::uint32_t tries = is_home(yard) ? kTries : 2 * kTries;
    for (std::uint32_t i = 0; i < tries; ++i) {
      const std::uint32_t index = n == 0 ? 1 + 3 * i : 1 + kDrawsOfPlace * (2 * kTries * n + i);
      if (const YardRectangle place = drawn_place(kind, draw, index); suits(kind, place)) return place;
    }
    return std::nullopt;
  }
};

things::Thing thing_at(const YardFurnisher& furnisher, const YardRectangle& place, std::string_view kind,
                       double height_m, std::uint32_t number) {
  const Yard& yard = furnisher.yard;
  const auto variant = static_cast<std::uint8_t>(furnisher.draws("variants").below(things::kVariants, number));
  return {.id = derived_id(yard.building, lots::kPartsOfYard, number),
          .at = snapped(place.at),
          .direction = things::nearest_direction(place.back * -1.0),
          .form = {.kind = std::string(kind),
                   .width_m = snapped(place.width_m),
                   .depth_m = snapped(place.depth_m),
                   .height_m = snapped(height_m),
                   .country = yard.country,
                   .variant = variant}};
}

void add_kinds(YardFurnisher furnisher, std::vector<things::Thing>& made) {
  std::uint32_t number = 0;
  bool has_garage = false;
  for (const YardKind& kind : things::kYardKinds) {
    ++number;
    const bool is_of_drive = kind.spot == YardSpot::kBehindDrive || kind.spot == YardSpot::kOverDrive;
    const std::uint32_t wanted = is_of_drive && has_garage ? 0 : furnisher.number_of(kind);
    for (std::uint32_t n = 0; n < wanted; ++n) {
      const std::optional<YardRectangle> place = furnisher.place_for(kind, n);
      if (!place) continue;
      furnisher.taken.push_back(*place);
      has_garage = has_garage || kind.spot == YardSpot::kBehindDrive;
      const auto kinds = static_cast<std::uint32_t>(std::size(things::kYardKinds));
      made.push_back(thing_at(furnisher, *place, kind.name, kind.height_m, number + n * kinds));
    }
  }
}

bool has_gates(const Yard& yard, const lots::BorderRule& border, const YardFurnisher& furnisher) {
  const bool is_solid = border.kind == map::BarrierKind::kWall || border.kind == map::BarrierKind::kFence;
  const bool is_built = std::ranges::any_of(
      yard.borders, [](const lots::BorderRun& run) { return run.place == lots::BorderPlace::kStreet; });
  return is_solid && is_built && 100 * furnisher.draws("gates").unit(0) < kGatePercent;
}

// Gates where strips cross the barrier along the street.
void add_gates(const YardFurnisher& furnisher, double height_m, std::vector<things::Thing>& made) {
  const Yard& yard = furnisher.yard;
  const double line_m = lots::inset_m(lots::BorderPlace::kStreet);
  std::uint32_t number = kPartsOfKinds;
  for (const lots::YardStrip& strip : yard.strips) {
    ++number;
    const double from_m = std::min(strip.from.y, strip.to.y), to_m = std::max(strip.from.y, strip.to.y);
    const bool is_crossing = strip.from.x == strip.to.x && from_m <= line_m && to_m > line_m;
    if (!is_crossing) continue;
    const YardRectangle place{.at = furnisher.frame.plane({strip.from.x, line_m}),
                              .right = furnisher.frame.along,
                              .back = furnisher.frame.inward,
                              .width_m = strip.is_drive ? lots::kDriveWidth_m : lots::kYardPath_m,
                              .depth_m = kGateDepth_m};
    made.push_back(thing_at(furnisher, place, things::kYardGate, std::min(height_m, kHighestGate_m), number));
  }
}

}  // namespace

std::vector<things::Thing> yard_things(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       std::uint64_t seed, const Box2& box) {
  std::vector<things::Thing> made;
  for (const Yard& yard : recipes.yards) {
    if (!is_home(yard) && use_of(yard.kind) == YardUse::kNone) continue;
    const std::optional<lots::YardRule> rule = lots::rule_of(yard, seed);
    if (!rule) continue;
    const YardFurnisher furnisher{recipes, zones, yard, seed};
    add_kinds(furnisher, made);
    if (is_home(yard) && has_gates(yard, rule->street, furnisher)) add_gates(furnisher, rule->street.height_m, made);
  }
  for (const Yard& plot : recipes.plots) add_kinds({recipes, zones, plot, seed, true}, made);
  std::erase_if(made, [&](const things::Thing& thing) { return !box.contains_half_open(thing.at); });
  return made;
}

}  // namespace citykiln::furniture
