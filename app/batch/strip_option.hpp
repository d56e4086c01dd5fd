#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/strips/strip_spec.hpp"

#include <string>
#include <vector>

namespace forefront {

/// The strips of the command line.
struct StripArguments {
    std::vector<std::string> texts; ///< values of --strip
    struct Strip {
        std::string name; ///< of the line
        StripSpec spec;   ///< without its tag
    };
    std::vector<Strip> strips; ///< parsed
};

/// Adds the option --strip.
void addStripOption(CLI::App &app, StripArguments &arguments, const char *help);

/// Parses values such as wall:width=0.2,rows=2. Returns what is wrong; empty if nothing is.
std::string parseStrips(StripArguments &arguments);

/// Adds the strips of the command line to those of the input, or puts them in their place. A name may also be a default
/// name such as boundary_2. Error: "unknown-boundary", with the list of parts.
Diagnostics applyStrips(const StripArguments &arguments, const Domain &domain, std::vector<StripSpec> &strips);

} // namespace forefront
