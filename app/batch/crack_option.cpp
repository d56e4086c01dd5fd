#include "app/batch/crack_option.hpp"

#include "app/batch/part_names.hpp"

#include <algorithm>
#include <optional>

namespace forefront {

void addCrackOption(CLI::App &app, std::vector<std::string> &names) {
    app.add_option(
           "--crack", names,
           "make a crack of the inner line NAME: the elements on its two sides get nodes of their own; the face "
           "on the right of the line is named NAME_right; can be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
}

Diagnostics applyCracks(const std::vector<std::string> &names, const Domain &domain,
                        std::vector<std::int32_t> &cracks) {
    const PartNames parts(domain);
    for (const std::string &name : names) {
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
