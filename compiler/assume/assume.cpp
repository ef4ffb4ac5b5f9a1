#include "compiler/assume/assume.h"

#include <utility>

#include "compiler/assume/styles.h"

namespace citykiln::assume {

map::Features assume(map::Features features, const Settings& settings, Report& report) {
  if (has(settings.on, Assumption::kStyles)) features = assume_styles(std::move(features), report);
  return features;
}

}  // namespace citykiln::assume
