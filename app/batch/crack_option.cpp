#include "app/batch/crack_option.hpp"

#include "app/batch/named_tags.hpp"

#include <algorithm>
#include <optional>

namespace forefront {

void addCrackOptions(CLI::App &app, CrackArguments &arguments, const char *crackHelp) {
    app.add_option("--crack", arguments.names, crackHelp)->allow_extra_args(false)->type_name("NAME");
    app.add_flag("--no-cracks", arguments.dropsOthers,
                 "leave out the cracks of the input: those of a project, and the lines along which a mesh is open, are "
                 "inner lines whose two sides share nodes");
}

Diagnostics applyCracks(const CrackArguments &arguments, const Domain &domain, std::vector<std::int32_t> &cracks) {
    if (arguments.dropsOthers) {
        cracks.clear();
    }
    const NamedTags parts = NamedTags::ofParts(domain);
    for (const std::string &name : arguments.names) {
        const std::optional<std::int32_t> tag = parts.find(name);
        if (!tag) {
            return parts.unknown("--crack", name);
        }
        if (std::find(cracks.begin(), cracks.end(), *tag) == cracks.end()) {
            cracks.push_back(*tag);
        }
    }
    return {};
}

} // namespace forefront
