// The shipped species have the sizes that their head comments state: "15 to 25 m high, crown 12 to 24 m wide, trunk 0.6
// to 1.2 m thick".
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <regex>

#include "lsystems/mesh/tubes.h"
#include "lsystems/rewriting/turtle.h"
#include "tests/lsystems/derived.h"
#include "tests/test_files.h"

namespace citykiln::lsystems {
namespace {

constexpr std::uint64_t kSeeds = 8;

struct Bounds {
  double low = 0, high = 0;

  bool hold(double value) const { return low <= value && value <= high; }
};

/// A file, and the sizes in its first comment.
struct Species {
  std::string name, text;
  Bounds height_m, crown_m, trunk_m;
};

Bounds bounds_of(const std::smatch& match, int first) { return {std::stod(match[first]), std::stod(match[first + 1])}; }

Species read_species(const std::string& name) {
  Species species{name, text_of_tree("lsystems/species/" + name + ".lsys"), {}, {}, {}};
  static const std::regex kHead(
      R"(([\d.]+) to ([\d.]+) m high, crown ([\d.]+) to ([\d.]+) m wide, (?:trunk|stems) ([\d.]+) to ([\d.]+) m thick)");
  std::smatch match;
  EXPECT_TRUE(std::regex_search(species.text, match, kHead)) << name;
  if (match.empty()) return species;
  species.height_m = bounds_of(match, 1);
  species.crown_m = bounds_of(match, 3);
  species.trunk_m = bounds_of(match, 5);
  return species;
}

std::vector<std::string> names() {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("lsystems/species")))
    if (entry.path().extension() == ".lsys") found.push_back(entry.path().stem().string());
  std::sort(found.begin(), found.end());
  return found;
}

using Given = std::map<std::string, double, std::less<>>;

Plant grown_plant(const Species& species, std::uint64_t seed, const Given& given = {}) {
  const Result<LSystem> system = read_lsystem(species.text, species.name + ".lsys", given);
  EXPECT_TRUE(system) << to_string(system.error());
  if (!system) return {};
  DeriveOptions options;
  options.seed = seed;
  Plant plant = grow(*system, options);
  EXPECT_FALSE(plant.derivation.limit_exceeded) << species.name;
  for (const auto* warnings : {&plant.derivation.warnings, &plant.skeleton.warnings})
    for (const Warning& warning : *warnings) ADD_FAILURE() << warning_line(*system, warning);
  return plant;
}

/// Ends of segments, vertices of polygons, bases and tips of instances.
std::vector<Vec3> points_of(const Skeleton& skeleton) {
  std::vector<Vec3> points = skeleton.vertices;
  for (const Segment& segment : skeleton.segments) {
    points.push_back(segment.start.at);
    points.push_back(segment.end().at);
  }
  for (const Instance& instance : skeleton.instances) {
    points.push_back(instance.frame.at);
    points.push_back(instance.frame.at + instance.frame.heading * instance.size);
  }
  return points;
}

struct Extent {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  /// Mean of the widths in x and y.
  double width() const { return (high.x - low.x + high.y - low.y) / 2; }
};

Extent extent_of(const std::vector<Vec3>& points) {
  Extent extent;
  for (const Vec3 p : points) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y), std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y), std::max(extent.high.z, p.z)};
  }
  return extent;
}

/// The file's default height.
double default_height_m(const Species& species) {
  static const std::regex kDefault(R"(#define height_m ([\d.]+))");
  std::smatch match;
  EXPECT_TRUE(std::regex_search(species.text, match, kDefault)) << species.name;
  return match.empty() ? 1 : std::stod(match[1]);
}

/// Species with few leaves, of which scenes have many.
bool is_small(const Species& species) {
  constexpr std::array kSmall = {"fern", "grass", "hedge", "maize", "reed", "straw", "vine", "wheat"};
  return std::ranges::find(kSmall, species.name) != kSmall.end();
}

bool has_many_stems(const Species& species) {
  constexpr std::array kMany = {"bush", "fern", "grass", "hedge", "reed", "sagebrush", "straw", "wheat"};
  return std::ranges::find(kMany, species.name) != kMany.end();
}

class EachSpecies : public testing::TestWithParam<std::string> {};

