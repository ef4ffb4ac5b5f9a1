// The formats are those of https://github.com/bratek20/RPForest (configs/, assets/). Interpretation follows the book;
// RPForest's own turtle adds up angles instead of rotating.
#include "lsystems/reading/read_rpforest.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

#include "lsystems/reading/read_lsystem.h"
#include "lsystems/reading/reader.h"

namespace citykiln::lsystems {
namespace {

struct Word {
  std::string text;
  TextPosition place;
};

struct Production {
  std::string from, to;
};

// The entries of a file of any of the three formats.
struct Config {
  std::string file;
  std::map<std::string, double, std::less<>> numbers;
  std::string axiom;
  std::vector<Production> productions;
  std::optional<Error> failed;

  double number(std::string_view name) const { return numbers.find(name)->second; }
};

enum class Form { kLsys, kHonda, kFamily };

Form form_of(std::string_view file) {
  if (file.ends_with(".honda")) return Form::kHonda;
  return file.ends_with(".family") ? Form::kFamily : Form::kLsys;
}

// RPForest's defaults.
std::map<std::string, double, std::less<>> defaults_of(Form form) {
  std::map<std::string, double, std::less<>> values{{"Height", 0}, {"ConeBasePoints", 3}, {"InitRadius", 0.3}};
  if (form == Form::kLsys) values.insert({{"TurnAngle", 0}, {"PitchAngle", 0}, {"RollAngle", 0}});
  if (form == Form::kHonda) values["Height"] = 2, values["InitRadius"] = 0.2;
  if (form == Form::kFamily) values["Height"] = 0.4;
  return values;
}

std::vector<std::string> needed_by(Form form) {
  if (form == Form::kHonda) return {"N", "R1", "R2", "A0", "A2", "D", "Wr"};
  if (form == Form::kFamily) return {"N", "Delta", "LA", "RA", "LB", "RB", "PD"};
  return {"N"};
}

std::vector<Word> words_of(std::string_view text) {
  std::vector<Word> words;
  std::uint32_t line = 1;
  std::size_t line_start = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\n') ++line, line_start = at + 1;
    if (text[at] == ' ' || text[at] == '\t' || text[at] == '\r' || text[at] == '\n') {
      ++at;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    words.push_back({std::string(text.substr(at, end - at)), {line, static_cast<std::uint32_t>(at - line_start + 1)}});
    at = end;
  }
  return words;
}

void fail(Config& config, const Word& word, const std::string& message) {
  if (!config.failed) config.failed = Error{position_name(config.file, word.place), message};
}

double number_of(Config& config, const Word& word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.text.data(), word.text.data() + word.text.size(), number);
  const bool is_number = error == std::errc() && end == word.text.data() + word.text.size() && std::isfinite(number);
  if (!is_number) fail(config, word, fmt::format("expected a number, found '{}'", word.text.substr(0, 40)));
  return number;
}

// A name with a capital; the oldest files write small letters.
std::string spelled(std::string name) {
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name == "Angle" ? "TurnAngle" : name;
}

void take_production(Config& config, const Word& from, const Word& arrow, const Word& to) {
  if (from.text.size() != 1)
    return fail(config, from, fmt::format("expected one symbol, found '{}'", from.text.substr(0, 40)));
  if (arrow.text != ">") return fail(config, arrow, fmt::format("expected '>', found '{}'", arrow.text.substr(0, 40)));
  config.productions.push_back({from.text, to.text});
}

// Reads the entry at `at`. Returns its number of words.
std::size_t take_entry(Config& config, Form form, const std::vector<Word>& words, std::size_t at) {
  const std::string name = spelled(words[at].text);
  const bool is_text = name == "Material" || (form == Form::kLsys && name == "Axiom");
  const bool is_production = form == Form::kLsys && name == "Prod";
  const auto needed = needed_by(form);
  const bool known = is_text || is_production || defaults_of(form).contains(name) ||
                     std::find(needed.begin(), needed.end(), name) != needed.end();
  if (!known)
    return fail(config, words[at],
                fmt::format("'{}' is no RPForest entry of this format", words[at].text.substr(0, 40))),
           1;
  const std::size_t values = is_production ? 3 : 1;
  if (at + values >= words.size())
    return fail(config, words[at], fmt::format("expected a value of '{}', found the end of the file", name)), 1;
  if (is_production) take_production(config, words[at + 1], words[at + 2], words[at + 3]);
  if (name == "Axiom") config.axiom = words[at + 1].text;
  if (!is_text && !is_production) config.numbers[name] = number_of(config, words[at + 1]);
  return 1 + values;
}

// Reads the oldest form: N, angle, height, axiom, then productions, without names.
void take_unnamed(Config& config, const std::vector<Word>& words) {
  if (words.size() < 4) return fail(config, words[0], "expected N, angle, height and axiom");
  config.numbers["N"] = number_of(config, words[0]);
  config.numbers["TurnAngle"] = number_of(config, words[1]);
  config.numbers["Height"] = number_of(config, words[2]);
  config.axiom = words[3].text;
  for (std::size_t at = 4; at < words.size(); at += 3) {
    if (at + 2 >= words.size())
      return fail(config, words[at], "expected a production: a symbol, > and what it becomes");
    take_production(config, words[at], words[at + 1], words[at + 2]);
  }
}

Config config_of(std::string_view text, std::string_view file, Form form) {
  Config config{std::string(file), defaults_of(form), {}, {}, {}};
  const std::vector<Word> words = words_of(text);
  if (form == Form::kLsys && !words.empty() && is_digit(words[0].text[0])) {
    take_unnamed(config, words);
    return config;
  }
  for (std::size_t at = 0; at < words.size() && !config.failed;) at += take_entry(config, form, words, at);
  for (const std::string& name : needed_by(form))
    if (!config.failed && !config.numbers.contains(name))
      config.failed = Error{config.file, fmt::format("expected a value of '{}'", name)};
  if (!config.failed && form == Form::kLsys && config.axiom.empty())
    config.failed = Error{config.file, "expected an Axiom"};
  return config;
}

// A directive of our notation; none for 0.
std::string directive(std::string_view name, double value) {
  return value == 0 ? "" : fmt::format("{}: {}\n", name, value);
}

std::string lsys_text(const Config& config) {
  std::string text = fmt::format("n: {}\n", config.number("N"));
  text += directive("height", config.number("Height")) + fmt::format("width: {}\n", 2 * config.number("InitRadius"));
  text += "axiom: " + config.axiom + "\n";
  for (const Production& production : config.productions) text += production.from + " -> " + production.to + "\n";
  // our notation has one angle, RPForest's three
  const double turn = config.number("TurnAngle"), pitch = config.number("PitchAngle"),
               roll = config.number("RollAngle");
  text +=
      fmt::format("interpretation:\n+ -> +({0})\n- -> -({0})\n& -> &({1})\n^ -> ^({1})\n\\ -> \\({2})\n/ -> /({2})\n",
                  turn, pitch, roll);
  return text;
}

std::string defines(const Config& config, std::initializer_list<const char*> names) {
  std::string text;
  for (const char* name : names) text += fmt::format("#define {} {}\n", name, config.number(name));
  return text;
}

std::string honda_text(const Config& config) {
  std::string text = fmt::format("n: {}\n", config.number("N")) + directive("height", config.number("Height"));
  text += defines(config, {"R1", "R2", "A0", "A2", "D", "Wr"});
  text += fmt::format("axiom: A(1,{})\n", 2 * config.number("InitRadius"));
  text += "A(l,w) -> !(w)F(l)[&(A0)B(l*R2,w*Wr)]/(D)A(l*R1,w*Wr)\n";
  text += "B(l,w) -> !(w)F(l)[-(A2)$C(l*R2,w*Wr)]C(l*R1,w*Wr)\n";
  text += "C(l,w) -> !(w)F(l)[+(A2)$B(l*R2,w*Wr)]B(l*R1,w*Wr)\n";
  return text;
}

// RPForest's first step makes the polygon.
std::string family_text(const Config& config) {
  std::string text = fmt::format("n: {}\n", config.number("N")) + directive("height", config.number("Height"));
  text += defines(config, {"Delta", "LA", "RA", "LB", "RB", "PD"});
  text += "axiom: X\nX -> {.A(0)}\n";
  text += "A(t) -> G(LA,RA)[-(Delta)B(t).][A(t+1)][+(Delta)B(t).]\n";
  text += "B(t) : t > 0 -> G(LB,RB)B(t-PD)\nB(t) : t <= 0 -> *\nG(s,r) -> G(s*r,r)\n";
  return text;
}

// The text of a file in our notation.
Result<std::string> rpforest_to_lsystem_text(std::string_view text, std::string_view file) {
  if (text.size() > kTextLimit)
    return Error{std::string(file), fmt::format("expected at most {} bytes, found {}", kTextLimit, text.size())};
  const Form form = form_of(file);
  const Config config = config_of(text, file, form);
  if (config.failed) return *config.failed;
  if (form == Form::kHonda) return honda_text(config);
  return form == Form::kFamily ? family_text(config) : lsys_text(config);
}

}  // namespace

