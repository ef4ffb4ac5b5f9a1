#include "compiler/commands/manual/man_page.h"

#include <fmt/format.h>

#include "compiler/contract/system/program_version.h"
#include "compiler/contract/texts/parse.h"

namespace citykiln::commands {
namespace {

constexpr std::string_view kDescription =
    "citykiln compiles OpenStreetMap extracts and heightmaps into 3D city tiles, offline. It writes glTF, USD and 3D "
    "Tiles with levels of detail whose largest geometric error is measured and stated, and a manifest of recipes from "
    "which every tile can be made again, byte for byte.";

/// Returns the text with the characters escaped that man(7) would read as commands. A hyphen stays one that can be
/// copied into a terminal.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
      out += std::string("\\&") + c;
    else
      out += c;
  }
  return out;
}

bool stands_by_place(const Option& option) { return option.flags.front() != '-'; }

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + escaped(text) + "\\fR"; }

/// "-o, --out FOLDER" with the fonts of a manual page.
std::string heading_of(const Option& option) {
  if (stands_by_place(option)) return italic(option.value.empty() ? option.flags : option.value);
  std::string heading;
  for (const std::string_view flag : split(option.flags, ',')) heading += (heading.empty() ? "" : ", ") + bold(flag);
  if (option.value.empty()) return heading;
  return heading + (option.value.starts_with("[=") ? "" : " ") + italic(option.value);
}

/// "compile [OPTION]... FILE": the verb and what stands by place.
std::string usage_of(const Verb& verb) {
  std::string usage = bold("citykiln " + verb.name) + " [" + italic("OPTION") + "]...";
  for (const Option& option : verb.options)
    if (stands_by_place(option)) usage += " " + heading_of(option);
  return usage;
}

std::string section_of(const Option& option) {
  return fmt::format(".TP\n{}\n{}\n", heading_of(option), escaped(option.help));
}

std::string examples_of(const Verb& verb) {
  if (verb.examples.empty()) return "";
  std::string text = ".PP\nExamples:\n.PP\n.nf\n";
  for (const std::string& example : verb.examples) text += "    " + escaped(example) + "\n";
  return text + ".fi\n";
}

std::string section_of(const Verb& verb) {
  std::string text =
      fmt::format(".SS citykiln {}\n{}\n.PP\n{}\n", escaped(verb.name), usage_of(verb), escaped(verb.help));
  for (const Option& option : verb.options) text += section_of(option);
  return text + examples_of(verb);
}

std::string shared_options() {
  std::string text;
  for (const SharedSwitch& shared : {kJson, kQuiet, kHelp})
    text += fmt::format(".TP\n{}\n{}\n", bold(shared.flag), escaped(shared.help));
  return text;
}

constexpr std::string_view kExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n0\ndone\n"
    ".TP\n1\nfailed; one line on the standard error says why\n"
    ".TP\n2\ndone, but data was mended or dropped and \\fB\\-\\-strict\\fR was given\n"
    ".TP\n130\ninterrupted\n";
constexpr std::string_view kFiles =
    ".SH FILES\n"
    ".TP\n\\fI/usr/share/citykiln/examples/town\\fR\nan invented town to begin with\n"
    ".TP\n\\fI/usr/share/citykiln\\fR\nadd\\-ons for programs that read the tiles\n";

std::string see_also(std::span<const Verb> verbs) {
  std::string names;
  for (const Verb& verb : verbs)
    if (!verb.is_hidden) names += (names.empty() ? "" : ",\n") + bold("citykiln-" + verb.name) + "(1)";
  return ".SH SEE ALSO\n" + names + "\n";
}

}  // namespace

std::string man_page(std::span<const Verb> verbs) {
  std::string page = fmt::format(".TH CITYKILN 1 \"\" \"{}\" \"User Commands\"\n", escaped(kProgramVersion));
  page += ".SH NAME\ncitykiln \\- compiles OpenStreetMap extracts and heightmaps to 3D city tiles\n.SH SYNOPSIS\n.nf\n";
  for (const Verb& verb : verbs)
    if (!verb.is_hidden) page += usage_of(verb) + "\n";
  page += fmt::format(".fi\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n", escaped(kDescription));
  for (const Verb& verb : verbs)
    if (!verb.is_hidden) page += section_of(verb);
  page += ".SS All commands\n" + shared_options() + std::string(kExitStatus) + std::string(kFiles);
  return page + see_also(verbs);
}

std::string man_page_of(const Verb& verb) {
  const std::string name = "citykiln-" + verb.name;
  std::string page = fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n", escaped(name), escaped(kProgramVersion));
  page += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}\n.SH OPTIONS\n", escaped(name), escaped(verb.help),
                      usage_of(verb));
  for (const Option& option : verb.options) page += section_of(option);
  return page + shared_options() + examples_of(verb) + std::string(kExitStatus) + ".SH SEE ALSO\n\\fBcitykiln\\fR(1)\n";
}

}  // namespace citykiln::commands
