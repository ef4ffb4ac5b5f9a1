#include "compiler/outputs/material_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "exporters/gltf/pictures/jpeg.h"
#include "exporters/gltf/pictures/png.h"

namespace citykiln::outputs {
namespace {

namespace fs = std::filesystem;
using materials::TextureImage;

// A folder of its own for each test, with a table and pictures.
class MaterialSets : public testing::Test {
 protected:
  MaterialSets() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "brick");
    write("materials.csv", "material,size_m,credit,licence\nbrick,1.6,Jane Doe,CC0\n");
  }
  ~MaterialSets() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  void write(const std::string& name, const std::vector<std::byte>& bytes) {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  Result<std::vector<MaterialSet>> read() const { return read_material_sets(folder_.string(), 512); }
  // The lines of the error.
  std::string faults() const {
    const auto sets = read();
    return sets ? "" : to_string(sets.error());
  }

  fs::path folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TextureImage picture(std::uint32_t columns, std::uint32_t rows, TextureImage::Texel low, TextureImage::Texel high) {
  TextureImage image{1, columns, rows, std::vector<TextureImage::Texel>(std::size_t{columns} * rows, low)};
  std::fill(image.texels.begin(), image.texels.begin() + static_cast<std::ptrdiff_t>(image.texels.size() / 2), high);
  return image;
}

constexpr TextureImage::Texel kDark = {90, 40, 30}, kBright = {160, 90, 70};

TEST_F(MaterialSets, AreReadAsAmbientCgNamesThem) {
  write("brick/Bricks075A_1K-JPG_Color.jpg",
        exporters::encode_jpeg(picture(600, 600, kDark, kBright), 95, exporters::JpegChroma::kFull));
  write("brick/Bricks075A_1K-JPG_NormalGL.png",
        exporters::encode_png(picture(600, 600, {128, 192, 238}, {128, 192, 238})));
  write("brick/Bricks075A_1K-JPG_Roughness.png",
        exporters::encode_png(picture(600, 600, {204, 204, 204}, {204, 204, 204})));
  write("brick/Bricks075A.png", exporters::encode_png(picture(20, 10, kDark, kBright)));  // a preview: no word
  const auto sets = read();
  ASSERT_TRUE(sets) << to_string(sets.error());
  ASSERT_EQ(sets->size(), 1u);
  const materials::Texture& texture = sets->front().texture;
  EXPECT_EQ(sets->front().credit, "Jane Doe");
  EXPECT_EQ(texture.colour.columns, 512u);
  EXPECT_DOUBLE_EQ(side_m(texture), 1.6);  // 64 m / 40
  EXPECT_EQ(texture.surface.texels.front()[1], 204);
  // up in the picture is up the wall, along v: against the image's rows
  EXPECT_NEAR(texture.normal.texels.front()[1], 63, 1);
  // the upper half of the picture is the half with larger v
  EXPECT_GT(texture.colour.texels.back()[0], texture.colour.texels.front()[0]);
  const auto factor = colour_factor(texture);
  for (const double f : factor) EXPECT_NEAR(f, 1 / 1.03, 0.01);
}

TEST_F(MaterialSets, AreReadAsPolyHavenNamesThem) {
  write("brick/red_brick_diff_1k.png", exporters::encode_png(picture(256, 256, kDark, kBright)));
  write("brick/red_brick_nor_dx_1k.png", exporters::encode_png(picture(256, 256, {128, 192, 238}, {128, 192, 238})));
  write("brick/red_brick_ao_1k.png", exporters::encode_png(picture(256, 256, {128, 128, 128}, {255, 255, 255})));
  const auto sets = read();
  ASSERT_TRUE(sets) << to_string(sets.error());
  EXPECT_NEAR(sets->front().texture.normal.texels.front()[1], 192, 1);
  EXPECT_TRUE(sets->front().texture.surface.texels.empty());
}

TEST_F(MaterialSets, AreNoneWithoutAFolder) {
  EXPECT_TRUE(read_material_sets("", 512)->empty());
  EXPECT_FALSE(read_material_sets((folder_ / "missing").string(), 512));
}

TEST_F(MaterialSets, NameWhatIsMissing) {
  EXPECT_NE(faults().find("brick: expected a picture whose name has Color or diff"), std::string::npos) << faults();
  fs::remove(folder_ / "materials.csv");
  EXPECT_NE(faults().find("materials.csv: expected a table"), std::string::npos) << faults();
  EXPECT_EQ(faults().find("expected a row"), std::string::npos) << faults();
  write("materials.csv", "brick,zero,me,CC0\n");
  EXPECT_NE(faults().find("materials.csv:1: expected material,size_m"), std::string::npos) << faults();
}

TEST_F(MaterialSets, NameEachPictureThatIsWrongInALine) {
  write("brick/a_Color.png", exporters::encode_png(picture(64, 64, kDark, kBright)));
  write("brick/a_Roughness.png", "not an image");
  write("brick/a_NormalGL.png", exporters::encode_png(picture(32, 32, kDark, kBright)));
  write("brick/a_AO.png", exporters::encode_png(picture(64, 32, kDark, kBright)));
  fs::create_directories(folder_ / "cheese");
  const std::string lines = faults();
  EXPECT_EQ(std::ranges::count(lines, '\n'), 3) << lines;
  EXPECT_NE(lines.find("a_Roughness.png"), std::string::npos);
  EXPECT_NE(lines.find("a_AO.png: expected a square picture"), std::string::npos) << lines;
  EXPECT_NE(lines.find("found 32 x 32"), std::string::npos) << lines;
  EXPECT_NE(lines.find("cheese: expected the name of a ground, wall or roof"), std::string::npos) << lines;
}

TEST_F(MaterialSets, NameRowsWithoutAFolder) {
  write("brick/a_Color.png", exporters::encode_png(picture(64, 64, kDark, kBright)));
  write("materials.csv", "brick,1.6,me,CC0\nbrik,1.6,me,CC0\n");
  EXPECT_NE(faults().find("materials.csv:2: expected a folder"), std::string::npos) << faults();
  EXPECT_EQ(faults().find('\n'), std::string::npos) << faults();
}

std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
  }
  return ~crc;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

TEST_F(MaterialSets, RefuseSidesOf16K) {
  const std::string header = "IHDR" + big_endian(16384) + big_endian(16384) + std::string("\x08\x02\0\0\0", 5);
  write("brick/a_Color.png", "\x89PNG\r\n\x1a\n" + big_endian(13) + header + big_endian(crc_of(header)));
  const std::string lines = faults();
  EXPECT_NE(lines.find("a_Color.png"), std::string::npos) << lines;
  EXPECT_EQ(std::ranges::count(lines, '\n'), 0) << lines;
}

}  // namespace
}  // namespace citykiln::outputs
