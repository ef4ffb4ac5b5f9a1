#include "compiler/verify/check_folder.h"

#include <gtest/gtest.h>

namespace citykiln::verify {
namespace {

TEST(CheckFolder, KnowsTheNamesThatRunsGive) {
  for (const char* name : {"scene.kiln",
                           "report.json",
                           "findings.json",
                           "timing.json",
                           "glb/0_0_L0.glb",
                           "glb/-13_2_L10.glb",
                           "usd/scene.usda",
                           "usd/tiles/-1_0.usda",
                           "usd/tiles/0_0_L0.usdc",
                           "usd/textures/Grass_0.jpg",
                           "3dtiles/tileset.json",
                           "3dtiles/tileset_12.json",
                           "3dtiles/0_-1_L2.glb",
                           "3dtiles/Q3_0_1.glb",
                           "3dtiles/surroundings.glb",
                           "tileset.3tz",
                           "keys.jsonl",
                           "glb/clouds.glb",
                           "glb/surroundings.glb",
                           "glb/shared/0123456789abcdef_64.bin",
                           "usd/surroundings.usdc",
                           "usd/clouds.usdc",
                           "usd/clouds.vdb",
                           "page/viewer.js",
                           "page/page.json",
                           "page/names.json",
                           "page/features/12.json"})
    EXPECT_TRUE(is_name_of_run(name)) << name;
  for (const char* name :
       {"notes.txt", "glb/house.glb", "glb/0_0.glb", "glb/0_L0.glb", "glb/0_0_L0.glb.old", "0_0_L0.glb",
        "glb/a_b_L0.glb", "preview.png", "usd/mine.usda", "usd/textures/notes.txt", "3dtiles/notes.txt",
        "3dtiles/other.glb", "index.html", "page/", "page/notes.txt", "page/features/mine.json", "glb/shared/",
        "glb/shared/house.bin", "glb/shared/0123456789abcdef_x.bin"})
    EXPECT_FALSE(is_name_of_run(name)) << name;
}

}  // namespace
}  // namespace citykiln::verify
