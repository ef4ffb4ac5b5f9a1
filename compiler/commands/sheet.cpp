#include "compiler/commands/sheet.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "compiler/sky/plan.h"

namespace citykiln::commands {
namespace {

// Letters, five columns each from the left, whose lowest bit is the upper row. Eight rows: small letters hang down by
// one.
constexpr int kLetterRows = 8, kLetterColumns = 5, kTextScale = 2;
struct Glyph {
  char letter;
  std::uint8_t columns[kLetterColumns];
};
constexpr Glyph kGlyphs[] = {{'a', {0x20, 0x54, 0x54, 0x54, 0x78}}, {'b', {0x7f, 0x48, 0x44, 0x44, 0x38}},
                             {'c', {0x38, 0x44, 0x44, 0x44, 0x28}}, {'d', {0x38, 0x44, 0x44, 0x48, 0x7f}},
                             {'e', {0x38, 0x54, 0x54, 0x54, 0x18}}, {'f', {0x08, 0x7e, 0x09, 0x01, 0x02}},
                             {'g', {0x18, 0xa4, 0xa4, 0xa4, 0x7c}}, {'h', {0x7f, 0x08, 0x04, 0x04, 0x78}},
                             {'i', {0x00, 0x44, 0x7d, 0x40, 0x00}}, {'j', {0x40, 0x80, 0x84, 0x7d, 0x00}},
                             {'k', {0x7f, 0x10, 0x28, 0x44, 0x00}}, {'l', {0x00, 0x41, 0x7f, 0x40, 0x00}},
                             {'m', {0x7c, 0x04, 0x78, 0x04, 0x78}}, {'n', {0x7c, 0x08, 0x04, 0x04, 0x78}},
                             {'o', {0x38, 0x44, 0x44, 0x44, 0x38}}, {'p', {0xfc, 0x24, 0x24, 0x24, 0x18}},
                             {'q', {0x18, 0x24, 0x24, 0x24, 0xfc}}, {'r', {0x7c, 0x08, 0x04, 0x04, 0x08}},
                             {'s', {0x48, 0x54, 0x54, 0x54, 0x24}}, {'t', {0x04, 0x3f, 0x44, 0x44, 0x20}},
                             {'u', {0x3c, 0x40, 0x40, 0x20, 0x7c}}, {'v', {0x1c, 0x20, 0x40, 0x20, 0x1c}},
                             {'w', {0x3c, 0x40, 0x30, 0x40, 0x3c}}, {'x', {0x44, 0x28, 0x10, 0x28, 0x44}},
                             {'y', {0x1c, 0xa0, 0xa0, 0xa0, 0x7c}}, {'z', {0x44, 0x64, 0x54, 0x4c, 0x44}},
                             {'0', {0x3e, 0x51, 0x49, 0x45, 0x3e}}, {'1', {0x00, 0x42, 0x7f, 0x40, 0x00}},
                             {'2', {0x42, 0x61, 0x51, 0x49, 0x46}}, {'3', {0x21, 0x41, 0x45, 0x4b, 0x31}},
                             {'4', {0x18, 0x14, 0x12, 0x7f, 0x10}}, {'5', {0x27, 0x45, 0x45, 0x45, 0x39}},
                             {'6', {0x3c, 0x4a, 0x49, 0x49, 0x30}}, {'7', {0x01, 0x71, 0x09, 0x05, 0x03}},
                             {'8', {0x36, 0x49, 0x49, 0x49, 0x36}}, {'9', {0x06, 0x49, 0x49, 0x29, 0x1e}},
                             {'.', {0x00, 0x60, 0x60, 0x00, 0x00}}, {'-', {0x08, 0x08, 0x08, 0x08, 0x08}},
                             {'_', {0x40, 0x40, 0x40, 0x40, 0x40}}};

bool is_inked(char letter, int column, int row) {
  const auto glyph = std::ranges::find(kGlyphs, letter, &Glyph::letter);
  return glyph != std::end(kGlyphs) && (glyph->columns[column] >> row & 1) != 0;
}

}  // namespace

preview::Image empty_sheet(int width, int height) {
  preview::Image sheet{width, height, {}};
  sheet.rgb.resize(3UL * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return sheet;
}

void put_picture(const preview::Image& from, int x0, int y0, preview::Image& to) {
  for (int y = 0; y < from.height; ++y)
    std::copy_n(from.rgb.begin() + 3L * y * from.width, 3 * from.width,
                to.rgb.begin() + 3L * ((y0 + y) * to.width + x0));
}

void put_text(std::string_view text, int x0, int y0, preview::Image& to) {
  const int step = (kLetterColumns + 1) * kTextScale;
  for (std::size_t i = 0; i < text.size(); ++i)
    for (int y = 0; y < kLetterRows * kTextScale; ++y)
      for (int x = 0; x < kLetterColumns * kTextScale; ++x) {
        const int column = x0 + static_cast<int>(i) * step + x, row = y0 + y;
        if (column < to.width && row < to.height && is_inked(text[i], x / kTextScale, y / kTextScale))
          std::fill_n(to.rgb.begin() + 3L * (row * to.width + column), 3, 1.0f);
      }
}

sky::Sky sheet_sky() {
  constexpr int kMorning_min = 9 * 60 + 30;
  return sky::plan({11, 48}, sky::moment_of(std::chrono::year(2026) / std::chrono::June / 21, kMorning_min));
}

bake::Primitive ground_square(materials::Material material, float half_m) {
  bake::Primitive square{material, {}, {}, {}, {}, {}};
  for (const bake::Float3& p :
       {bake::Float3{-half_m, -half_m, 0}, {half_m, -half_m, 0}, {half_m, half_m, 0}, {-half_m, half_m, 0}}) {
    square.positions.push_back(p), square.normals.push_back({0, 0, 1});
    square.colours.push_back(materials::kNoTint), square.features.push_back(0);
  }
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  return square;
}

}  // namespace citykiln::commands
