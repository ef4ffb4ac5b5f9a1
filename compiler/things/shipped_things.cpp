#include "compiler/things/catalogue.h"

namespace citykiln::things {

std::span<const RuleText> shipped_things() {
  static const std::vector<RuleText> files = {
#include "compiler/things/shipped_things_generated.h"
  };
  return files;
}

}  // namespace citykiln::things
