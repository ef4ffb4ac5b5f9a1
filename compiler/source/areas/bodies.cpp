#include "compiler/source/areas/bodies.h"

#include <algorithm>

namespace citykiln::source {
namespace {

struct BodyTag {
  std::string_view key, value;
  bool operator==(const BodyTag&) const = default;
};

constexpr std::string_view kBodyKeys[] = {
#define BODY_KEY(key) key,
#define BODY(key, value)
#define NO_BODY(key, value)
#include "compiler/source/areas/bodies.inc"
#undef BODY_KEY
#undef BODY
#undef NO_BODY
};

constexpr BodyTag kBodies[] = {
#define BODY_KEY(key)
#define BODY(key, value) {key, value},
#define NO_BODY(key, value)
#include "compiler/source/areas/bodies.inc"
#undef BODY
#undef NO_BODY
};

constexpr BodyTag kWithoutBody[] = {
#define BODY(key, value)
#define NO_BODY(key, value) {key, value},
#include "compiler/source/areas/bodies.inc"
#undef BODY_KEY
#undef BODY
#undef NO_BODY
};

}  // namespace

bool has_body(std::string_view key, std::string_view value) {
  const BodyTag tag{key, value};
  if (std::ranges::find(kBodyKeys, key) != std::end(kBodyKeys))
    return std::ranges::find(kWithoutBody, tag) == std::end(kWithoutBody);
  return std::ranges::find(kBodies, tag) != std::end(kBodies);
}

}  // namespace citykiln::source
