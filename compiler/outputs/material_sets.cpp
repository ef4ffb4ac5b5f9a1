#include "compiler/outputs/material_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>

#include "compiler/contract/texts/parse.h"
#include "exporters/file.h"
#include "exporters/gltf/pictures/picture_formats.h"

namespace citykiln::outputs {
namespace {

namespace fs = std::filesystem;
using materials::Material;
using materials::TextureImage;

constexpr const char* kTableName = "materials.csv";
// Without a map of normals the highest place of a displacement is this share of the size above the lowest.
constexpr double kDisplacedShare = 0.01;

// The use of a picture of a set.
enum class MapKind { kColour, kNormalGl, kNormalDx, kRoughness, kOcclusion, kDisplacement };

struct MapWord {
  std::string_view word;
  MapKind kind;
};
constexpr MapWord kMapWords[] = {{"color", MapKind::kColour},
                                 {"colour", MapKind::kColour},
                                 {"diff", MapKind::kColour},
                                 {"diffuse", MapKind::kColour},
                                 {"albedo", MapKind::kColour},
                                 {"basecolor", MapKind::kColour},
                                 {"normalgl", MapKind::kNormalGl},
                                 {"nor_gl", MapKind::kNormalGl},
                                 {"normaldx", MapKind::kNormalDx},
                                 {"nor_dx", MapKind::kNormalDx},
                                 {"roughness", MapKind::kRoughness},
                                 {"rough", MapKind::kRoughness},
                                 {"ao", MapKind::kOcclusion},
                                 {"ambientocclusion", MapKind::kOcclusion},
                                 {"displacement", MapKind::kDisplacement},
                                 {"disp", MapKind::kDisplacement},
                                 {"height", MapKind::kDisplacement}};

std::string in_small_letters(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// The last word of a file's name decides: "Bricks075_1K-JPG_Color.jpg", "red_brick_nor_gl_1k.png".
std::optional<MapKind> kind_of(const fs::path& file) {
  const std::string ending = in_small_letters(file.extension().string());
  if (ending != ".png" && ending != ".jpg" && ending != ".jpeg" && ending != ".webp") return {};
  std::string name = "_" + in_small_letters(file.stem().string()) + "_";
  std::ranges::replace(name, '-', '_');
  std::optional<MapKind> kind;
  std::size_t last = 0;
  for (const MapWord& word : kMapWords)
    if (const std::size_t at = name.rfind(fmt::format("_{}_", word.word)); at != std::string::npos && at >= last)
      kind = word.kind, last = at;
  return kind;
}

struct TableRow {
  double size_m = 0;
  int line = 0;
  std::string credit, licence;
};

// The lines of what is wrong.
using Faults = std::vector<std::string>;

std::map<std::string, TableRow> read_table(const std::string& path, Faults& faults) {
  std::map<std::string, TableRow> rows;
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) {
    faults.push_back(fmt::format("{}: expected a table with the columns material,size_m,credit,licence", path));
    return rows;
  }
  const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  int number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#') || line.starts_with("material,")) continue;
    const std::vector<std::string_view> cells = split(line, ',');
    const std::optional<double> size_m = cells.size() > 1 ? number_in<double>(cells[1]) : std::nullopt;
    if (!size_m || !(*size_m >= 0.05 && *size_m <= 64)) {
      faults.push_back(
          fmt::format("{}:{}: expected material,size_m,credit,licence with a size of 0.05 to 64 m", path, number));
      continue;
    }
    rows[std::string(cells[0])] = {*size_m, number, cells.size() > 2 ? std::string(cells[2]) : "",
                                   cells.size() > 3 ? std::string(cells[3]) : ""};
  }
  return rows;
}

// Adds a fault for each row of a table that has no folder beside it.
void check_rows(const std::map<std::string, TableRow>& table, const std::string& table_path, Faults& faults) {
  std::error_code failed;
  for (const auto& [name, row] : table)
    if (const fs::path folder = fs::path(table_path).parent_path() / name; !fs::is_directory(folder, failed))
      faults.push_back(fmt::format("{}:{}: expected a folder {}", table_path, row.line, folder.string()));
}

// A picture as decoded: square, v upwards as on walls.
std::optional<TextureImage> read_map(const fs::path& file, Faults& faults) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(file.string());
  const Result<exporters::CutoutImage> picture =
      bytes ? exporters::decode_picture(*bytes, file.string()) : Result<exporters::CutoutImage>(bytes.error());
  if (!picture) {
    faults.push_back(fmt::format(
        "{}: expected a whole PNG, baseline JPEG or WebP picture of at most 8192 x 8192 texels", file.string()));
    return {};
  }
  TextureImage image = picture->colour;
  if (image.columns != image.rows || image.columns < 16) {
    faults.push_back(fmt::format("{}: expected a square picture of at least 16 texels a side, found {} x {}",
                                 file.string(), image.columns, image.rows));
    return {};
  }
  for (std::size_t row = 0; row < image.rows / 2; ++row)
    std::swap_ranges(image.texels.begin() + static_cast<std::ptrdiff_t>(row * image.columns),
                     image.texels.begin() + static_cast<std::ptrdiff_t>((row + 1) * image.columns),
                     image.texels.end() - static_cast<std::ptrdiff_t>((row + 1) * image.columns));
  return image;
}

