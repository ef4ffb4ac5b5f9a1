// Patterns: what a node made, ready to be made again of a shape that is the same but for a motion.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grammars/derive.h"
#include "grammars/displacement.h"

namespace citykiln::grammars {

struct Run;

/// How a shape came about: the `ordinal`-th child, called `name`, of the shape `parent`.
struct Birth {
  std::uint32_t parent = 0;  ///< Into Run::births.
  const char* name = "";     ///< Lives in the program.
  std::uint64_t ordinal = 0;
};

/// A throw of a shape's dice that decided between a few ways to go on.
struct Throw {
  std::uint32_t birth = 0;   ///< The shape's; into Run::births, or of a pattern as in Pattern::births.
  std::uint32_t index = 0;   ///< Of Draw::unit().
  double scale = 1;          ///< What the number was multiplied by.
  double low = 0, high = 0;  ///< low <= number · scale < high: whatever lies there leads the same way.
};

/// All throws that a node depends on, and the descent of those who threw, seen from its shape.
struct Throws {
  std::vector<Birth> births;  ///< Parents first; a parent of 0 is the shape, others one more than their place here.
  std::vector<Throw> thrown;
};

/// What is known of a terminal beyond what the caller hears.
struct TerminalNote {
  std::uint32_t birth = 0;       ///< Into Run::births.
  std::uint32_t texture = 0;     ///< Into Tables::textures.
  std::uint32_t stands_for = 0;  ///< Into Tables::look_areas: of one that was cut, what its detail looks like.
  std::uint32_t moved_at = 0;    ///< As Shape's.
};

/// Indices from `first` to before `end`.
struct IndexRange {
  std::size_t first = 0, end = 0;
};

/// What a node made, in the tables of the run.
struct Made {
  IndexRange terminals, births, reports, textures, throws;
  std::uint64_t shapes = 0, steps = 0;
  NodeTrace trace;
};

/// A point of a copy: an offset, along the scope's axes, from a vertex of the shape. Without one it is the vertex, bit
/// for bit.
struct Anchored {
  std::uint32_t vertex = 0;
  Vec3 offset_m;
};

/// Where a copy's texture comes from.
enum class TextureSource : std::uint8_t { kTexture, kProjection, kOwn };

struct PatternTerminal {
  Terminal terminal;   ///< As it was first derived; its scope's axes and texture along the pattern's scope.
  TerminalNote note;   ///< `birth` into Pattern::births, 0 the pattern's own shape.
  bool moved = false;  ///< Off the shape's surface: no part of it.
  TextureSource source = TextureSource::kTexture;
  std::uint32_t texture = 0;               ///< Of kOwn: into Pattern::textures.
  std::uint32_t origin = 0;                ///< Of the scope; into Pattern::points.
  std::vector<std::uint32_t> points = {};  ///< Of all vertices in turn; into Pattern::points.
};

struct PatternReport {
  Reported reported;
  std::uint32_t birth = 0;
};

/// Everything that a copy needs.
struct Pattern {
  std::vector<Anchored> points;
  std::vector<Birth> births;  ///< Those that terminals and reports descend from; parents into this list, 0 the shape.
  struct Texture {
    std::uint32_t origin = 0;  ///< Into `points`.
    Vec3 u_per_m, v_per_m;     ///< Along the scope's axes.
  };
  std::vector<Texture> textures;
  std::vector<PatternTerminal> terminals;
  std::vector<PatternReport> reports;
  std::vector<Throw> throws;
};

/// The throws of a node that began with the shape born as `birth`.
Throws throws_of(const Run& run, std::uint32_t birth, IndexRange throws);

/// True if the dice of the descendants of the shape born as `birth` would fall as those did. O(births).
bool would_throw(Run& run, std::uint32_t birth, const Throws& throws);

/// The pattern of what `shape`, one face without holes, was made to. std::nullopt if something divides the shape's
/// surface at its border, where neighbours would have to be divided at the same points, bit for bit.
/// O(n e), n points made, e edges of the shape.
std::optional<Pattern> pattern_of(const Run& run, const Shape& shape, const Made& made);

/// Makes it again of `shape`, into the tables of the run.
///
/// Guarantees: vertices of the shape stay as they are, bit for bit; points that were one are one; ids are those of
/// descent. O(what it makes).
void copy_pattern(Run& run, const Pattern& pattern, const Shape& shape);

}  // namespace citykiln::grammars
