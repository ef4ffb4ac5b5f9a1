// The settings of a compile: one table for the command line, for spec.json and for the help text.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "compiler/spec.h"

namespace citykiln {

/// One row of the table of settings.
struct Setting {
  std::string_view name;  ///< The name, such as "tile".
  /// The format of the value, such as "M" or "W,S,E,N"; empty for a switch, which takes "true" or "false". The format
  /// of a switch with an optional value begins with "[=", such as "[=CODE,...]".
  std::string_view value;
  std::string_view help;  ///< "{}" stands for the default value.
  bool repeats = false;   ///< True if it may be given several times; the values accumulate.
  Result<Done> (*apply)(CompileSpec& spec, std::string_view text);
  std::string (*default_in)(const CompileSpec& spec) = nullptr;  ///< The value in a spec as text, if help has "{}".
};

/// Returns the help with the default value, which is that of an empty CompileSpec.
std::string help_of(const Setting& setting);

/// Returns all settings in the order of the help text.
std::span<const Setting> settings();

/// Applies one setting. An error states the expected value, without the name of the setting, and leaves the spec
/// unchanged.
Result<Done> apply(const Setting& setting, std::string_view text, CompileSpec& spec);

}  // namespace citykiln
