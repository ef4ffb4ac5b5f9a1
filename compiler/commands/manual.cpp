// The hidden verbs that print the manual page and the shell completion. A build runs them, a package installs what they
// print.
#include <fmt/format.h>

#include "compiler/commands/manual/bash_completion.h"
#include "compiler/commands/manual/man_page.h"
#include "compiler/commands/verb.h"

namespace citykiln::commands {
namespace {

using MakeText = std::string (*)(std::span<const Verb> verbs);

Verb printing_verb(std::string name, std::string help, std::vector<Verb> verbs, MakeText make) {
  Verb verb{std::move(name), std::move(help), {}, {}};
  verb.is_hidden = true;
  verb.run = [verbs = std::move(verbs), make](const Console&) -> Result<Exit> {
    fmt::print("{}", make(verbs));
    return Exit::kDone;
  };
  return verb;
}

}  // namespace

Verb man_verb(std::vector<Verb> verbs) {
  return printing_verb("man", "prints the manual page", std::move(verbs), man_page);
}

Verb completion_verb(std::vector<Verb> verbs) {
  return printing_verb("completion", "prints the completion for bash", std::move(verbs), bash_completion);
}

}  // namespace citykiln::commands
