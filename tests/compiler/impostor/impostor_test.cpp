#include "compiler/impostor/impostor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "compiler/contract/random_sequence.h"
#include "tests/compiler/impostor/made_wall.h"

namespace citykiln::impostor {
namespace {

using materials::Material;
using materials::MaterialMesh;

Impostor seen(const std::vector<MaterialMesh>& meshes, const View& view) { return render(model_of(meshes), view); }

Texel whole(Material material) {
  const Impostor one = seen({panel(0, 0, 1, 1, material)}, seen_from_south(1, 1));
  return one.picture.texels.front();
}

double light(Material material, std::size_t channel) { return values_of(material).base_colour[channel]; }

View with_slopes(View view) {
  view.has_slopes = true;
  return view;
}

// Random panels in front of and behind a wall of 8 by 8 m; their sides lie between samples, so that mirrored pictures
// are equal.
std::vector<MaterialMesh> scattered(std::uint64_t seed, std::size_t count) {
  const RandomSequence draw(seed, StableId{}, "panels");
  std::vector<MaterialMesh> meshes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto quarters = [&](std::uint32_t which, std::uint64_t below) {
      return static_cast<double>(draw.below(below, 6 * i + which)) / 4;
    };
    const double x = quarters(0, 32), z = quarters(1, 32), wide = 0.25 + quarters(2, 12), high = 0.25 + quarters(3, 6);
    const auto material = static_cast<Material>(draw.below(40, 6 * i + 4));
    // few different depths, so that there are ties
    meshes.push_back(panel(x, z, x + wide, z + high, material, quarters(5, 3)));
  }
  return meshes;
}

TEST(Impostor, ShowsTheColourOfAFace) {
  for (const Material material : {Material::kPlaster, Material::kGlass, Material::kMetalRoof}) {
    const Impostor one = seen({panel(0, 0, 3, 2, material)}, seen_from_south(3, 2));
    ASSERT_FALSE(one.picture.texels.empty());
    for (const Texel& texel : one.picture.texels) {
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(texel.light[c] / 65535.0, light(material, c), 1e-5);
      EXPECT_NEAR(texel.roughness / 255.0, values_of(material).roughness, 0.002);
      EXPECT_EQ(texel.shown, kSamplesPerTexel);
    }
    EXPECT_EQ(one.dominant, (materials::SurfaceMaterial{material, materials::kNoTint}));
    EXPECT_EQ(one.dominant_share, 1);
  }
}

TEST(Impostor, ShowsEmission) {
  const std::vector<MaterialMesh> half_lit = {panel(0, 0, 1, 1, Material::kPlaster),
                                              panel(0, 0, 0.5, 1, Material::kRoomWall, -0.25)};
  const Texel texel = seen(half_lit, seen_from_south(1, 1)).picture.texels.front();
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(texel.emission[c] / 65535.0, emission_of(Material::kRoomWall)[c] / 2, 1e-5);
  EXPECT_EQ(whole(Material::kPlaster).emission, (std::array<std::uint16_t, 3>{}));
}

// A balcony 1 m in front of a window hides its colour; a frame hides its light too.
TEST(Impostor, ShowsLightPastDistantOccluders) {
  const auto behind = [](double y) {
    return seen({panel(0, 0, 1, 1, Material::kPlaster, y), panel(0, 0, 1, 1, Material::kRoomWall, 0.5)},
                seen_from_south(1, 1))
        .picture.texels.front();
  };
  EXPECT_EQ(behind(-0.5).emission, whole(Material::kRoomWall).emission);
  EXPECT_EQ(behind(-0.5).light, whole(Material::kPlaster).light);
  EXPECT_EQ(behind(0.25).emission, (std::array<std::uint16_t, 3>{}));
}

TEST(Impostor, MultipliesColoursByTints) {
  MaterialMesh mesh = panel(0, 0, 1, 1, Material::kPlaster);
  mesh.tint = {255, 51, 0, 255};
  const Texel texel = seen({mesh}, seen_from_south(1, 1)).picture.texels.front();
  EXPECT_NEAR(texel.light[0] / 65535.0, light(Material::kPlaster, 0), 1e-5);
  EXPECT_NEAR(texel.light[1] / 65535.0, light(Material::kPlaster, 1) / 5, 1e-5);
  EXPECT_EQ(texel.light[2], 0);
}

TEST(Impostor, MixesColoursByCoveredShare) {
  const std::vector<MaterialMesh> halves = {panel(0, 0, 0.5, 1, Material::kPlaster),
                                            panel(0.5, 0, 1, 1, Material::kGlass)};
  const Impostor one = seen(halves, seen_from_south(1, 1));
  const Texel texel = one.picture.texels.front(), a = whole(Material::kPlaster), b = whole(Material::kGlass);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(texel.light[c], (a.light[c] + b.light[c]) / 2.0, 0.5);
  EXPECT_NEAR(texel.roughness, (a.roughness + b.roughness) / 2.0, 0.5);
  EXPECT_EQ(one.dominant_share, 0.5);
}

TEST(Impostor, IgnoresSamplesThatAreNotCovered) {
  const Texel texel = seen({panel(0, 0, 0.5, 1, Material::kPlaster)}, seen_from_south(1, 1)).picture.texels.front();
  EXPECT_EQ(texel.light, whole(Material::kPlaster).light);
  EXPECT_EQ(texel.shown, kSamplesPerTexel / 2);
}

TEST(Impostor, ShowsTheNearestSurface) {
  const std::vector<MaterialMesh> one_behind = {panel(0, 0, 1, 1, Material::kBrick, 0.25),
                                                panel(0, 0, 1, 1, Material::kGlass, 0)};
  EXPECT_EQ(seen(one_behind, seen_from_south(1, 1)).dominant.material, Material::kGlass);
}

TEST(Impostor, IgnoresSurfacesOutsideOfTheDepthRange) {
  View view = seen_from_south(1, 1);
  view.before_m = 0.5, view.behind_m = 0.25;
  const auto shown = [&](double y) {
    return seen({panel(0, 0, 1, 1, Material::kBrick, y)}, view).picture.texels.front().shown > 0;
  };
  EXPECT_TRUE(shown(-0.49));
  EXPECT_FALSE(shown(-0.51));
  EXPECT_TRUE(shown(0.24));
  EXPECT_FALSE(shown(0.26));
}

TEST(Impostor, ClipsSurfacesAtTheDepthRange) {
  MaterialMesh ramp = panel(0, 0, 1, 4, Material::kBrick);
  for (Vec3& p : ramp.mesh.positions) p.y = p.z;
  View view = seen_from_south(1, 4);
  view.behind_m = 2;
  const std::vector<Texel> texels = seen({ramp}, view).picture.texels;
  ASSERT_EQ(texels.size(), 4u);
  for (std::size_t row = 0; row < 4; ++row) EXPECT_EQ(texels[row].shown > 0, row >= 2) << row;
}

TEST(Impostor, IgnoresBackFaces) {
  MaterialMesh mesh = panel(0, 0, 1, 1, Material::kBrick);
  for (Triangle& t : mesh.mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(seen({mesh}, seen_from_south(1, 1)).picture.texels.front(), Texel{});
}

TEST(Impostor, DoesNotDependOnTheOrderOfTriangles) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<MaterialMesh> meshes = scattered(seed, 40);
    const Impostor one = seen(meshes, seen_from_south(8, 8));
    std::ranges::reverse(meshes);
    for (MaterialMesh& mesh : meshes) std::ranges::reverse(mesh.mesh.triangles);
    const Impostor other = seen(meshes, seen_from_south(8, 8));
    EXPECT_GT(one.dominant_share, 0);
    EXPECT_EQ(one.picture, other.picture);
    EXPECT_EQ(one.dominant, other.dominant);
  }
}

