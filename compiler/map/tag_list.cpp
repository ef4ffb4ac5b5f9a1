#include "compiler/map/tag_list.h"

#include <cassert>

namespace citykiln::map {

void TagList::add(std::string_view key, std::string_view value) {
  assert(key.find('\0') == std::string_view::npos && value.find('\0') == std::string_view::npos);
  texts_ += key, texts_ += '\0';
  texts_ += value, texts_ += '\0';
}

std::vector<TagView> TagList::views() const {
  std::vector<TagView> tags;
  std::string_view rest = texts_;
  const auto next = [&] {
    const std::string_view text = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(text.size() + 1);
    return text;
  };
  while (!rest.empty()) {
    const std::string_view key = next();
    tags.push_back({key, next()});
  }
  return tags;
}

}  // namespace citykiln::map
