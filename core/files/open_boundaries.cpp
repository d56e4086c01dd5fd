#include "core/files/open_boundaries.hpp"

#include "core/engine/base/note.hpp"
#include "core/files/common/tagged_sides.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace forefront {

std::map<std::int32_t, std::string> boundaryPartsOf(const MeshView &mesh) {
    std::map<std::int32_t, std::string> parts;
    const TaggedSides sides(mesh);
    for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
        const std::int32_t tag = mesh.edges[k].tag;
        if (sides.of(k).size() == 1 && !parts.contains(tag)) {
            parts.emplace(tag, boundaryName(mesh.boundaryNames, tag));
        }
    }
    return parts;
}

std::vector<std::int32_t> openPartsIn(const MeshView &mesh, std::span<const std::int32_t> tags) {
    if (tags.empty()) {
        return {};
    }
    const std::map<std::int32_t, std::string> parts = boundaryPartsOf(mesh);
    std::vector<std::int32_t> open;
    std::ranges::copy_if(tags, std::back_inserter(open), [&](std::int32_t tag) { return parts.contains(tag); });
    return open;
}

Diagnostics noteAllLand(const std::filesystem::path &path, std::string_view formatId, const ExportOptions &options,
                        const std::string &advice) {
    if (!options.openBoundaries.empty() || !hasOpenBoundaries(path, formatId)) {
        return {};
    }
    Diagnostic note = noteOf("no-open-boundary", "all of the boundary is land; " + advice);
    note.file = path.string();
    return {std::move(note)};
}

} // namespace forefront
