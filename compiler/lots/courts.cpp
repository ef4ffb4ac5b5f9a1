#include "compiler/lots/courts.h"

#include <algorithm>

namespace citykiln::lots {
namespace {

using map::LandCoverClass;

constexpr double kCourtBucket_m = 64, kMostOfOneArea_m2 = 400;

}  // namespace

std::optional<bool> is_green_court(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kGrass:
    case LandCoverClass::kGarden:
    case LandCoverClass::kFlowerbed:
    case LandCoverClass::kHedgeArea:
    case LandCoverClass::kScrub:
    case LandCoverClass::kVillageGreen:
      return true;
    case LandCoverClass::kParking:
    case LandCoverClass::kSquare:
    case LandCoverClass::kServiceArea:
      return false;
    default:
      return std::nullopt;
  }
}

CourtGreen index_court_green(const map::FeatureView& features) {
  CourtGreen green;
  std::vector<Box2> boxes;
  for (const map::AreaFeature& area : features.areas) {
    const std::optional<bool> is_green = is_green_court(area.surface);
    const bool is_court = area.area_m2 >= kLeastCourt_m2 && area.area_m2 <= kLargestCourt_m2;
    if (!is_green || !is_court || area.polygon.outer.empty()) continue;
    const Vec2 middle = box_of(area.polygon.outer).centre();
    green.all.push_back({middle, area.area_m2, *is_green, area.id});
    boxes.push_back(Box2{middle, middle});
  }
  if (!boxes.empty()) green.grid = grid_of(boxes, kCourtBucket_m);
  return green;
}

std::optional<double> green_share(const CourtGreen& green, Vec2 p, ObjectId without) {
  if (green.all.empty()) return std::nullopt;
  double green_m2 = 0, all_m2 = 0;
  for (const std::uint32_t i : boxes_about(green.grid, Box2{p, p}.widened(kCourtRadius_m))) {
    const CourtGreen::Area& area = green.all[i];
    if (distance(area.middle, p) > kCourtRadius_m || area.id == without) continue;
    const double counted_m2 = std::min(area.area_m2, kMostOfOneArea_m2);
    all_m2 += counted_m2, green_m2 += area.is_green ? counted_m2 : 0;
  }
  if (all_m2 == 0) return std::nullopt;
  return green_m2 / all_m2;
}

LotKind court_of(const CourtGreen& green, Vec2 p) {
  const std::optional<double> share = green_share(green, p);
  if (!share) return LotKind::kPerimeter;
  if (*share >= kGreenCourtShare) return LotKind::kGreenCourt;
  return *share <= kPavedCourtShare ? LotKind::kPavedCourt : LotKind::kPerimeter;
}

}  // namespace citykiln::lots
