#include "compiler/structures/plan_piers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/plan.h"
#include "compiler/structures/supports.h"

namespace citykiln::structures {
namespace {

// Bridges up to the first length have no piers; others are shared out into bays between the other two.
constexpr double kUnsupported_m = 30, kShortBay_m = 20, kLongBay_m = 40;
// Supports nearer to each other than this are one.
constexpr double kApart_m = 12;
// How far along the axis a free place is looked for, in which steps.
constexpr double kSearch_m = 12, kStep_m = 1;
// Of what has to lie between a deck's top and the ground, and how deep a pier goes.
constexpr double kLowest_m = 2, kDeep_m = 0.5, kDeepInWater_m = 2;
// Over deeper valleys bridges hang or are arches: no pier is higher.
constexpr double kHighest_m = 60;
constexpr double kReach_m = 4;  // no foot keeps farther away
constexpr double kSee_m = 64, kBucket_m = 128, kFootStep_m = 0.25;
// Priorities of surface classes: water and all above, paths and all above.
constexpr int kWaterPriority = 50, kPathPriority = 70;

double quarters(double v) { return std::floor(v * 4 + 0.5) / 4; }

// A straight piece of a deck as seen from above it.
struct DeckPiece {
  std::uint32_t bridge = 0;
  Rib from, to;
  double half_m = 0;
};

struct Placed {
  Vec2 at;
  double z_m = 0;
};

// What is in the way, all over the map.
struct Site {
  const ground::GradedTerrain& graded;
  std::vector<const ground::LandCoverPolygon*> standing;  // what somebody would miss
  BoxGrid near_standing, near_decks;
  std::vector<DeckPiece> decks;
};

Site site_of(std::span<const Span> bridges, const ground::GradedTerrain& graded,
             std::span<const ground::LandCoverPolygon> standing) {
  Site site{graded, {}, {}, {}, {}};
  std::vector<Box2> boxes;
  for (const ground::LandCoverPolygon& s : standing) {
    const Box2 box = ground::box_of(s);
    if (box.is_empty() || map::values_of(s.surface).priority < kWaterPriority) continue;
    site.standing.push_back(&s);
    boxes.push_back(box);
  }
  site.near_standing = grid_of(boxes, kBucket_m);
  boxes.clear();
  for (std::uint32_t b = 0; b < bridges.size(); ++b) {
    const std::vector<Rib> ribs = ribs_of(bridges[b]);
    const DeckDimensions shape = deck_dimensions(bridges[b], kShortBay_m);
    const double half_m = std::max(shape.left_m, shape.right_m) + kParapet_m;
    for (std::size_t i = 0; i + 1 < ribs.size(); ++i) {
      site.decks.push_back({b, ribs[i], ribs[i + 1], half_m});
      boxes.push_back(box_of(std::array{ribs[i].at, ribs[i + 1].at}).widened(half_m + kReach_m));
    }
  }
  site.near_decks = grid_of(boxes, kBucket_m);
  return site;
}

// A bridge while its piers are placed.
struct Placing {
  const Site& site;
  std::uint32_t number;
  const Span& bridge;
  std::vector<Rib> ribs;
  DeckDimensions shape;
  Box2 box;
  std::vector<ground::LandCoverPolygon> near;
  ground::LandCoverIndex map;

