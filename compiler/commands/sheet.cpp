#include "compiler/commands/sheet.h"

#include <algorithm>

#include "compiler/sky/plan.h"

namespace citykiln::commands {
namespace {

// The letters A to Z, seven rows of five pixels each.
constexpr int kLetterRows = 7, kLetterColumns = 5, kTextScale = 2;
constexpr std::uint8_t kLetters[26][kLetterRows] = {{0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001},
                                                    {0b11110, 0b10001, 0b10001, 0b11110, 0b10001, 0b10001, 0b11110},
                                                    {0b01110, 0b10001, 0b10000, 0b10000, 0b10000, 0b10001, 0b01110},
                                                    {0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110},
                                                    {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111},
                                                    {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000},
                                                    {0b01110, 0b10001, 0b10000, 0b10111, 0b10001, 0b10001, 0b01111},
                                                    {0b10001, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001},
                                                    {0b01110, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110},
                                                    {0b00111, 0b00010, 0b00010, 0b00010, 0b00010, 0b10010, 0b01100},
                                                    {0b10001, 0b10010, 0b10100, 0b11000, 0b10100, 0b10010, 0b10001},
                                                    {0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b11111},
                                                    {0b10001, 0b11011, 0b10101, 0b10101, 0b10001, 0b10001, 0b10001},
                                                    {0b10001, 0b11001, 0b10101, 0b10011, 0b10001, 0b10001, 0b10001},
                                                    {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110},
                                                    {0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000, 0b10000},
                                                    {0b01110, 0b10001, 0b10001, 0b10001, 0b10101, 0b10010, 0b01101},
                                                    {0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001},
                                                    {0b01111, 0b10000, 0b10000, 0b01110, 0b00001, 0b00001, 0b11110},
                                                    {0b11111, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100},
                                                    {0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110},
                                                    {0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01010, 0b00100},
                                                    {0b10001, 0b10001, 0b10001, 0b10101, 0b10101, 0b11011, 0b10001},
                                                    {0b10001, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001, 0b10001},
                                                    {0b10001, 0b10001, 0b01010, 0b00100, 0b00100, 0b00100, 0b00100},
                                                    {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b10000, 0b11111}};

bool is_inked(char letter, int column, int row) {
  if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return letter >= 'A' && letter <= 'Z' && (kLetters[letter - 'A'][row] >> (kLetterColumns - 1 - column) & 1) != 0;
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