bool is_rpforest(std::string_view text, std::string_view file) {
  if (form_of(file) != Form::kLsys) return true;
  const std::vector<Word> words = words_of(text.substr(0, 4096));
  if (!file.ends_with(".lsys") || words.empty()) return false;
  static constexpr const char* kNames[] = {"N",          "TurnAngle",      "PitchAngle", "RollAngle", "Angle", "Height",
                                           "InitRadius", "ConeBasePoints", "Material",   "Axiom",     "Prod"};
  const bool is_named = std::find(std::begin(kNames), std::end(kNames), words[0].text) != std::end(kNames);
  // our `n: 5` is RPForest's `N 5`; of our statements, only productions begin with a number
  const bool is_numbers = words.size() > 1 && is_digit(words[0].text[0]) && is_digit(words[1].text[0]);
  return words.size() > 1 && (is_numbers || (is_named && words[1].text != ":" && words[1].text != "="));
}

Result<LSystem> read_rpforest(std::string_view text, std::string_view file) {
  const Result<std::string> ours = rpforest_to_lsystem_text(text, file);
  if (!ours) return ours.error();
  Result<LSystem> system = read_lsystem(*ours, file);
  // positions refer to the translation
  if (!system) return Error{std::string(file), "translated to our notation: " + to_string(system.error())};
  return system;
}

}  // namespace citykiln::lsystems
