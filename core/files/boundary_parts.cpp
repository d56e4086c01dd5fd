#include "core/files/boundary_parts.hpp"

#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_parts.hpp"
#include "core/files/source/source.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace forefront {

namespace {

std::string shown(double length) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", length);
    return text;
}

Diagnostics compare(const MeshView &mesh, const std::map<std::int32_t, MshCurveGroup> &groups,
                    const std::map<std::int32_t, double> &changes, double tolerance) {
    std::map<std::int32_t, double> lengths;
    for (const TaggedEdge &edge : mesh.edges) {
        lengths[edge.tag] += distance(mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)]);
    }
    Diagnostics faults;
    const auto fault = [&](const std::string &message) {
        faults.push_back(std::move(error("wrong-part", message).front()));
    };
    for (const auto &[tag, group] : groups) {
        const std::string name = "boundary part " + inQuotes(group.name) + " (tag " + std::to_string(tag) + ')';
        const auto change = changes.find(tag);
        const double repaired = change == changes.end() ? 0.0 : change->second;
        if (!group.curved && !(std::abs(lengths[tag] - repaired - group.length) <= tolerance)) {
            const std::string note = repaired == 0.0 ? "" : "; the repair changes it by " + shown(repaired);
            fault(name + " is " + shown(lengths[tag]) + " long in the mesh, but " + shown(group.length) +
                  " in the domain's file" + note);
        }
        for (const auto &[other, given] : mesh.boundaryNames) {
            if (other != tag && !group.name.empty() && given == group.name && lengths.count(other) > 0 &&
                groups.count(other) == 0) {
                fault("the mesh gives the name of " + name + " to tag " + std::to_string(other));
            }
        }
    }
    return faults;
}

} // namespace

Diagnostics checkBoundaryParts(const MeshView &mesh, const std::filesystem::path &domainFile,
                               const ImportOptions &options, const std::map<std::int32_t, double> &changes) {
    if (mesh.edges.empty()) {
        return {};
    }
    std::string loaded;
    if (options.content == nullptr) {
        Result<std::string> bytes = readFileBytes(domainFile, options.maxBytes);
        if (!bytes) {
            return bytes.faults();
        }
        loaded = std::move(*bytes);
    }
    const std::string &text = options.content != nullptr ? *options.content : loaded;
    constexpr std::size_t kHeadBytes = 4096;
    if (!looksLikeMsh(std::string_view(text).substr(0, kHeadBytes))) {
        return {};
    }
    const double tolerance = 1e-9 * static_cast<double>(mesh.edges.size()) * mesh.bounds().diagonal();
    const auto groups = mshCurveGroups(text);
    return groups ? compare(mesh, *groups, changes, tolerance) : Diagnostics{};
}

} // namespace forefront
