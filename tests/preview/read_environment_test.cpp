#include "preview/picture/read_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "preview/picture/image.h"
#include "tests/scratch_folder.h"

namespace citykiln::preview {
namespace {

class ReadEnvironmentFile : public testing::Test {
 protected:
  // A picture of which texel (x, y) is {x, y, 0}, times a half.
  std::string ramp(int width, int height) const {
    Image image{.width = width, .height = height};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (const double v : {0.5 * x, 0.5 * y, 0.0}) image.rgb.push_back(static_cast<float>(v));
    const std::string path = folder_.at("ramp.exr");
    EXPECT_TRUE(write_image(image, path));
    return path;
  }
  std::string hdr(const std::string& name, const std::string& size, const std::string& texels) const {
    const std::string path = folder_.at(name);
    std::ofstream(path, std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" << size << "\n" << texels;
    return path;
  }

  const ScratchFolder folder_;
};

// East is in the middle of EnvironmentMap; the picture's middle is the bearing that was given.
TEST_F(ReadEnvironmentFile, TheMiddleIsAtItsBearing) {
  const std::string path = ramp(16, 8);
  const auto middle = [&](double turn_deg) { return read_environment(path, turn_deg)->map.rgb[(3 * 16 + 8) * 3]; };
  EXPECT_EQ(middle(90), 4);             // middle of the picture
  EXPECT_EQ(middle(0), 6);              // east is a quarter to the right of north
  EXPECT_EQ(middle(180), 2);            // and a quarter to the left of south
  EXPECT_EQ(middle(90 - 11.25), 4.25);  // between two columns
  EXPECT_EQ(read_environment(path, 0)->map.rgb[(3 * 16 + 8) * 3 + 1], 1.5f);
}

TEST_F(ReadEnvironmentFile, AnHdrFileIsLinear) {
  // exponent 129: mantissas / 128
  const auto read = read_environment(hdr("a.hdr", "-Y 1 +X 2", std::string("\x40\x80\x20\x81\x40\x80\x20\x81", 8)), 90);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_NEAR(read->map.rgb[0], 0.5, 0.01);
  EXPECT_NEAR(read->map.rgb[1], 1, 0.01);
}

TEST_F(ReadEnvironmentFile, NegativeAndInfiniteTexelsAreBlackAndCounted) {
  Image image{.width = 4, .height = 2, .rgb = std::vector<float>(24, 1.f)};
  image.rgb[4] = -1, image.rgb[9] = std::numeric_limits<float>::infinity(), image.rgb[10] = std::nanf("");
  ASSERT_TRUE(write_image(image, folder_.at("a.exr")));
  const auto read = read_environment(folder_.at("a.exr"), 90);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->mended, 2u);
  for (const float v : read->map.rgb) EXPECT_TRUE(v == 0 || v == 1) << v;
  EXPECT_EQ(read->map.rgb[4], 0);
}

// 100 GB by its header alone.
TEST_F(ReadEnvironmentFile, ASizeBeyondTheLimitIsOneClearLine) {
  const auto read = read_environment(hdr("a.hdr", "-Y 65536 +X 131072", "x"), 0);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("16384 x 8192"), std::string::npos) << read.error().message;
}

TEST_F(ReadEnvironmentFile, WrongFilesAreOneClearLine) {
  EXPECT_NE(read_environment(ramp(8, 8), 0).error().message.find("twice as wide"), std::string::npos);
  EXPECT_FALSE(read_environment(folder_.at("absent.exr"), 0));
  EXPECT_FALSE(read_environment("a.jpg", 0));
  EXPECT_FALSE(read_environment(hdr("cut.hdr", "-Y 4 +X 8", "\x02"), 0));
  std::ofstream(folder_.at("text.exr")) << "no picture";
  const auto text = read_environment(folder_.at("text.exr"), 0);
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().message.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace citykiln::preview
