#include "compiler/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cassert>
#include <new>

#include "compiler/contract/nearest_name.h"
#include "compiler/contract/parse.h"
#include "compiler/contract/program_version.h"

namespace citykiln::commands {
namespace {

int fail(const Error& error, const Console& console) {
  console.print_error(error);
  return static_cast<int>(Exit::kFailed);
}

/// Declares one option of the table to CLI11.
void declare(CLI::App& app, const Option& option) {
  // a switch, or one that can have a value: --strict, --strict=CODE
  if (option.value.empty() || option.value.starts_with("[=")) {
    app.add_flag(option.flags, option.help);
    return;
  }
  CLI::Option* declared = app.add_option(option.flags, option.help)->type_name(option.value);
  const bool stands_by_place = option.flags.front() != '-';
  if (option.repeats)
    declared->expected(1, CLI::detail::expected_max_vector_size)
        ->allow_extra_args(stands_by_place || option.takes_several);
}

CLI::App& declare(CLI::App& app, const Verb& verb, Console& console) {
  CLI::App& command = *app.add_subcommand(verb.name, verb.help);
  for (const Option& option : verb.options) declare(command, option);
  if (!verb.examples.empty()) command.footer(fmt::format("Examples:\n  {}", fmt::join(verb.examples, "\n  ")));
  command.add_flag(kJson.flag, console.is_json, kJson.help);
  command.add_flag(kQuiet.flag, console.is_quiet, kQuiet.help);
  command.set_help_flag("-h," + std::string(kHelp.flag), kHelp.help);
  // a group without a name is not in the help
  if (verb.is_hidden) command.group("");
  return command;
}

/// Passes every given value to its option.
Result<Done> take(const CLI::App& command, const Verb& verb) {
  for (const Option& option : verb.options) {
    const std::string name = option.flags.substr(option.flags.rfind(',') + 1);
    for (const std::string& text : command.get_option(name)->results()) {
      if (const Result<Done> taken = option.store(text); !taken) {
        return taken.error().where.empty() ? Error{name, taken.error().message} : taken.error();
      }
    }
  }
  return Done{};
}

int run_verb(const CLI::App& command, const Verb& verb, const Console& console) {
  if (const Result<Done> taken = take(command, verb); !taken) return fail(taken.error(), console);
  const Result<Exit> exit = verb.run(console);
  return exit ? static_cast<int>(*exit) : fail(exit.error(), console);
}

/// All long flags of a verb: "--out" of "-o,--out".
std::vector<std::string> long_flags_of(const Verb& verb) {
  std::vector<std::string> flags = {kJson.flag, kQuiet.flag, kHelp.flag};
  for (const Option& option : verb.options)
    for (const std::string_view flag : split(option.flags, ','))
      if (flag.starts_with("--")) flags.emplace_back(flag);
  return flags;
}

/// Error: the first word is no verb, or a later one is a long flag that the verb does not have.
Result<Done> are_known(std::span<const Verb> verbs, std::span<const char* const> words) {
  if (words.empty() || words.front()[0] == '-') return Done{};
  std::vector<std::string> names;
  for (const Verb& verb : verbs)
    if (!verb.is_hidden) names.push_back(verb.name);
  const auto verb = std::ranges::find(verbs, words.front(), &Verb::name);
  if (verb == verbs.end())
    return Error{words.front(), fmt::format("is not a verb{}; the verbs are {}", did_you_mean(words.front(), names),
                                            fmt::join(names, ", "))};
  const std::vector<std::string> flags = long_flags_of(*verb);
  for (const std::string_view word : words.subspan(1)) {
    const std::string flag(word.substr(0, word.find('=')));
    if (!flag.starts_with("--") || std::ranges::find(flags, flag) != flags.end()) continue;
    return Error{flag, fmt::format("is not an option of {}{} (citykiln {} --help lists all)", verb->name,
                                   did_you_mean(flag, flags), verb->name)};
  }
  return Done{};
}

}  // namespace

int run(std::span<const Verb> verbs, int argc, const char* const* argv) {
  assert(!verbs.empty() && argc > 0);
  CLI::App app("citykiln compiles OpenStreetMap extracts and heightmaps to 3D city tiles", "citykiln");
  app.set_version_flag("--version", kProgramVersion);
  app.require_subcommand(1);
  // known before parsing, so that errors of the command line are JSON too
  const bool is_json =
      std::ranges::count(std::span(argv, static_cast<std::size_t>(argc)), std::string_view("--json")) > 0;
  Console console{.is_json = is_json};
  for (const Verb& verb : verbs) declare(app, verb, console);
  const std::span words(argv + 1, static_cast<std::size_t>(argc - 1));
  if (const Result<Done> known = are_known(verbs, words); !known) return fail(known.error(), console);
  if (words.empty()) return fail({"", "no verb is given; citykiln --help lists them"}, console);

  try {
    app.parse(argc, argv);
    for (const Verb& verb : verbs) {
      if (app.got_subcommand(verb.name)) return run_verb(*app.get_subcommand(verb.name), verb, console);
    }
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& problem) {
    return fail({"", problem.what()}, console);
  } catch (const std::bad_alloc&) {
    return fail({"", "out of memory"}, console);
  }
  return static_cast<int>(Exit::kFailed);
}

}  // namespace citykiln::commands
