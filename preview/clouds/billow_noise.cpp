#include "preview/clouds/billow_noise.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::preview {
namespace {

constexpr int kBillowCells = BillowNoise::kPeriod;
using CellPoints = std::vector<std::array<float, 3>>;

std::size_t cell_index(int x, int y, int z) {
  const auto wrapped = [](int v) { return static_cast<std::size_t>((v + kBillowCells) % kBillowCells); };
  return (wrapped(z) * kBillowCells + wrapped(y)) * kBillowCells + wrapped(x);
}

// One point in each cell, relative to the cell.
CellPoints random_points() {
  const RandomSequence draw(1, StableId{1}, "billows");
  CellPoints points;
  for (std::uint32_t i = 0; i < kBillowCells * kBillowCells * kBillowCells; ++i)
    points.push_back({static_cast<float>(draw.unit(3 * i)), static_cast<float>(draw.unit(3 * i + 1)),
                      static_cast<float>(draw.unit(3 * i + 2))});
  return points;
}

// The square of the distance to the nearest point.
float nearest2(const CellPoints& points, const std::array<float, 3>& at) {
  std::array<int, 3> cell{};
  for (std::size_t i = 0; i < 3; ++i) cell[i] = static_cast<int>(at[i]);
  float least = 4;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const auto& point = points[cell_index(cell[0] + x, cell[1] + y, cell[2] + z)];
        const float dx = static_cast<float>(cell[0] + x) + point[0] - at[0],
                    dy = static_cast<float>(cell[1] + y) + point[1] - at[1],
                    dz = static_cast<float>(cell[2] + z) + point[2] - at[2];
        least = std::min(least, dx * dx + dy * dy + dz * dz);
      }
  return least;
}

}  // namespace

BillowNoise::BillowNoise() {
  const CellPoints points = random_points();
  constexpr float kStep = static_cast<float>(kPeriod) / kSamples;
  double sum = 0;
  for (int i = 0; i < kSamples * kSamples * kSamples; ++i) {
    const std::array<float, 3> at = {static_cast<float>(i % kSamples) * kStep,
                                     static_cast<float>(i / kSamples % kSamples) * kStep,
                                     static_cast<float>(i / kSamples / kSamples) * kStep};
    const float value = std::max(0.0F, 1 - nearest2(points, at));
    tile_.push_back(static_cast<std::uint8_t>(value * 255 + 0.5F));
    sum += tile_.back();
  }
  mean_ = static_cast<float>(sum / (255.0 * static_cast<double>(tile_.size())));
}

float BillowNoise::at(float x, float y, float z) const {
  constexpr float kScale = static_cast<float>(kSamples) / kPeriod;
  const float fx = std::floor(x * kScale), fy = std::floor(y * kScale), fz = std::floor(z * kScale);
  const float u = x * kScale - fx, v = y * kScale - fy, w = z * kScale - fz;
  constexpr int kMask = kSamples - 1;
  const int ix = static_cast<int>(fx), iy = static_cast<int>(fy), iz = static_cast<int>(fz);
  const int x0 = ix & kMask, x1 = (ix + 1) & kMask;
  const auto along_x = [&](int row, int slice) {
    const std::uint8_t* first =
        &tile_[static_cast<std::size_t>(((slice & kMask) * kSamples + (row & kMask)) * kSamples)];
    return static_cast<float>(first[x0]) * (1 - u) + static_cast<float>(first[x1]) * u;
  };
  const float low = along_x(iy, iz) * (1 - v) + along_x(iy + 1, iz) * v,
              high = along_x(iy, iz + 1) * (1 - v) + along_x(iy + 1, iz + 1) * v;
  return (low * (1 - w) + high * w) * (1.0F / 255);
}

}  // namespace citykiln::preview
