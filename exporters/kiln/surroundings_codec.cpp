#include "exporters/kiln/surroundings_codec.h"

#include <limits>

#include "exporters/kiln/streams.h"

namespace citykiln::exporters {
namespace {

using surroundings::Cover;
using surroundings::Surroundings;

std::vector<std::uint8_t> encode_lines(const std::vector<std::int32_t>& lines) {
  StreamWriter writer;
  for (const std::int32_t line : lines) writer.put_delta(line);
  return writer.bytes();
}

// Each height is predicted by its neighbours to the west, south and south-west.
std::int64_t predicted_surrounding_height_m(const Surroundings& around, std::size_t column, std::size_t row) {
  const auto at = [&](std::size_t c, std::size_t r) { return std::int64_t{around.heights_m[around.index(c, r)]}; };
  if (column == 0) return row == 0 ? 0 : at(0, row - 1);
  if (row == 0) return at(column - 1, 0);
  return at(column - 1, row) + at(column, row - 1) - at(column - 1, row - 1);
}

std::optional<std::int32_t> as_int32(std::int64_t value) {
  using Limits = std::numeric_limits<std::int32_t>;
  if (value < Limits::min() || value > Limits::max()) return std::nullopt;
  return static_cast<std::int32_t>(value);
}

std::optional<std::vector<std::int32_t>> decode_lines(std::span<const std::uint8_t> stream) {
  StreamReader reader(stream);
  std::vector<std::int32_t> lines;
  while (reader.remaining() > 0 && lines.size() <= surroundings::kMostLines) {
    const auto line = as_int32(reader.get_delta());
    if (!line) return std::nullopt;
    lines.push_back(*line);
  }
  return reader.is_finished() && lines.size() <= surroundings::kMostLines ? std::optional(lines) : std::nullopt;
}

bool decode_heights(std::span<const std::uint8_t> stream, Surroundings& around) {
  StreamReader reader(stream);
  for (std::size_t row = 0; row < around.rows(); ++row)
    for (std::size_t column = 0; column < around.columns(); ++column) {
      const std::int64_t difference = reader.get_signed();
      constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
      if (!reader.good() || difference < -kMost || difference > kMost) return false;
      const auto height_m = as_int32(predicted_surrounding_height_m(around, column, row) + difference);
      if (!height_m) return false;
      around.heights_m.push_back(*height_m);
    }
  return reader.is_finished();
}

constexpr auto kCovers = static_cast<std::size_t>(Cover::kCount);

Cover next_cover(Cover cover) { return static_cast<Cover>((static_cast<std::size_t>(cover) + 1) % kCovers); }

// Runs of one cover, of land, sea and lake in turn.
bool decode_covers(std::span<const std::uint8_t> stream, Surroundings& around) {
  StreamReader reader(stream);
  const std::size_t count = around.heights_m.size();
  for (Cover cover = Cover::kLand; reader.remaining() > 0; cover = next_cover(cover)) {
    const std::uint64_t run = reader.get();
    if (!reader.good() || run > count - around.covers.size()) return false;
    around.covers.insert(around.covers.end(), run, cover);
  }
  return around.covers.size() == count;
}

}  // namespace

SurroundingsStreams encode_surroundings(const Surroundings& around) {
  StreamWriter heights, covers;
  for (std::size_t row = 0; row < around.rows(); ++row)
    for (std::size_t column = 0; column < around.columns(); ++column)
      heights.put_signed(around.heights_m[around.index(column, row)] -
                         predicted_surrounding_height_m(around, column, row));
  Cover cover = Cover::kLand;
  std::uint64_t run = 0;
  for (const Cover next : around.covers) {
    for (; cover != next; cover = next_cover(cover)) covers.put(run), run = 0;
    ++run;
  }
  covers.put(run);
  return {encode_lines(around.x_m), encode_lines(around.y_m), heights.bytes(), covers.bytes()};
}

std::optional<Surroundings> decode_surroundings(std::span<const std::uint8_t> x, std::span<const std::uint8_t> y,
                                                std::span<const std::uint8_t> heights,
                                                std::span<const std::uint8_t> covers) {
  auto columns = decode_lines(x), rows = decode_lines(y);
  // each height takes a byte at least
  if (!columns || !rows || columns->size() * rows->size() > heights.size()) return std::nullopt;
  Surroundings around{.x_m = std::move(*columns), .y_m = std::move(*rows), .heights_m = {}, .covers = {}};
  if (!decode_heights(heights, around) || !decode_covers(covers, around)) return std::nullopt;
  return around;
}

}  // namespace citykiln::exporters
