#include "app/batch/periodic_option.hpp"

#include "app/batch/named_tags.hpp"

#include <algorithm>
#include <optional>

namespace forefront {

void addPeriodicOption(CLI::App &app, std::vector<std::string> &texts) {
    app.add_option("--periodic", texts,
                   "divide two boundary parts alike, such as left:right: the second is the first one moved or turned, "
                   "and each of its nodes is the image of one of the first; can be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME:NAME");
}

Diagnostics applyPeriodic(const std::vector<std::string> &texts, MeshingJob &job) {
    const NamedTags parts = NamedTags::ofParts(job.domain);
    std::vector<PeriodicSpec> given;
    for (const std::string &text : texts) {
        // Names may hold colons: the first place where both sides are known counts.
        std::optional<PeriodicSpec> spec;
        for (std::size_t colon = text.find(':'); colon != std::string::npos && !spec;
             colon = text.find(':', colon + 1)) {
            const auto from = parts.find(text.substr(0, colon)), to = parts.find(text.substr(colon + 1));
            if (from && to) {
                spec = PeriodicSpec{*from, *to};
            }
        }
        if (!spec) {
            const std::size_t colon = text.find(':');
            if (colon == std::string::npos || colon == 0 || colon + 1 == text.size()) {
                return error("bad-option", "--periodic " + text + ": expected two boundary parts, such as left:right");
            }
            const std::string first = text.substr(0, colon);
            return parts.unknown("--periodic", parts.find(first) ? text.substr(colon + 1) : first);
        }
        given.push_back(*spec);
    }
    std::erase_if(job.periodic, [&](const PeriodicSpec &own) {
        return std::any_of(given.begin(), given.end(), [&](const PeriodicSpec &spec) {
            return spec.from == own.from || spec.from == own.to || spec.to == own.from || spec.to == own.to;
        });
    });
    job.periodic.insert(job.periodic.end(), given.begin(), given.end());
    return {};
}

} // namespace forefront
