#include "compiler/commands/sheet.h"

#include <algorithm>

#include "compiler/sky/plan.h"

namespace citykiln::commands {

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
