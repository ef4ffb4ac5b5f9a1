#include "compiler/commands/serve/site.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

constexpr int kPort = 8000;

TEST(Site, OnlyThisMachineIsItsOwnHost) {
  EXPECT_TRUE(is_own_host("127.0.0.1:8000", kPort));
  EXPECT_TRUE(is_own_host("localhost:8000", kPort));
  for (const char* host : {"", "example.org", "example.org:8000", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:8000.org"})
    EXPECT_FALSE(is_own_host(host, kPort)) << host;
}

TEST(Site, MediaTypesAreThoseOfEndings) {
  EXPECT_EQ(std::string(media_type_of("page/viewer.js")), "application/javascript; charset=utf-8");
  EXPECT_EQ(std::string(media_type_of("3dtiles/a.glb")), "model/gltf-binary");
  EXPECT_EQ(std::string(media_type_of("scene.kiln")), "application/octet-stream");
}

}  // namespace
}  // namespace citykiln::commands
