// Clouds as USD and OpenVDB; other programs read them in tests/interop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "exporters/usd/encode_cloud_layer.h"
#include "exporters/usd/read_layer.h"
#include "exporters/vdb/encode_vdb.h"

namespace citykiln::exporters {
namespace {

constexpr sky::CloudLayer kLayers[] = {{sky::CloudKind::kCumulus, 0.4, 1500, 2300, {3, 4}, 7},
                                       {sky::CloudKind::kCirrus, 0.3, 8000, 8600, {20, 5}, 1}};

std::vector<sky::LayerParticles> particles() { return sky::clouds_over(kLayers, {{-500, -500}, {500, 500}}, 60, 2); }

TEST(EncodeVdb, GivesTheSameBytesWithoutARandomId) {
  const sky::CloudVoxels voxels = sky::cloud_voxels(particles(), {0, 0, 0}, 80);
  const auto first = encode_vdb(voxels), second = encode_vdb(voxels);
  if (!first) GTEST_SKIP() << first.error().message;
  EXPECT_EQ(*first, *second);
  ASSERT_GT(first->size(), 10000U);
  // the magic number, and the id
  EXPECT_EQ(std::memcmp(first->data(), " BDV", 4), 0);
  const std::string_view id(reinterpret_cast<const char*>(first->data()) + 21, 36);
  EXPECT_EQ(id, "00000000-0000-0000-0000-000000000000");
}

}  // namespace
}  // namespace citykiln::exporters
