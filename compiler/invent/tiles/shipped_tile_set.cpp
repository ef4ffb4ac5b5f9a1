#include <string_view>
#include <utility>

#include "compiler/invent/tiles/tile_set.h"

namespace citykiln::invent {

std::string_view shipped_tile_set() {
  static constexpr std::pair<std::string_view, std::string_view> kFile[] = {
#include "compiler/invent/tiles/shipped_tile_set_generated.h"
  };
  return kFile[0].second;
}

}  // namespace citykiln::invent