using Linear = std::array<double, 3>;

// The mean of the texels that each of side × side squares covers.
template <typename ValueOf>
std::vector<Linear> box_filtered(const TextureImage& image, std::uint32_t side, ValueOf value_of) {
  std::vector<Linear> out(static_cast<std::size_t>(side) * side);
  std::vector<double> counts(out.size(), 0);
  for (std::uint32_t row = 0; row < image.rows; ++row)
    for (std::uint32_t column = 0; column < image.columns; ++column) {
      const std::size_t at = static_cast<std::size_t>(std::uint64_t{row} * side / image.rows) * side +
                             static_cast<std::size_t>(std::uint64_t{column} * side / image.columns);
      const TextureImage::Texel& texel = image.texels[static_cast<std::size_t>(row) * image.columns + column];
      for (std::size_t c = 0; c < 3; ++c) out[at][c] += value_of(texel[c]);
      counts[at] += 1;
    }
  for (std::size_t i = 0; i < out.size(); ++i)
    for (double& value : out[i]) value /= counts[i];
  return out;
}

double share_of_byte(std::uint8_t byte) { return byte / 255.0; }
std::uint8_t rounded_byte(double share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255 + 0.5); }

TextureImage blank_map(std::uint32_t side, double size_m) {
  return {size_m / side, side, side, std::vector<TextureImage::Texel>(static_cast<std::size_t>(side) * side)};
}

using Maps = std::map<MapKind, TextureImage>;

TextureImage colour_of(const Maps& maps, Material material, std::uint32_t side, double size_m) {
  std::vector<Linear> colours = box_filtered(maps.at(MapKind::kColour), side, materials::linear_of_srgb);
  if (const auto ao = maps.find(MapKind::kOcclusion); ao != maps.end()) {
    const std::vector<Linear> open = box_filtered(ao->second, side, share_of_byte);
    for (std::size_t i = 0; i < colours.size(); ++i)
      for (double& c : colours[i]) c *= open[i][0];
  }
  Linear mean{};
  for (const Linear& colour : colours)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += colour[c] / static_cast<double>(colours.size());
  const auto& base = values_of(material).base_colour;
  TextureImage image = blank_map(side, size_m);
  // 3 % lighter, as the textures of citykiln are, so that colour_factor() stays below 1
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      image.texels[i][c] = materials::srgb_of_linear(colours[i][c] * (mean[c] > 0 ? 1.03 * base[c] / mean[c] : 1));
  return image;
}

TextureImage normal_of(const TextureImage& map, bool is_gl, std::uint32_t side, double size_m) {
  const std::vector<Linear> normals = box_filtered(map, side, [](std::uint8_t b) { return b / 127.5 - 1; });
  TextureImage image = blank_map(side, size_m);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto [x, y, z] = normals[i];
    const double length = std::max(1e-6, std::sqrt(x * x + y * y + z * z)), against_v = is_gl ? -y : y;
    image.texels[i] = {rounded_byte((x / length + 1) / 2), rounded_byte((against_v / length + 1) / 2),
                       rounded_byte((std::max(z, 0.0) / length + 1) / 2)};
  }
  return image;
}

TextureImage normal_of_heights(const TextureImage& map, std::uint32_t side, double size_m) {
  const std::vector<Linear> heights = box_filtered(map, side, share_of_byte);
  const auto height = [&](std::uint32_t c, std::uint32_t r) {
    return heights[static_cast<std::size_t>(r % side) * side + c % side][0];
  };
  TextureImage image = blank_map(side, size_m);
  for (std::uint32_t r = 0; r < side; ++r)
    for (std::uint32_t c = 0; c < side; ++c) {
      const double steep = kDisplacedShare * side / 2;
      const double u = steep * (height(c + 1, r) - height(c + side - 1, r)),
                   v = steep * (height(c, r + 1) - height(c, r + side - 1));
      const double out = 1 / std::sqrt(1 + u * u + v * v);
      image.texels[static_cast<std::size_t>(r) * side + c] = {
          rounded_byte((1 - u * out) / 2), rounded_byte((1 + v * out) / 2), rounded_byte((1 + out) / 2)};
    }
  return image;
}

