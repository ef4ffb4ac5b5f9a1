// A string of modules in two flat arrays: kinds and parameter values.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// A string of modules. F(1)[+(30)A(2,3)] has kinds F [ + A ] and values 1 30 2 3: each module has as many values as
/// the arity of its kind.
struct ModuleString {
  std::vector<Kind> kinds;
  std::vector<double> values;
};

/// Returns the string in the file's notation: "F(1)[+(30)A(2,3)]". Spaces separate names of more than one letter.
std::string text_of(const LSystem& system, const ModuleString& string);

}  // namespace citykiln::lsystems