TEST(Impostor, IsMirroredForMirroredInput) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<MaterialMesh> meshes = scattered(seed, 40);
    const Picture one = seen(meshes, with_slopes(seen_from_south(8, 8))).picture;
    for (MaterialMesh& mesh : meshes) {
      for (Vec3& p : mesh.mesh.positions) p.x = 8 - p.x;
      for (Triangle& t : mesh.mesh.triangles) std::swap(t[1], t[2]);
    }
    Picture other = seen(meshes, with_slopes(seen_from_south(8, 8))).picture;
    for (Texel& texel : other.texels) texel.slope[0] = static_cast<std::int16_t>(-texel.slope[0]);
    for (std::size_t row = 0; row < other.rows; ++row)
      std::reverse(other.texels.begin() + static_cast<std::ptrdiff_t>(row * 8),
                   other.texels.begin() + static_cast<std::ptrdiff_t>(row * 8 + 8));
    EXPECT_EQ(one, other);
  }
}

TEST(Impostor, HasTheSlopeOfARamp) {
  // 2 m high, 1 m farther back at its top
  MaterialMesh ramp = panel(0, 0, 3, 2, Material::kBrick);
  for (Vec3& p : ramp.mesh.positions) p.y = p.z / 2;
  for (const Texel& texel : seen({ramp}, with_slopes(seen_from_south(3, 2))).picture.texels) {
    EXPECT_EQ(texel.slope[0], 0);
    // at the picture's border there is no sample beyond
    EXPECT_NEAR(texel.slope[1] * kSlopeUnit, 0.5, 0.07);
  }
  EXPECT_EQ(seen({ramp}, seen_from_south(3, 2)).picture.texels.front().slope, (std::array<std::int16_t, 2>{}));
}

