#include "compiler/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cassert>
#include <new>

namespace citykiln::commands {
namespace {

constexpr const char* kVersion = "citykiln " CITYKILN_VERSION;

int fail(const Error& error) {
  // prints a single line, even if a library's message has several
  std::string line = to_string(error);
  std::ranges::replace(line, '\n', ' ');
  fmt::print(stderr, "citykiln: {}\n", line);
  return static_cast<int>(Exit::kFailed);
}

/// Declares one option of the table to CLI11.
void declare(CLI::App& app, const Option& option) {
  if (option.value.empty()) {
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
  command.add_flag("--json", console.is_json, "print the result as one JSON document");
  command.add_flag("--quiet", console.is_quiet, "print errors only");
  return command;
}

/// Passes every given value to its option.
Result<Done> take(const CLI::App& command, const Verb& verb) {
  for (const Option& option : verb.options) {
    const std::string name = option.flags.substr(option.flags.rfind(',') + 1);
    for (const std::string& text : command.get_option(name)->results()) {
      if (const Result<Done> taken = option.take(text); !taken) {
        return taken.error().where.empty() ? Error{name, taken.error().message} : taken.error();
      }
    }
  }
  return Done{};
}

int run(const CLI::App& command, const Verb& verb, const Console& console) {
  if (const Result<Done> taken = take(command, verb); !taken) return fail(taken.error());
  const Result<Exit> exit = verb.run(console);
  return exit ? static_cast<int>(*exit) : fail(exit.error());
}

}  // namespace

int run(std::span<const Verb> verbs, int argc, const char* const* argv) {
  assert(!verbs.empty() && argc > 0);
  CLI::App app("citykiln compiles OpenStreetMap extracts and heightmaps to 3D city tiles", "citykiln");
  app.set_version_flag("--version", kVersion);
  app.require_subcommand(1);
  Console console;
  for (const Verb& verb : verbs) declare(app, verb, console);

  try {
    app.parse(argc, argv);
    for (const Verb& verb : verbs) {
      if (app.got_subcommand(verb.name)) return run(*app.get_subcommand(verb.name), verb, console);
    }
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& problem) {
    return fail({"", problem.what()});
  } catch (const std::bad_alloc&) {
    return fail({"", "out of memory"});
  }
  return static_cast<int>(Exit::kFailed);
}

}  // namespace citykiln::commands
