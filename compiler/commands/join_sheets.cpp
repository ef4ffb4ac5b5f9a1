#include "compiler/commands/join_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace citykiln::commands {
namespace {

using materials::Sheet;

// Either side of where two sheets meet; keeps them apart down to the third level of a prefiltered sheet.
constexpr std::uint32_t kGutter_px = 4;

// The sheet's columns first, first + 1, … of the joined one, each row as often as it repeats.
void draw(const Sheet& sheet, std::int64_t first, Sheet& joined) {
  const std::int64_t from = std::max<std::int64_t>(0, first - kGutter_px),
                     to = std::min<std::int64_t>(joined.columns, first + sheet.columns + kGutter_px);
  for (std::size_t row = 0; row < joined.rows; ++row)
    for (std::int64_t column = from; column < to; ++column) {
      const auto source = static_cast<std::size_t>(std::clamp<std::int64_t>(column - first, 0, sheet.columns - 1));
      joined.texels[row * joined.columns + static_cast<std::size_t>(column)] =
          sheet.texels[row % sheet.rows * sheet.columns + source];
    }
}

// Each sheet that differs from those before it, and where it begins.
struct Placed {
  std::vector<const Sheet*> sheets;
  std::vector<std::int64_t> firsts;
  std::uint64_t columns = 0, rows = 1;

  std::int64_t place(const Sheet& sheet) {
    const auto same = std::ranges::find_if(sheets, [&](const Sheet* other) { return *other == sheet; });
    if (same != sheets.end()) return firsts[static_cast<std::size_t>(same - sheets.begin())];
    const std::uint64_t first = columns + (sheets.empty() ? 0 : 2 * kGutter_px);
    sheets.push_back(&sheet), firsts.push_back(static_cast<std::int64_t>(first));
    columns = first + sheet.columns;
    rows = std::min(std::lcm(rows, std::uint64_t{sheet.rows}), std::uint64_t{materials::kWidestSheet_px} + 1);
    return firsts.back();
  }
};

}  // namespace

Result<JoinedSheets> join_sheets(std::span<const Sheet* const> sheets) {
  Placed placed;
  JoinedSheets joined;
  for (const Sheet* sheet : sheets) {
    const std::int64_t first = sheet->texels.empty() ? 0 : placed.place(*sheet);
    joined.offsets_m.push_back(static_cast<double>(first) * sheet->texel_m);
    if (!sheet->texels.empty() && sheet->texel_m != placed.sheets.front()->texel_m)
      return Error{"", "sheets of different texels cannot be in one file: bake to a folder"};
  }
  if (std::max(placed.columns, placed.rows) > materials::kWidestSheet_px ||
      placed.columns * placed.rows > materials::kMostTexels)
    return Error{"",
                 fmt::format("the tiles' sheets would be {} by {} texels as one, too many: bake fewer tiles, or to a "
                             "folder",
                             placed.columns, placed.rows)};
  if (placed.sheets.empty()) return joined;
  joined.sheet.texel_m = placed.sheets.front()->texel_m;
  joined.sheet.columns = static_cast<std::uint32_t>(placed.columns);
  joined.sheet.rows = static_cast<std::uint32_t>(placed.rows);
  joined.sheet.texels.resize(placed.columns * placed.rows);
  for (std::size_t i = 0; i < placed.sheets.size(); ++i) draw(*placed.sheets[i], placed.firsts[i], joined.sheet);
  return joined;
}

}  // namespace citykiln::commands
