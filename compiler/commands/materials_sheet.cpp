#include "compiler/commands/materials_sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "compiler/bake/merge.h"
#include "compiler/commands/sheet.h"
#include "preview/picture/denoise.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

using materials::Material;

constexpr int kMaterialWidth_px = 240, kMaterialHeight_px = 190, kName_px = 18, kMaterialsInRow = 8,
              kMaterialSamples = 10;
constexpr double kMaterialTolerance_m = 0.02;

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

bake::BakedTile tile_of_material(Material material) {
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  bake::Primitive surface = blank_surface(material);
  add_rectangle(surface, {-6, -5, 0}, {12, 0, 0}, {0, 7, 0}, {0, 0});
  add_rectangle(surface, {-6, 2, 0}, {12, 0, 0}, {0, 0, 6}, {0, 0});
  add_sphere(surface, {-0.1, 0.9, 0.62}, 0.62);
  tile.primitives = {std::move(surface)};
  tile.tolerance_m = kMaterialTolerance_m;
  tile.textures = bake::textures_shown(tile, kMaterialTolerance_m, materials::TextureCache(1));
  return tile;
}

preview::Image drawn_material(Material material, const sky::Sky& sky) {
  preview::Options options;
  options.width = kMaterialWidth_px, options.height = kMaterialHeight_px, options.samples = kMaterialSamples;
  const bake::BakedTile tile = tile_of_material(material);
  options.has_guides = true;
  return preview::denoise(preview::render(std::span(&tile, 1), sky, {{1.3, -3.2, 1.7}, {0, 1.2, 0.75}, 40}, options),
                          options.threads);
}

}  // namespace

Result<Done> draw_materials_sheet(const std::string& path, const Console& console) {
  std::vector<Material> drawn;
  for (int m = 0; m < static_cast<int>(Material::kCount); ++m)
    if (materials::has_texture(static_cast<Material>(m), kMaterialTolerance_m) &&
        !materials::has_holes(static_cast<Material>(m)))
      drawn.push_back(static_cast<Material>(m));
  const int count = static_cast<int>(drawn.size()), rows = (count + kMaterialsInRow - 1) / kMaterialsInRow;
  const int row_px = kMaterialHeight_px + kName_px;
  preview::Image sheet = empty_sheet(kMaterialWidth_px * kMaterialsInRow, row_px * rows);
  const sky::Sky sky = sheet_sky();
  for (int i = 0; i < count; ++i) {
    const Material material = drawn[static_cast<std::size_t>(i)];
    const int x0 = i % kMaterialsInRow * kMaterialWidth_px, y0 = i / kMaterialsInRow * row_px;
    put_picture(drawn_material(material, sky), x0, y0, sheet);
    put_text(values_of(material).name, x0 + 4, y0 + kMaterialHeight_px + 2, sheet);
  }
  console.print_line(fmt::format("{} materials", count));
  return preview::write_image(sheet, path);
}

}  // namespace citykiln::commands
