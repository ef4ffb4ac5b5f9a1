// Reads and writes lines with curves: the points of a curve between its ends are computed from a few numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/curved_chord.h"
#include "exporters/kiln/member_codecs.h"

namespace citykiln::exporters {

/// A part of a line: a curve, or a straight piece, to the point `last` of the line.
struct CodedPart {
  std::size_t last = 0;
  std::optional<CurvedChord> curve{};
};

/// Returns the parts of a line, the first of which is its first point. A curve is the longest that the line follows
/// from where the part before ends. O(points).
inline std::vector<CodedPart> parts_of(std::span<const Vec2> line) {
  constexpr std::size_t kMostBetween = 2 * kMostPieces;
  std::vector<CodedPart> parts = {{0}};
  while (parts.back().last + 1 < line.size()) {
    const std::size_t from = parts.back().last;
    CodedPart next{from + 1};
    for (std::size_t n = std::min(kMostBetween + 2, line.size() - from); n > 2 && !next.curve; --n)
      if (const std::optional<CurvedChord> chord = chord_through(line.subspan(from, n))) next = {from + n - 1, chord};
    parts.push_back(next);
  }
  return parts;
}

// Reads a part of a line that begins where the line ends.
void read_part(auto& io, Stream kind, std::vector<Vec2>& line) {
  std::uint64_t code = io.whole("points");
  const bool is_curve = code == kCurve;
  if (is_curve && line.empty()) return io.fail(kind);
  CurvedChord chord;
  if (is_curve) chord = io.curve(), code = io.whole("points");
  Vec2 end;
  io.point_of(code, end);
  if (is_curve && io.wrong.empty())
    for (const Vec2 p : points_between(chord, line.back(), end)) line.push_back(p);
  line.push_back(end);
}

/// The points of a line that may have curves.
/// @param kind   The stream with the number of its parts.
/// @param least  The smallest number of parts.
template <typename Io>
void curved_points(Io& io, Stream kind, std::vector<Vec2>& line, std::size_t least) {
  if constexpr (Io::kReads) {
    const std::size_t size = io.count(kind, 0);
    if (size < least) return io.fail(kind);
    for (std::size_t i = 0; i < size && io.wrong.empty(); ++i) read_part(io, kind, line);
  } else if constexpr (requires(const CurvedChord& chord) { io.curve(chord); }) {
    const std::vector<CodedPart> parts = parts_of(line);
    io.count(kind, parts.size());
    for (const CodedPart& part : parts) {
      if (part.curve) io.curve(*part.curve);
      io.point(line[part.last]);
    }
  } else {
    points(io, kind, line, least);
  }
}

}  // namespace citykiln::exporters
