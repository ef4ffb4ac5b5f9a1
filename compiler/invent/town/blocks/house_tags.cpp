#include "compiler/invent/town/blocks/house_tags.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/invent/tags.h"

namespace citykiln::invent {
namespace {

constexpr std::array kPlasters = {"#efe6d2", "#e9dcc0", "#f2ede2", "#dfd3bd", "#e8d6b8", "#d9c9ae", "#eadfd5",
                                  "#d8dcd2", "#e3d2c4", "#f0e3c6", "#cfd6d8", "#e6c9a8", "#d7b896", "#e8e8e4"};
constexpr std::array kBricks = {"#9c5a44", "#a8664c", "#8a4e3c", "#b0735a"};
constexpr std::array kTiles = {"#8f4a36", "#a0553c", "#7d4535", "#6b4a42", "#5c5450", "#4d4b4c"};

template <std::size_t N>
const char* pick(const std::array<const char*, N>& values, Draws& draws) {
  return values[draws.below(static_cast<std::uint32_t>(N))];
}

void pitched_roof(Tags& tags, const char* shape, int roof_levels, Draws& draws) {
  set_tag(tags, "roof:shape", shape);
  set_tag(tags, "roof:colour", pick(kTiles, draws));
  set_tag(tags, "roof:material", "roof_tiles");
  if (roof_levels > 0) set_tag(tags, "roof:levels", std::to_string(roof_levels));
}

void flat_roof(Tags& tags) {
  set_tag(tags, "roof:shape", "flat");
  set_tag(tags, "roof:levels", "0");
}

void core_roof(Tags& tags, int storeys, bool is_corner, Draws& draws) {
  // wings of a corner house meet under a hip
  if (storeys > 7 || draws.chance(0.22)) return flat_roof(tags);
  const bool is_mansard = storeys >= 4 && draws.chance(0.3);
  pitched_roof(tags, is_corner ? "hipped" : is_mansard ? "mansard" : "gabled", 1, draws);
}

void house_roof(Tags& tags, bool is_corner, Draws& draws) {
  const double roof = draws.unit();
  if (roof < 0.06) return flat_roof(tags);
  pitched_roof(tags, is_corner || roof < 0.24 ? "hipped" : roof < 0.32 ? "half-hipped" : "gabled", 1, draws);
}

const char* building_of(BlockUse use, int storeys, Draws& draws) {
  switch (use) {
    case BlockUse::kCore:
      return storeys > 8 ? "office" : draws.chance(0.12) ? "commercial" : "apartments";
    case BlockUse::kTerraces:
      return "terrace";
    case BlockUse::kFlats:
      return "apartments";
    case BlockUse::kCommerce:
      return draws.chance(0.5) ? "commercial" : "office";
    case BlockUse::kIndustry:
      return draws.chance(0.5) ? "industrial" : "warehouse";
    case BlockUse::kFarms:
      return draws.chance(0.5) ? "farm" : "house";
    default:
      return draws.chance(0.6) ? "house" : "detached";
  }
}

bool has_flat_roof(BlockUse use) {
  return use == BlockUse::kFlats || use == BlockUse::kCommerce || use == BlockUse::kIndustry;
}

void paint_large(Tags& tags, BlockUse use, int storeys, Draws& draws) {
  if (use == BlockUse::kIndustry) {
    set_tag(tags, "building:material", draws.chance(0.6) ? "metal" : "brick");
    set_tag(tags, "building:colour", draws.chance(0.5) ? "#c9ccca" : "#a9b4b8");
  } else if (storeys > 8) {
    set_tag(tags, "building:material", draws.chance(0.6) ? "glass" : "concrete");
  } else {
    paint_walls(tags, draws);
  }
}

}  // namespace

void paint_walls(Tags& tags, Draws& draws) {
  const bool is_brick = draws.chance(0.18);
  set_tag(tags, "building:material", is_brick ? "brick" : "plaster");
  set_tag(tags, "building:colour", is_brick ? pick(kBricks, draws) : pick(kPlasters, draws));
}

int storeys_at(const TownPlan& plan, double density, BlockUse use, Draws& draws) {
  const bool is_city = plan.settings.kind == TownKind::kCity;
  const double spread = draws.unit();
  switch (use) {
    case BlockUse::kCore:
      if (is_city && density > 0.84 && spread > 0.86) return 9 + static_cast<int>(draws.below(14));
      return static_cast<int>((is_city ? 2.6 : 2.2) + density * (is_city ? 3.4 : 2.4) + spread * 1.8);
    case BlockUse::kFlats:
      if (is_city && spread > 0.85) return 8 + static_cast<int>(draws.below(7));
      return 3 + static_cast<int>(spread * (is_city ? 4 : 2.6));
    case BlockUse::kTerraces:
      return 2 + (spread > 0.4 ? 1 : 0);
    case BlockUse::kCommerce:
      return 1 + static_cast<int>(spread * (is_city ? 6 : 3));
    case BlockUse::kIndustry:
      return 1 + (spread > 0.8 ? 1 : 0);
    default:
      return spread > 0.6 ? 3 : spread > 0.12 ? 2 : 1;
  }
}

Tags house_tags(BlockUse use, int storeys, bool is_corner, Draws& draws) {
  Tags tags = tags_of({{"building", building_of(use, storeys, draws)}, {"building:levels", std::to_string(storeys)}});
  if (has_flat_roof(use) && !(use == BlockUse::kIndustry && draws.chance(0.3)))
    flat_roof(tags);
  else if (use == BlockUse::kCore)
    core_roof(tags, storeys, is_corner, draws);
  else
    house_roof(tags, is_corner, draws);
  if (use == BlockUse::kIndustry) set_tag(tags, "height", std::to_string(storeys * 4 + 3));
  paint_large(tags, use, storeys, draws);
  return tags;
}

Tags outhouse_tags(const char* building, Draws& draws) {
  // mappers seldom state the storeys of garages and sheds
  Tags tags = tags_of({{"building", building}});
  const bool is_barn = std::string_view(building) == "barn";
  if (is_barn)
    pitched_roof(tags, "gabled", 1, draws);
  else if (draws.chance(0.6))
    flat_roof(tags);
  else
    pitched_roof(tags, "gabled", 0, draws);
  return tags;
}

}  // namespace citykiln::invent
