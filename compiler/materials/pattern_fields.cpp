#include "compiler/materials/pattern_fields.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace citykiln::materials {
namespace {

Field within_one(Field field) {
  for (float& v : field.values) v = std::clamp(v, -1.0f, 1.0f);
  return field;
}

// Box filter of odd width over a row that wraps around, by a running sum.
void blur_row(std::vector<double>& row, std::uint32_t width) {
  const std::size_t count = row.size(), half = width / 2;
  const std::vector<double> own = row;
  double sum = 0;
  for (std::size_t i = 0; i < width; ++i) sum += own[(i + count - half) % count];
  for (std::size_t i = 0; i < count; ++i) {
    row[i] = sum / width;
    sum += own[(i + half + 1) % count] - own[(i + count - half) % count];
  }
}

// Two box filters in each direction, an approximately isotropic blur.
Field blurred(const Field& field, std::uint32_t width) {
  Field out = field;
  std::vector<double> line(field.side_px);
  for (int pass = 0; pass < 4; ++pass)
    for (std::uint32_t row = 0; row < field.side_px; ++row) {
      const auto value = [&](std::uint32_t i) -> float& { return pass % 2 == 0 ? out.at(i, row) : out.at(row, i); };
      for (std::uint32_t i = 0; i < field.side_px; ++i) line[i] = value(i);
      blur_row(line, width);
      for (std::uint32_t i = 0; i < field.side_px; ++i) value(i) = static_cast<float>(line[i]);
    }
  return out;
}

}  // namespace

Field flat_field(std::uint32_t side_px) {
  return {side_px, std::vector<float>(static_cast<std::size_t>(side_px) * side_px)};
}

Field normalised(Field field, double deviations) {
  double sum = 0, squares = 0;
  for (const float v : field.values) sum += v;
  const double mean = sum / static_cast<double>(field.values.size());
  for (const float v : field.values) squares += (v - mean) * (v - mean);
  const double deviation = std::sqrt(squares / static_cast<double>(field.values.size()));
  const double scale = deviation > 1e-9 ? 1 / (deviations * deviation) : 0;
  for (float& v : field.values) v = static_cast<float>((v - mean) * scale);
  return field;
}

Field fine(const Field& field) {
  constexpr float kKeptShare = 0.15f;
  Field out = field;
  const Field wide = blurred(field, std::max(3u, field.side_px / 10 | 1u));
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] -= (1 - kKeptShare) * wide.values[i];
  return out;
}

PatternFields tones(const Field& tone, const Field& relief) {
  return {within_one(normalised(tone, 2)), normalised(relief, 1)};
}
PatternFields fine_tones(const Field& tone, const Field& relief) { return tones(fine(tone), relief); }

PatternFields fine_tones(const Field& both) { return fine_tones(both, both); }

double step(double value, double at, double width) { return std::clamp((value - at) / width + 0.5, 0.0, 1.0); }

}  // namespace citykiln::materials
