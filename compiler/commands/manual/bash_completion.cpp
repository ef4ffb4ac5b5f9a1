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

/// The values that the table lists, and whether several can be given with commas between them.
struct Literals {
  std::vector<std::string> values;
  bool is_list = false;
};

/// Returns "clear" and "fair" of "clear|fair|FILE.json", "kiln" and "glb" of "kiln,glb", "none" of "[none]", and none
/// of "FILE".
Literals literals_of(const Option& option) {
  std::string_view text = option.value;
  if (text.starts_with("[") && text.ends_with("]")) text = text.substr(1, text.size() - 2);
  const bool is_list = text.find('|') == std::string_view::npos && text.find(',') != std::string_view::npos;
  Literals literals{.values = {}, .is_list = is_list};
  for (const std::string_view value : split(text, is_list ? ',' : '|'))
    if (is_literal(value)) literals.values.emplace_back(value);
  return literals;
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

/// The words before a value: the flags of an option, or for what stands by place the verb.
std::vector<std::string> words_before(const Option& option, const Verb& verb) {
  return option.flags.starts_with('-') ? flags_of(option) : std::vector{verb.name};
}

std::string value_cases(const Verb& verb) {
  std::string text;
  for (const Option& option : verb.options) {
    const Literals literals = literals_of(option);
    if (literals.values.empty()) continue;
    for (const std::string& before : words_before(option, verb))
      text += fmt::format("    {}:{}) {}words=\"{}\" ;;\n", verb.name, before, literals.is_list ? "is_list=1 " : "",
                          fmt::join(literals.values, " "));
  }
  return text;
}

constexpr std::string_view kScriptStart = R"(# bash completion for citykiln, written by `citykiln completion`
_citykiln() {
  local word="${COMP_WORDS[COMP_CWORD]}" verb="${COMP_WORDS[1]}" before="${COMP_WORDS[COMP_CWORD-1]}"
  local words="" is_list="" given=""
)";

constexpr std::string_view kScriptEnd = R"(  # of a list, the part after the last comma is completed
  if [ -n "$is_list" ] && [ "$word" != "${word%,*}" ]; then given="${word%,*},"; fi
  COMPREPLY=($(compgen -P "$given" -W "$words" -- "${word#"$given"}"))
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
