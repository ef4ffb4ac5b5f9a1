// A string of modules, flat: names in one array, numbers in another.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lsystems/lsystem.h"

namespace citykiln::lsystems {

/// F(1)[+(30)A(2,3)]: kinds F [ + A ], values 1 30 2 3. Each module takes as many values as its kind's arity.
struct ModuleString {
  std::vector<Kind> kinds;
  std::vector<double> values;
};

/// As one would write it: "F(1)[+(30)A(2,3)]"; names of more than a letter stand apart.
std::string text_of(const LSystem& system, const ModuleString& string);

}  // namespace citykiln::lsystems
