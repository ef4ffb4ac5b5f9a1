// The lines of a pitch and the places of its equipment, from the texts of the table (pitches.inc).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/pitches/recipe.h"

namespace citykiln::pitches {

/// A painted line, in the pitch's frame: x from its middle towards `to`, y to the left of it, metres.
struct PitchLine {
  Polyline path;                   ///< The middle of the line. It is closed if the last point is the first one.
  std::size_t section_chords = 1;  ///< Chords of a section: 1 for straight lines, more for arcs.
  bool is_disc = false;            ///< The path is the border of a disc.
  double dash_m = 0, gap_m = 0;    ///< Dashes of a broken line, and the gaps between them; 0: unbroken.
};

/// A thing that belongs to a pitch: a goal, a net.
struct Equipment {
  std::string_view thing;  ///< A row of the table of things.
  Vec2 at, facing;         ///< Plane metres; the direction that it faces, length 1.
};

/// The half lengths of a pitch to the middle of its outer lines.
struct HalfSize {
  double to_end_line_m, to_side_line_m;  ///< Along the pitch, and across it.
};
HalfSize half_size_of(const Pitch& pitch);

/// Returns the lines of a text. Chords of arcs are within 4 mm of the arc. A command that cannot be read gives nothing:
/// all rows can be read, which a test checks.
std::vector<PitchLine> lines_of(std::string_view text, HalfSize half);
std::vector<PitchLine> lines_of(const Pitch& pitch);

/// Returns the equipment of a pitch.
std::vector<Equipment> equipment_of(const Pitch& pitch);

/// The pitch's frame: a point of it in the plane.
struct PitchFrame {
  Vec2 middle, along;  ///< `along` points from the first end to the second one, length 1.
  Vec2 in_plane(Vec2 p) const { return middle + along * p.x + left_of(along) * p.y; }
};
PitchFrame frame_of(const Pitch& pitch);

/// Returns a coordinate: a number, e, s, or a sum of two of these, such as "e-5.5" or "-s". Empty if the text is not a
/// coordinate.
std::optional<double> coordinate_m(std::string_view text, HalfSize half);

}  // namespace citykiln::pitches
