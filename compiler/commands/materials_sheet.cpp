#include "compiler/commands/materials_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "compiler/bake/merge.h"
#include "compiler/commands/sheet.h"
#include "compiler/sky/generate.h"
#include "preview/picture/denoise.h"
#include "preview/picture/exposure.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

using materials::Material;

constexpr int kMaterialWidth_px = 240, kMaterialHeight_px = 190, kName_px = 22, kMaterialsInRow = 8,
              kMaterialSamples = 8;
constexpr double kMaterialTolerance_m = 0.02;
// The width of what is seen of each material.
constexpr double kStand_m = 2.4;
constexpr float kSheetExposure = 0.7f;

bake::Primitive blank_surface(Material material) {
  bake::Primitive surface{material, {}, {}, {}, {}, {}};
  surface.colour_source = materials::ColourSource::kByMaterial;
  return surface;
}

void add_point(bake::Primitive& surface, Vec3 at, Vec3 normal, Vec2 uv_m) {
  const auto f = [](double v) { return static_cast<float>(v); };
  surface.positions.push_back({f(at.x), f(at.y), f(at.z)}),
      surface.normals.push_back({f(normal.x), f(normal.y), f(normal.z)});
  surface.uvs.push_back({f(uv_m.x), f(uv_m.y)});
  surface.colours.push_back(materials::kNoTint), surface.features.push_back(0);
}

// A rectangle from one corner along two sides.
void add_rectangle(bake::Primitive& surface, Vec3 corner, Vec3 along, Vec3 up, Vec2 uv_m) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  const Vec3 normal = unit(cross(along, up));
  for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    add_point(surface, corner + along * a + up * b, normal, uv_m + Vec2{a * length(along), b * length(up)});
  surface.triangles.push_back({first, first + 1, first + 2}),
      surface.triangles.push_back({first, first + 2, first + 3});
}

// Longitudes along u, latitudes along v, both in metres at the equator.
void add_sphere(bake::Primitive& surface, Vec3 middle, double radius_m) {
  constexpr std::uint32_t kAround = 64, kUp = 32;
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  for (std::uint32_t row = 0; row <= kUp; ++row)
    for (std::uint32_t column = 0; column <= kAround; ++column) {
      const double around = 2 * std::numbers::pi * column / kAround, up = std::numbers::pi * (1.0 * row / kUp - 0.5);
      const Vec3 out{std::cos(around) * std::cos(up), std::sin(around) * std::cos(up), std::sin(up)};
      add_point(surface, middle + out * radius_m, out, {around * radius_m, up * radius_m});
    }
  for (std::uint32_t row = 0; row < kUp; ++row)
    for (std::uint32_t column = 0; column < kAround; ++column) {
      const std::uint32_t a = first + row * (kAround + 1) + column, b = a + kAround + 1;
      surface.triangles.push_back({a, a + 1, b + 1}), surface.triangles.push_back({a, b + 1, b});
    }
}

// Materials side by side, each on a wall, the ground and a sphere.
bake::BakedTile tile_of_materials(std::span<const Material> row) {
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  double left_m = -kStand_m * kMaterialsInRow / 2;
  for (const Material material : row) {
    bake::Primitive surface = blank_surface(material);
    add_rectangle(surface, {left_m, -3, 0}, {kStand_m, 0, 0}, {0, 4.5, 0}, {0, 0});
    add_rectangle(surface, {left_m, 1.5, 0}, {kStand_m, 0, 0}, {0, 0, 3}, {0, 0});
    add_sphere(surface, {left_m + kStand_m / 2, 0.4, 0.5}, 0.5);
    tile.primitives.push_back(std::move(surface));
    left_m += kStand_m;
  }
  tile.tolerance_m = kMaterialTolerance_m;
  tile.textures = bake::textures_shown(tile, kMaterialTolerance_m, materials::TextureCache(1));
  return tile;
}

// From so far away that all are seen alike.
// @param white  The radiance of level white ground.
preview::Image drawn_row(std::span<const Material> row, const sky::Sky& sky, const preview::Rgb& white) {
  constexpr double kAway_m = 60;
  preview::Options options;
  options.width = kMaterialWidth_px * kMaterialsInRow, options.height = kMaterialHeight_px;
  options.samples = kMaterialSamples, options.has_guides = true;
  const bake::BakedTile tile = tile_of_materials(row);
  const double high_m = kStand_m * kMaterialHeight_px / kMaterialWidth_px;
  const double view_deg = 2 * std::atan(high_m / 2 / kAway_m) * 180 / std::numbers::pi;
  const Vec3 middle{0, 0.5, 0.75}, eye = middle + unit(Vec3{0, -1, 0.32}) * kAway_m;
  preview::Image image =
      preview::denoise(preview::render(std::span(&tile, 1), sky, {eye, middle, view_deg}, options), options.threads);
  // a white wall in the sun is not burnt, and white
  for (float& value : image.rgb) value *= kSheetExposure;
  preview::balance(image, preview::white_balance(white));
  return image;
}

}  // namespace

Result<Done> draw_materials_sheet(const std::string& path, const Console& console) {
  std::vector<Material> drawn;
  for (int m = 0; m < static_cast<int>(Material::kCount); ++m)
    if (const auto material = static_cast<Material>(m);
        materials::has_texture(material, kMaterialTolerance_m) && !materials::has_holes(material))
      drawn.push_back(material);
  const int count = static_cast<int>(drawn.size()), rows = (count + kMaterialsInRow - 1) / kMaterialsInRow;
  constexpr int kRow_px = kMaterialHeight_px + kName_px;
  preview::Image sheet = empty_sheet(kMaterialWidth_px * kMaterialsInRow, kRow_px * rows);
  const sky::Sky sky = sheet_sky();
  const preview::Rgb white = sky::generate(sky).white_ground;
  for (int i = 0; i < count; i += kMaterialsInRow) {
    const auto row = std::span(drawn).subspan(static_cast<std::size_t>(i),
                                              static_cast<std::size_t>(std::min(kMaterialsInRow, count - i)));
    const int y0 = i / kMaterialsInRow * kRow_px;
    put_picture(drawn_row(row, sky, white), 0, y0, sheet);
    for (int k = 0; k < static_cast<int>(row.size()); ++k)
      put_text(materials::words_of(row[static_cast<std::size_t>(k)]), k * kMaterialWidth_px + 4,
               y0 + kMaterialHeight_px + 2, sheet);
  }
  console.print_line(fmt::format("{} materials", count));
  return preview::write_image(sheet, path);
}

}  // namespace citykiln::commands
