#include "compiler/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cassert>
#include <filesystem>
#include <new>
#include <string_view>
#include <utility>

#include "compiler/commands/manual/built_commit.h"
#include "compiler/commands/run_paths.h"
#include "compiler/contract/system/program_version.h"
#include "compiler/contract/texts/nearest_name.h"
#include "compiler/contract/texts/parse.h"

namespace citykiln::commands {
namespace {

int fail(const Error& error, const Console& console) {
  console.print_error(error);
  return static_cast<int>(Exit::kFailed);
}

/// Declares one option of the table to CLI11.
void declare(CLI::App& app, const Option& option) {
  // a switch, or one that can have a value: --strict, --strict=CODE, --surroundings none
  if (option.value.empty() || option.value.starts_with("[")) {
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
  const InterruptNotice notice(verb.interrupted);
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

/// Words that other programs have for an option, where the letters are too far apart for did_you_mean().
struct OtherName {
  std::string_view other, flag;
};
constexpr OtherName kOtherNames[] = {{"--levels", "--lods"},    {"--lod", "--lods"},
                                     {"--detail", "--lods"},    {"--tolerances", "--lods"},
                                     {"--format", "--emit"},    {"--formats", "--emit"},
                                     {"--output", "--out"},     {"--outdir", "--out"},
                                     {"--folder", "--out"},     {"--heights", "--dem"},
                                     {"--heightmap", "--dem"},  {"--elevation", "--dem"},
                                     {"--terrain", "--dem"},    {"--bounds", "--bbox"},
                                     {"--box", "--bbox"},       {"--extent", "--bbox"},
                                     {"--tile-size", "--tile"}, {"--jobs", "--threads"},
                                     {"--cores", "--threads"},  {"--center", "--origin"},
                                     {"--centre", "--origin"},  {"--resolution", "--size"},
                                     {"--samples", "--spp"},    {"--camera", "--eye"},
                                     {"--position", "--eye"},   {"--target-point", "--look"},
                                     {"--date", "--time"},      {"--config", "--spec"},
                                     {"--settings", "--spec"},  {"--plants", "--species"},
                                     {"--styles", "--rules"},   {"--error", "--tolerance"},
                                     {"--lod-error", "--lods"}, {"--lights-per-tile", "--lights"}};

/// Returns "; did you mean --lods?", by the words of other programs or the letters; "" if nothing is near.
std::string meant_option(const std::string& flag, const std::vector<std::string>& flags) {
  for (const OtherName& name : kOtherNames)
    if (name.other == flag && std::ranges::find(flags, name.flag) != flags.end())
      return fmt::format("; did you mean {}?", name.flag);
  return did_you_mean(flag, flags);
}

/// Returns what to do with a first word that is a file or folder, and no verb: "; did you mean citykiln compile
/// map.osm -o out?"; "" for other words.
std::string meant_verb(const std::string& word) {
  std::error_code none;
  if (is_map_name(word)) return fmt::format("; did you mean citykiln compile {} -o out?", word);
  if (word.ends_with(".kiln") || word.ends_with(".glb"))
    return fmt::format("; did you mean citykiln preview {} -o picture.png?", word);
  if (word == "chart") return "; charts are made by citykiln-chart, which the build of the tests makes";
  if (word == "help") return "; did you mean citykiln --help?";
  if (word.ends_with(".json")) return fmt::format("; did you mean citykiln compile --spec {}?", word);
  if (std::filesystem::is_directory(word, none)) return fmt::format("; did you mean citykiln view {}?", word);
  return "";
}

std::string unknown_verb(const std::string& word, const std::vector<std::string>& names) {
  if (const std::string meant = meant_verb(word); !meant.empty()) return "is not a verb" + meant;
  return fmt::format("is not a verb{}; the verbs are {}", did_you_mean(word, names), fmt::join(names, ", "));
}

/// Error: a flag before the verb that is not --help, -h or --version.
Result<Done> is_own_flag(const std::string& word) {
  if (word == "--help" || word == "-h" || word == "--version" || word == kJson.flag) return Done{};
  const std::vector<std::string> own = {"--help", "--version"};
  const std::string meant = did_you_mean(word, own);
  return Error{word, "stands before the verb" +
                         (meant.empty() ? "; the verb comes first, such as citykiln compile map.osm -o out" : meant)};
}

/// True for "-threads", which is read as the short flag -t.
bool is_flag_with_one_dash(const std::string& word, const std::vector<std::string>& flags) {
  return word.size() > 2 && word[0] == '-' && std::ranges::find(flags, "-" + word) != flags.end();
}

/// Error: the first word is no verb, or a later one is a long flag that the verb does not have.
Result<Done> are_known(std::span<const Verb> verbs, std::span<const char* const> words) {
  if (words.empty()) return Done{};
  if (words.front()[0] == '-') return is_own_flag(words.front());
  std::vector<std::string> names;
  for (const Verb& verb : verbs)
    if (!verb.is_hidden) names.push_back(verb.name);
  const auto verb = std::ranges::find(verbs, words.front(), &Verb::name);
  if (verb == verbs.end()) return Error{words.front(), unknown_verb(words.front(), names)};
  const std::vector<std::string> flags = long_flags_of(*verb);
  for (const std::string_view word : words.subspan(1)) {
    const std::string given(word.substr(0, word.find('=')));
    const std::string flag = is_flag_with_one_dash(given, flags) ? "-" + given : given;
    if (!flag.starts_with("--") || std::ranges::find(flags, given) != flags.end()) continue;
    return Error{given, fmt::format("is not an option of {}{} (citykiln {} --help lists all)", verb->name,
                                    meant_option(flag, flags), verb->name)};
  }
  return Done{};
}

}  // namespace

namespace {

/// Returns the error of an option without its value, of CLI11's "--out: 1 required FOLDER missing".
Error without_value(const std::string& text) {
  const std::size_t colon = text.find(": "), end = text.rfind(" missing");
  constexpr std::string_view kRequired = "required ";
  const std::size_t begin = text.find(kRequired);
  if (colon == std::string::npos || end == std::string::npos || begin == std::string::npos) return {"", text};
  const std::size_t from = begin + kRequired.size();
  return {text.substr(0, colon), fmt::format("expected {} after it, found nothing", text.substr(from, end - from))};
}

/// True if a word is one of the values in "[none]" or "[usual|none|SHARE]", where capitals stand for a number.
bool fits(std::string_view value, std::string_view word) {
  if (!value.starts_with("[") || value.starts_with("[=")) return false;
  for (const std::string_view one : split(value.substr(1, value.size() - 2), '|')) {
    const bool is_number = std::ranges::all_of(one, [](char c) { return c >= 'A' && c <= 'Z'; });
    if (one == word || (is_number && number_in<double>(word))) return true;
  }
  return false;
}

/// True if an option's value may be left out, and a word is it: the none of "--surroundings none".
bool is_optional_value(std::span<const Verb> verbs, std::string_view flag, std::string_view word) {
  return std::ranges::any_of(verbs, [&](const Verb& verb) {
    return std::ranges::any_of(verb.options, [&](const Option& o) { return o.flags == flag && fits(o.value, word); });
  });
}

/// Returns the words with such values joined to their flags, as CLI11 reads them: --surroundings=none.
std::vector<std::string> with_optional_values(std::span<const Verb> verbs, std::span<const char* const> words) {
  std::vector<std::string> joined;
  for (const char* word : words) {
    if (!joined.empty() && is_optional_value(verbs, joined.back(), word))
      joined.back() += fmt::format("={}", word);
    else
      joined.emplace_back(word);
  }
  return joined;
}

int run_words(std::span<const Verb> verbs, int argc, const char* const* argv, Console& console) {
  CLI::App app("citykiln compiles OpenStreetMap extracts and heightmaps to 3D city tiles", "citykiln");
  app.set_version_flag("--version", std::string(kProgramVersion) + kBuiltCommit);
  app.require_subcommand(1);
  for (const Verb& verb : verbs) declare(app, verb, console);
  const std::span words(argv + 1, static_cast<std::size_t>(argc - 1));
  if (const Result<Done> known = are_known(verbs, words); !known) return fail(known.error(), console);
  const bool has_only_json = words.size() == 1 && std::string_view(words.front()) == kJson.flag;
  if (words.empty() || has_only_json) return fail({"", "no verb is given; citykiln --help lists them"}, console);

  try {
    std::vector<std::string> read = with_optional_values(verbs, words);
    std::ranges::reverse(read);  // CLI11 takes the first word from the end
    app.parse(std::move(read));
    for (const Verb& verb : verbs) {
      if (app.got_subcommand(verb.name)) return run_verb(*app.get_subcommand(verb.name), verb, console);
    }
  } catch (const CLI::Success& help) {
    // help is text, whatever else is asked for
    console.is_json = false;
    return app.exit(help);
  } catch (const CLI::ExtrasError& problem) {
    const std::string text = problem.what();
    return fail({"", fmt::format("one word too much: {}; the verb takes one, and options begin with --",
                                 text.substr(text.rfind(": ") + 2))},
                console);
  } catch (const CLI::ArgumentMismatch& problem) {
    return fail(without_value(problem.what()), console);
  } catch (const CLI::ParseError& problem) {
    return fail({"", problem.what()}, console);
  } catch (const std::bad_alloc&) {
    return fail({"", "out of memory"}, console);
  }
  return static_cast<int>(Exit::kFailed);
}

}  // namespace

int run(std::span<const Verb> verbs, int argc, const char* const* argv) {
  assert(!verbs.empty() && argc > 0);
  // known before parsing, so that errors of the command line are JSON too
  const bool is_json =
      std::ranges::count(std::span(argv, static_cast<std::size_t>(argc)), std::string_view("--json")) > 0;
  Console console{.is_json = is_json};
  const int exit_code = run_words(verbs, argc, argv, console);
  console.end_json();
  return exit_code;
}

}  // namespace citykiln::commands