TextureImage surface_of(const TextureImage& map, Material material, std::uint32_t side, double size_m) {
  const std::vector<Linear> rough = box_filtered(map, side, share_of_byte);
  TextureImage image = blank_map(side, size_m);
  for (std::size_t i = 0; i < rough.size(); ++i)
    image.texels[i] = {255, rounded_byte(rough[i][0]), rounded_byte(values_of(material).metallic)};
  return image;
}

Maps read_maps(const fs::path& folder, Faults& faults) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (kind_of(entry.path())) files.push_back(entry.path());
  std::ranges::sort(files);
  Maps maps;
  for (const fs::path& file : files) {
    std::optional<TextureImage> image = read_map(file, faults);
    if (!image) continue;
    if (!maps.empty() && maps.begin()->second.columns != image->columns)
      faults.push_back(fmt::format("{}: expected {} x {} texels, as the set's other pictures have, found {} x {}",
                                   file.string(), maps.begin()->second.columns, maps.begin()->second.columns,
                                   image->columns, image->rows));
    maps.emplace(*kind_of(file), std::move(*image));
  }
  return maps;
}

MaterialSet set_of(const Maps& maps, Material material, const TableRow& row, std::uint32_t most_px) {
  const double size_m =
      materials::kTexturePeriod_m / std::max(1.0, std::floor(materials::kTexturePeriod_m / row.size_m + 0.5));
  const std::uint32_t side = std::min(most_px, std::bit_floor(maps.at(MapKind::kColour).columns)),
                      coarse = std::min(side, most_px / 2);
  MaterialSet set{{material, colour_of(maps, material, side, size_m), {}, {}, {}}, row.credit, row.licence};
  const auto map_of = [&](MapKind kind) { return maps.contains(kind) ? &maps.at(kind) : nullptr; };
  if (const auto* gl = map_of(MapKind::kNormalGl))
    set.texture.normal = normal_of(*gl, true, coarse, size_m);
  else if (const auto* dx = map_of(MapKind::kNormalDx))
    set.texture.normal = normal_of(*dx, false, coarse, size_m);
  else if (const auto* heights = map_of(MapKind::kDisplacement))
    set.texture.normal = normal_of_heights(*heights, coarse, size_m);
  if (const auto* rough = map_of(MapKind::kRoughness))
    set.texture.surface = surface_of(*rough, material, coarse, size_m);
  return set;
}

std::optional<MaterialSet> read_set(const fs::path& folder, const std::map<std::string, TableRow>& table,
                                    const std::string& table_path, std::uint32_t most_px, Faults& faults) {
  const std::string name = folder.filename().string();
  const std::optional<Material> material = materials::material_named(name);
  if (!material || !materials::has_texture(*material, 0) || materials::has_holes(*material) ||
      materials::is_bark(*material)) {
    faults.push_back(
        fmt::format("{}: expected the name of a ground, wall or roof that has a texture, such as flemish_brick "
                    "(citykiln inspect --materials -o sheet.png shows all)",
                    folder.string()));
    return {};
  }
  const auto row = table.find(name);
  if (row == table.end() && fs::exists(table_path))
    faults.push_back(fmt::format("{}: expected a row {},size_m,credit,licence", table_path, name));
  const std::size_t before = faults.size();
  const Maps maps = read_maps(folder, faults);
  if (!maps.contains(MapKind::kColour) && faults.size() == before)
    faults.push_back(
        fmt::format("{}: expected a picture whose name has Color or diff, as PNG, JPEG or WebP", folder.string()));
  if (row == table.end() || faults.size() > before) return {};
  return set_of(maps, *material, row->second, most_px);
}

}  // namespace

Result<std::vector<MaterialSet>> read_material_sets(const std::string& folder, std::uint32_t most_px) {
  std::vector<MaterialSet> sets;
  if (folder.empty()) return sets;
  std::error_code failed;
  if (!fs::is_directory(folder, failed))
    return Error{folder, "expected a folder of materials, each a folder of pictures"};
  const std::string table_path = (fs::path(folder) / kTableName).string();
  Faults faults;
  const std::map<std::string, TableRow> table = read_table(table_path, faults);
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (entry.is_directory(failed)) folders.push_back(entry.path());
  std::ranges::sort(folders);
  for (const fs::path& each : folders)
    if (std::optional<MaterialSet> set = read_set(each, table, table_path, most_px, faults))
      sets.push_back(std::move(*set));
  check_rows(table, table_path, faults);
  if (!faults.empty()) return Error{"", fmt::format("{}", fmt::join(faults, "\n"))};
  std::ranges::sort(sets, {}, [](const MaterialSet& set) { return set.texture.material; });
  return sets;
}

}  // namespace citykiln::outputs