// The height of a step does not depend on its position in a texel or between two.
TEST(Impostor, HasSlopesThatAddUpToTheRise) {
  for (const double at : {0.6, 1.0, 1.1, 2.5}) {
    const std::vector<MaterialMesh> step = {panel(0, 0, at, 1, Material::kBrick, 0.25),
                                            panel(at, 0, 3, 1, Material::kGlass)};
    double rise_m = 0;
    for (const Texel& texel : seen(step, with_slopes(seen_from_south(3, 1))).picture.texels)
      rise_m += texel.slope[0] * kSlopeUnit;
    EXPECT_NEAR(rise_m, 0.25, 1e-9) << at;
  }
}

TEST(Impostor, HasNoSlopeNextToUncoveredSamples) {
  const Picture picture = seen({panel(1.2, 0, 2, 1, Material::kBrick, 0.5), panel(0, 0, 0.6, 1, Material::kBrick)},
                               with_slopes(seen_from_south(3, 1)))
                              .picture;
  ASSERT_EQ(picture.texels.size(), 3u);
  for (const Texel& texel : picture.texels) EXPECT_EQ(texel.slope, (std::array<std::int16_t, 2>{}));
}

// The wall rotated to face east, seen from the east.
TEST(Impostor, IsTheSameForARotatedWall) {
  std::vector<MaterialMesh> meshes = scattered(3, 40);
  const Picture south = seen(meshes, seen_from_south(8, 8)).picture;
  for (MaterialMesh& mesh : meshes)
    for (Vec3& p : mesh.mesh.positions) p = {100 - p.y, p.x, p.z};
  View view = seen_from_south(8, 8);
  view.corner = {100, 0, 8}, view.u = {0, 1, 0};
  EXPECT_EQ(seen(meshes, view).picture, south);
}

TEST(Impostor, CoversSharedEdgesOnce) {
  // vertices at sample centres, so that all edges pass through samples
  MaterialMesh fan;
  fan.material = Material::kBrick;
  fan.mesh.positions = {{2.125, 0, 2.125}, {0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}};
  fan.mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  const Picture picture = seen({fan}, seen_from_south(4, 4)).picture;
  ASSERT_EQ(picture.texels.size(), 16u);
  for (const Texel& texel : picture.texels) EXPECT_EQ(texel.shown, kSamplesPerTexel);
}

TEST(Impostor, IgnoresVerticesThatAreNotFinite) {
  MaterialMesh mesh = panel(0, 0, 1, 1, Material::kBrick);
  mesh.mesh.positions[0].x = std::numeric_limits<double>::quiet_NaN();
  mesh.mesh.positions[3].z = std::numeric_limits<double>::infinity();
  mesh.mesh.positions.push_back({-1e300, 0, 0}), mesh.mesh.triangles.push_back({4, 1, 2});
  EXPECT_EQ(seen({mesh}, seen_from_south(1, 1)).picture.texels.front(), Texel{});
}

TEST(Impostor, IsEmptyForAnEmptyModel) {
  const Impostor nothing = seen({}, seen_from_south(2, 2));
  EXPECT_EQ(nothing.picture.texels, std::vector<Texel>(4));
  EXPECT_EQ(nothing.dominant_share, 0);
}

TEST(Picture, UnpacksToWhatWasPacked) {
  Picture picture{40, 30, std::vector<Texel>(1200)};
  for (std::size_t i = 0; i < picture.texels.size(); ++i)
    picture.texels[i].light[0] = static_cast<std::uint16_t>(i / 7 % 50), picture.texels[i].shown = 16;
  const PackedPicture small = packed(picture);
  EXPECT_LT(small.bytes.size(), picture.texels.size() * sizeof(Texel) / 4);
  EXPECT_EQ(unpacked(small), picture);
}

}  // namespace
}  // namespace citykiln::impostor
