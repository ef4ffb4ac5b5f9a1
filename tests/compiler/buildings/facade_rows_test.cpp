// Windows and doors as rectangles before walls that are one face.
#include "compiler/buildings/facade_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/buildings/generate.h"
#include "compiler/contract/random_sequence.h"

namespace citykiln::buildings {
namespace {

using impostor::Picture;
using impostor::Texel;

constexpr OsmId kHouseWithRows{OsmType::kWay, 5};

Texel grey_texel(std::uint16_t light) { return {.light = {light, light, light}, .shown = impostor::kSamplesPerTexel}; }

// A window of one grey, 1 m wide and 1.5 m high.
impostor::SharedPicture grey_window(std::uint16_t light) {
  return impostor::shared(Picture{12, 18, std::vector<Texel>(12 * 18, grey_texel(light))});
}

grammars::Face upright(Vec3 corner, Vec3 along, double high_m) {
  return {.outer = {corner, corner + along, corner + along + Vec3{0, 0, high_m}, corner + Vec3{0, 0, high_m}}};
}

// A wall that faces south, from x = 0, with its foot at z = 0.
grammars::Face wall_to_the_south(double wide_m, double high_m, double y = 0) {
  return upright({0, y, 0}, {wide_m, 0, 0}, high_m);
}

PlacedElement placed_window(double x, double z, double y = 0, std::uint16_t light = 9000) {
  return {upright({x, y, z}, {1, 0, 0}, 1.5), grey_window(light)};
}

TEST(ElementsOn, LieOnTheNearestParallelFace) {
  const std::vector<grammars::Face> faces{wall_to_the_south(10, 9, 0), wall_to_the_south(10, 9, 0.4),
                                          upright({10, 5, 0}, {-10, 0, 0}, 9)};
  const std::vector<PlacedElement> elements{placed_window(2, 1, 0.1), placed_window(5, 1, 0.3)};
  const auto on_faces = elements_on(faces, elements, 0.5);
  ASSERT_EQ(on_faces[0].size(), 1u);
  ASSERT_EQ(on_faces[1].size(), 1u);
  EXPECT_TRUE(on_faces[2].empty());
  EXPECT_NEAR(on_faces[0][0].moved_m, 0.1, 1e-9);
  EXPECT_NEAR(on_faces[1][0].box.min.x, 5, 1e-9);
  EXPECT_NEAR(on_faces[1][0].box.height(), 1.5, 1e-9);
}

TEST(ElementsOn, AreLeftOutWithoutRoomOrFartherThanTheReach) {
  const std::vector<grammars::Face> faces{wall_to_the_south(10, 9)};
  const std::vector<PlacedElement> elements{placed_window(9.5, 1), placed_window(2, 8), placed_window(2, 1, 0.6)};
  EXPECT_TRUE(elements_on(faces, elements, 0.5)[0].empty());
}

TEST(ElementsOn, AreLeftOutOverAHole) {
  std::vector<grammars::Face> faces{wall_to_the_south(10, 9)};
  faces[0].holes = {upright({1, 0, 0.5}, {3, 0, 0}, 3).outer};
  const std::vector<PlacedElement> elements{placed_window(2, 1), placed_window(6, 1)};
  EXPECT_EQ(elements_on(faces, elements, 0.5)[0].size(), 1u);
}

// A wall with windows in columns and rows 3 m apart, every other of another kind.
WallWithElements wall_of_grey_windows(std::size_t columns, std::size_t rows, std::uint16_t even = 9000,
                                      std::uint16_t odd = 9000) {
  WallWithElements wall{{{}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, grey_texel(40000), {}};
  const impostor::SharedPicture kinds[] = {grey_window(even), even == odd ? nullptr : grey_window(odd)};
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const Vec2 low{1 + 3.0 * static_cast<double>(c), 1 + 3.0 * static_cast<double>(r)};
      wall.elements.push_back({{low, low + Vec2{1, 1.5}}, kinds[even == odd ? 0 : (c + r) % 2], 0});
    }
  return wall;
}

std::size_t count_of_rectangles(const std::vector<TexturedFace>& faces) {
  std::size_t triangles = 0;
  for (const TexturedFace& face : faces) triangles += face.mesh.mesh.triangles.size();
  return triangles / 2;
}

TEST(RowsOf, JoinWindowsOfLargeWalls) {
  const std::vector<WallWithElements> walls{wall_of_grey_windows(16, 40)};
  EXPECT_EQ(count_of_rectangles(rows_of(walls, row_sizes(0.5), kHouseWithRows)), 10u);
  EXPECT_EQ(count_of_rectangles(rows_of(walls, row_sizes(2.5), kHouseWithRows)), 10u);
}

// Three windows are no reason for a picture of the wall between them.
TEST(RowsOf, KeepFewWindowsApartAtFineLevels) {
  const std::vector<WallWithElements> walls{wall_of_grey_windows(3, 1)};
  const std::vector<TexturedFace> fine = rows_of(walls, row_sizes(0.5), kHouseWithRows);
  EXPECT_EQ(count_of_rectangles(fine), 3u);
  ASSERT_EQ(fine.size(), 1u);
  EXPECT_EQ(fine[0].picture->columns, 8u);
  EXPECT_EQ(count_of_rectangles(rows_of(walls, row_sizes(2.5), kHouseWithRows)), 1u);
}

// The light of a rectangle with its uvs, times its area.
double light_times_area(const TexturedFace& face, std::size_t first, double unit_m) {
  const auto& p = face.mesh.mesh.positions;
  const Vec2 low = face.mesh.uvs[first + 3] * (1 / unit_m), high = face.mesh.uvs[first + 1] * (1 / unit_m);
  const Picture seen = unpacked(*face.picture);
  double sum = 0, texels = 0;
  for (auto y = static_cast<std::uint32_t>(low.y + 0.5); y < static_cast<std::uint32_t>(high.y + 0.5); ++y)
    for (auto x = static_cast<std::uint32_t>(low.x + 0.5); x < static_cast<std::uint32_t>(high.x + 0.5); ++x)
      sum += seen.texels[y * seen.columns + x].light[0], ++texels;
  return sum / texels * length(p[first + 1] - p[first]) * length(p[first + 2] - p[first + 1]);
}

// Mean colours of levels agree, though windows have whole texels and kinds have whole places.
TEST(RowsOf, HaveTheMeanColourOfTheirWindows) {
  for (const double tolerance_m : {0.5, 1.2, 2.5}) {
    const std::vector<WallWithElements> walls{wall_of_grey_windows(8, 8, 4000, 12000)};
    double light = 0, m2 = 0;
    for (const TexturedFace& face : rows_of(walls, row_sizes(tolerance_m), kHouseWithRows))
      for (std::size_t i = 0; i < face.mesh.mesh.positions.size(); i += 4) {
        light += light_times_area(face, i, tolerance_m);
        m2 += length(face.mesh.mesh.positions[i + 1] - face.mesh.mesh.positions[i]) *
              length(face.mesh.mesh.positions[i + 2] - face.mesh.mesh.positions[i + 1]);
      }
    const double wall_m2 = 24.0 * 24, windows_m2 = 64 * 1.5;
    const double is = light + (wall_m2 - m2) * 40000, expected = windows_m2 * 8000 + (wall_m2 - windows_m2) * 40000;
    EXPECT_NEAR(is / expected, 1, 0.02) << tolerance_m;
  }
}

bool do_overlap(const std::vector<Vec3>& p, std::size_t a, std::size_t b) {
  return p[a].x + 0.01 < p[b + 2].x && p[b].x + 0.01 < p[a + 2].x && p[a].z + 0.01 < p[b + 2].z &&
         p[b].z + 0.01 < p[a + 2].z;
}

// Windows of several sizes anywhere: no picture of wall lies over another window.
TEST(RowsOf, NeverCoverAnother) {
  const RandomSequence random(1, {}, "rows");
  for (std::uint32_t run = 0; run < 200; ++run) {
    WallWithElements wall = wall_of_grey_windows(10, 6);
    for (std::uint32_t i = 0; i < wall.elements.size(); ++i) {
      Box2& box = wall.elements[i].box;
      // 1.5 m apart, so that a window between two equal ones is nearer to both than the widest wall on a picture
      box.min.x /= 2, box.max.x = box.min.x + 1;
      if (random.below(3, 100 * run + i) == 0) box.max.y = box.min.y + 0.75;
    }
    for (const double tolerance_m : {0.5, 2.5}) {
      std::vector<Vec3> all;
      for (const TexturedFace& face : rows_of(std::span(&wall, 1), row_sizes(tolerance_m), kHouseWithRows))
        all.insert(all.end(), face.mesh.mesh.positions.begin(), face.mesh.mesh.positions.end());
      for (std::size_t a = 0; a < all.size(); a += 4)
        for (std::size_t b = a + 4; b < all.size(); b += 4) ASSERT_FALSE(do_overlap(all, a, b)) << run;
    }
  }
}

// Levels that have a wall as one face show glass on it, within the tolerance.
TEST(RowsOf, ShowWindowsOfHousesAtCoarseLevels) {
  static const Rulebook book = parse_rulebook(shipped_rules());
  const ElementPictures pictures;
  Building house;
  house.id = {kHouseWithRows, 0};
  house.footprint = {{{0, 0}, {18, 0}, {18, 12}, {0, 12}}, {}};
  house.top_m = 15, house.levels = 5;
  house.wall = materials::Material::kPlaster, house.roof = materials::Material::kFlatRoof;
  for (const Style style : {Style::kOldTownHouse, Style::kCourtyardBlock, Style::kPanelBlock, Style::kVilla})
    for (const double tolerance_m : {0.5, 1.2, 2.5}) {
      house.style = style;
      Report report;
      const GeneratedBuilding made =
          generate(house, book, {.seed = 1, .night = {}, .pictures = &pictures}, tolerance_m, report);
      EXPECT_LE(made.error_m, tolerance_m);
      // texels mix panes, which have 15 to 26, with frames, which have 191 as walls have
      const auto is_pane = [](const Texel& texel) { return texel.roughness < 110; };
      EXPECT_TRUE(std::ranges::any_of(
          made.textured_faces,
          [&](const TexturedFace& face) { return std::ranges::any_of(unpacked(*face.picture).texels, is_pane); }))
          << static_cast<int>(style) << " at " << tolerance_m;
    }
}

}  // namespace
}  // namespace citykiln::buildings
