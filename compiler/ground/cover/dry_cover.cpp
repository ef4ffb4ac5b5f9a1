#include "compiler/ground/cover/dry_cover.h"

#include <algorithm>
#include <iterator>

namespace citykiln::ground {
namespace {

struct DryCoverRow {
  map::LandCoverClass cover;
  DryShares most;
};
constexpr DryCoverRow kDryCovers[] = {
#define DRY_COVER(cover, straw, bare) {map::LandCoverClass::cover, {straw, bare}},
#include "compiler/ground/cover/dry_covers.inc"
};

}  // namespace

DryShares dry_shares(map::LandCoverClass cover, const climate::ClimateMix& climate, climate::LocalMonth month) {
  const auto row = std::ranges::find(kDryCovers, cover, &DryCoverRow::cover);
  if (row == std::end(kDryCovers)) return {};
  return {row->most.straw * climate.mean([&](auto each) { return climate::straw_share(each, month); }),
          row->most.bare * climate.mean([](auto each) { return climate::bare_share(each); })};
}

bool is_dry_anywhere(const climate::ClimateField& field, climate::LocalMonth month) {
  return std::ranges::any_of(field.nodes, [&](const climate::ClimateNode& node) {
    for (std::size_t i = 0; i < node.shares.size(); ++i)
      if (node.shares[i] > 0 &&
          (climate::straw_share(node.classes[i], month) > 0 || climate::bare_share(node.classes[i]) > 0))
        return true;
    return false;
  });
}

}  // namespace citykiln::ground