TEST_P(EachSpecies, HasTheHeightAndWidthOfItsHead) {
  const Species species = read_species(GetParam());
  const double height_m = default_height_m(species);
  EXPECT_TRUE(species.height_m.hold(height_m));
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Plant plant = grown_plant(species, seed);
    const std::vector<Vec3> points = points_of(plant.skeleton);
    for (const Vec3 p : points) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    const Extent extent = extent_of(points);
    EXPECT_GE(extent.low.z, -0.1) << "seed " << seed;
    EXPECT_NEAR(extent.high.z, height_m, 0.1 * height_m) << "seed " << seed;
    EXPECT_TRUE(species.crown_m.hold(extent.width())) << extent.width() << " m, seed " << seed;
  }
}

// The trunk's diameter at 1.3 m, or at a quarter of the height if that is lower; of a bush, that of a rod.
TEST_P(EachSpecies, HasTheTrunkOfItsHead) {
  const Species species = read_species(GetParam());
  const std::int32_t order = has_many_stems(species) ? 1 : 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Plant plant = grown_plant(species, seed);
    const double breast_m = std::min(1.3, default_height_m(species) / 4);
    const auto found = std::find_if(
        plant.skeleton.segments.begin(), plant.skeleton.segments.end(),
        [&](const Segment& s) { return s.order <= order && s.start.at.z <= breast_m && s.end().at.z >= breast_m; });
    ASSERT_NE(found, plant.skeleton.segments.end());
    const double diameter_m = found->start_radius + found->end_radius;
    EXPECT_TRUE(species.trunk_m.hold(diameter_m)) << diameter_m << " m, seed " << seed;
  }
}

TEST_P(EachSpecies, KeepsItsBudgetAtFullDetail) {
  const Species species = read_species(GetParam());
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Skeleton skeleton = grown_plant(species, seed).skeleton;
    const std::size_t leaves = skeleton.instances.size() + skeleton.polygons.size();
    EXPECT_GE(skeleton.segments.size(), is_small(species) ? 20u : 1'000u);
    EXPECT_LE(skeleton.segments.size(), is_small(species) ? 1'000u : 20'000u);
    EXPECT_LE(leaves, is_small(species) ? 5'000u : 11'000u);
    EXPECT_GE(leaves, is_small(species) ? 50u : 1'000u);
  }
}

// Half and 1.5 times the default height, at 5 to 400 years.
TEST_P(EachSpecies, HasTheGivenHeightAtAnyAge) {
  const Species species = read_species(GetParam());
  for (const double height_m : {default_height_m(species) / 2, default_height_m(species) * 1.5})
    for (const double age : {5.0, 25.0, 400.0}) {
      const Plant plant = grown_plant(species, 1, {{"height_m", height_m}, {"age", age}});
      const Extent extent = extent_of(points_of(plant.skeleton));
      EXPECT_NEAR(extent.high.z, height_m, 0.1 * height_m) << "age " << age;
      EXPECT_GE(extent.low.z, -0.1) << "age " << age;
      EXPECT_LE(extent.width(), (is_small(species) ? 1.8 : 1.4) * height_m) << "age " << age;
    }
}

TEST_P(EachSpecies, IsAFunctionOfItsSeed) {
  const Species species = read_species(GetParam());
  std::vector<std::vector<Vec3>> plants;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) plants.push_back(points_of(grown_plant(species, seed).skeleton));
  for (std::size_t i = 0; i < plants.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(plants[i], plants[j]) << i << " and " << j;
  EXPECT_EQ(points_of(grown_plant(species, 3).skeleton), plants[3]);
}

TEST_P(EachSpecies, HasBarkAndLeavesAsAMesh) {
  const Species species = read_species(GetParam());
  const PlantMesh mesh = mesh_plant(grown_plant(species, 0).skeleton);
  EXPECT_GT(mesh.leaf.triangles.size(), is_small(species) ? 80u : 2'000u);
  if (is_small(species)) return;
  EXPECT_GT(mesh.bark.triangles.size(), 1'000u);
  // only the trunk is separate: one root, and at most four branches at a node
  EXPECT_EQ(mesh.separate_stems, 1u);
}

INSTANTIATE_TEST_SUITE_P(Shipped, EachSpecies, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& info) { return info.param; });

TEST(Species, AreListedInTheReadme) {
  const std::string readme = text_of_tree("lsystems/notation.md");
  ASSERT_EQ(names().size(), 29u);
  for (const std::string& name : names()) EXPECT_NE(readme.find("`" + name + "`"), std::string::npos) << name;
}

}  // namespace
}  // namespace citykiln::lsystems
