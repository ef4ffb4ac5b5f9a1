#include "compiler/structures/plan_piers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/plan.h"
#include "compiler/structures/deck_index.h"
#include "compiler/structures/supports.h"

namespace citykiln::structures {
namespace {

// Bridges up to this length have no piers; longer ones have bays between the other two lengths.
constexpr double kMaxUnsupported_m = 30, kMinBay_m = 20, kMaxBay_m = 40;
// Piers are at least this far from each other, also from those of joined bridges.
constexpr double kMinPierSpacing_m = 12;
// Distance along the axis, and step, of the search for a free position.
constexpr double kSearch_m = 12, kSearchStep_m = 1;
// Least height of a deck above the ground, and depth of piers below ground and water.
constexpr double kMinHeight_m = 2, kPierDepth_m = 0.5, kDepthInWater_m = 2;
// Bridges over deeper valleys are suspended or arched.
constexpr double kMaxHeight_m = 60;
constexpr double kMaxClear_m = 4;  // at least the largest keep_clear_m()
constexpr double kVisible_m = 64, kBucket_m = 128, kFootStep_m = 0.25, kPierStep_m = 0.25;
// Priorities of land cover classes: water and all above, paths and all above.
constexpr int kWaterPriority = 50, kPathPriority = 70;

struct Placed {
  Vec2 at;
  double z_m = 0;
};

// Obstacles of the whole map.
struct Site {
  const ground::GradedTerrain& graded;
  std::vector<const ground::LandCoverPolygon*> obstacles;
  BoxGrid near_obstacles;
  DeckIndex decks;
};

Site site_of(std::span<const Span> bridges, const ground::GradedTerrain& graded,
             std::span<const ground::LandCoverPolygon> obstacles) {
  Site site{graded, {}, {}, index_decks(bridges, kParapet_m + kMaxClear_m)};
  std::vector<Box2> boxes;
  for (const ground::LandCoverPolygon& obstacle : obstacles) {
    const Box2 box = ground::box_of(obstacle);
    if (box.is_empty() || map::values_of(obstacle.surface).priority < kWaterPriority) continue;
    site.obstacles.push_back(&obstacle);
    boxes.push_back(box);
  }
  site.near_obstacles = grid_of(boxes, kBucket_m);
  return site;
}

// State while the piers of one bridge are placed.
struct Placing {
  const Site& site;
  std::uint32_t number;
  const Span& bridge;
  std::vector<Rib> ribs;
  DeckDimensions shape;
  Box2 box;
  std::vector<ground::LandCoverPolygon> near;
  ground::LandCoverIndex obstacles_index;

