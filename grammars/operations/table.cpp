#include "grammars/operations/table.h"

#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

constexpr OperationRow kOperations[] = {
#define OPERATION(name, function, signatures, words, selectors, alters, text) \
  {name, signatures, words, selectors, alters, function, text},
#include "grammars/operations/operations.inc"
#undef OPERATION
};

bool fits(const std::string& signature, const std::string& words, std::span<const Expression> arguments) {
  if (signature.size() != arguments.size()) return false;
  for (std::size_t i = 0; i < signature.size(); ++i) {
    const bool is_word = arguments[i].kind == ExpressionKind::kName && is_among(arguments[i].text, words);
    if ((signature[i] == 'w') != is_word && signature[i] != 'a') return false;
    if (is_share(arguments[i]) && signature[i] != 'm') return false;
  }
  return true;
}

}  // namespace

std::span<const OperationRow> operation_table() { return kOperations; }

int operation_of(const std::string& name) {
  for (std::size_t i = 0; i < std::size(kOperations); ++i)
    if (name == kOperations[i].name) return static_cast<int>(i);
  return -1;
}

bool is_among(std::string_view word, std::string_view words) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (at > 0 && words[at - 1] == ' ' && end < words.size() && words[end] == ' ') return true;
  }
  return false;
}

std::string fitting_signature(const OperationRow& row, std::span<const Expression> arguments, bool& found) {
  const std::string signatures = row.signatures;
  found = false;
  for (std::size_t from = 0; from <= signatures.size();) {
    const std::size_t end = std::min(signatures.find('|', from), signatures.size());
    const std::string signature = signatures.substr(from, end - from);
    found = fits(signature, row.words, arguments);
    if (found) return signature;
    from = end + 1;
  }
  return {};
}

}  // namespace citykiln::grammars
