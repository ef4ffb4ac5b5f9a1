#include "preview/light/direction_table.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "preview/turn.h"

namespace citykiln::preview {
namespace {

Rgb widened(const std::array<float, 3>& cell) { return {cell[0], cell[1], cell[2]}; }

}  // namespace

CumulativeSums::CumulativeSums(std::vector<double> terms) : sums_(std::move(terms)), guide_(sums_.size()) {
  for (std::size_t i = 1; i < sums_.size(); ++i) sums_[i] += sums_[i - 1];
  int first = 0;
  for (std::size_t part = 0; part < guide_.size(); ++part) {
    const double least = total() * static_cast<double>(part) / static_cast<double>(guide_.size());
    while (first + 1 < static_cast<int>(sums_.size()) && sums_[first] <= least) ++first;
    guide_[part] = first;
  }
}

CumulativeSums::Step CumulativeSums::at(double share) const {
  const double wanted = share * total();
  const int last = static_cast<int>(sums_.size()) - 1;
  int i = guide_[static_cast<std::size_t>(share * static_cast<double>(guide_.size()))];
  while (i < last && sums_[i] <= wanted) ++i;
  // rounding may have put the guide one too far
  while (i > 0 && sums_[i - 1] > wanted) --i;
  const double before = i > 0 ? sums_[i - 1] : 0, size = sums_[i] - before;
  return {i, size > 0 ? std::clamp((wanted - before) / size, 0.0, 1.0) : 0.5};
}

double turn_of(Vec3 d) {
  const double turn = std::atan2(d.y, d.x) / (2 * std::numbers::pi);
  return turn < 0 ? std::min(turn + 1, 1 - 0x1p-53) : turn;
}

Vec3 direction_at(double turn, double z) {
  const Vec2 round = on_circle(turn) * std::sqrt(std::max(0.0, 1 - z * z));
  return at_height(round, z);
}

DirectionTable::DirectionTable(std::vector<double> z_edges, int columns, std::vector<std::array<float, 3>> cells)
    : z_edges_(std::move(z_edges)), columns_(columns), cells_(std::move(cells)) {
  assert(z_edges_.size() >= 2 && columns > 0 && cells_.size() == (z_edges_.size() - 1) * columns);
  const double height = (z_edges_.back() - z_edges_.front()) / rows();
  is_even_ = true;
  std::vector<double> of_rows;
  for (int row = 0; row < rows(); ++row) {
    const double of_row = z_edges_[row + 1] - z_edges_[row];
    is_even_ = is_even_ && std::abs(of_row - height) < 1e-12;
    std::vector<double> fluxes;
    for (int column = 0; column < columns; ++column)
      fluxes.push_back(luminance(widened(cells_[static_cast<std::size_t>(row) * columns + column])) * of_row);
    of_rows.push_back(sums_.emplace_back(std::move(fluxes)).total());
  }
  row_sums_ = CumulativeSums(std::move(of_rows));
  if (row_sums_.total() > 0) pdf_per_light_ = columns / (2 * std::numbers::pi * row_sums_.total());
}

// The flux of a cell over its height and width, as a share of all.
double DirectionTable::pdf_of(const std::array<float, 3>& cell) const {
  return luminance(widened(cell)) * pdf_per_light_;
}

int DirectionTable::row_of(double z) const {
  if (is_even_) {
    const double at = (z - z_edges_.front()) / (z_edges_.back() - z_edges_.front()) * rows();
    return std::clamp(static_cast<int>(at), 0, rows() - 1);
  }
  const auto above = std::upper_bound(z_edges_.begin() + 1, z_edges_.end() - 1, z);
  return static_cast<int>(above - z_edges_.begin()) - 1;
}

Rgb DirectionTable::radiance(Vec3 direction) const {
  const double column = turn_of(direction) * columns_ - 0.5;
  const int left = column < 0 ? columns_ - 1 : static_cast<int>(column), right = left + 1 == columns_ ? 0 : left + 1;
  const double across = column < 0 ? column + 1 : column - left;
  const int own = row_of(direction.z);
  const auto middle = [&](int row) { return (z_edges_[row] + z_edges_[row + 1]) / 2; };
  const int low = std::clamp(direction.z < middle(own) ? own - 1 : own, 0, rows() - 1);
  const int high = std::min(direction.z < middle(own) ? own : own + 1, rows() - 1);
  const double up = high > low ? std::clamp((direction.z - middle(low)) / (middle(high) - middle(low)), 0.0, 1.0) : 0;
  const auto at = [&](int row) {
    const auto first = static_cast<std::size_t>(row) * columns_;
    return mixed(widened(cells_[first + left]), widened(cells_[first + right]), across);
  };
  return mixed(at(low), at(high), up);
}

DirectionSample DirectionTable::sample(UnitPair chance) const {
  if (!(row_sums_.total() > 0)) return {};
  const CumulativeSums::Step row = row_sums_.at(chance.u), column = sums_[row.index].at(chance.v);
  const double z = z_edges_[row.index] + (z_edges_[row.index + 1] - z_edges_[row.index]) * row.within;
  return {direction_at((column.index + column.within) / columns_, z),
          pdf_of(cells_[static_cast<std::size_t>(row.index) * columns_ + column.index])};
}

double DirectionTable::pdf(Vec3 direction) const {
  if (!(row_sums_.total() > 0) || direction.z < z_edges_.front() || direction.z > z_edges_.back()) return 0;
  const int row = row_of(direction.z);
  const int column = std::min(static_cast<int>(turn_of(direction) * columns_), columns_ - 1);
  return pdf_of(cells_[static_cast<std::size_t>(row) * columns_ + column]);
}

}  // namespace citykiln::preview
