#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "preview/picture/image.h"
#include "preview/picture/tone_map.h"
#include "tests/scratch_folder.h"

namespace citykiln::preview {
namespace {

namespace fs = std::filesystem;

Image small_image() {
  Image image{5, 3, {}};
  for (int i = 0; i < 5 * 3 * 3; ++i) image.rgb.push_back(0.05f * static_cast<float>(i));
  return image;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class WriteImage : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_.at(name); }
  std::set<std::string> names() const { return folder_.names(); }

  const ScratchFolder folder_;
};

TEST_F(WriteImage, PngIsWrittenAndNothingElse) {
  const auto done = write_image(small_image(), at("a.png"));
  ASSERT_TRUE(done) << to_string(done.error());
  EXPECT_EQ(names(), std::set<std::string>{"a.png"});
  const std::string bytes = bytes_of(at("a.png"));
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  // IHDR: width and height, 8 bits, RGB
  EXPECT_EQ(bytes.substr(16, 10), std::string("\0\0\0\5\0\0\0\3\x08\x02", 10));
}

TEST_F(WriteImage, ExrIsWrittenAndNothingElse) {
  const auto done = write_image(small_image(), at("a.exr"));
  ASSERT_TRUE(done) << to_string(done.error());
  EXPECT_EQ(names(), std::set<std::string>{"a.exr"});
  EXPECT_EQ(bytes_of(at("a.exr")).substr(0, 4), "\x76\x2f\x31\x01");
}

// Image files contain neither time nor path.
TEST_F(WriteImage, SamePictureSameBytes) {
  for (const char* ending : {".png", ".exr"}) {
    ASSERT_TRUE(write_image(small_image(), at((std::string("a") + ending))));
    ASSERT_TRUE(write_image(small_image(), at((std::string("b") + ending))));
    EXPECT_EQ(bytes_of(at((std::string("a") + ending))), bytes_of(at((std::string("b") + ending))));
  }
}

TEST_F(WriteImage, AFileOfThatNameIsReplaced) {
  std::ofstream(at("a.png")) << "old";
  ASSERT_TRUE(write_image(small_image(), at("a.png")));
  EXPECT_EQ(bytes_of(at("a.png")).substr(1, 3), "PNG");
}

TEST_F(WriteImage, AnotherEndingIsOneClearLine) {
  for (const char* name : {"a.jpg", "a", "png", ".pn", "a.png.txt", ""}) {
    const auto done = write_image(small_image(), name);
    ASSERT_FALSE(done) << name;
    EXPECT_EQ(done.error().where, name);
    EXPECT_EQ(done.error().message, "expected a name that ends in .png or .exr");
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(WriteImage, AFolderThatIsNotThereIsOneClearLine) {
  for (const char* name : {"a.png", "a.exr"}) {
    const std::string path = at(std::string("absent/") + name);
    const auto done = write_image(small_image(), path);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().where, path);
    EXPECT_TRUE(done.error().message.starts_with("cannot be written: ")) << done.error().message;
    EXPECT_GT(done.error().message.size(), 20u);
    EXPECT_EQ(done.error().message.find('\n'), std::string::npos) << done.error().message;
  }
}

TEST_F(WriteImage, AFolderInItsPlaceIsOneClearLineAndLeavesNoPart) {
  for (const char* name : {"a.png", "a.exr"}) {
    fs::create_directories(fs::path(at(name)) / "inside");
    const auto done = write_image(small_image(), at(name));
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().where, at(name));
    EXPECT_EQ(done.error().message.find('\n'), std::string::npos) << done.error().message;
  }
  EXPECT_EQ(names(), (std::set<std::string>{"a.exr", "a.png"}));
}

// On a full disk no half-written file stays.
TEST_F(WriteImage, AFullDiskIsOneClearLineAndLeavesNoPart) {
  for (const char* ending : {".png", ".exr"}) {
    fs::create_symlink("/dev/full", at((std::string("a.part") + ending)));
    const auto done = write_image(small_image(), at((std::string("a") + ending)));
    ASSERT_FALSE(done) << ending;
    EXPECT_EQ(done.error().message.find('\n'), std::string::npos) << done.error().message;
  }
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace citykiln::preview
