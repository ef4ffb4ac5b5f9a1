#include "compiler/commands/view/frame_names.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

using Names = std::vector<std::string>;

TEST(FrameNames, CountFromOneInPlaceOfNumberSigns) {
  EXPECT_EQ(*frame_names("out/frame_####.png", 2), (Names{"out/frame_0001.png", "out/frame_0002.png"}));
  EXPECT_EQ(*frame_names("#2024/a#.exr", 11), (*frame_names("#2024/a1.exr", 11)));
  EXPECT_EQ(frame_names("f##.png", 100)->back(), "f100.png");
}

TEST(FrameNames, GoOnFromDigits) {
  EXPECT_EQ(*frame_names("a_0099.png", 2), (Names{"a_0099.png", "a_0100.png"}));
  EXPECT_EQ(*frame_names("/x1/b7c.png", 2), (Names{"/x1/b7c.png", "/x1/b8c.png"}));
}

TEST(FrameNames, WithoutANumberAreOneClearLine) {
  for (const char* name : {"a.png", "x1/a.png", ".png", "1/.png", "", "99999999999999999999999.png"})
    EXPECT_FALSE(frame_names(name, 2)) << name;
}

}  // namespace
}  // namespace citykiln::commands
