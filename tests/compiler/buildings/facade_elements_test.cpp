// Pictures of windows and doors on levels that have no room for their frames.
#include "compiler/buildings/facade_elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/buildings/generate.h"
#include "compiler/buildings/styles/style.h"

namespace citykiln::buildings {
namespace {

using materials::Material;

Building house_of_style(Style style, std::uint64_t id = 7) {
  Building b;
  b.id = {{OsmType::kWay, static_cast<std::int64_t>(id)}, 0};
  b.footprint = {{{0, 0}, {18, 0}, {18, 12}, {0, 12}}, {}};
  b.top_m = 15, b.levels = 5;
  b.wall = Material::kPlaster, b.roof = Material::kFlatRoof;
  b.style = style;
  return b;
}

GeneratedBuilding at_tolerance(const Building& building, double tolerance_m, const ElementPictures& pictures,
                               std::optional<WeekTime> night = {}) {
  static const Rulebook book = parse_rulebook(shipped_rules());
  Report report;
  return generate(building, book, {.seed = 1, .night = night, .pictures = &pictures}, tolerance_m, report);
}

TEST(FacadeElements, ShowFramesAndGlassAtToleranceOfAFrame) {
  const ElementPictures pictures;
  for (const Style style : {Style::kOldTownHouse, Style::kCourtyardBlock, Style::kPanelBlock, Style::kVilla}) {
    const GeneratedBuilding house = at_tolerance(house_of_style(style), 0.1, pictures);
    ASSERT_FALSE(house.textured_faces.empty()) << static_cast<int>(style);
    std::size_t windows = 0;
    for (const TexturedFace& face : house.textured_faces) {
      const auto is_pane = [](const impostor::Texel& texel) { return texel.roughness < 20; };
      const impostor::Picture seen = unpacked(*face.picture);
      windows += std::ranges::any_of(seen.texels, is_pane) && !std::ranges::all_of(seen.texels, is_pane);
    }
    EXPECT_GE(windows, 1u) << static_cast<int>(style);
    EXPECT_LE(house.error_m, 0.1);
  }
}

// Each vertex shows a corner of the picture.
TEST(FacadeElements, FillTheirRectangles) {
  const ElementPictures pictures;
  for (const TexturedFace& face : at_tolerance(house_of_style(Style::kOldTownHouse), 0.25, pictures).textured_faces) {
    const double wide_m = face.picture->columns * kElementTexel_m, high_m = face.picture->rows * kElementTexel_m;
    ASSERT_EQ(face.mesh.uvs.size(), face.mesh.mesh.positions.size());
    for (const Vec2 uv : face.mesh.uvs) {
      EXPECT_NEAR(std::min(uv.x, wide_m - uv.x), 0, 1e-9);
      EXPECT_NEAR(std::min(uv.y, high_m - uv.y), 0, 1e-9);
    }
  }
}

// A run has few distinct windows: sixty houses of one style need hardly more pictures than ten.
TEST(FacadeElements, AreSharedByHouses) {
  const ElementPictures pictures;
  std::set<impostor::PackedPicture> distinct;
  std::size_t windows = 0, after_ten = 0;
  for (std::uint64_t id = 1; id <= 60; ++id) {
    for (const TexturedFace& face : at_tolerance(house_of_style(Style::kPanelBlock, id), 0.1, pictures).textured_faces)
      distinct.insert(*face.picture), windows += face.mesh.mesh.triangles.size() / 2;
    if (id == 10) after_ten = distinct.size();
  }
  EXPECT_LT(distinct.size(), 8 * after_ten);
  EXPECT_LT(10 * distinct.size(), windows);
}

TEST(FacadeElements, AreOnePictureForAllHouses) {
  const ElementPictures pictures;
  const GeneratedBuilding one = at_tolerance(house_of_style(Style::kPanelBlock, 1), 0.1, pictures),
                          same = at_tolerance(house_of_style(Style::kPanelBlock, 1), 0.1, pictures);
  ASSERT_EQ(one.textured_faces.size(), same.textured_faces.size());
  for (std::size_t i = 0; i < one.textured_faces.size(); ++i)
    EXPECT_EQ(one.textured_faces[i].picture, same.textured_faces[i].picture);
}

// A second cache draws the same, whichever house comes first.
TEST(FacadeElements, DoNotDependOnTheOrderOfHouses) {
  const ElementPictures ascending, descending;
  const Building a = house_of_style(Style::kVilla, 1), b = house_of_style(Style::kVilla, 2);
  const GeneratedBuilding first = at_tolerance(a, 0.1, ascending);
  at_tolerance(b, 0.1, descending);
  const GeneratedBuilding second = at_tolerance(a, 0.1, descending);
  ASSERT_EQ(first.textured_faces.size(), second.textured_faces.size());
  for (std::size_t i = 0; i < first.textured_faces.size(); ++i)
    EXPECT_EQ(*first.textured_faces[i].picture, *second.textured_faces[i].picture);
}

TEST(FacadeElements, ShineByNight) {
  const ElementPictures pictures;
  const auto shines = [&](std::optional<WeekTime> night) {
    const GeneratedBuilding house = at_tolerance(house_of_style(Style::kCourtyardBlock), 0.25, pictures, night);
    return std::ranges::any_of(house.textured_faces,
                               [](const TexturedFace& face) { return face.picture->has_emission; });
  };
  EXPECT_FALSE(shines({}));
  EXPECT_TRUE(shines(WeekTime{19.5}));
}

}  // namespace
}  // namespace citykiln::buildings
