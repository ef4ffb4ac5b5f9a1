#include "compiler/vacant/ground_cover.h"

#include <algorithm>
#include <array>

namespace citykiln::vacant {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;

struct UseCount {
  LandCoverClass use{};
  ObjectId area{};
  int priority = 0;
  int count = 0;
};

void count_use(const ground::LandCoverPolygon* cover, std::vector<UseCount>& counts) {
  const LandCoverClass use = cover == nullptr ? LandCoverClass::kUnknown : cover->surface;
  if (!is_left_over(use)) return;
  auto found = std::ranges::find(counts, use, &UseCount::use);
  if (found == counts.end())
    found = counts.insert(counts.end(), {use, cover == nullptr ? ObjectId{} : cover->id, 0, 0});
  ++found->count;
  if (cover != nullptr) found->priority = std::max(found->priority, ground::priority_of(*cover));
}

// True for green ground, false for paved ground, empty for all else.
std::optional<bool> is_green_ground(const ground::LandCoverPolygon& cover) {
  switch (map::values_of(cover.surface).group) {
    case LandCoverGroup::kForest:
    case LandCoverGroup::kGrassland:
    case LandCoverGroup::kGarden:
    case LandCoverGroup::kScrubland:
      return true;
    case LandCoverGroup::kPaved:
      return cover.surface == LandCoverClass::kPavement ? std::nullopt : std::optional(false);
    default:
      if (ground::is_yard(cover)) return false;
      return std::nullopt;
  }
}

}  // namespace

const ground::LandCoverPolygon* cover_at(const PlotInputs& inputs, Vec2 p) {
  if (!inputs.land_cover.box.contains(p)) return nullptr;
  const std::uint32_t top = ground::land_cover_at(inputs.land_cover, p);
  return top == ground::kNoLandCover ? nullptr : &inputs.land_cover.surfaces[top];
}

bool is_left_over(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kUnknown:
    case LandCoverClass::kResidential:
    case LandCoverClass::kCommercial:
    case LandCoverClass::kRetail:
    case LandCoverClass::kIndustrial:
    case LandCoverClass::kBrownfield:
    case LandCoverClass::kPort:
      return true;
    default:
      return false;
  }
}

LeftOver left_over_of(const PlotInputs& inputs, Vec2 corner, Vec2 right, Vec2 back) {
  std::vector<UseCount> counts;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const Vec2 p = corner + right * ((i + 0.5) / kSamples) + back * ((j + 0.5) / kSamples);
      if (!inputs.land_cover.box.contains(p)) continue;
      count_use(cover_at(inputs, p), counts);
    }
  if (counts.empty()) return {};
  const UseCount most = *std::ranges::max_element(counts, {}, &UseCount::count);
  return {most.use, most.area, most.priority, static_cast<double>(most.count) / (kSamples * kSamples)};
}

std::optional<double> green_share_about(const PlotInputs& inputs, Vec2 p) {
  constexpr std::array<Vec2, 8> kWays = {
      {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
  int green = 0, all = 0;
  for (const double away_m : {8.0, 16.0, 24.0})
    for (const Vec2 way : kWays) {
      const ground::LandCoverPolygon* cover = cover_at(inputs, p + way * away_m);
      if (cover == nullptr) continue;
      const std::optional<bool> is_green = is_green_ground(*cover);
      all += is_green.has_value(), green += is_green.value_or(false);
    }
  if (all == 0) return std::nullopt;
  return static_cast<double>(green) / all;
}

}  // namespace citykiln::vacant
