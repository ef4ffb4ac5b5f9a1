#include "compiler/plants/tufts/tuft_mesh.h"

#include <gtest/gtest.h>

namespace citykiln::plants {
namespace {

constexpr LeafColour kTestLeaf = {0.11, 0.18, 0.05};

TEST(TuftMesh, IsAboutAMetreTallAndCheap) {
  for (int form = 0; form < static_cast<int>(TuftForm::kCount); ++form)
    for (std::uint8_t variant = 0; variant < kTuftVariants; ++variant) {
      double top_m = 0;
      std::size_t triangles = 0;
      for (const materials::MaterialMesh& part : tuft_mesh(static_cast<TuftForm>(form), variant, kTestLeaf)) {
        triangles += part.mesh.triangles.size();
        for (const Vec3 p : part.mesh.positions) top_m = std::max(top_m, p.z);
        EXPECT_EQ(part.tints.size(), part.mesh.positions.size());
      }
      EXPECT_NEAR(top_m, 1, 0.05) << form;
      EXPECT_LE(triangles, 100u) << form;
    }
}

TEST(TuftMesh, HasTheColourOfTheGroundHalfwayUp) {
  const auto parts = tuft_mesh(TuftForm::kMown, 0, kTestLeaf);
  ASSERT_EQ(parts.size(), 1u);
  const auto& base = values_of(parts[0].material).base_colour;
  // the third vertex of a blade
  EXPECT_NEAR(parts[0].tints[2][1] / 255.0 * static_cast<double>(base[1]), kTestLeaf.green, 0.002);
}

}  // namespace
}  // namespace citykiln::plants
