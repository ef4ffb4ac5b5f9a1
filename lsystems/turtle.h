// Turtle interpretation: from a string to a skeleton.
#pragma once

#include "lsystems/environment.h"
#include "lsystems/skeleton.h"

namespace citykiln::lsystems {

/// Interprets a string of interpret() from the origin with heading z; turtle_symbols.inc lists the operations. Other
/// modules are skipped. With LSystem::height the result is scaled about the origin.
///
/// Tropism: after each segment the heading turns towards the tropism T by e |heading × T| radians (the book,
/// section 2.1). Guarantees: the same bytes on every machine; directions are orthonormal within 1e-9; everything is
/// finite. Total: unclosed polygons, } and . outside polygons, polygons of fewer than three vertices, numbers beyond
/// kWalkLimit and branches deeper than kBranchLimit are skipped with a warning. O(modules).
Skeleton walk(const LSystem& system, const ModuleString& interpreted);

/// A derivation and its skeleton.
struct Plant {
  Derivation derivation;
  Skeleton skeleton;
};
/// Derives, interprets and walks.
Plant grow(const LSystem& system, const DeriveOptions& options = {});

/// The parameters of a string's queries in order: three numbers for ?P, one for ?H and ?S.
std::vector<double> answers_to(const LSystem& system, const ModuleString& interpreted, const Environment& environment);

inline constexpr double kWalkLimit = 1e9;            ///< Of a length, angle or width.
inline constexpr std::size_t kBranchLimit = 10'000;  ///< Of nested brackets, and of nested polygons.

}  // namespace citykiln::lsystems
