#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "compiler/contract/texts/parse.h"
#include "compiler/source/height_units.h"
#include "compiler/source/read_raster.h"

namespace citykiln::source {
namespace {

// The expected value, if a text does not parse; else empty.
using ParseError = std::optional<std::string_view>;

ParseError set_bounds(std::string_view value, RasterSpec& spec) {
  const auto edges = numbers_in<double>(value, '/', 4);
  if (!edges) return "W/S/E/N in degrees";
  const LonLatBox box{(*edges)[0], (*edges)[1], (*edges)[2], (*edges)[3]};
  if (!(box.west < box.east && box.south < box.north && box.south >= -90 && box.north <= 90)) {
    return "W/S/E/N in degrees with west < east and south < north";
  }
  spec.bounds = box;
  return std::nullopt;
}

ParseError set_tile(std::string_view value, RasterSpec& spec) {
  constexpr int kDeepestZoom = 30;
  const auto zxy = numbers_in<int>(value, '/', 3);
  if (!zxy) return "Z/X/Y as whole numbers";
  const int z = (*zxy)[0], x = (*zxy)[1], y = (*zxy)[2];
  if (z < 0 || z > kDeepestZoom || x < 0 || y < 0 || x >= 1 << z || y >= 1 << z) return "Z/X/Y with X and Y below 2^Z";
  spec.tile_zxy = {z, x, y};
  return std::nullopt;
}

ParseError set_number(std::string_view value, double& number) {
  const std::optional<double> parsed = number_in<double>(value);
  if (!parsed) return "a number";
  number = *parsed;
  return std::nullopt;
}

ParseError set_offset(std::string_view value, RasterSpec& spec) {
  spec.is_fitted = value == "auto";
  if (spec.is_fitted) return std::nullopt;
  return set_number(value, spec.offset_m) ? ParseError("a number or auto") : std::nullopt;
}

ParseError set_unit(std::string_view value, RasterSpec& spec) {
  spec.unit_m = unit_of_heights_m(value);
  return spec.unit_m ? std::nullopt : ParseError("a unit, such as m, ft or us-ft");
}

ParseError set_encoding(std::string_view value, RasterSpec& spec) {
  if (value != "terrarium" && value != "mapbox") return "terrarium or mapbox";
  spec.encoding = value;
  return std::nullopt;
}

constexpr std::string_view kKeys = "bounds, scale, offset, unit, encoding, tile, credit";

ParseError set(std::string_view key, std::string_view value, RasterSpec& spec, bool& is_known) {
  if (key == "bounds") return set_bounds(value, spec);
  if (key == "scale") return set_number(value, spec.scale);
  if (key == "offset") return set_offset(value, spec);
  if (key == "unit") return set_unit(value, spec);
  if (key == "encoding") return set_encoding(value, spec);
  if (key == "tile") return set_tile(value, spec);
  if (key == "credit") {
    spec.credit = value;
    return std::nullopt;
  }
  is_known = false;
  return std::nullopt;
}

// The number of pieces that make up the name of the file: of names with commas the longest that is a file.
std::size_t pieces_of_path(const std::vector<std::string_view>& pieces, std::string& path) {
  std::size_t found = 1;
  path = pieces.front();
  std::string longer = path;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    longer.append(",").append(pieces[i]);
    if (std::error_code none; !std::filesystem::is_regular_file(longer, none)) continue;
    path = longer, found = i + 1;
  }
  return found;
}

}  // namespace

Result<RasterSpec> parse_raster_spec(std::string_view text) {
  const std::vector<std::string_view> pieces = split(text, ',');
  RasterSpec spec;
  const std::size_t first_key = pieces_of_path(pieces, spec.path);
  if (spec.path.empty())
    return Error{std::string(text), "expected the file name of a heightmap first, such as N43E007.hgt"};
  for (std::size_t i = first_key; i < pieces.size(); ++i) {
    const std::size_t equals = pieces[i].find('=');
    const std::string_view key = pieces[i].substr(0, equals);
    if (equals == std::string_view::npos)
      return Error{spec.path, fmt::format("expected key=value, found '{}'", pieces[i])};
    bool is_known = true;
    const ParseError expected = set(key, pieces[i].substr(equals + 1), spec, is_known);
    if (!is_known) return Error{spec.path, fmt::format("unknown key '{}'; expected one of {}", key, kKeys)};
    if (expected)
      return Error{spec.path,
                   fmt::format("expected {} after {}=, found '{}'", *expected, key, pieces[i].substr(equals + 1))};
  }
  return spec;
}

}  // namespace citykiln::source
