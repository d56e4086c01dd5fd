#include "app/batch/open_boundaries.hpp"

#include "app/batch/suggestion.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/common/names.hpp"
#include "core/files/files.hpp"
#include "core/files/open_boundaries.hpp"

#include <algorithm>
#include <map>
#include <string_view>

namespace forefront {

namespace {

using Parts = std::map<std::int32_t, std::string>; ///< names by tag

/// `advice`: how to name a part, with a comma or semicolon before it.
Diagnostics unknownNames(const std::vector<std::string> &open, const Parts &parts, const std::string &advice) {
    constexpr std::size_t kListed = 20;
    std::vector<std::string> unknown, known;
    for (const std::string &name : open) {
        const bool found =
            std::any_of(parts.begin(), parts.end(), [&](const auto &part) { return part.second == name; });
        if (!found) {
            unknown.push_back(name);
        }
    }
    if (unknown.empty()) {
        return {};
    }
    for (const auto &[tag, name] : parts) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            known.push_back(name);
        }
    }
    const std::vector<std::string_view> words(known.begin(), known.end());
    return error("unknown-boundary",
                 "--open: unknown boundary part " + listed(unknown, kListed) + suggestion(unknown.front(), words),
                 known.empty() ? "the boundary has no parts" : "expected one of " + listed(known, kListed) + advice);
}

} // namespace

void addOpenOption(CLI::App &app, MeshForm &form) {
    app.add_option(
           "--open", form.open,
           "name of a boundary part through which water flows, for ADCIRC, SCHISM, TELEMAC and MIKE, such as sea or "
           "boundary_2; all others are land; without it, those of the project; --name gives names to parts; can be "
           "repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
}

std::string checkOpen(const MeshForm &form, const std::vector<Output> &outputs) {
    const bool used = std::any_of(outputs.begin(), outputs.end(),
                                  [](const Output &output) { return hasOpenBoundaries(output.path, output.format); });
    if (form.open.empty() || used) {
        return {};
    }
    std::string extensions;
    for (const FileFormat &format : allFormats().list()) {
        if (format.hasOpenBoundaries) {
            extensions += (extensions.empty() ? "" : ", ") + std::string(format.extension);
        }
    }
    return "--open: no output tells open boundaries from land; add -o OUT with one of " + extensions;
}

Diagnostics checkOpenNames(const MeshForm &form, const Domain &domain) {
    Parts parts;
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role == SegmentRole::Boundary && !form.open.empty()) {
            parts.try_emplace(segment.tag, boundaryName(domain.boundaryNames, segment.tag));
        }
    }
    const std::string name = form.open.empty() ? std::string() : form.open.front();
    return unknownNames(form.open, parts,
                        "; --name \"" + name +
                            ":X1,Y1;X2,Y2\" names the part between two places, as a line of a map "
                            "on its edge does");
}

Diagnostics checkOpenNames(const MeshForm &form, const MeshView &mesh) {
    if (form.open.empty()) {
        return {};
    }
    return unknownNames(form.open, boundaryPartsOf(mesh),
                        "; the mesh has its names from the file that it was made from, see --name of "
                        "'forefront mesh'");
}

ExportOptions exportOptionsOf(const MeshForm &form, const MeshView &mesh) {
    ExportOptions options;
    options.extrusion = form.extrusion;
    options.keepTags = form.keepTags;
    options.unit = form.unit.value_or(LengthUnit::None);
    options.system = form.system;
    if (form.open.empty()) {
        options.openBoundaries = openPartsIn(mesh, form.openOfProject);
    }
    const Parts parts = form.open.empty() ? Parts() : tagsOf(mesh).edges;
    for (const std::string &name : form.open) {
        for (const auto &[tag, given] : parts) {
            const auto &known = options.openBoundaries;
            if (given == name && std::find(known.begin(), known.end(), tag) == known.end()) {
                options.openBoundaries.push_back(tag);
            }
        }
    }
    return options;
}

} // namespace forefront
