// The hidden verbs that print the manual pages and the shell completion. A build runs them, a package installs what
// they print.
#include <fmt/format.h>

#include <memory>

#include "compiler/commands/manual/bash_completion.h"
#include "compiler/commands/manual/man_page.h"
#include "compiler/commands/run_paths.h"
#include "compiler/commands/verb.h"
#include "exporters/file.h"
#include "exporters/output_folder.h"

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

/// Writes the pages of the program and of its verbs.
Result<Exit> write_pages(std::span<const Verb> verbs, const std::string& folder) {
  if (const Result<Done> made = make_output_folder(folder); !made) return made.error();
  const auto write = [&](const std::string& name, const std::string& page) {
    return exporters::write_file(folder + "/" + name + ".1", exporters::bytes_of(page));
  };
  if (const Result<Done> done = write("citykiln", man_page(verbs)); !done) return done.error();
  for (const Verb& verb : verbs)
    if (const Result<Done> done = write("citykiln-" + verb.name, man_page_of(verb)); !done) return done.error();
  return Exit::kDone;
}

}  // namespace

Verb man_verb(std::vector<Verb> verbs) {
  const auto folder = std::make_shared<std::string>();
  Verb verb = printing_verb("man", "prints the manual page, or writes the pages of all verbs", verbs, man_page);
  verb.options = {{"-o,--out", "FOLDER", "folder for citykiln.1 and citykiln-VERB.1", false, store_text(*folder)}};
  verb.run = [print = verb.run, verbs = std::move(verbs), folder](const Console& console) -> Result<Exit> {
    return folder->empty() ? print(console) : write_pages(verbs, *folder);
  };
  return verb;
}

Verb completion_verb(std::vector<Verb> verbs) {
  return printing_verb("completion", "prints the completion for bash", std::move(verbs), bash_completion);
}

}  // namespace citykiln::commands
