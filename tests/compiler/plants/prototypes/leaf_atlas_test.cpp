#include "compiler/plants/prototypes/leaf_atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/plants/prototypes/sprays.h"
#include "tests/compiler/impostor/mip_levels.h"

namespace citykiln::plants {
namespace {

using impostor::MipLevel;

constexpr Month kMonths[] = {Month{1}, Month{4}, kMidsummer, Month{10}, Month{11}};

std::uint32_t texel_at(double at_m) { return static_cast<std::uint32_t>(std::floor(at_m / kSprayTexel + 0.5)); }

// The cell of a picture, whose sides are multiples of 16 texels.
MipLevel cell_of(const LeafAtlas& atlas, const LeafPlace& place) {
  constexpr std::uint32_t kCell = impostor::kCell_px;
  const std::uint32_t left = texel_at(place.at_m.x) / kCell * kCell, top = texel_at(place.at_m.y) / kCell * kCell;
  const auto up = [&](double end_m) { return (texel_at(end_m) + kCell) / kCell * kCell; };
  MipLevel cell{up(place.at_m.x + place.size_m.x) - left, up(place.at_m.y + place.size_m.y) - top, {}};
  for (std::uint32_t row = 0; row < cell.rows; ++row)
    for (std::uint32_t column = 0; column < cell.columns; ++column)
      cell.opacity.push_back(
          atlas.cutout.opacity[std::size_t{top + row} * atlas.cutout.colour.columns + left + column]);
  return cell;
}

TEST(LeafAtlas, ShowsEverySprayOfEverySpeciesInEveryMonth) {
  for (const Month month : kMonths) {
    const LeafAtlas atlas = leaf_atlas(month);
    EXPECT_LE(atlas.cutout.colour.columns, 1024u);
    for (const auto& [leaf, place] : atlas.places) {
      const MipLevel cell = cell_of(atlas, place);
      EXPECT_GT(opaque_share(cell), 0) << leaf.spray;
    }
  }
}

// A reader's mip levels of the shipped leaves keep their coverage; needles and twigs become denser, and none vanishes.
TEST(LeafAtlas, KeepsItsCoverageOnMipLevels) {
  int dense = 0;
  for (const Month month : kMonths) {
    const LeafAtlas atlas = leaf_atlas(month);
    for (const auto& [leaf, place] : atlas.places) {
      MipLevel level = cell_of(atlas, place);
      const double covered = opaque_share(level);
      for (int i = 0; i < 4; ++i) {
        level = halved(level);
        EXPECT_GT(opaque_share(level), 0) << leaf.spray << ' ' << level.columns;
        if (level.opacity.size() < 64) continue;
        EXPECT_GT(opaque_share(level), covered - 0.05) << leaf.spray << ' ' << level.columns;
        if (covered < 0.3 || leaf.material != materials::Material::kBroadLeaf) continue;
        ++dense;
        EXPECT_LT(opaque_share(level), covered + std::max(0.05, 0.15 * covered)) << leaf.spray << ' ' << level.columns;
      }
    }
  }
  EXPECT_GT(dense, 40);
}

TEST(LeafAtlas, IsAFunctionOfTheMonth) {
  EXPECT_EQ(leaf_atlas(kMidsummer).cutout, leaf_atlas(kMidsummer).cutout);
  EXPECT_NE(leaf_atlas(kMidsummer).cutout, leaf_atlas(Month{1}).cutout);
}

TEST(LeafAtlas, FindsThePictureOfForeignSpraysToo) {
  const LeafAtlas atlas = leaf_atlas(kMidsummer);
  const Appearance fir = appearance_of({Species::kFir, 0}, kMidsummer),
                   oak = appearance_of({Species::kOak, 0}, kMidsummer);
  EXPECT_EQ(place_of(atlas, "oak_leaf", false, fir).at_m, place_of(atlas, "oak_leaf", false, oak).at_m);
  EXPECT_NE(place_of(atlas, "oak_leaf", false, oak).at_m, place_of(atlas, "oak_leaf", true, oak).at_m);
}

}  // namespace
}  // namespace citykiln::plants
