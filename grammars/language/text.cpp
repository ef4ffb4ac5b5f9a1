#include "grammars/language/text.h"

#include <algorithm>

namespace citykiln::grammars {
namespace {

std::size_t index_in(const std::string& text, double index) {
  return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(text.size())));
}

}  // namespace

std::string part_of(const std::string& text, double from, double to) {
  const std::size_t first = index_in(text, from), end = index_in(text, to);
  return end > first ? text.substr(first, end - first) : "";
}

double index_of_word(const std::string& text, const std::string& word, double from) {
  const std::size_t at = text.find(word, index_in(text, from));
  return at == std::string::npos ? -1 : static_cast<double>(at);
}

double count_of_word(const std::string& text, const std::string& word) {
  double times = 0;
  if (word.empty()) return times;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++times;
  return times;
}

std::string replaced(const std::string& text, const std::string& word, const std::string& other) {
  if (word.empty()) return text;
  std::string made;
  std::size_t from = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, from)) {
    made.append(text, from, at - from).append(other);
    from = at + word.size();
  }
  made.append(text, from);
  made.resize(std::min<std::size_t>(made.size(), 4096));
  return made;
}

}  // namespace citykiln::grammars
