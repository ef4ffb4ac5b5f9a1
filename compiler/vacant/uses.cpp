#include "compiler/vacant/uses.h"

#include <algorithm>

namespace citykiln::vacant {
namespace {

using map::LandCoverClass;
using things::YardUse;

struct UseOfLand {
  LandCoverClass land;
  YardUse use;
};
constexpr UseOfLand kUsesOfLand[] = {
    {LandCoverClass::kIndustrial, YardUse::kWorks},   {LandCoverClass::kIndustrial, YardUse::kStorage},
    {LandCoverClass::kBrownfield, YardUse::kStorage}, {LandCoverClass::kPort, YardUse::kStorage},
    {LandCoverClass::kInstitution, YardUse::kSchool}, {LandCoverClass::kReligious, YardUse::kChurch},
    {LandCoverClass::kConstruction, YardUse::kSite},  {LandCoverClass::kAllotments, YardUse::kAllotment}};

}  // namespace

std::vector<YardUse> uses_on(std::span<const map::AreaFeature> areas) {
  std::vector<YardUse> uses = {YardUse::kApartments, YardUse::kCourt, YardUse::kGreen};
  for (const UseOfLand& row : kUsesOfLand)
    if (std::ranges::find(areas, row.land, &map::AreaFeature::surface) != areas.end()) uses.push_back(row.use);
  const auto is_shops = [](const map::AreaFeature& area) {
    return area.surface == LandCoverClass::kRetail || area.surface == LandCoverClass::kCommercial;
  };
  if (std::ranges::any_of(areas, is_shops)) uses.push_back(YardUse::kShop);
  return uses;
}

}  // namespace citykiln::vacant
