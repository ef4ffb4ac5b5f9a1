#include "compiler/map/pavements.h"

#include <string>

#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

// Two people with a pram between them.
constexpr double kUsual_m = 2;
constexpr double kLeast_m = 0.5, kMost_m = 20;

bool is_none(std::string_view value) { return value == "no" || value == "none" || value == "separate" || value == "0"; }

// What a side's own key says, else what both sides' does, else the plain key.
bool has_side(const Reading& reading, source::Range tags, const std::string& side) {
  for (const std::string& key : {"sidewalk:" + side, std::string("sidewalk:both")})
    if (const std::string_view value = reading.tag(tags, key); !value.empty()) return !is_none(value);
  const std::string_view value = reading.tag(tags, "sidewalk");
  return value == "both" || value == "yes" || value == side;
}

double width_m(const Reading& reading, OsmId id, source::Range tags, const std::string& side) {
  if (!has_side(reading, tags, side)) return 0;
  for (const std::string& key :
       {"sidewalk:" + side + ":width", std::string("sidewalk:both:width"), std::string("sidewalk:width")})
    if (const auto tagged = tagged_length_m(reading, id, tags, key, kLeast_m, kMost_m))
      return snapped_to(0.25, *tagged);
  return kUsual_m;
}

}  // namespace

Pavements pavements_of(const Reading& reading, OsmId id, source::Range tags) {
  return {width_m(reading, id, tags, "left"), width_m(reading, id, tags, "right")};
}

}  // namespace citykiln::map
