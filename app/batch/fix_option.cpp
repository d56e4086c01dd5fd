#include "app/batch/fix_option.hpp"

#include "app/batch/cli_options.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

/// Reads NAME=VALUE; returns what is wrong, empty if nothing is.
std::string readLimit(const std::string &text, MeshLimits &limits) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::optional<MeshLimit> limit = fromWord<MeshLimit>(text.substr(0, equals));
    if (!limit) {
        return "unknown limit '" + text.substr(0, equals) + "'; expected " + wordList<MeshLimit>();
    }
    const std::optional<double> value = numberIn(std::string_view(text).substr(std::min(equals + 1, text.size())));
    if (!value) {
        return "expected NAME=VALUE, such as max-growth=2, got '" + text + '\'';
    }
    if (const std::string fault = limitFault(*limit, *value); !fault.empty()) {
        return std::string(wordOf(*limit)) + ": " + fault;
    }
    limits[*limit] = *value;
    return {};
}

} // namespace

void addFixOptions(CLI::App &app, MeshLimits &limits, bool &fix) {
    app.add_option_function<std::vector<std::string>>(
           "--limit",
           [&limits](const std::vector<std::string> &texts) {
               for (const std::string &text : texts) {
                   if (const std::string wrong = readLimit(text, limits); !wrong.empty()) {
                       throw CLI::ValidationError("--limit", wrong);
                   }
               }
           },
           "a limit that the mesh should meet, such as max-growth=2, besides those of a project; a warning tells where "
           "it does not; limits: " +
               wordList<MeshLimit>() + "; can be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    app.add_flag(
        "--fix", fix,
        "change the settings until the mesh meets its limits: the gradation for growth, elements across narrow "
        "places, bounds of the size for lengths, the least angle, else the best improvement; each change is "
        "reported, and what none can mend");
}

} // namespace forefront