  // The middle and both ends of a foot, and two between.
  std::vector<Vec2> foot_at(const Rib& rib) const {
    const PierFoot foot = foot_of(shape);
    const Vec2 left = unit(rib.out), middle = rib.at + left * ((shape.left_m - shape.right_m) / 2);
    std::vector<Vec2> places;
    for (int i = -2; i <= 2; ++i) places.push_back(middle + left * (foot.half_across_m * i / 2));
    return places;
  }
  // The widest gap between the places of a foot is half of that wide.
  double keep_clear_m() const {
    const PierFoot foot = foot_of(shape);
    return kPierClear_m + length(Vec2{foot.half_across_m / 4, foot.half_along_m});
  }
  bool pierces_deck(Vec2 p, double z_m) const {
    for (const std::uint32_t i : boxes_about(site.near_decks, p)) {
      const DeckPiece& deck = site.decks[i];
      if (deck.bridge == number) continue;
      const Vec2 along = deck.to.at - deck.from.at;
      const double length2 = dot(along, along);
      const double t = length2 > 0 ? std::clamp(dot(p - deck.from.at, along) / length2, 0.0, 1.0) : 0;
      const double deck_m = deck.from.z_m + (deck.to.z_m - deck.from.z_m) * t;
      if (deck_m < z_m - 1 && distance(p, deck.from.at + along * t) < deck.half_m + keep_clear_m()) return true;
    }
    return false;
  }
  bool is_free(const Rib& rib, int priority) const {
    const double clear_m = keep_clear_m();
    return std::ranges::all_of(foot_at(rib), [&](Vec2 p) {
      if (!box.contains(p) || pierces_deck(p, rib.z_m)) return false;
      return near.empty() || clearance_m(map, p, priority, clear_m) >= clear_m;
    });
  }
  std::optional<double> nearest_free(double wanted_m, int priority) const {
    for (double off_m = 0; off_m <= kSearch_m; off_m += kStep_m)
      for (const double at_m : {wanted_m - off_m, wanted_m + off_m})
        if (at_m >= ribs.front().along_m && at_m <= ribs.back().along_m && is_free(rib_at(ribs, at_m), priority))
          return at_m;
    return std::nullopt;
  }
  double foot_m(const Rib& rib) const {
    double lowest_m = rib.z_m;
    for (const Vec2 p : foot_at(rib)) {
      const ground::Heights heights = ground::heights_at(site.graded, p);
      const double land_m = of(heights, ground::HeightLayer::kLand), water_m = of(heights, ground::HeightLayer::kWater);
      lowest_m = std::min(lowest_m, water_m < land_m ? water_m - kDeepInWater_m : land_m - kDeep_m);
    }
    return std::floor(lowest_m / kFootStep_m) * kFootStep_m;
  }
};

Placing placing_of(const Site& site, std::uint32_t number, const Span& bridge) {
  const double bay_m = std::clamp(roads::distances_along(bridge).back(), kShortBay_m, kLongBay_m);
  Placing placing{site, number, bridge, ribs_of(bridge), deck_dimensions(bridge, bay_m), {}, {}, {}};
  placing.box = box_of(bridge.axis).widened(kSee_m);
  for (const std::uint32_t i : boxes_about(site.near_standing, placing.box)) {
    ground::LandCoverPolygon trimmed = ground::trimmed_to(*site.standing[i], placing.box.widened(1));
    if (!trimmed.rings.empty()) placing.near.push_back(std::move(trimmed));
  }
  if (!placing.near.empty()) placing.map = ground::index_land_cover(placing.near, placing.box);
  return placing;
}

// Even shares of the bridge, and where it goes on into another one.
std::vector<double> wanted_places(const Span& bridge, std::span<const Rib> ribs) {
  const double from_m = ribs.front().along_m, long_m = ribs.back().along_m - from_m;
  const double bay_m = std::clamp(long_m / 3, kShortBay_m, kLongBay_m);
  const int bays = long_m <= kUnsupported_m ? 1 : static_cast<int>(std::ceil(long_m / bay_m));
  std::vector<double> places;
  if (bridge.from.kind == EndKind::kJoint) places.push_back(from_m);
  for (int i = 1; i < bays; ++i) places.push_back(from_m + long_m * i / bays);
  if (bridge.to.kind == EndKind::kJoint) places.push_back(ribs.back().along_m);
  return places;
}

bool is_taken(std::span<const Placed> placed, Vec2 at, double z_m) {
  return std::ranges::any_of(
      placed, [&](const Placed& p) { return distance(p.at, at) < kApart_m && std::abs(p.z_m - z_m) < kLowest_m; });
}

// Returns what became of the wanted place.
enum class Outcome { kStands, kTaken, kLow, kNoPlace };
Outcome place_one(const Placing& placing, double wanted_m, std::vector<Placed>& placed, Span& bridge) {
  const Rib wanted = rib_at(placing.ribs, wanted_m);
  if (is_taken(placed, wanted.at, wanted.z_m)) return Outcome::kTaken;
  std::optional<double> found = placing.nearest_free(wanted_m, kWaterPriority);
  if (!found) found = placing.nearest_free(wanted_m, kPathPriority);
  if (!found) return Outcome::kNoPlace;
  const Rib rib = rib_at(placing.ribs, quarters(*found));
  if (is_taken(placed, rib.at, rib.z_m)) return Outcome::kTaken;
  const Pier pier{std::max(0.0, quarters(*found)), placing.foot_m(rib)};
  if (rib.z_m - pier.foot_m < kLowest_m + kDeep_m) return Outcome::kLow;
  if (rib.z_m - pier.foot_m > kHighest_m) return Outcome::kNoPlace;
  bridge.piers.push_back(pier);
  placed.push_back({rib.at, rib.z_m});
  return Outcome::kStands;
}

void count(Outcome outcome, const Span& bridge, double bay_m, Account& account, Report& report) {
  ++account.in;
  if (outcome == Outcome::kNoPlace)
    report.drop(account, Code::kNoPlaceForPier, bridge.id.osm, bay_m);
  else if (outcome == Outcome::kStands)
    ++account.out;
  else
    ++account.merged;
}

}  // namespace

std::vector<Span> place_piers(std::vector<Span> bridges, const ground::GradedTerrain& graded,
                              std::span<const ground::LandCoverPolygon> standing, Report& report) {
  const Site site = site_of(bridges, graded, standing);
  Account account;
  std::vector<Placed> placed;
  for (std::uint32_t b = 0; b < bridges.size(); ++b) {
    Span& bridge = bridges[b];
    const Placing placing = placing_of(site, b, bridge);
    if (placing.ribs.empty()) continue;
    const std::vector<double> wanted = wanted_places(bridge, placing.ribs);
    for (const double wanted_m : wanted)
      count(place_one(placing, wanted_m, placed, bridge), bridge,
            2 * (placing.ribs.back().along_m - placing.ribs.front().along_m) / static_cast<double>(wanted.size() + 1),
            account, report);
    std::ranges::sort(bridge.piers, {}, &Pier::at_m);
    erase_repeated(bridge.piers, &Pier::at_m);
  }
  report.account("structures", "pier") = account;
  return bridges;
}

}  // namespace citykiln::structures
