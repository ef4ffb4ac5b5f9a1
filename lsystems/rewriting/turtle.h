// Interprets a string of modules by a turtle (a moving position with three directions), which draws a skeleton: stems,
// polygons and instances.
#pragma once

#include "lsystems/rewriting/environment.h"
#include "lsystems/rewriting/skeleton.h"

namespace citykiln::lsystems {

/// Interprets the result of interpret() from the origin with heading z. turtle_symbols.inc lists the operations; other
/// modules are skipped. If LSystem::height is set, the result is scaled about the origin.
///
/// Tropism: after each segment the heading turns towards the tropism T by e |heading × T| radians (the book,
/// section 2.1). Guarantees: deterministic on every machine; directions are orthonormal within 1e-9; all numbers are
/// finite. Skips with a warning: unclosed polygons, } and . outside polygons, polygons of fewer than three vertices,
/// numbers beyond kWalkLimit, branches deeper than kBranchLimit. O(modules).
Skeleton walk(const LSystem& system, const ModuleString& interpreted);

/// A derived plant: the string and the skeleton.
struct Plant {
  Derivation derivation;
  Skeleton skeleton;
};
/// Grows a plant: derive(), interpret() and walk().
Plant grow(const LSystem& system, const DeriveOptions& options = {});

/// Returns the answers to a string's queries in order: three numbers for ?P, one each for ?H and ?S.
std::vector<double> answers_to(const LSystem& system, const ModuleString& interpreted, const Environment& environment);

inline constexpr double kWalkLimit = 1e9;            ///< The largest length, angle or width.
inline constexpr std::size_t kBranchLimit = 10'000;  ///< The depth of nested brackets, and of nested polygons.

}  // namespace citykiln::lsystems
