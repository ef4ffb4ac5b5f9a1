#include "grammars/language/operation_table.h"

#include <algorithm>

namespace citykiln::grammars {
namespace {

constexpr OperationRow kOperations[] = {
#define OPERATION(name, function, signatures, words, selectors, alters, bound, text) \
  {name, signatures, words, selectors, alters, bound, text},
#include "grammars/language/operations.inc"
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

bool sets_attribute(const Statement& statement) {
  return statement.name == "set" && statement.arguments.front().index != ~0u;
}

std::span<const OperationRow> operation_table() { return kOperations; }

int operation_of(const std::string& name) {
  const auto row = std::ranges::find(kOperations, name, &OperationRow::name);
  return row == std::end(kOperations) ? -1 : static_cast<int>(row - kOperations);
}

bool is_among(std::string_view word, std::string_view words) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (at > 0 && words[at - 1] == ' ' && end < words.size() && words[end] == ' ') return true;
  }
  return false;
}

std::vector<std::string> signatures_of(const OperationRow& row) {
  std::vector<std::string> signatures(1);
  for (const char* letter = row.signatures; *letter != 0; ++letter) {
    if (*letter == '|') signatures.emplace_back();
    if (*letter != '|') signatures.back() += *letter;
  }
  return signatures;
}

std::optional<std::string> fitting_signature(const OperationRow& row, std::span<const Expression> arguments) {
  for (std::string& signature : signatures_of(row))
    if (fits(signature, row.words, arguments)) return std::move(signature);
  return std::nullopt;
}

}  // namespace citykiln::grammars
