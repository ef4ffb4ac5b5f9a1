#include "compiler/roads/pieces/tactile_paving.h"

#include "compiler/roads/markings/mark.h"

namespace citykiln::roads {
namespace {

using map::CountryGroup;
using SlabColour = materials::TextureImage::Texel;

constexpr SlabColour kRedSlab = {150, 72, 62}, kBuffSlab = {198, 176, 136}, kYellowSlab = {208, 168, 58},
                     kGreySlab = {196, 194, 188};

SlabColour slab_colour(CountryGroup country, StretchKind stretch) {
  switch (country) {
    case CountryGroup::kBritishIsles:
      return stretch == StretchKind::kAlong ? kBuffSlab : kRedSlab;
    case CountryGroup::kNorthAmerica:
    case CountryGroup::kLatinAmerica:
    case CountryGroup::kJapan:
    case CountryGroup::kChina:
    case CountryGroup::kSouthAsia:
    case CountryGroup::kSouthEastAsia:
    case CountryGroup::kOceania:
      return kYellowSlab;
    default:
      return kGreySlab;
  }
}

SlabColour darker(SlabColour colour) {
  for (auto& channel : colour) channel = static_cast<std::uint8_t>(channel * 4 / 5);
  return colour;
}

}  // namespace

bool is_tactile_usual(CountryGroup country, StretchKind stretch) {
  switch (country) {
    case CountryGroup::kBritishIsles:
    case CountryGroup::kNorthAmerica:
    case CountryGroup::kJapan:
    case CountryGroup::kOceania:
      return true;
    case CountryGroup::kSouthernEurope:
    case CountryGroup::kChina:
      return stretch != StretchKind::kAlong;
    case CountryGroup::kCentralEurope:
      return stretch == StretchKind::kCrossing;
    default:
      return false;
  }
}

MarkingLayout tactile_layout(CountryGroup country, StretchKind stretch, double depth_m) {
  constexpr double kSlab_m = 0.4, kSlabJoint_m = 0.05;
  const SlabColour colour = slab_colour(country, stretch), joint = darker(colour);
  MarkingLayout layout{.surface = map::LandCoverClass::kPavement, .lanes = {}, .panel = {}, .panel_m = depth_m};
  layout.panel.push_back({rectangle({0, 0}, {depth_m, kLayoutLength_m}), colour});
  for (double u_m = kSlab_m; u_m < depth_m - kSlab_m / 2; u_m += kSlab_m)
    layout.panel.push_back({rectangle({u_m - kSlabJoint_m / 2, 0}, {u_m + kSlabJoint_m / 2, kLayoutLength_m}), joint});
  for (double v_m = kSlab_m / 2; v_m < kLayoutLength_m; v_m += kSlab_m)
    layout.panel.push_back({rectangle({0, v_m - kSlabJoint_m / 2}, {depth_m, v_m + kSlabJoint_m / 2}), joint});
  return layout;
}

}  // namespace citykiln::roads
