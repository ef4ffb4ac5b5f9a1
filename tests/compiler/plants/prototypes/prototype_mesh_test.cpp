#include "compiler/plants/prototypes/prototype_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/trig.h"
#include "compiler/materials/texture.h"
#include "compiler/plants/prototypes/crown_hull.h"
#include "compiler/plants/prototypes/leaf_clusters.h"
#include "compiler/plants/prototypes/sprays.h"

namespace citykiln::plants {
namespace {

using materials::ColourSource;

const GrownPlantCache& nursery() {
  static const GrownPlantCache nursery(shipped_species());
  return nursery;
}

const LeafAtlas& midsummer_leaves() {
  static const LeafAtlas atlas = leaf_atlas(kMidsummer);
  return atlas;
}

std::vector<Species> all_species() {
  std::vector<Species> all;
  for (const SpeciesText& text : shipped_species())
    for (int s = 0; s < static_cast<int>(Species::kCount); ++s)
      if (values_of(static_cast<Species>(s)).file == text.name) all.push_back(static_cast<Species>(s));
  return all;
}

PrototypeMesh mesh_of(Species species, double tolerance_m) {
  return prototype_mesh(nursery().grown({species, 0}), midsummer_leaves(), species, values_of(species).tallest_m,
                        tolerance_m);
}

bool has_trunk(Species species) {
  const LeafForm leaves = values_of(species).leaf_form;
  return leaves != LeafForm::kBlade && species != Species::kFern;
}

std::size_t triangles_of(const PrototypeMesh& plant) {
  std::size_t sum = 0;
  for (const auto& dressed : plant.meshes) sum += dressed.mesh.triangles.size();
  return sum;
}

double area_of(const std::vector<Card>& cards) {
  double sum = 0;
  for (const Card& card : cards) sum += area_of(card);
  return sum;
}

class EachPlant : public testing::TestWithParam<Species> {};

TEST_P(EachPlant, HasLeaves) {
  const GrownPlant& grown = nursery().grown({GetParam(), 0});
  EXPECT_GT(grown.foliage.cards.size(), 10u);
  EXPECT_GT(grown.height_m, 0);
}

TEST_P(EachPlant, IsAMetreTallAndStandsOnTheGround) {
  for (const double share : {0.001, 0.02, 0.1}) {
    double low = 1, high = 0;
    for (const auto& dressed : mesh_of(GetParam(), share * values_of(GetParam()).tallest_m).meshes)
      for (const Vec3 p : dressed.mesh.positions) low = std::min(low, p.z), high = std::max(high, p.z);
    EXPECT_NEAR(high, 1, 0.03 + share) << share;
    EXPECT_NEAR(low, 0, 0.06 + 2.8 * share) << share;
  }
}

// Stems keep the tolerance, leaves the width of their clusters: six tolerances at most, 2.8 at coarse levels.
TEST_P(EachPlant, StatesAnErrorOfAFewTolerances) {
  const double tallest_m = values_of(GetParam()).tallest_m;
  for (const double share : {0.0005, 0.002, 0.01, 0.03, 0.1}) {
    const PrototypeMesh plant = mesh_of(GetParam(), share * tallest_m);
    EXPECT_FALSE(plant.meshes.empty()) << share;
    EXPECT_LE(plant.error_per_m, share * (share < 1.0 / 64 ? 6 : 2.8)) << share;
  }
}

TEST_P(EachPlant, GetsNoLargerWithTheTolerance) {
  std::size_t last = triangles_of(mesh_of(GetParam(), 0.0005 * values_of(GetParam()).tallest_m));
  ASSERT_GT(last, 0u);
  for (const double share : {0.002, 0.01, 0.03, 0.1, 0.5}) {
    const std::size_t now = triangles_of(mesh_of(GetParam(), share * values_of(GetParam()).tallest_m));
    EXPECT_LE(now, std::max<std::size_t>(last, 40)) << share;
    last = now;
  }
}

// The mean of the trees of a mixed wood.
TEST(PrototypeMesh, LosesAtMostSevenEighthsOfItsTrianglesFromOneDefaultLevelToTheNext) {
  constexpr Species kTrees[] = {Species::kOak, Species::kBeech, Species::kBirch, Species::kSpruce, Species::kPine};
  for (const double height_m : {16.0, 32.0}) {
    double last = 0;
    for (const double tolerance_m : {0.1, 0.5, 1.2, 2.5, 12.5}) {
      double sum = 0;
      for (const Species species : kTrees)
        sum += static_cast<double>(triangles_of(
            prototype_mesh(nursery().grown({species, 0}), midsummer_leaves(), species, height_m, tolerance_m)));
      EXPECT_LE(last / sum, 8) << height_m << " m tall at " << tolerance_m;
      EXPECT_TRUE(last == 0 || sum < last);
      EXPECT_GE(sum, 8 * std::size(kTrees));
      last = sum;
    }
  }
}

TEST_P(EachPlant, IsDeterministic) {
  const GrownPlant again = grow(*std::ranges::find(shipped_species(), values_of(GetParam()).file, &SpeciesText::name),
                                values_of(GetParam()), 3);
  EXPECT_EQ(again.skeleton.segments.size(), nursery().grown({GetParam(), 3}).skeleton.segments.size());
  const double tolerance_m = 0.1 * values_of(GetParam()).tallest_m;
  const PrototypeMesh a =
      prototype_mesh(again, midsummer_leaves(), GetParam(), values_of(GetParam()).tallest_m, tolerance_m);
  const PrototypeMesh b = prototype_mesh(nursery().grown({GetParam(), 3}), midsummer_leaves(), GetParam(),
                                         values_of(GetParam()).tallest_m, tolerance_m);
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (std::size_t i = 0; i < a.meshes.size(); ++i) EXPECT_EQ(a.meshes[i].uvs, b.meshes[i].uvs);
}

Vec3 in_ellipse(const Card& card, double turn, double share) {
  const Vec2 p = direction_of(turn) * (share / 2);
  return card.centre() + card.across * p.x + card.along * p.y;
}

// Samples in the ellipses that show leaves against all cards of the other set.
TEST_P(EachPlant, HasClustersWithinTheirError) {
  const Foliage& foliage = nursery().grown({GetParam(), 0}).foliage;
  for (const double share : {0.02, 0.1, 0.3}) {
    const double width_m = share * values_of(GetParam()).height_m;
    const Clusters clusters = cluster(foliage, width_m);
    EXPECT_LE(clusters.error_m, width_m);
    EXPECT_LE(clusters.cards.size(), foliage.cards.size());
    const auto worst = [](const std::vector<Card>& from, const std::vector<Card>& to) {
      double farthest = 0;
      for (std::size_t i = 0; i < from.size(); i += from.size() / 60 + 1)
        for (const double turn : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}) {
          const Vec3 p = in_ellipse(from[i], turn, 1);
          double nearest = 1e300;
          for (const Card& card : to) nearest = std::min(nearest, distance(card, p));
          farthest = std::max(farthest, nearest);
        }
      return farthest;
    };
    EXPECT_LE(worst(foliage.cards, clusters.cards), clusters.error_m + 1e-9);
    EXPECT_LE(worst(clusters.cards, foliage.cards), clusters.error_m + 1e-9);
  }
}

// Clumps have more leaves on a smaller card; what lies behind others may go.
TEST_P(EachPlant, KeepsItsLeafAreaWhileClustersAreSmall) {
  const Foliage& foliage = nursery().grown({GetParam(), 0}).foliage;
  double area = 0;
  for (const Card& card : cluster(foliage, 0.02 * values_of(GetParam()).height_m).cards)
    area += area_of(card) * (card.is_clump ? kClumpLeaves : 1);
  EXPECT_GT(area / area_of(foliage.cards), 0.4);
  EXPECT_LT(area / area_of(foliage.cards), 1.01);
}

TEST_P(EachPlant, HasAClosedHull) {
  const CrownHull hull = crown_hull(nursery().grown({GetParam(), 0}).foliage);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : hull.mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      ++sides[{t[i], t[(i + 1) % 3]}];
      --sides[{t[(i + 1) % 3], t[i]}];
    }
  ASSERT_FALSE(sides.empty());
  for (const auto& [side, count] : sides) EXPECT_EQ(count, 0);
  double volume = 0;
  for (const Triangle& t : hull.mesh.triangles)
    volume += dot(hull.mesh.positions[t[0]], cross(hull.mesh.positions[t[1]], hull.mesh.positions[t[2]])) / 6;
  EXPECT_GT(volume, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, EachPlant, testing::ValuesIn(all_species()),
                         [](const auto& info) { return std::string(values_of(info.param).file); });

TEST(PrototypeMesh, OfAHedgeIsAClosedBoxAtCoarseLevels) {
  const PrototypeMesh hedge = mesh_of(Species::kHedge, 0.2 * values_of(Species::kHedge).tallest_m);
  ASSERT_EQ(triangles_of(hedge), 12u);
  EXPECT_LE(hedge.error_per_m, 0.3);
  double volume = 0;
  const Mesh& box = hedge.meshes[0].mesh;
  for (const Triangle& t : box.triangles) {
    volume += dot(box.positions[t[0]], cross(box.positions[t[1]], box.positions[t[2]])) / 6;
    const Vec3 out = cross(box.positions[t[1]] - box.positions[t[0]], box.positions[t[2]] - box.positions[t[0]]);
    EXPECT_GT(dot(out, box.normals[t[0]]), 0);
  }
  EXPECT_NEAR(volume, 0.9 * 0.9 * 0.5, 0.12);
}

TEST(PrototypeMesh, IsDroppedWhereThePlantIsLowerThanTheTolerance) {
  const PrototypeMesh plant = mesh_of(Species::kBush, 12.5);
  EXPECT_TRUE(plant.meshes.empty());
  EXPECT_EQ(plant.error_per_m, 1);
}

TEST(PrototypeMesh, OfAnUnreadableTextIsEmpty) {
  const GrownPlant grown = grow({"oak", "axiom: ["}, values_of(Species::kOak), 0);
  EXPECT_TRUE(prototype_mesh(grown, midsummer_leaves(), Species::kOak, 20, 0.1).meshes.empty());
}

TEST(Sprays, CoverMoreOfACardAsAClump) {
  const auto share = [](const char* name, bool is_clump) {
    const impostor::Picture picture = picture_of_spray(name, materials::Material::kBroadLeaf, 1, is_clump);
    std::uint64_t shown = 0;
    for (const impostor::Texel& texel : picture.texels) shown += texel.shown;
    return static_cast<double>(shown) / (static_cast<double>(picture.texels.size()) * impostor::kSamplesPerTexel);
  };
  for (const char* name : {"oak_leaf", "birch_leaf", "spruce_needles", "pine_needles", "willow_leaf"})
    EXPECT_NEAR(share(name, true) / share(name, false), kClumpLeaves, 0.3) << name;
}

TEST(Sprays, CoverAPartOfTheirCard) {
  for (const char* name : {"oak_leaf", "spruce_needles", "willow_leaf", "palm", ""}) {
    const impostor::Picture picture = picture_of_spray(name, materials::Material::kBroadLeaf);
    std::uint64_t shown = 0;
    for (const impostor::Texel& texel : picture.texels) shown += texel.shown;
    const double share =
        static_cast<double>(shown) / (static_cast<double>(picture.texels.size()) * impostor::kSamplesPerTexel);
    EXPECT_GT(share, 0.2) << name;
  }
}

TEST(PrototypeBark, IsNamedByEachSpeciesWithATrunk) {
  for (const Species species : all_species())
    EXPECT_EQ(is_bark(nursery().grown({species, 0}).bark), has_trunk(species)) << values_of(species).file;
  EXPECT_EQ(bark_named("furrowed"), materials::Material::kFurrowedBark);
  for (const char* name : {"", "no_such", "grass"}) EXPECT_EQ(bark_named(name), materials::Material::kBark);
}

TEST(PrototypeBark, HasTextureCoordinatesAtFineLevels) {
  int tested = 0;
  for (const Species species : {Species::kOak, Species::kBirch, Species::kPalm})
    for (const double tolerance_m : {0.02, 0.1, 0.25, 0.5, 1.0}) {
      const auto meshes = mesh_of(species, tolerance_m).meshes;
      const materials::MaterialMesh& stems = meshes.front();
      if (stems.colour_source != ColourSource::kByMaterial) continue;
      ++tested;
      const bool is_shown = has_detail(Detail::kMaterialTextures, tolerance_m);
      EXPECT_EQ(stems.uvs.size(), is_shown ? stems.mesh.positions.size() : 0) << values_of(species).file << tolerance_m;
      EXPECT_EQ(stems.material, is_shown ? nursery().grown({species, 0}).bark : materials::Material::kBark);
      for (const Vec2 uv : stems.uvs) {
        EXPECT_EQ(std::fmod(uv.x, materials::kTextureCoordinateStep_m), 0);
        EXPECT_GE(std::min(uv.x, uv.y), 0);
      }
    }
  EXPECT_GE(tested, 9);
}

TEST(PrototypeBark, IsOfOneColourOnAllLevels) {
  using materials::Material;
  const auto plain = materials::values_of(Material::kBark).base_colour;
  for (int m = 0; m < static_cast<int>(Material::kCount); ++m) {
    const auto material = static_cast<Material>(m);
    if (!is_bark(material)) continue;
    EXPECT_EQ(materials::values_of(material).base_colour, plain);
  }
  EXPECT_EQ(mesh_of(Species::kOak, 0.02).meshes.front().tint, mesh_of(Species::kOak, 0.5).meshes.front().tint);
}

}  // namespace
}  // namespace citykiln::plants
