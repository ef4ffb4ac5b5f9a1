#include "compiler/commands/manual/bash_completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "compiler/contract/texts/parse.h"

namespace citykiln::commands {
namespace {

std::vector<std::string> flags_of(const Option& option) {
  std::vector<std::string> flags;
  for (const std::string_view flag : split(option.flags, ','))
    if (flag.starts_with('-')) flags.emplace_back(flag);
  return flags;
}

/// True for a value that is written as it stands, such as "meshopt"; names of what to give, such as "FILE", are not.
bool is_literal(std::string_view text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

/// The values that the table lists: "clear" and "fair" of "clear|fair|FILE.json", none of "FILE".
std::vector<std::string> literals_of(const Option& option) {
  std::vector<std::string> values;
  if (option.value.find('|') == std::string::npos) return values;
  for (const std::string_view value : split(option.value, '|'))
    if (is_literal(value)) values.emplace_back(value);
  return values;
}

/// A case of the script: after these words, these can follow.
std::string case_of(std::string_view pattern, const std::vector<std::string>& words) {
  return fmt::format("    {}) words=\"{}\" ;;\n", pattern, fmt::join(words, " "));
}

std::string flag_case(const Verb& verb) {
  std::vector<std::string> flags = {kJson.flag, kQuiet.flag, kHelp.flag};
  for (const Option& option : verb.options)
    for (std::string& flag : flags_of(option)) flags.push_back(std::move(flag));
  std::ranges::sort(flags);
  return case_of(verb.name + ":-*", flags);
}

std::string value_cases(const Verb& verb) {
  std::string text;
  for (const Option& option : verb.options) {
    const std::vector<std::string> values = literals_of(option);
    for (const std::string& flag : flags_of(option))
      if (!values.empty()) text += case_of(fmt::format("{}:{}", verb.name, flag), values);
  }
  return text;
}

constexpr std::string_view kScriptStart = R"(# bash completion for citykiln, written by `citykiln completion`
_citykiln() {
  local word="${COMP_WORDS[COMP_CWORD]}" verb="${COMP_WORDS[1]}" before="${COMP_WORDS[COMP_CWORD-1]}" words=""
)";

constexpr std::string_view kScriptEnd = R"(  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o bashdefault -o default -F _citykiln citykiln
)";

}  // namespace

std::string bash_completion(std::span<const Verb> verbs) {
  std::string names, flags, values;
  for (const Verb& verb : verbs) {
    if (verb.is_hidden) continue;
    names += verb.name + " ";
    flags += flag_case(verb);
    values += value_cases(verb);
  }
  std::string script(kScriptStart);
  script += fmt::format("  if [ \"$COMP_CWORD\" -eq 1 ]; then words=\"{}--help --version\"; fi\n", names);
  script += "  case \"$verb:$word\" in\n" + flags + "  esac\n";
  script += "  case \"$verb:$before\" in\n" + values + "  esac\n";
  return script + std::string(kScriptEnd);
}

}  // namespace citykiln::commands
