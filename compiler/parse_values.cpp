#include "compiler/parse_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "compiler/contract/texts/parse.h"
#include "compiler/contract/tolerance.h"

namespace citykiln {

namespace {

// Finer than the grid of vertices (kQuantum_m) no level can be.
constexpr double kLeastTolerance_m = 0.001;

}  // namespace

Error expected(std::string_view what, std::string_view found) {
  return {"", fmt::format("expected {}, found \"{}\"", what, found)};
}

Result<double> parse_tolerance(std::string_view text) {
  const auto tolerance_m = number_in<double>(text);
  if (tolerance_m && *tolerance_m >= kLeastTolerance_m && *tolerance_m <= kCoarsest_m) return *tolerance_m;
  return expected(fmt::format("a tolerance in metres, {} to {}, such as 0.1", kLeastTolerance_m, kCoarsest_m), text);
}

Result<std::vector<double>> parse_ladder(std::string_view text) {
  std::vector<double> tolerances_m;
  for (const std::string_view part : split(text, ',')) {
    const Result<double> tolerance_m = parse_tolerance(part);
    const double last = tolerances_m.empty() ? 0 : tolerances_m.back();
    if (!tolerance_m || !(*tolerance_m > last))
      return expected(
          fmt::format("increasing tolerances in metres, {} to {}, such as 0.1,0.5,2.5", kLeastTolerance_m, kCoarsest_m),
          text);
    tolerances_m.push_back(*tolerance_m);
  }
  return tolerances_m;
}

Result<scene::TileKey> parse_tile(std::string_view text) {
  const auto xy = numbers_in<std::int32_t>(text, '_', 2);
  if (!xy) return expected("a tile X_Y, such as 3_-2", text);
  return scene::TileKey{(*xy)[0], (*xy)[1]};
}

Result<Done> add_tiles(std::string_view text, std::vector<scene::TileKey>& tiles) {
  assert(std::ranges::is_sorted(tiles));
  for (const std::string_view part : split(text, ',')) {
    const Result<scene::TileKey> tile = parse_tile(part);
    if (!tile) return tile.error();
    const auto place = std::ranges::lower_bound(tiles, *tile);
    if (place == tiles.end() || *place != *tile) tiles.insert(place, *tile);
  }
  return Done{};
}

Result<double> parse_number(std::string_view text) {
  const auto number = number_in<double>(text);
  return number ? Result(*number) : expected("a number", text);
}

Result<std::vector<double>> parse_numbers(std::string_view text, std::size_t count) {
  assert(count > 0);
  auto numbers = numbers_in<double>(text, ',', count);
  return numbers ? Result(std::move(*numbers)) : expected(fmt::format("{} numbers separated by commas", count), text);
}

Result<bool> parse_switch(std::string_view text) {
  if (text != "true" && text != "false") return expected("true or false", text);
  return text == "true";
}

Result<std::int64_t> parse_whole(std::string_view text, std::int64_t least) {
  const auto number = number_in<std::int64_t>(text);
  // counts of threads, pixels and paths are ints
  if (number && *number >= least && *number <= 0x7fffffff) return *number;
  return expected(fmt::format("a whole number of at least {}", least), text);
}

}  // namespace citykiln
