#include "grammars/language/read_rules.h"

#include <algorithm>
#include <cassert>

#include "grammars/language/body_properties.h"
#include "grammars/language/constant.h"
#include "grammars/language/lexer.h"
#include "grammars/language/parse.h"
#include "grammars/language/resolve.h"

namespace citykiln::grammars {
namespace {

// A file is read again for each prefix it is imported by. The limit is far above that of the shipped rules (6 files).
constexpr std::size_t kMostFiles = 256;

struct Linker {
  const Loader& load;
  Program program;
  std::vector<std::string> open;  ///< Files being read, the importing before the imported.
};

template <typename Named>
void add_all(std::vector<Named>& from, const std::string& prefix, std::vector<Named>& to,
             std::map<std::string, std::uint32_t, std::less<>>& index_of) {
  for (Named& one : from) {
    one.name = prefix + one.name;
    // Names of the importing file, which are added first, take precedence.
    if (!index_of.emplace(one.name, static_cast<std::uint32_t>(to.size())).second) continue;
    to.push_back(std::move(one));
  }
}

std::optional<Error> add_file(Linker& linker, const std::string& file, const std::string& prefix);

std::optional<Error> add_import(Linker& linker, const Import& import, const std::string& prefix) {
  const std::string where = position_text(linker.program.files[import.position.file], import.position);
  if (std::find(linker.open.begin(), linker.open.end(), import.file) != linker.open.end())
    return Error{where, "the files '" + linker.open.back() + "' and '" + import.file + "' import each other"};
  if (linker.program.files.size() >= kMostFiles) return Error{where, "more than 256 files are imported"};
  if (const Result<std::string> text = linker.load(import.file); !text)
    return Error{where, "the import \"" + import.file + "\": " + text.error().message};
  return add_file(linker, import.file, import.prefix.empty() ? prefix : prefix + import.prefix + ".");
}

std::optional<Error> add_file(Linker& linker, const std::string& file, const std::string& prefix) {
  const Result<std::string> text = linker.load(file);
  if (!text) return text.error();
  const auto file_index = static_cast<std::uint32_t>(linker.program.files.size());
  linker.program.files.push_back(file);
  Result<SyntaxTree> tree = parse(*text, file, file_index);
  if (!tree) return tree.error();
  if (file_index == 0) linker.program.start = tree->start;
  add_all(tree->attributes, prefix, linker.program.attributes, linker.program.attribute_of);
  add_all(tree->functions, prefix, linker.program.functions, linker.program.function_of);
  add_all(tree->rules, prefix, linker.program.rules, linker.program.rule_of);
  linker.open.push_back(file);
  for (const Import& import : tree->imports)
    if (auto error = add_import(linker, import, prefix)) return error;
  linker.open.pop_back();
  return {};
}

}  // namespace

Result<Program> read_rules(const std::string& file, const Loader& load) {
  assert(load);
  Linker linker{load, {}, {}};
  if (auto error = add_file(linker, file, "")) return *error;
  if (auto error = resolve(linker.program)) return *error;
  mark_constants(linker.program);
  analyse_bodies(linker.program);
  return std::move(linker.program);
}

Result<Program> read_rules_of(const std::string& text, const std::string& file) {
  return read_rules(file, [&](const std::string& asked) -> Result<std::string> {
    if (asked == file) return text;
    return Error{asked, "there is no such rule file"};
  });
}

}  // namespace citykiln::grammars