  // Five points along a foot, from end to end.
  std::vector<Vec2> foot_at(const Rib& rib) const {
    const PierFoot foot = foot_of(shape);
    const Vec2 left = unit(rib.out), middle = rib.at + left * ((shape.left_m - shape.right_m) / 2);
    std::vector<Vec2> places;
    for (int i = -2; i <= 2; ++i) places.push_back(middle + left * (foot.half_across_m * i / 2));
    return places;
  }
  // Around each of its points, the clearance that covers the foot between them.
  double keep_clear_m() const {
    const PierFoot foot = foot_of(shape);
    return kPierClear_m + length(Vec2{foot.half_across_m / 4, foot.half_along_m});
  }
  bool pierces_deck(Vec2 p, double z_m) const {
    for (const std::uint32_t i : boxes_about(site.decks.grid, p)) {
      const DeckPiece& deck = site.decks.pieces[i];
      if (deck.bridge == number) continue;
      const double share = nearest_share(deck.from.at, deck.to.at, p);
      const double deck_m = deck.from.z_m + (deck.to.z_m - deck.from.z_m) * share;
      const Vec2 nearest = deck.from.at + (deck.to.at - deck.from.at) * share;
      if (deck_m < z_m - 1 && distance(p, nearest) < std::max(deck.left_m, deck.right_m) + kParapet_m + keep_clear_m())
        return true;
    }
    return false;
  }
  bool is_free(const Rib& rib, int priority) const {
    const double clear_m = keep_clear_m();
    return std::ranges::all_of(foot_at(rib), [&](Vec2 p) {
      if (!box.contains(p) || pierces_deck(p, rib.z_m)) return false;
      return near.empty() || clearance_m(obstacles_index, p, priority, clear_m) >= clear_m;
    });
  }
  std::optional<double> nearest_free(double wanted_m, int priority) const {
    for (double off_m = 0; off_m <= kSearch_m; off_m += kSearchStep_m)
      for (const double at_m : {wanted_m - off_m, wanted_m + off_m})
        if (at_m >= ribs.front().along_m && at_m <= ribs.back().along_m && is_free(rib_at(ribs, at_m), priority))
          return at_m;
    return std::nullopt;
  }
  double foot_m(const Rib& rib) const {
    double lowest_m = rib.z_m;
    for (const Vec2 p : foot_at(rib)) {
      const ground::Heights heights = ground::heights_at(site.graded, p);
      const double land_m = layer_height_m(heights, ground::HeightLayer::kLand),
                   water_m = layer_height_m(heights, ground::HeightLayer::kWater);
      lowest_m = std::min(lowest_m, water_m < land_m ? water_m - kDepthInWater_m : land_m - kPierDepth_m);
    }
    return std::floor(lowest_m / kFootStep_m) * kFootStep_m;
  }
};

Placing placing_of(const Site& site, std::uint32_t number, const Span& bridge) {
  const double bay_m = std::clamp(roads::distances_along(bridge).back(), kMinBay_m, kMaxBay_m);
  Placing placing{site, number, bridge, ribs_of(bridge), deck_dimensions(bridge, bay_m), {}, {}, {}};
  placing.box = box_of(bridge.axis).widened(kVisible_m);
  for (const std::uint32_t i : boxes_about(site.near_obstacles, placing.box)) {
    ground::LandCoverPolygon trimmed = ground::trimmed_to(*site.obstacles[i], placing.box.widened(1));
    if (!trimmed.rings.empty()) placing.near.push_back(std::move(trimmed));
  }
  if (!placing.near.empty()) placing.obstacles_index = ground::index_land_cover(placing.near, placing.box);
  return placing;
}

// Evenly spaced positions, and the joints of the bridge.
std::vector<double> target_positions(const Span& bridge, std::span<const Rib> ribs) {
  const double from_m = ribs.front().along_m, long_m = ribs.back().along_m - from_m;
  const double bay_m = std::clamp(long_m / 3, kMinBay_m, kMaxBay_m);
  const int bays = long_m <= kMaxUnsupported_m ? 1 : static_cast<int>(std::ceil(long_m / bay_m));
  std::vector<double> places;
  if (bridge.from.kind == EndKind::kJoint) places.push_back(from_m);
  for (int i = 1; i < bays; ++i) places.push_back(from_m + long_m * i / bays);
  if (bridge.to.kind == EndKind::kJoint) places.push_back(ribs.back().along_m);
  return places;
}

bool is_taken(std::span<const Placed> placed, Vec2 at, double z_m) {
  return std::ranges::any_of(placed, [&](const Placed& p) {
    return distance(p.at, at) < kMinPierSpacing_m && std::abs(p.z_m - z_m) < kMinHeight_m;
  });
}

enum class Outcome { kPlaced, kTaken, kTooLow, kNoPlace };
Outcome place_one(const Placing& placing, double wanted_m, std::vector<Placed>& placed, Span& bridge) {
  const Rib wanted = rib_at(placing.ribs, wanted_m);
  if (is_taken(placed, wanted.at, wanted.z_m)) return Outcome::kTaken;
  std::optional<double> found = placing.nearest_free(wanted_m, kWaterPriority);
  if (!found) found = placing.nearest_free(wanted_m, kPathPriority);
  if (!found) return Outcome::kNoPlace;
  const Rib rib = rib_at(placing.ribs, snapped_to(kPierStep_m, *found));
  if (is_taken(placed, rib.at, rib.z_m)) return Outcome::kTaken;
  const Pier pier{std::max(0.0, snapped_to(kPierStep_m, *found)), placing.foot_m(rib)};
  if (rib.z_m - pier.foot_m < kMinHeight_m + kPierDepth_m) return Outcome::kTooLow;
  if (rib.z_m - pier.foot_m > kMaxHeight_m) return Outcome::kNoPlace;
  bridge.piers.push_back(pier);
  placed.push_back({rib.at, rib.z_m});
  return Outcome::kPlaced;
}

void count_outcome(Outcome outcome, const Span& bridge, double bay_m, Account& account, Report& report) {
  const bool counts = report.counts(bridge.id.osm);
  account.in += counts;
  if (outcome == Outcome::kNoPlace)
    report.drop(account, Code::kNoPlaceForPier, bridge.id.osm, bay_m);
  else if (outcome == Outcome::kPlaced)
    account.out += counts;
  else
    account.merged += counts;
}

}  // namespace

std::vector<Span> place_piers(std::vector<Span> bridges, const ground::GradedTerrain& graded,
                              std::span<const ground::LandCoverPolygon> obstacles, Report& report) {
  assert(std::ranges::is_sorted(bridges, {}, &Span::id));
  const Site site = site_of(bridges, graded, obstacles);
  Account account;
  std::vector<Placed> placed;
  for (std::uint32_t b = 0; b < bridges.size(); ++b) {
    Span& bridge = bridges[b];
    const Placing placing = placing_of(site, b, bridge);
    if (placing.ribs.empty()) continue;
    const std::vector<double> wanted = target_positions(bridge, placing.ribs);
    for (const double wanted_m : wanted)
      count_outcome(
          place_one(placing, wanted_m, placed, bridge), bridge,
          2 * (placing.ribs.back().along_m - placing.ribs.front().along_m) / static_cast<double>(wanted.size() + 1),
          account, report);
    std::ranges::sort(bridge.piers, {}, &Pier::at_m);
    erase_repeated(bridge.piers, &Pier::at_m);
  }
  report.account("structures", "pier") = account;
  return bridges;
}

}  // namespace citykiln::structures
