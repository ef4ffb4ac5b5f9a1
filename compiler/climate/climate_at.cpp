#include "compiler/climate/climate_at.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "compiler/geometry/mathematics.h"

namespace citykiln::climate {
namespace {

constexpr int kCellRows = 360, kCellColumns = 720;
constexpr double kCell_deg = 0.5;

struct CellRow {
  int row;
  std::string_view runs;
};
constexpr CellRow kCells[] = {
#define CLIMATE_ROW(row, runs) {row, runs},
#include "compiler/climate/climate_cells.inc"
};

constexpr char kLetters[] = {
#define CLIMATE(name, letter, ...) letter,
#include "compiler/climate/climate_classes.inc"
};

struct Cell {
  int column, row;
};

// Cells first to last of a row have one class; none: sea.
struct Run {
  int first, last;
  std::optional<ClimateClass> climate;
};

std::optional<ClimateClass> class_of_letter(char c) {
  const char* letter = std::ranges::find(kLetters, c);
  if (letter == std::end(kLetters)) return std::nullopt;
  return static_cast<ClimateClass>(letter - std::begin(kLetters));
}

// Calls visit(Run) for the runs of a row, from the west on.
template <typename Visit>
void for_each_run(int row, Visit visit) {
  const auto cells = std::ranges::lower_bound(kCells, row, {}, &CellRow::row);
  if (cells == std::end(kCells) || cells->row != row) return;
  int column = 0, count = 0;
  for (const char c : cells->runs) {
    if ('0' <= c && c <= '9') {
      count = 10 * count + (c - '0');
      continue;
    }
    const int end = column + std::max(count, 1);
    visit(Run{column, end - 1, class_of_letter(c)});
    column = end, count = 0;
  }
}

Cell cell_at(double lon_deg, double lat_deg) {
  const double from_west = lon_deg + 180 - 360 * std::floor((lon_deg + 180) / 360);
  return {std::min(static_cast<int>(from_west / kCell_deg), kCellColumns - 1),
          std::clamp(static_cast<int>((90 - lat_deg) / kCell_deg), 0, kCellRows - 1)};
}

std::optional<ClimateClass> class_of(Cell cell) {
  std::optional<ClimateClass> found;
  for_each_run(cell.row, [&](const Run& run) {
    if (run.first <= cell.column && cell.column <= run.last) found = run.climate;
  });
  return found;
}

// Cells between a column and the nearest one of a run, around the Earth.
int columns_away(const Run& run, int column) {
  if (run.first <= column && column <= run.last) return 0;
  const auto forwards = [](int from, int to) { return (to - from + kCellColumns) % kCellColumns; };
  return std::min(forwards(column, run.first), forwards(run.last, column));
}

// The class of the nearest cell of land; of equally near ones the first from north-west.
ClimateClass nearest_class(Cell cell) {
  const double narrow = cosine(90 - kCell_deg * (cell.row + 0.5));
  double least2 = 4.0 * kCellRows * kCellRows;
  ClimateClass nearest{};
  for (int down = 0; down * down <= least2 && down < kCellRows; ++down)
    for (const int row : {cell.row - down, cell.row + down})
      for_each_run(row, [&](const Run& run) {
        if (!run.climate) return;
        const double across = narrow * columns_away(run, cell.column), away2 = across * across + down * down;
        if (away2 < least2) least2 = away2, nearest = *run.climate;
      });
  return nearest;
}

}  // namespace

ClimateClass climate_at(double lon_deg, double lat_deg) {
  const Cell cell = cell_at(lon_deg, lat_deg);
  const std::optional<ClimateClass> own = class_of(cell);
  return own ? *own : nearest_class(cell);
}

ClimateMix climate_mix_at(double lon_deg, double lat_deg) {
  // the north-western one of the four centres about the place, in cells
  const double x = (lon_deg + 180) / kCell_deg - 0.5, y = (90 - lat_deg) / kCell_deg - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  double land = 0;
  std::array<ClimateShare, 4> corners;
  std::size_t count = 0;
  for (const int right : {0, 1})
    for (const int down : {0, 1}) {
      const int column = static_cast<int>(left + right - kCellColumns * std::floor((left + right) / kCellColumns));
      const int row = std::clamp(static_cast<int>(top) + down, 0, kCellRows - 1);
      const double share = (right ? x - left : 1 - (x - left)) * (down ? y - top : 1 - (y - top));
      const std::optional<ClimateClass> own = class_of({column, row});
      if (own && share > 0) corners[count++] = {*own, share}, land += share;
    }
  if (count == 0) return ClimateMix(climate_at(lon_deg, lat_deg));
  ClimateMix mix;
  for (const ClimateShare& corner : std::span(corners).first(count)) mix.add(corner.climate, corner.share / land);
  return mix;
}

}  // namespace citykiln::climate
